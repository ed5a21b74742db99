#include "oracle/trajectories/extended_run.hpp"

#include <stdexcept>

#include "lubjoint/motion/multibody_run.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/explicit_integrators.hpp"
#include "lubjoint/ode/radau_integrator.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/multibody_scene.hpp"

namespace lubjoint::reports {

namespace {

using Real = long double;

template <std::size_t N>
std::unique_ptr<Integrator<Real, N>> integrator_of(ExtendedMethod method, const StepTolerance<Real, N>& tolerance) {
  if (method == ExtendedMethod::radau) return std::make_unique<RadauIntegrator<Real, N, 3>>(tolerance);
  return std::make_unique<Fehlberg78Integrator<Real, N>>(tolerance);
}

/// A free journal on any law. Each would make an equation of its own; the law is chosen where it runs, and has the bits
/// that it has alone.
class ExtendedJournal final : public OdeSystem<Real, 4> {
 public:
  explicit ExtendedJournal(const JournalScene& p)
      : journal_(film_of<ChosenLaw, Real>(p.law,
                                          Bearing<Real>(p.bearing.length(), p.bearing.radius(), p.bearing.clearance()),
                                          Lubricant<Real>(p.oil.viscosity()), p.table.get()),
                 {p.drive.mass, p.drive.load.template cast<Real>(), p.drive.bearing_spin, p.drive.journal_spin}) {}
  void rate(const State& y, State& dydt, const Real&) override { journal_.rate(y, dydt); }
  void jacobian(const State& y, Jacobian& j, const Real&) override {
    exact_jacobian([this](const auto& x, auto& dxdt) { journal_.rate(x, dxdt); }, y, j);
  }
  void time_slope(const State&, State& slope, const Real&) override { slope.fill(0); }

 private:
  FreeJournal<ChosenLaw, Real> journal_;
};

}  // namespace

double extended_tolerance(ExtendedMethod method) {
  // Radau's estimate is of order 3: it asks for more of a tolerance than the explicit pair's of order 8.
  return method == ExtendedMethod::radau ? 1e-14 : 1e-15;
}

Reference extended_journal_run(const Scene& scene, const std::vector<double>& times, ExtendedMethod method) {
  const std::string& law = scene.joints[0].film;
  if (with_film_law<NamedFilmLaws>(law, []<class Law>() { return JumpingLaw<Law>; })) {
    throw std::invalid_argument(law + ": allowed here are laws without a jump");
  }
  const JournalScene parts = journal_scene(scene);
  ExtendedJournal system(parts);
  const Real tolerance(extended_tolerance(method));
  const Real velocity = tolerance * 1000;  // rates of ê reach thousands a second
  const auto integrator = integrator_of<4>(method, {tolerance, {tolerance, tolerance, velocity, velocity}, tolerance});
  std::array<Real, 4> y{parts.start[0], parts.start[1], parts.start[2], parts.start[3]};
  Real t = 0;
  Real dt = Real(1e-9) * scene.run.duration;
  Reference seen;
  for (const double time : times) {
    while (t < time) {
      const Real wanted = dt;
      const bool last = t + dt >= time;
      if (last) dt = time - t;
      if (!integrator->try_step(system, y, t, dt) || !last) continue;
      t = time;
      dt = std::max(dt, wanted);
    }
    seen.emplace_back(static_cast<double>(y[0]), static_cast<double>(y[1]));
  }
  return seen;
}

ExtendedRun extended_multibody_run(const Scene& given, double output_interval, ExtendedMethod method,
                                   double tolerance) {
  Scene scene = given;
  scene.energy_ledger = false;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
  scene.run.output_interval = output_interval;
  scene.run.stop_at_outputs = true;
  const PlanarSystem<Real> system = planar_system<Real>(scene);
  std::vector<Real> start = scene_start<Real>(scene);
  assemble_start<Real>(system, Real(0), Real(scene_units(scene).mechanism), start);
  MultibodyOde<Real> ode(system, false);
  const Real nominal(scene.run.relative_tolerance);
  MultibodyRun<Real> run(
      ode, scene.run, integrator_of<run_time_size>(method, {Real(0), scene_tolerances<Real>(scene), nominal}),
      scene.stabilisation.projection ? ConstraintUpkeep::by_projection : ConstraintUpkeep::by_accelerations);
  const RunOutcome outcome = run.run(start);
  if (outcome.status != RunStatus::finished) {
    throw std::runtime_error(scene.name + ": the reference in extended precision " + outcome.message);
  }
  return {start, run.recorder().samples()};
}

Reference looked_at(const Scene& scene, const std::vector<MultibodySample>& samples) {
  Reference seen;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    seen.push_back(samples[i].joints.empty()
                       ? looked_at_without_joints(scene, samples[i].state)
                       : Vector2<double>(samples[i].joints[0].eccentricity / scene.joints[0].clearance));
  }
  return seen;
}

Vector2<double> looked_at_without_joints(const Scene& scene, const std::vector<double>& y) {
  const std::size_t last = 3 * (scene.bodies.size() - 1);
  return Vector2<double>(y[last], y[last + 1]) / scene_units(scene).length;
}

}  // namespace lubjoint::reports
