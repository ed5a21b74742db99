#include <algorithm>
#include <cmath>

#include "lubjoint/joint/chosen_film.hpp"
#include "lubjoint/motion/journal_run.hpp"
#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/measure/bench/golden_reference.hpp"
#include "oracle/measure/bench/race.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/measure/bench/spatial_cases.hpp"
#include "oracle/trajectories/extended_run.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

// Three formulations as race problems.

/// Law: of law_list.hpp, or ChosenLaw.
template <class Law>
class JournalProblem final : public RaceProblem<4> {
 public:
  JournalProblem(const FreeJournal<Law>& journal, const State& start)
      : journal_(journal), start_(start), velocity_scale_(detail::rate_scale(journal)) {}

  void rate(const State& y, State& dydt, const double&) override {
    ++evaluations_;
    journal_.rate(y, dydt);
  }
  void jacobian(const State& y, Jacobian& j, const double&) override {
    exact_jacobian([this](const auto& x, auto& dxdt) { journal_.rate(x, dxdt); }, y, j);
  }
  void time_slope(const State&, State& slope, const double&) override { slope.fill(0); }
  void kinks(const State& y, const double&, std::vector<double>& values) override {
    values.clear();
    if (journal_.joint().kinks()) values.push_back(y[0] * y[2] + y[1] * y[3]);
  }
  State start() const override { return start_; }
  StepTolerance<double, 4> tolerance(double relative) const override {
    const double velocity = relative * velocity_scale_;
    return {relative, {relative, relative, velocity, velocity}, relative};
  }
  bool is_admissible(double, const State& y) override {
    return std::isfinite(y[2]) && std::isfinite(y[3]) && one_minus_squared_norm(y[0], y[1]) > 0;
  }
  void look(double, const State& y, Reference& seen) override { seen.emplace_back(y[0], y[1]); }
  std::size_t positions() const override { return 2; }
  std::size_t evaluations() const override { return evaluations_; }

 private:
  FreeJournal<Law> journal_;
  State start_;
  double velocity_scale_;
  std::size_t evaluations_ = 0;
};

/// Deviations of the rod's angle and the slider's position from the ideal mechanism, in clearances, and their rates.
class MinimalProblem final : public RaceProblem<4> {
 public:
  MinimalProblem(const Scene& scene)
      : mechanism_(lubricated_slider_crank<PinkusSternlicht, double>(scene)), speed_(crank_speed_of(scene)) {}

  void rate(const State& y, State& dydt, const double& t) override {
    ++evaluations_;
    evaluate(y, dydt, t);
  }
  void jacobian(const State& y, Jacobian& j, const double& t) override {
    exact_jacobian([this, t](const auto& x, auto& dxdt) { evaluate(x, dxdt, t); }, y, j);
  }
  void time_slope(const State& y, State& slope, const double& t) override {
    // Central differences of order 4 over ±1e-4 and ±2e-4 rad of the crank: 1e-11 of a rate, rounding included.
    const double h = 1e-4 / speed_;
    slope.fill(0);
    State near;
    for (const auto& [shift, weight] : {std::pair(1.0, 8.0), {-1.0, -8.0}, {2.0, -1.0}, {-2.0, 1.0}}) {
      rate(y, near, t + shift * h);
      for (std::size_t i = 0; i < 4; ++i) slope[i] += weight / (12 * h) * near[i];
    }
  }
  void kinks(const State& y, const double& t, std::vector<double>& values) override {
    const auto pin = mechanism_.pin(t, State{y[0], y[1], y[2] / speed_, y[3] / speed_});
    values.assign(1, dot(pin.eccentricity, pin.velocity));
  }
  State start() const override { return {0, 0, 0, 0}; }
  StepTolerance<double, 4> tolerance(double relative) const override {
    return {relative, {relative, relative, relative * speed_, relative * speed_}, relative};
  }
  bool is_admissible(double t, const State& y) override {
    for (const double each : y) {
      if (!std::isfinite(each)) return false;
    }
    const Vector2<double> e = mechanism_.eccentricity(t, y[0], y[1]);
    return one_minus_squared_norm(e.x(), e.y()) > 0;
  }
  void look(double t, const State& y, Reference& seen) override {
    seen.push_back(mechanism_.eccentricity(t, y[0], y[1]));
  }
  std::size_t positions() const override { return 2; }
  std::size_t evaluations() const override { return evaluations_; }

 private:
  /// The mechanism counts its rates in crank speeds; here they are per second, ẏ₀ = y₂.
  template <class T>
  void evaluate(const std::array<T, 4>& y, std::array<T, 4>& dydt, double t) const {
    const std::array<T, 4> scaled{y[0], y[1], T(y[2] / speed_), T(y[3] / speed_)};
    mechanism_.rate(scaled, dydt, t);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = T(dydt[2] * speed_);
    dydt[3] = T(dydt[3] * speed_);
  }

  mechanisms::LubricatedSliderCrank<PinkusSternlicht, double> mechanism_;
  double speed_;
  std::size_t evaluations_ = 0;
};

