#include "oracle/measure/bench/simbody_space.hpp"

#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/mechanisms/simbody_spatial_slider_crank.hpp"
#include "oracle/trajectories/spatial_slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using mechanisms::SimbodyAxes;
using mechanisms::SimbodyBody;
using mechanisms::SimbodyFilm;
using mechanisms::SimbodyVector;

SimbodyVector plain(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }
Vector3<double> vector(const SimbodyVector& v) { return {v[0], v[1], v[2]}; }
SimbodyAxes plain(const AxisFrame<double>& at) { return {plain(at.point), plain(at.axis), plain(at.across)}; }

SimbodyBody body_at_start(const SpatialScene& scene, const std::vector<double>& start, std::size_t number) {
  const SpatialSceneBody& body = scene.bodies.at(number);
  const SpatialFrame<double> frame(spatial_motion_in(start.data(), scene.bodies.size(), number));
  const Matrix3<double>& j = body.inertia;
  const Matrix3<double>& a = frame.rotation;
  return {body.mass,
          {j(0, 0), j(1, 1), j(2, 2), j(0, 1), j(0, 2), j(1, 2)},
          plain(frame.position),
          {a(0, 0), a(0, 1), a(0, 2), a(1, 0), a(1, 1), a(1, 2), a(2, 0), a(2, 1), a(2, 2)},
          plain(frame.velocity),
          plain(frame.spin)};
}

mechanisms::SimbodySpatialProblem problem_of(const SpatialScene& scene, const FilmChange& change) {
  const SpatialSliderCrankParts parts(scene);
  const auto& guide = constraint_of<CylindricalJoint<double>>(scene, "guide");
  const auto& faces = constraint_of<PlanarJoint<double>>(scene, "thrust-faces");
  const SpatialSceneJoint& pin = scene.joints[0];
  const std::vector<double> start = prepare_spatial(scene).start;
  const auto film =
      mechanisms::simbody_film(Bearing<double>(pin.plane.length, pin.plane.journal_radius, pin.plane.clearance),
                               Lubricant<double>(pin.plane.viscosity));
  return {body_at_start(scene, start, parts.crank_pin.first.body),
          body_at_start(scene, start, pin.bearing.body),
          body_at_start(scene, start, pin.journal.body),
          plain(scene.gravity),
          plain(parts.main_bearing.first),
          plain(parts.main_bearing.second),
          plain(parts.crank_pin.first.point),
          plain(parts.crank_pin.second.point),
          plain(guide.first),
          plain(guide.second),
          plain(faces.first),
          plain(faces.second),
          plain(pin.bearing.point),
          plain(pin.bearing.axis),
          plain(pin.journal.point),
          plain(pin.journal.axis),
          change ? change(film) : film};
}

class SimbodySpatialCase final : public BenchCase {
 public:
  SimbodySpatialCase(const SpatialScene& scene, std::vector<double> times, Reference reference,
                     const FilmChange& change)
      : engine_(problem_of(scene, change)),
        in_plane_(scene),
        duration_(scene.run.duration),
        times_(std::move(times)),
        reference_(std::move(reference)) {}

  std::string formulation() const override { return "joint"; }
  std::vector<std::string> methods() const override { return {"simbody_cpodes"}; }

  MethodRun run(const std::string&, double tolerance, const BenchLimits& given) override {
    const BenchLimits limits{given.repeats, patience * given.seconds, given.pace};
    return measured_run(limits, reference_, [&](Reference* seen) {
      const auto run = engine_.run(tolerance, duration_, seen ? times_ : std::vector<double>(), limits.seconds);
      if (seen) {
        for (const SimbodyFilm& film : run.pins)
          seen->push_back(in_plane_(vector(film.axis), vector(film.eccentricity)));
      }
      return method_run(run);
    });
  }

 private:
  static constexpr double patience = 10;  ///< times a run's share: else nothing would be known of it

  mechanisms::SimbodySpatialEngine engine_;
  PinInPlane in_plane_;
  double duration_;
  std::vector<double> times_;
  Reference reference_;
};

}  // namespace

std::unique_ptr<BenchCase> simbody_spatial_case(const SpatialScene& scene, const std::vector<double>& times,
                                                const Reference& reference, const FilmChange& change) {
  return std::make_unique<SimbodySpatialCase>(scene, times, reference, change);
}

}  // namespace lubjoint::reports
