#include "oracle/paper/example_2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/paper/slider_crank_checks.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::size_t samples_per_turn = 720;

/// A scene with fine tolerances, whole revolutions, and samples at the same crank angles in each.
Scene prepared(const std::filesystem::path& file) {
  Scene scene = load_scene(file);
  scene.run.relative_tolerance = scene.run.absolute_tolerance = run_tolerance;
  scene.run.output_interval = two_pi / crank_speed_of(scene) / static_cast<double>(samples_per_turn);
  scene.energy_ledger = true;
  return scene;
}

Vector2<double> ratio_of(const Example2Case& item, const MultibodySample& sample) {
  return sample.joints[0].eccentricity / item.scene.joints[0].clearance;
}

std::vector<double> times_of(const MultibodyTrajectory& run) {
  std::vector<double> times;
  for (const MultibodySample& sample : run.samples) times.push_back(sample.t);
  return times;
}

Example2Case run_case(Scene scene) {
  Example2Case item;
  item.scene = std::move(scene);
  item.run = simulate_multibody(item.scene);
  item.verdict.checks = compare_with_minimal_coordinates(
      item.scene, item.run, minimal_coordinates_run_with_peaks(item.scene, times_of(item.run), 1e-12));
  item.verdict.checks.push_back(energy_check(item.run, run_tolerance));
  for (std::size_t i = samples_per_turn; i < item.run.samples.size(); ++i) {
    const Vector2<double> change =
        ratio_of(item, item.run.samples[i]) - ratio_of(item, item.run.samples[i - samples_per_turn]);
    item.repeat_difference = std::max(item.repeat_difference, change.norm());
  }
  Scene swapped = item.scene;
  std::swap(swapped.joints[0].bearing, swapped.joints[0].journal);
  swapped.run.relative_tolerance = swapped.run.absolute_tolerance = 1e-8;
  swapped.energy_ledger = false;
  const MultibodyTrajectory other = simulate_multibody(swapped);
  for (std::size_t i = 0; i < std::min(other.samples.size(), item.run.samples.size()); ++i) {
    item.swapped_ratio = std::max(item.swapped_ratio, std::abs(other.samples[i].joints[0].eccentricity_ratio -
                                                               item.run.samples[i].joints[0].eccentricity_ratio));
  }
  item.swapped_force = other.joints[0].force.value;
  item.verdict.checks.push_back(
      swapped_check(swapped, other, minimal_coordinates_run_with_peaks(swapped, times_of(other), 1e-10)));
  item.orbit = periodic_orbit(item.scene, ratio_of(item, item.run.samples.back()));
  return item;
}

/// Largest value of a function of the crank angle over a turn.
template <class Function>
double largest_over_turn(const Function& f) {
  double best = 0;
  const double step = two_pi / 360;
  for (int i = 0; i < 360; ++i) {
    if (f(i * step) < best) continue;
    const auto found =
        boost::math::tools::brent_find_minima([&](double a) { return -f(a); }, (i - 1) * step, (i + 1) * step, 40);
    best = std::max(best, -found.second);
  }
  return best;
}