/// Mass centres over the mechanism's size, and angles.
void look_at_bodies(const std::vector<double>& y, double size, Reference& seen) {
  for (std::size_t i = 0; i < y.size() / 2; i += 3) {
    seen.emplace_back(y[i] / size, y[i + 1] / size);
    seen.emplace_back(y[i + 2], 0.0);
  }
}

class AbsoluteProblem : public RaceProblem<run_time_size> {
 public:
  explicit AbsoluteProblem(const Scene& scene)
      : scene_(scene),
        size_(scene_units(scene).mechanism),
        system_(planar_system<double>(scene)),
        ode_(system_, false),
        start_(scene_start<double>(scene)) {
    scene_.energy_ledger = false;
    assemble_start(system_, 0.0, size_, start_);
  }

  void rate(const State& y, State& dydt, const double& t) override { ode_.rate(y, dydt, t); }
  void jacobian(const State& y, Jacobian& j, const double& t) override { ode_.jacobian(y, j, t); }
  void time_slope(const State& y, State& slope, const double& t) override { ode_.time_slope(y, slope, t); }
  State start() const override { return start_; }
  StepTolerance<double, run_time_size> tolerance(double relative) const override {
    return {0, scene_tolerances<double>(scene_at(relative)), relative};
  }
  bool is_admissible(double, const State& y) override {
    for (const double each : y) {
      if (!std::isfinite(each)) return false;
    }
    for (const JointElement<double>& joint : system_.joints()) {
      const Vector2<double> e = eccentricity_of(joint, y);
      if (joint.film && !(one_minus_squared_norm(e.x(), e.y()) > 0)) return false;
    }
    return true;
  }
  void look(double, const State& y, Reference& seen) override {
    for (const JointElement<double>& joint : system_.joints()) seen.push_back(eccentricity_of(joint, y));
    if (system_.joints().empty()) look_at_bodies(y, size_, seen);
  }
  std::size_t positions() const override { return system_.coordinates(); }
  std::size_t evaluations() const override { return ode_.evaluations(); }

 protected:
  /// The scene at a tolerance.
  Scene scene_at(double relative) const {
    Scene scene = scene_;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = relative;
    return scene;
  }
  const PlanarSystem<double>& system() const { return system_; }
  MultibodyOde<double>& ode() { return ode_; }

 private:
  PlanarFrame<double> frame(std::size_t body, const State& y) const {
    if (body == ground_body) return PlanarFrame<double>(ground_motion<double>());
    return PlanarFrame<double>(
        PlanarMotion<double>{Vector2<double>(y[3 * body], y[3 * body + 1]), y[3 * body + 2], Vector2<double>(0, 0), 0});
  }
  Vector2<double> eccentricity_of(const JointElement<double>& joint, const State& y) const {
    return joint_kinematics(frame(joint.bearing_at.body, y), joint.bearing_at.point, frame(joint.journal_at.body, y),
                            joint.journal_at.point)
               .motion.eccentricity /
           joint.bearing.clearance();
  }

  Scene scene_;
  double size_;  ///< of the mechanism [m]
  PlanarSystem<double> system_;
  MultibodyOde<double> ode_;
  State start_;
};

/// The same bodies, stepped in the coordinates that their constraints leave free.
class IndependentProblem final : public AbsoluteProblem {
 public:
  using AbsoluteProblem::AbsoluteProblem;

  bool is_chosen() const { return choose_coordinates(scene_at(1e-6), system()).independent; }
  std::unique_ptr<Integrator<double, run_time_size>> integrator(const std::string& method, double relative) override {
    const Scene scene = scene_at(relative);
    return independent_method(method, scene, ode(), scene.run, scene_tolerances<double>(scene));
  }
  bool is_for_others() const override { return false; }
};

/// What errors are measured in at every sample after the start.
Reference seen_along(const Scene& scene, const std::vector<MultibodySample>& samples) {
  Reference seen;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    for (std::size_t j = 0; j < samples[i].joints.size(); ++j) {
      seen.emplace_back(samples[i].joints[j].eccentricity / scene.joints[j].clearance);
    }
    if (samples[i].joints.empty()) look_at_bodies(samples[i].state, scene_units(scene).mechanism, seen);
  }
  return seen;
}

/// Run as `simulate` does it, with events and records: for scenes with contact.
class SimulatedCase final : public BenchCase {
 public:
  SimulatedCase(const Scene& scene, double output_interval, Reference reference)
      : scene_(scene), reference_(std::move(reference)) {
    scene_.run.output_interval = output_interval;
  }
  std::string formulation() const override { return "absolute"; }
  std::vector<std::string> methods() const override { return {method_names().begin(), method_names().end()}; }
  MethodRun run(const std::string& method, double tolerance, const BenchLimits& limits) override {
    Scene scene = scene_;
    scene.integrator = method;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    scene.run.max_steps = 1'000'000;
    return measured_run(limits, reference_, [&](Reference* seen) {
      const double begin = mechanisms::processor_seconds();
      const MultibodyTrajectory run = simulate_multibody(scene);
      MethodRun result;
      result.seconds = mechanisms::processor_seconds() - begin;
      result.finished = run.outcome.status == RunStatus::finished;
      result.message = run.outcome.message;
      result.steps = run.outcome.steps;
      result.rejected = run.outcome.rejected_steps;
      result.rhs_evaluations = run.outcome.rhs_evaluations;
      result.jacobian_evaluations = run.outcome.jacobian_evaluations;
      result.factorisations = run.outcome.factorisations;
      if (seen) *seen = seen_along(scene, run.samples);
      return result;
    });
  }

