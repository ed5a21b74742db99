#include "oracle/reports/example_2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/multibody_report.hpp"
#include "oracle/reports/slider_crank_reference.hpp"

namespace lubjoint::reports {

namespace {

constexpr double two_pi = boost::math::constants::two_pi<double>();
constexpr std::size_t samples_per_turn = 720;
constexpr double tolerance = 1e-10;

/// A scene with fine tolerances, whole revolutions, and samples at the same crank angles in each.
Scene prepared(const std::filesystem::path& file) {
  Scene scene = load_scene(file);
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
  scene.run.output_interval = two_pi / crank_speed_of(scene) / static_cast<double>(samples_per_turn);
  scene.energy_ledger = true;
  return scene;
}

Vector2<double> ratio_of(const Example2Case& item, const MultibodySample& sample) {
  return sample.joints[0].eccentricity / item.scene.joints[0].clearance;
}

void check_energy(const MultibodyTrajectory& run, std::vector<std::string>& failures) {
  if (run.outcome.status != RunStatus::finished) failures.push_back(run.outcome.message);
  if (run.energy_residual && *run.energy_residual > 100 * tolerance * run.energy_scale) {
    failures.push_back(fmt::format("the energy ledger is open by {:.1e} J", *run.energy_residual));
  }
}

Example2Case run_case(Scene scene, double ideal_moment) {
  Example2Case item;
  item.scene = std::move(scene);
  item.run = simulate_multibody(item.scene);
  check_energy(item.run, item.failures);
  std::vector<double> times;
  for (const MultibodySample& sample : item.run.samples) times.push_back(sample.t);
  const std::vector<ReferenceSample> reference = minimal_coordinates_run(item.scene, times, 1e-12);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const MultibodySample& sample = item.run.samples[i];
    item.oracle_difference =
        std::max(item.oracle_difference, (ratio_of(item, sample) - reference[i].eccentricity_ratio).norm());
    item.moment_difference = std::max(item.moment_difference,
                                      std::abs(sample.driving_moments[0] - reference[i].driving_moment) / ideal_moment);
    if (i >= samples_per_turn) {
      const MultibodySample& before = item.run.samples[i - samples_per_turn];
      item.repeat_difference =
          std::max(item.repeat_difference, (ratio_of(item, sample) - ratio_of(item, before)).norm());
    }
  }
  if (item.oracle_difference > 1e-8) {
    item.failures.push_back(fmt::format("minimal coordinates differ by {:.1e} clearances", item.oracle_difference));
  }
  Scene swapped = item.scene;
  std::swap(swapped.joints[0].bearing, swapped.joints[0].journal);
  swapped.run.relative_tolerance = swapped.run.absolute_tolerance = 1e-8;
  swapped.energy_ledger = false;
  const MultibodyTrajectory other = simulate_multibody(swapped);
  for (std::size_t i = 0; i < std::min(other.samples.size(), times.size()); ++i) {
    item.swapped_ratio = std::max(item.swapped_ratio, std::abs(other.samples[i].joints[0].eccentricity_ratio -
                                                               item.run.samples[i].joints[0].eccentricity_ratio));
  }
  item.swapped_force = other.joints[0].force.value;
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
  check_energy(example.ideal, example.failures);
  const auto mechanism = slider_crank_of(scene);
  const double speed = crank_speed_of(scene);
  const auto closed = [&](double angle) { return mechanisms::ideal_reactions<double>(mechanism, {angle, speed, 0}); };
  example.ideal_force = largest_over_turn([&](double a) { return closed(a).gudgeon_pin.norm(); });
  example.ideal_moment = largest_over_turn([&](double a) { return std::abs(closed(a).driving_moment); });

  const PlanarSystem<double> system = planar_system<double>(scene);
  SystemWorkspace<double> w = system.workspace<double>();
  std::size_t pin = 0;
  while (system.constraints()[pin].name != "gudgeon-pin") ++pin;
  for (const MultibodySample& sample : example.ideal.samples) {
    system.evaluate(sample.t, sample.state.data(), {}, w);
    const auto expected = closed(speed * sample.t);
    const auto force = system.reaction_on_second(pin, w);
    const double force_error = std::hypot(force[0] - expected.gudgeon_pin.x(), force[1] - expected.gudgeon_pin.y());
    const double moment_error = std::abs(sample.driving_moments[0] - expected.driving_moment);
    example.reaction_difference =
        std::max({example.reaction_difference, force_error / example.ideal_force, moment_error / example.ideal_moment});
  }
  if (example.reaction_difference > 1e-9) {
    example.failures.push_back(fmt::format("ideal reactions differ by {:.1e}", example.reaction_difference));
  }

  Scene torque = load_scene(scenes / "slider-crank-torque.toml");
  torque.run.relative_tolerance = torque.run.absolute_tolerance = tolerance;
  const MultibodyTrajectory run = simulate_multibody(torque);
  check_energy(run, example.failures);
  const std::size_t n = 3 * torque.bodies.size();
  const double last_work = torque.loads[0].moment * run.samples.back().state[2];
  for (const MultibodySample& sample : run.samples) {
    const double angle = sample.state[2];
    const double speed_now = sample.state[n + 2];
    const double kinetic = effective_inertia(mechanism, angle) * speed_now * speed_now / 2;
    example.torque_difference =
        std::max(example.torque_difference, std::abs(kinetic - torque.loads[0].moment * angle) / last_work);
  }
  if (example.torque_difference > 100 * tolerance) {
    example.failures.push_back(fmt::format("torque-driven energy differs by {:.1e}", example.torque_difference));
  }
}

}  // namespace

