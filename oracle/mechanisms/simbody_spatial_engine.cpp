#include "oracle/mechanisms/simbody_spatial_engine.hpp"

#include "oracle/mechanisms/simbody_integration.hpp"

namespace lubjoint::mechanisms {

namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

Vec3 vec(const SimbodyVector& v) { return {v[0], v[1], v[2]}; }
SimbodyVector plain(const Vec3& v) { return {v[0], v[1], v[2]}; }

/// A frame of a mobilizer, whose motions are about and along z, or in the plane of x and y.
Transform frame(const SimbodyAxes& at) {
  return {Rotation(UnitVec3(vec(at.axis)), SimTK::ZAxis, vec(at.across), SimTK::XAxis), vec(at.point)};
}

SimTK::Body::Rigid rigid(const SimbodyBody& body) {
  const auto& j = body.inertia;
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, Vec3(0), SimTK::Inertia(Vec3(j[0], j[1], j[2]), Vec3(j[3], j[4], j[5]))));
}

/// The joint between rod and slider. All that follows is in the rod's axes, in which the bearing is at rest.
class FilmForce final : public SimbodyPinForce<SimbodyFilm> {
 public:
  FilmForce(const SimbodySpatialProblem& problem, const MobilizedBody& rod, const MobilizedBody& slider)
      : law_(problem.film),
        rod_(rod),
        slider_(slider),
        bearing_(vec(problem.bearing_centre)),
        axis_(vec(problem.bearing_direction)),
        journal_(vec(problem.journal_centre)),
        journal_axis_(vec(problem.journal_direction)) {}

  SimbodyFilm pin(const SimTK::State& state) const override {
    const Vec3 along = slider_.expressVectorInAnotherBodyFrame(state, journal_axis_, rod_);
    const Vec3 turning = slider_.findBodyAngularVelocityInAnotherBody(state, rod_);
    const double cosine = SimTK::dot(axis_, along);
    const Vec3 d = slider_.findStationLocationInAnotherBody(state, journal_, rod_) - bearing_;
    const double sliding = SimTK::dot(axis_, d) / cosine;
    // X moves with the journal's axis, and along it so that it stays in the bearing's middle plane.
    const Vec3 of_axis =
        slider_.findStationVelocityInAnotherBody(state, journal_, rod_) - sliding * SimTK::cross(turning, along);
    const Vec3 velocity = of_axis - SimTK::dot(axis_, of_axis) / cosine * along;
    const auto inertial = [&](const Vec3& v) { return plain(rod_.expressVectorInGroundFrame(state, v)); };
    return {inertial(axis_), inertial(d - sliding * along), inertial(velocity), SimTK::dot(axis_, turning)};
  }

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    clock().look();
    const SimbodyFilmForce film = law_(pin(state));
    const Vec3 on_slider = vec(film.force);
    const Vec3 at = rod_.findStationLocationInGround(state, bearing_) + vec(film.point);
    slider_.applyForceToBodyPoint(state, slider_.findStationAtGroundPoint(state, at), on_slider, on_bodies);
    rod_.applyForceToBodyPoint(state, rod_.findStationAtGroundPoint(state, at), -on_slider, on_bodies);
  }

 private:
  SimbodyFilmLaw law_;
  const MobilizedBody& rod_;
  const MobilizedBody& slider_;
  Vec3 bearing_;
  Vec3 axis_;
  Vec3 journal_;
  Vec3 journal_axis_;
};

/// Position and velocity of a frame that is fixed to a body, from the body's start.
struct Placed {
  Placed(const SimbodyBody& body, const Transform& fixed) {
    const auto& a = body.rotation;
    const Rotation turn(SimTK::Mat33(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]));
    at = Transform(turn, vec(body.position)) * fixed;
    spin = vec(body.spin);
    velocity = vec(body.velocity) + SimTK::cross(spin, at.p() - vec(body.position));
  }
  explicit Placed(const Transform& on_ground) : at(on_ground), spin(0), velocity(0) {}

  Transform at;
  Vec3 spin;
  Vec3 velocity;  ///< of its origin
};

/// Sets a mobilizer's coordinates and speeds to what its two frames say, the second one's motion seen from the first.
void fit(const MobilizedBody& body, const Placed& first, const Placed& second, SimTK::State& state) {
  body.setQToFitTransform(state, ~first.at * second.at);
  const Vec3 relative = second.velocity - first.velocity - SimTK::cross(first.spin, second.at.p() - first.at.p());
  body.setUToFitVelocity(state,
                         SimTK::SpatialVec(~first.at.R() * (second.spin - first.spin), ~first.at.R() * relative));
}

}  // namespace

struct SimbodySpatialEngine::Parts {
  explicit Parts(const SimbodySpatialProblem& p)
      : matter(system),
        forces(system),
        weight(forces, matter, vec(p.gravity)),
        crank(matter.Ground(), frame(p.main_bearing), rigid(p.crank), frame(p.main_journal)),
        slider(matter.Ground(), frame(p.guide), rigid(p.slider), frame(p.guided)),
        rod(slider, frame(p.thrust_of_slider), rigid(p.rod), frame(p.thrust_of_rod)),
        ball(crank, vec(p.crank_pin), rod, vec(p.rod_end)),
        film(new FilmForce(p, rod, slider)),
        force(forces, film),
        start((forces.setNumberOfThreads(1), system.realizeTopology())) {
    fit(crank, Placed(frame(p.main_bearing)), Placed(p.crank, frame(p.main_journal)), start);
    fit(slider, Placed(frame(p.guide)), Placed(p.slider, frame(p.guided)), start);
    fit(rod, Placed(p.slider, frame(p.thrust_of_slider)), Placed(p.rod, frame(p.thrust_of_rod)), start);
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::Force::Gravity weight;
  MobilizedBody::Pin crank;
  MobilizedBody::Cylinder slider;
  MobilizedBody::Planar rod;
  SimTK::Constraint::Ball ball;
  FilmForce* film;  ///< Simbody's own
  SimTK::Force::Custom force;
  SimTK::State start;
};

SimbodySpatialEngine::SimbodySpatialEngine(const SimbodySpatialProblem& problem)
    : parts_(std::make_unique<Parts>(problem)) {}
SimbodySpatialEngine::~SimbodySpatialEngine() = default;

SimbodyRun<SimbodyFilm> SimbodySpatialEngine::run(double accuracy, double duration, const std::vector<double>& times,
                                                  double seconds) {
  return integrate(parts_->system, parts_->start, *parts_->film, {accuracy, duration, seconds, times, true});
}

}  // namespace lubjoint::mechanisms