void run_ideal(const std::filesystem::path& scenes, Example2& example) {
  const Scene scene = prepared(scenes / "slider-crank-ideal.toml");
  example.ideal = simulate_multibody(scene);
  const auto mechanism = slider_crank_of(scene);
  const double speed = crank_speed_of(scene);
  const auto closed = [&](double angle) { return mechanisms::ideal_reactions<double>(mechanism, {angle, speed, 0}); };
  example.ideal_force = largest_over_turn([&](double a) { return closed(a).gudgeon_pin.norm(); });
  example.ideal_moment = largest_over_turn([&](double a) { return std::abs(closed(a).driving_moment); });

  const PlanarSystem<double> system = planar_system<double>(scene);
  SystemWorkspace<double> w = system.workspace<double>();
  std::size_t pin = 0;
  while (system.constraints()[pin].name != "gudgeon-pin") ++pin;
  double force_difference = 0;
  double moment_difference = 0;
  for (const MultibodySample& sample : example.ideal.samples) {
    system.evaluate(sample.t, sample.state.data(), {}, w);
    const auto expected = closed(speed * sample.t);
    const auto force = system.reaction_on_second(pin, w);
    const double force_error = std::hypot(force[0] - expected.gudgeon_pin.x(), force[1] - expected.gudgeon_pin.y());
    const double moment_error = std::abs(sample.driving_moments[0] - expected.driving_moment);
    force_difference = std::max(force_difference, force_error / example.ideal_force);
    moment_difference = std::max(moment_difference, moment_error / example.ideal_moment);
  }
  std::vector<Check>& checks = example.ideal_verdict.checks;
  const char* closed_form = "the closed form at every output time";
  const char* reason = "ten times the tolerance of a step, which holds the constraints";
  checks.push_back(
      Check::at_most("gudgeon pin's force", closed_form, force_difference, 10 * run_tolerance, "of its peak", reason));
  checks.push_back(
      Check::at_most("driving moment", closed_form, moment_difference, 10 * run_tolerance, "of its peak", reason));
  checks.push_back(energy_check(example.ideal, run_tolerance));

  Scene torque = load_scene(scenes / "slider-crank-torque.toml");
  torque.run.relative_tolerance = torque.run.absolute_tolerance = run_tolerance;
  const MultibodyTrajectory run = simulate_multibody(torque);
  const std::size_t n = 3 * torque.bodies.size();
  const double last_work = torque.loads[0].moment * run.samples.back().state[2];
  const bool ended = run.outcome.status == RunStatus::finished;
  double torque_difference = ended ? 0 : std::numeric_limits<double>::infinity();
  for (const MultibodySample& sample : run.samples) {
    const double angle = sample.state[2];
    const double speed_now = sample.state[n + 2];
    const double kinetic = effective_inertia(mechanism, angle) * speed_now * speed_now / 2;
    torque_difference = std::max(torque_difference, std::abs(kinetic - torque.loads[0].moment * angle) / last_work);
  }
  checks.push_back(Check::at_most("energy under a constant torque", "I_eff(angle) spin^2/2 = M angle",
                                  torque_difference, 100 * run_tolerance, "of the work",
                                  "a hundred times the tolerance of a step"));
}

}  // namespace

std::vector<const Verdict*> Example2::verdicts() const {
  std::vector<const Verdict*> all;
  for (const Example2Case& item : cases) all.push_back(&item.verdict);
  return all;
}

bool Example2::passed() const {
  return ideal_verdict.agrees() &&
         std::all_of(cases.begin(), cases.end(), [](const auto& item) { return item.verdict.agrees(); });
}

Example2 run_example_2(const std::filesystem::path& scenes) {
  Example2 example;
  run_ideal(scenes, example);
  const std::array<const char*, 5> names = {"slider-crank", "slider-crank-c0.5-mu0.4", "slider-crank-c0.1-mu0.4",
                                            "slider-crank-c0.5-mu0.04", "slider-crank-c0.2-mu0.04"};
  example.cases.resize(names.size());
  run_parallel(names.size(), available_cores(), [&](std::size_t i) {
    example.cases[i] = run_case(prepared(scenes / (std::string(names[i]) + ".toml")));
  });
  return example;
}