bool Example2::passed() const {
  return failures.empty() &&
         std::all_of(cases.begin(), cases.end(), [](const auto& item) { return item.failures.empty(); });
}

Example2 run_example_2(const std::filesystem::path& scenes) {
  Example2 example;
  run_ideal(scenes, example);
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.4", "slider-crank-c0.1-mu0.4",
                           "slider-crank-c0.5-mu0.04", "slider-crank-c0.2-mu0.04"}) {
    example.cases.push_back(run_case(prepared(scenes / (std::string(name) + ".toml")), example.ideal_moment));
  }
  return example;
}

std::string example_2_table(const Example2& example) {
  const auto verdict = [](const std::vector<std::string>& failures) {
    if (failures.empty()) return std::string("yes");
    std::string text = "NO:";
    for (const std::string& failure : failures) text += " " + failure + ";";
    return text;
  };
  std::string text = fmt::format(
      "Example 2: slider-crank with a lubricated gudgeon pin, pinkus_sternlicht\n\n"
      "ideal joints: peak force {:.2f} N, driving moment +-{:.2f} N m; reactions differ from the closed form by "
      "{:.1e}, "
      "torque-driven energy by {:.1e}; agrees: {}\n\n"
      "{:>5} {:>6} {:>10} {:>8} {:>9} {:>9} {:>9} {:>10} {:>9} {:>9} {:>10} {:>9} {:>9} {:>10}  {}\n"
      "{:>5} {:>6} {:>10} {:>8} {:>9} {:>9} {:>9} {:>10} {:>9} {:>9} {:>10} {:>9} {:>9} {:>10}\n",
      example.ideal_force, example.ideal_moment, example.reaction_difference, example.torque_difference,
      verdict(example.failures), "c", "mu", "max e/c", "film", "force", "M max", "M min", "minimal", "energy",
      "2nd-1st", "multiplier", "swapped", "swapped", "orbit", "agrees", "[mm]", "[Pa s]", "[-]", "[um]", "[N]", "[N m]",
      "[N m]", "coord. [-]", "[J]", "[-]", "[-]", "[-]", "[N]", "[-]");
  for (const Example2Case& item : example.cases) {
    const SceneJoint& joint = item.scene.joints[0];
    const JointExtremes& peak = item.run.joints[0];
    const double film = joint.clearance - peak.eccentricity.value;
    text += fmt::format(
        "{:>5} {:>6} {:>10.6f} {:>8.3f} {:>9.2f} {:>9.3f} {:>9.3f} {:>10.1e} {:>9.1e} {:>9.1e} {:>10.1e} {:>9.1e} "
        "{:>9.2f} {:>10.1e}  {}\n",
        1e3 * joint.clearance, joint.viscosity, peak.eccentricity.value / joint.clearance, 1e6 * film, peak.force.value,
        item.run.drivers[0].max_moment.value, item.run.drivers[0].min_moment.value, item.oracle_difference,
        *item.run.energy_residual, item.repeat_difference, std::abs(item.orbit.multipliers[0]), item.swapped_ratio,
        item.swapped_force, item.orbit.distance, verdict(item.failures));
  }
  text +=
      "\nfilm: the least over two revolutions; safe is 3 um (0.00015 mm per mm of diameter). minimal coord.: largest\n"
      "|de|/c to minimal coordinates. energy: largest gap of the ledger. 2nd-1st: largest |de|/c of the second\n"
      "revolution to the first. multiplier: what is left of a deviation from the periodic orbit after a revolution.\n"
      "swapped: change of e/c, and the peak force, with the bearing on the slider. orbit: |de|/c of the last state to\n"
      "the periodic orbit.\n";
  return text;
}

std::string example_2_csv(const Example2& example) {
  std::string csv =
      "scene,clearance,viscosity,max_ratio,min_film,max_force,max_moment,min_moment,oracle_difference,"
      "moment_difference,energy_residual,repeat_difference,orbit_residual,orbit_distance,multiplier_1,multiplier_2,"
      "swapped_ratio,swapped_force,agrees\n";
  for (const Example2Case& item : example.cases) {
    const SceneJoint& joint = item.scene.joints[0];
    const JointExtremes& peak = item.run.joints[0];
    csv += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", item.scene.name, joint.clearance, joint.viscosity,
        peak.eccentricity.value / joint.clearance, joint.clearance - peak.eccentricity.value, peak.force.value,
        item.run.drivers[0].max_moment.value, item.run.drivers[0].min_moment.value, item.oracle_difference,
        item.moment_difference, *item.run.energy_residual, item.repeat_difference, item.orbit.residual,
        item.orbit.distance, std::abs(item.orbit.multipliers[0]), std::abs(item.orbit.multipliers[1]),
        item.swapped_ratio, item.swapped_force, item.failures.empty() ? "yes" : "no");
  }
  return csv;
}

}  // namespace lubjoint::reports
