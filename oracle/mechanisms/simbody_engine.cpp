#include "oracle/mechanisms/simbody_engine.hpp"

#include <Simbody.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "oracle/mechanisms/processor_time.hpp"

namespace lubjoint::mechanisms {

namespace {

/// The joint between the rod's end and the slider's centre.
class PinForce final : public SimTK::Force::Custom::Implementation {
 public:
  PinForce(const SimbodyProblem& problem, const SimTK::MobilizedBody& rod, const SimTK::MobilizedBody& slider)
      : problem_(problem), rod_(rod), slider_(slider), rod_end_(problem.rod_length / 2, 0, 0) {}

  SimbodyPin pin(const SimTK::State& state) const {
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
    if (++calls_ % 256 == 0 && processor_seconds() > deadline_) out_of_time_ = true;
    if (out_of_time_) throw std::runtime_error("out of time");
    const std::array<double, 2> on_journal = problem_.force(pin(state));
    const double sign = problem_.bearing_on_rod ? 1 : -1;
    const SimTK::Vec3 on_slider(sign * on_journal[0], sign * on_journal[1], 0);
    // The pair acts at the journal's centre.
    const SimTK::Vec3 centre = problem_.bearing_on_rod ? slider_.getBodyOriginLocation(state)
                                                       : rod_.findStationLocationInGround(state, rod_end_);
    slider_.applyForceToBodyPoint(state, slider_.findStationAtGroundPoint(state, centre), on_slider, on_bodies);
    rod_.applyForceToBodyPoint(state, rod_.findStationAtGroundPoint(state, centre), -on_slider, on_bodies);
  }

  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

  void start_clock(double seconds) {
    out_of_time_ = false;
    deadline_ = processor_seconds() + seconds;
  }
  bool is_out_of_time() const { return out_of_time_; }

 private:
  const SimbodyProblem& problem_;
  const SimTK::MobilizedBody& rod_;
  const SimTK::MobilizedBody& slider_;
  SimTK::Vec3 rod_end_;
  double deadline_ = 0;  ///< in processor_seconds()
  mutable std::size_t calls_ = 0;
  mutable bool out_of_time_ = false;
};

/// Of a body in the plane only the inertia about z counts: the same about every axis is a possible one.
SimTK::Body::Rigid body(double mass, double inertia) {
  return SimTK::Body::Rigid(SimTK::MassProperties(mass, SimTK::Vec3(0), SimTK::Inertia(inertia)));
}

SimTK::Transform at(double x) { return SimTK::Transform(SimTK::Vec3(x, 0, 0)); }

/// Standard error is nowhere as long as this is there: CPodes reports what it then mends, and can't be asked not to.
class Silence {
 public:
  Silence() : before_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (nowhere < 0) return;
    std::fflush(stderr);
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~Silence() {
    if (before_ < 0) return;
    std::fflush(stderr);
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int before_;
};

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

SimbodyRun SimbodyEngine::run(double accuracy, double duration, const std::vector<double>& times, double seconds) {
  SimbodyRun result;
  Parts& parts = *parts_;
  SimTK::CPodesIntegrator stepper(parts.system, SimTK::CPodes::BDF);
  stepper.setAccuracy(accuracy);
  stepper.setFinalTime(duration);
  std::vector<double> goals = times;
  if (goals.empty()) goals = {duration};
  parts.pin->start_clock(seconds);
  const int before = parts.system.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration);
  const Silence silence;
  const double begin = processor_seconds();
  try {
    stepper.initialize(parts.start);
    for (const double goal : goals) {
      while (stepper.getTime() < goal) stepper.stepTo(goal);
      if (times.empty()) continue;
      parts.system.realize(stepper.getState(), SimTK::Stage::Velocity);
      result.pins.push_back(parts.pin->pin(stepper.getState()));
    }
    result.finished = true;
  } catch (const std::exception&) {  // of Simbody: where in its sources, over several lines
    result.out_of_time = parts.pin->is_out_of_time();
    result.message = "Simbody stopped at " + std::to_string(stepper.getTime()) + " s";
  }
  result.seconds = processor_seconds() - begin;
  result.steps = static_cast<std::size_t>(stepper.getNumStepsTaken());
  result.rejected = static_cast<std::size_t>(stepper.getNumErrorTestFailures());
  result.evaluations =
      static_cast<std::size_t>(parts.system.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration) - before);
  return result;
}

std::string simbody_version() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace lubjoint::mechanisms
