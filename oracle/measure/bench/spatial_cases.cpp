#include "oracle/measure/bench/spatial_cases.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/motion/spatial_interpolant.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/explicit_integrators.hpp"
#include "lubjoint/ode/radau_integrator.hpp"
#include "lubjoint/scene/spatial_coordinates.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/measure/bench/race.hpp"
#include "oracle/measure/bench/simbody_space.hpp"
#include "oracle/measure/bench/spatial_reference.hpp"
#include "oracle/trajectories/embedded_scene.hpp"
#include "oracle/trajectories/spatial_slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

/// Crank angle, rod angle, slider position, and their rates.
class SpatialMinimalProblem final : public RaceProblem<6> {
 public:
  explicit SpatialMinimalProblem(const SpatialScene& scene)
      : mechanism_(lubricated_spatial_slider_crank<PinkusSternlicht, double>(scene)),
        start_(mechanism_.start(crank_angle_of(scene), crank_speed_of(scene))),
        units_(scene_units(scene)) {}

  void rate(const State& y, State& dydt, const double& t) override {
    ++evaluations_;
    mechanism_.rate(t, y, dydt);
  }
  void jacobian(const State& y, Jacobian& j, const double& t) override {
    exact_jacobian([this, t](const auto& x, auto& dxdt) { mechanism_.rate(t, x, dxdt); }, y, j);
  }
  void time_slope(const State&, State& slope, const double&) override { slope.fill(0); }
  State start() const override { return start_; }
  StepTolerance<double, 6> tolerance(double relative) const override {
    const double length = relative * units_.length;
    const double angle = relative * units_.angle;
    return {0, {angle, angle, length, angle * units_.rate, angle * units_.rate, length * units_.rate}, relative};
  }
  std::vector<std::string> own_methods() const override { return {"radau_iia5", "dopri5", "fehlberg78"}; }
  std::unique_ptr<Integrator<double, 6>> integrator(const std::string& method, double relative) override {
    if (method == "dopri5") return std::make_unique<Dopri5Integrator<double, 6>>(tolerance(relative));
    if (method == "fehlberg78") return std::make_unique<Fehlberg78Integrator<double, 6>>(tolerance(relative));
    return std::make_unique<RadauIntegrator<double, 6, 3>>(tolerance(relative));
  }
  bool is_admissible(double, const State& y) override {
    if (!std::all_of(y.begin(), y.end(), [](double each) { return std::isfinite(each); })) return false;
    const auto e = mechanism_.eccentricity(y);
    return one_minus_squared_norm(e[0], e[1]) > 0;
  }
  void look(double, const State& y, Reference& seen) override {
    const auto e = mechanism_.eccentricity(y);
    seen.emplace_back(e[0], e[1]);
  }
  std::size_t positions() const override { return 3; }
  std::size_t evaluations() const override { return evaluations_; }

 private:
  mechanisms::LubricatedSpatialSliderCrank<PinkusSternlicht, double> mechanism_;
  State start_;
  SceneUnits units_;
  std::size_t evaluations_ = 0;
};

/// Bodies in space, their constraints kept by the accelerations.
class SpatialProblem : public RaceProblem<run_time_size> {
 public:
  /// e/c of the first joint, in a plane.
  using InPlane = std::function<Vector2<double>(const SpatialJointKinematics<double>&)>;

  SpatialProblem(const SpatialScene& scene, InPlane in_plane, std::vector<std::string> methods)
      : scene_(scene),
        in_plane_(std::move(in_plane)),
        methods_(std::move(methods)),
        prepared_(prepare_spatial(scene)),
        ode_(prepared_.system, false) {
    scene_.energy_ledger = false;
  }