std::string example_2_table(const Example2& example) {
  std::string text = fmt::format(
      "Example 2: slider-crank with a lubricated gudgeon pin, pinkus_sternlicht\n\n"
      "ideal joints: peak force {:.2f} N, driving moment +-{:.2f} N m; agreement: {}\n{}\n",
      example.ideal_force, example.ideal_moment, example.ideal_verdict.in_letters(),
      check_legend({&example.ideal_verdict}));
  const auto heading = [&text](const std::array<const char*, 12>& words, const char* last) {
    constexpr std::array<int, 12> widths{5, 7, 10, 8, 9, 9, 9, 10, 10, 12, 11, 9};
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) line += fmt::format("{:>{}} ", words[i], widths[i]);
    text += (*last ? line + " " + last : line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
  };
  heading({"", "", "", "", "", "", "", "change of", "left of a", "change of e", "force with", "end off"}, "agreement:");
  heading({"", "vis-", "largest", "least", "largest", "largest", "least", "e, turn 1", "deviation", "with bearing",
           "bearing on", "periodic"},
          "checks that");
  heading(
      {"c", "cosity", "e/c", "film", "force", "moment", "moment", "to 2", "each turn", "on slider", "slider", "orbit"},
      "passed");
  heading({"[mm]", "[Pa s]", "[-]", "[um]", "[N]", "[N m]", "[N m]", "[c]", "[-]", "[c]", "[N]", "[c]"}, "");
  for (const Example2Case& item : example.cases) {
    const SceneJoint& joint = item.scene.joints[0];
    const JointExtremes& peak = item.run.joints[0];
    const double film = joint.clearance - peak.eccentricity.value;
    text += fmt::format(
        "{:>5} {:>7} {:>10.6f} {:>8.3f} {:>9.2f} {:>9.3f} {:>9.3f} {:>10.1e} {:>10.1e} {:>12.1e} {:>11.2f} {:>9.1e}  "
        "{}\n",
        1e3 * joint.clearance, joint.viscosity, peak.eccentricity.value / joint.clearance, 1e6 * film, peak.force.value,
        item.run.drivers[0].max_moment.value, item.run.drivers[0].min_moment.value, item.repeat_difference,
        std::abs(item.orbit.multipliers[0]), item.swapped_ratio, item.swapped_force, item.orbit.distance,
        item.verdict.in_letters());
  }
  text +=
      "\nExtremes are of both revolutions; a safe film is 3 um (0.00015 mm per mm of diameter). Changes of e are the\n"
      "largest of a turn. Left of a deviation: from the periodic orbit, in minimal coordinates (not judged). Bearing "
      "on\n"
      "slider: with bearing and journal on each other's bodies. End: the last e of the run (not judged).\n\n"
      "agreement: a letter for each check that passed, a dash for each that was not made. Minimal coordinates: rod\n"
      "angle and slider position, in extended precision by Fehlberg 7(8); they share the force law alone.\n" +
      check_legend(example.verdicts());
  return text;
}

std::string example_2_csv(const Example2& example) {
  std::string csv =
      "scene,clearance,viscosity,max_ratio,min_film,t_min_film,max_force,t_max_force,max_moment,min_moment,"
      "energy_residual,repeat_difference,orbit_residual,orbit_distance,multiplier_1,multiplier_2,swapped_ratio,"
      "swapped_force,checks_passed,checks_failed,checks_not_made,agrees\n";
  for (const Example2Case& item : example.cases) {
    const SceneJoint& joint = item.scene.joints[0];
    const JointExtremes& peak = item.run.joints[0];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", item.scene.name,
                       joint.clearance, joint.viscosity, peak.eccentricity.value / joint.clearance,
                       joint.clearance - peak.eccentricity.value, peak.eccentricity.t, peak.force.value, peak.force.t,
                       item.run.drivers[0].max_moment.value, item.run.drivers[0].min_moment.value,
                       *item.run.energy_residual, item.repeat_difference, item.orbit.residual, item.orbit.distance,
                       std::abs(item.orbit.multipliers[0]), std::abs(item.orbit.multipliers[1]), item.swapped_ratio,
                       item.swapped_force, item.verdict.count(CheckOutcome::passed),
                       item.verdict.count(CheckOutcome::failed), item.verdict.count(CheckOutcome::not_checked),
                       item.verdict.in_a_word());
  }
  return csv;
}

std::string example_2_checks_csv(const Example2& example) {
  std::vector<std::string> items{"slider-crank-ideal"};
  std::vector<const Verdict*> verdicts{&example.ideal_verdict};
  for (const Example2Case& item : example.cases) {
    items.push_back(item.scene.name);
    verdicts.push_back(&item.verdict);
  }
  return checks_csv(items, verdicts);
}

}  // namespace lubjoint::reports
