#include "oracle/mechanisms/simbody_engine.hpp"

#include "oracle/mechanisms/simbody_integration.hpp"

namespace lubjoint::mechanisms {

namespace {

/// The joint between the rod's end and the slider's centre.
class PinForce final : public SimbodyPinForce<SimbodyPin> {
 public:
  PinForce(const SimbodyProblem& problem, const SimTK::MobilizedBody& rod, const SimTK::MobilizedBody& slider)
      : problem_(problem), rod_(rod), slider_(slider), rod_end_(problem.rod_length / 2, 0, 0) {}

  SimbodyPin pin(const SimTK::State& state) const override {
    const double sign = problem_.bearing_on_rod ? 1 : -1;
    const SimTK::Vec3 e =
        sign * (slider_.getBodyOriginLocation(state) - rod_.findStationLocationInGround(state, rod_end_));
    const SimTK::Vec3 v =
        sign * (slider_.getBodyOriginVelocity(state) - rod_.findStationVelocityInGround(state, rod_end_));
    const double rod_spin = rod_.getBodyAngularVelocity(state)[2];
    const double slider_spin = slider_.getBodyAngularVelocity(state)[2];
    return {{e[0], e[1]},
            {v[0], v[1]},
            problem_.bearing_on_rod ? rod_spin : slider_spin,
            problem_.bearing_on_rod ? slider_spin : rod_spin};
  }

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies, SimTK::Vector_<SimTK::Vec3>&,
                 SimTK::Vector&) const override {
    clock().look();
    const std::array<double, 2> on_journal = problem_.force(pin(state));
    const double sign = problem_.bearing_on_rod ? 1 : -1;
    const SimTK::Vec3 on_slider(sign * on_journal[0], sign * on_journal[1], 0);
    // The pair acts at the journal's centre.
    const SimTK::Vec3 centre = problem_.bearing_on_rod ? slider_.getBodyOriginLocation(state)
                                                       : rod_.findStationLocationInGround(state, rod_end_);
    slider_.applyForceToBodyPoint(state, slider_.findStationAtGroundPoint(state, centre), on_slider, on_bodies);
    rod_.applyForceToBodyPoint(state, rod_.findStationAtGroundPoint(state, centre), -on_slider, on_bodies);
  }

 private:
  const SimbodyProblem& problem_;
  const SimTK::MobilizedBody& rod_;
  const SimTK::MobilizedBody& slider_;
  SimTK::Vec3 rod_end_;
};

/// Of a body in the plane only the inertia about z counts: the same about every axis is a possible one.
SimTK::Body::Rigid body(double mass, double inertia) {
  return SimTK::Body::Rigid(SimTK::MassProperties(mass, SimTK::Vec3(0), SimTK::Inertia(inertia)));
}

SimTK::Transform at(double x) { return SimTK::Transform(SimTK::Vec3(x, 0, 0)); }

}  // namespace

struct SimbodyEngine::Parts {
  explicit Parts(const SimbodyProblem& given)
      : problem(given),
        matter(system),
        forces(system),
        crank(matter.Ground(), at(0), body(given.crank_mass, given.crank_inertia), at(-given.crank_length / 2)),
        rod(crank, at(given.crank_length / 2), body(given.rod_mass, given.rod_inertia), at(-given.rod_length / 2)),
        slider(matter.Ground(), at(0), body(given.slider_mass, given.rod_inertia), at(0)),  // it does not turn
        motor(crank, given.crank_speed),
        pin(new PinForce(problem, rod, slider)),
        force(forces, pin),
        start((forces.setNumberOfThreads(1), system.realizeTopology())) {
    crank.setAngle(start, 0);
    crank.setRate(start, given.crank_speed);
    rod.setAngle(start, 0);
    rod.setRate(start, given.start_rod_spin - given.crank_speed);  // relative to the crank
    slider.setLength(start, given.start_slider);
    slider.setRate(start, 0);
  }

  SimbodyProblem problem;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::MobilizedBody::Pin crank;
  SimTK::MobilizedBody::Pin rod;
  SimTK::MobilizedBody::Slider slider;
  SimTK::Motion::Steady motor;
  PinForce* pin;  ///< Simbody's own
  SimTK::Force::Custom force;
  SimTK::State start;
};

SimbodyEngine::SimbodyEngine(const SimbodyProblem& problem) : parts_(std::make_unique<Parts>(problem)) {}
SimbodyEngine::~SimbodyEngine() = default;

SimbodyRun<SimbodyPin> SimbodyEngine::run(double accuracy, double duration, const std::vector<double>& times,
                                          double seconds) {
  return integrate(parts_->system, parts_->start, *parts_->pin, {accuracy, duration, seconds, times, false});
}

}  // namespace lubjoint::mechanisms