  void rate(const State& y, State& dydt, const double& t) override { ode_.rate(y, dydt, t); }
  void jacobian(const State& y, Jacobian& j, const double& t) override { ode_.jacobian(y, j, t); }
  void time_slope(const State& y, State& slope, const double& t) override { ode_.time_slope(y, slope, t); }
  State start() const override { return prepared_.start; }
  StepTolerance<double, run_time_size> tolerance(double relative) const override {
    return {0, scene_tolerances(scene_at(relative)), relative};
  }
  std::vector<std::string> own_methods() const override { return methods_; }
  std::unique_ptr<Integrator<double, run_time_size>> integrator(const std::string& method, double relative) override {
    norm_error_ = relative * scene_units(scene_).angle / 20;  // as simulate allows
    return RaceProblem::integrator(method, relative);
  }
  bool is_admissible(double, const State& y) override {
    if (!std::all_of(y.begin(), y.end(), [](double each) { return std::isfinite(each); })) return false;
    const Vector2<double> e = kinematics(y).motion.eccentricity / scene_.joints[0].plane.clearance;
    return one_minus_squared_norm(e.x(), e.y()) > 0;
  }
  void look(double, const State& y, Reference& seen) override { seen.push_back(in_plane_(kinematics(y))); }
  std::size_t positions() const override { return prepared_.system.places(); }
  std::size_t evaluations() const override { return ode_.evaluations(); }
  void state_at(const StepInterpolant<State>& step, double t, State& inside) override {
    spatial_state_at(step, scene_.bodies.size(), t, inside);
  }
  /// Euler parameters of norm 1, as a run keeps them.
  bool hold(State& y) override {
    bool changed = false;
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      Eigen::Map<EulerParameters<double>> p(&y[spatial_coordinates * b + 3]);
      const double size = p.norm();
      if (!(std::abs(size - 1) > norm_error_)) continue;
      p /= size;
      changed = true;
    }
    return changed;
  }
  /// Others' solvers would be given systems of another form.
  bool is_for_others() const override { return false; }

 protected:
  SpatialScene scene_at(double relative) const {
    SpatialScene scene = scene_;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = relative;
    return scene;
  }
  SpatialOde<double>& ode() { return ode_; }

 private:
  SpatialJointKinematics<double> kinematics(const State& y) const {
    const SpatialJointElement<double>& joint = prepared_.system.joints().front();
    const auto frame = [&](std::size_t body) {
      if (body == ground_body) return spatial_ground_frame<double>();
      return SpatialFrame<double>(spatial_motion_in(y.data(), scene_.bodies.size(), body));
    };
    return joint.kinematics(frame(joint.bearing_at.body), frame(joint.journal_at.body));
  }

  SpatialScene scene_;
  InPlane in_plane_;
  std::vector<std::string> methods_;
  PreparedSpatialScene prepared_;
  SpatialOde<double> ode_;
  double norm_error_ = 0;
};

/// The same bodies, stepped in the coordinates that their constraints leave free.
class IndependentSpatialProblem final : public SpatialProblem {
 public:
  using SpatialProblem::SpatialProblem;

  std::unique_ptr<Integrator<double, run_time_size>> integrator(const std::string& method, double relative) override {
    const SpatialScene scene = scene_at(relative);
    return independent_method(method, scene, ode(), scene.run, scene_tolerances(scene));
  }
  bool hold(State&) override { return false; }  // they are held to rounding
};

/// In absolute coordinates, or in independent ones.
template <class Problem>
std::unique_ptr<BenchCase> case_of(const std::string& formulation, const SpatialScene& scene,
                                   const std::vector<double>& times, const Reference& reference) {
  const auto in_plane = [in_it = PinInPlane(scene)](const SpatialJointKinematics<double>& k) {
    return in_it(k.axis, k.in_space(k.motion.eccentricity));
  };
  const std::vector<std::string> all(method_names().begin(), method_names().end());
  return std::make_unique<RaceCase<run_time_size>>(formulation, std::make_unique<Problem>(scene, in_plane, all),
                                                   scene.run.duration, times, reference);
}

}  // namespace

std::unique_ptr<BenchCase> embedded_case(const Scene& flat, const std::vector<double>& times,
                                         const Reference& reference) {
  const Plane plane = some_plane(3);
  SpatialScene scene = Embedding(plane).scene(flat);
  allow_what_is_redundant(scene);
  const auto in_plane = [turn = rotation_matrix(plane.orientation),
                         c = flat.joints.at(0).clearance](const SpatialJointKinematics<double>& k) {
    const Vector3<double> e = transposed_product(turn, k.in_space(k.motion.eccentricity));
    return Vector2<double>(e.x() / c, e.y() / c);
  };
  return std::make_unique<RaceCase<run_time_size>>(
      "embedded", std::make_unique<IndependentSpatialProblem>(scene, in_plane, std::vector<std::string>{"radau_iia5"}),
      scene.run.duration, times, reference);
}

BenchScene bench_scene(const SpatialScene& scene) {
  const SpatialReference reference = spatial_reference(scene, bench_times(scene.run.duration));
  BenchScene result;
  result.name = scene.name;
  result.reference_agreement = reference.agreement;
  result.cases.push_back(std::make_unique<RaceCase<6>>("minimal", std::make_unique<SpatialMinimalProblem>(scene),
                                                       scene.run.duration, reference.times, reference.seen));
  result.cases.push_back(case_of<SpatialProblem>("absolute", scene, reference.times, reference.seen));
  result.cases.push_back(case_of<IndependentSpatialProblem>("independent", scene, reference.times, reference.seen));
  if (auto simbody = simbody_spatial_case(scene, reference.times, reference.seen))
    result.cases.push_back(std::move(simbody));
  return result;
}

}  // namespace lubjoint::reports