 private:
  Scene scene_;
  Reference reference_;
};

double worst_difference(const Reference& one, const Reference& other) {
  double worst = 0;
  for (std::size_t i = 0; i < one.size(); ++i) worst = std::max(worst, (one[i] - other[i]).norm());
  return worst;
}

std::unique_ptr<BenchCase> journal_case(const Scene& scene, const std::vector<double>& times,
                                        const Reference& reference) {
  const JournalScene parts = journal_scene(scene);
  return with_film_law<NamedFilmLaws>(scene.joints[0].film, [&]<class Law>() -> std::unique_ptr<BenchCase> {
    if constexpr (JumpingLaw<Law>) {
      throw std::invalid_argument(std::string(Law::name) +
                                  ": its force jumps, and a race of steps alone has no events; allowed are laws "
                                  "without a jump, such as its dynamic film");
    } else {
      using Run = RunLaw<Law>;
      const FreeJournal<Run> journal(film_of<Run, double>(parts.law, parts.bearing, parts.oil, parts.table.get()),
                                     parts.drive);
      return std::make_unique<RaceCase<4>>("journal", std::make_unique<JournalProblem<Run>>(journal, parts.start),
                                           scene.run.duration, times, reference);
    }
  });
}

}  // namespace

std::vector<double> bench_times(double duration) {
  std::vector<double> times;
  constexpr int count = 100;
  for (int i = 1; i <= count; ++i) times.push_back(duration * i / count);
  return times;
}

namespace {

struct MadeReference {
  std::vector<double> times;
  Reference seen;
  double agreement;
  bool golden;
};

/// Of a scene that does not ship: two integrators of different families.
MadeReference extended_reference(const Scene& scene) {
  const std::vector<double> times = bench_times(scene.run.duration);
  if (is_free_journal(scene)) {
    const Reference one = extended_journal_run(scene, times, ExtendedMethod::radau);
    const Reference other = extended_journal_run(scene, times, ExtendedMethod::fehlberg);
    return {times, other, worst_difference(one, other), false};
  }
  const auto extended = [&](ExtendedMethod method) {
    return extended_multibody_run(scene, times.front(), method, extended_tolerance(method));
  };
  const ExtendedRun run = extended(ExtendedMethod::radau);
  const Reference one = seen_along(scene, run.samples);
  if (!has_minimal_coordinates(scene)) {
    const Reference other = seen_along(scene, extended(ExtendedMethod::fehlberg).samples);
    return {times, other, worst_difference(one, other), false};
  }
  std::vector<double> from_start{0};
  from_start.insert(from_start.end(), times.begin(), times.end());
  Reference other;
  for (const ReferenceSample& sample : minimal_coordinates_run(scene, from_start, 1e-16, run.start)) {
    other.push_back(sample.eccentricity_ratio);
  }
  other.erase(other.begin());
  return {times, other, worst_difference(one, other), false};
}

MadeReference reference_of(const Scene& scene) {
  if (auto golden = golden_reference(scene)) {
    return {std::move(golden->times), std::move(golden->seen), golden->disagreement, true};
  }
  return extended_reference(scene);
}

}  // namespace

BenchScene bench_scene(const Scene& scene) {
  const MadeReference reference = reference_of(scene);
  BenchScene result;
  result.name = scene.name;
  result.golden = reference.golden;
  result.reference_agreement = reference.agreement;
  if (is_free_journal(scene)) {
    result.cases.push_back(journal_case(scene, reference.times, reference.seen));
    return result;
  }
  if (has_contact(scene)) {
    result.cases.push_back(std::make_unique<SimulatedCase>(scene, reference.times.front(), reference.seen));
    return result;
  }
  const double duration = scene.run.duration;
  if (has_minimal_coordinates(scene)) {
    result.cases.push_back(std::make_unique<RaceCase<4>>("minimal", std::make_unique<MinimalProblem>(scene), duration,
                                                         reference.times, reference.seen));
  }
  result.cases.push_back(std::make_unique<RaceCase<run_time_size>>("absolute", std::make_unique<AbsoluteProblem>(scene),
                                                                   duration, reference.times, reference.seen));
  if (auto independent = std::make_unique<IndependentProblem>(scene); independent->is_chosen()) {
    result.cases.push_back(std::make_unique<RaceCase<run_time_size>>("independent", std::move(independent), duration,
                                                                     reference.times, reference.seen));
  }
  if (has_minimal_coordinates(scene)) {
    result.cases.push_back(embedded_case(scene, reference.times, reference.seen));
    if (auto simbody = simbody_case(scene, reference.times, reference.seen)) result.cases.push_back(std::move(simbody));
  }
  return result;
}

}  // namespace lubjoint::reports
