#include "oracle/measure/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/measure/measuring_sources.hpp"
#include "oracle/results/film_resolution.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* csv_header =
    "case,law,integrator,status,error,rate_error,force_error,over_expected,compared,seconds,steps,program,message\n";

/// Where a run was, and how it ended.
struct StressRun {
  RunOutcome outcome;
  std::vector<StressSample> samples;
  double seconds = 0;
  double thinnest_film = 1;  ///< in clearances
  std::string warning;       ///< of what its tolerance leaves open
  std::string fault;         ///< what no run may do; empty if it did not
};

void look_at(const StressSample& sample, bool may_touch, StressRun& run) {
  const auto fault = [&](const char* what) {
    if (run.fault.empty()) run.fault = fmt::format("{} at t = {} s", what, sample.t);
  };
  if (!sample.place.allFinite()) fault("eccentricity is not finite");
  if (!sample.rate.allFinite()) fault("velocity is not finite");
  if (!sample.force.allFinite()) fault("force is not finite");
  if (!may_touch && !(one_minus_squared_norm(sample.place.x(), sample.place.y()) > 0)) {
    fault("a sample lies beyond the wall");
  }
  if (!run.samples.empty() && !(sample.t > run.samples.back().t)) fault("samples are not in order");
  run.samples.push_back(sample);
}

StressRun run_journal(const Scene& scene) {
  StressRun run;
  const JournalTrajectory trajectory = simulate_journal(scene);
  run.outcome = trajectory.outcome;
  run.seconds = trajectory.wall_seconds;
  run.thinnest_film = thinnest_film(scene, trajectory);
  for (const JournalSample& sample : trajectory.samples) {
    const auto& y = sample.state;
    look_at({sample.t, {y[0], y[1]}, {y[2], y[3]}, sample.force}, false, run);
  }
  if (!std::isfinite(trajectory.max_force + trajectory.min_film_thickness)) run.fault = "an extreme is not finite";
  return run;
}

/// Velocity of a joint's point in a state q, q̇: that of its body's mass centre and ω × s.
Vector2<double> point_velocity(const SceneAnchor& anchor, const std::vector<double>& state) {
  const PlanarMotion<double> body = motion_in(state, anchor.body);
  const Vector2<double> arm = inertial_vector(body, anchor.point);
  return {body.velocity.x() - body.spin * arm.y(), body.velocity.y() + body.spin * arm.x()};
}

StressRun run_multibody(const Scene& scene) {
  StressRun run;
  const MultibodyTrajectory trajectory = simulate_multibody(scene);
  run.outcome = trajectory.outcome;
  run.seconds = trajectory.wall_seconds;
  run.thinnest_film = thinnest_film(scene, 0, trajectory);
  const SceneJoint& joint = scene.joints.front();
  for (const MultibodySample& sample : trajectory.samples) {
    const JointSample& at = sample.joints.front();
    const Vector2<double> velocity =
        point_velocity(joint.journal, sample.state) - point_velocity(joint.bearing, sample.state);
    look_at({sample.t, at.eccentricity / joint.clearance, velocity / joint.clearance, at.force},
            joint.contact.has_value(), run);
  }
  for (const JointExtremes& each : trajectory.joints) {
    if (!std::isfinite(each.force.value + each.eccentricity.value)) run.fault = "an extreme is not finite";
  }
  return run;
}

StressRun run_scene(const Scene& scene) {
  try {
    StressRun run = is_free_journal(scene) ? run_journal(scene) : run_multibody(scene);
    const SceneJoint& joint = scene.joints.front();
    for (const std::string& coarse : {resolution_warning(scene, joint, run.thinnest_film),
                                      unseen_warning(scene, joint, run.outcome.integrator, run.thinnest_film)}) {
      run.warning += (coarse.empty() || run.warning.empty() ? "" : "; ") + coarse;
    }
    const RunOutcome& outcome = run.outcome;
    const auto fault = [&](const std::string& what) {
      if (run.fault.empty()) run.fault = what;
    };
    if (run.samples.empty()) fault("no sample was kept");
    if (!run.samples.empty() && run.samples.back().t != outcome.t_end) fault("the last state was not kept");
    if (outcome.status == RunStatus::stopped && outcome.message.empty()) fault("it stopped without a reason");
    if (outcome.status == RunStatus::finished && outcome.t_end != scene.run.duration) fault("it ended before its end");
    return run;
  } catch (const std::exception& error) {
    StressRun run;
    run.fault = std::string("exception: ") + error.what();
    return run;
  }
}

/// Those behind are chance.
double in_four_digits(double value) {
  const std::string digits = fmt::format("{:.3e}", value);
  double read = value;
  std::from_chars(digits.data(), digits.data() + digits.size(), read);
  return read;
}

std::string without_commas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// What the errors of a run come from. A step's error is held in the root mean square of n states over their
/// tolerances: in one of them it may be √n of these. A free journal's two tolerances add up. In absolute coordinates
/// every step rounds places of the mechanism's size; rates have the tolerance of the scene's own rate, which may be
/// above the motion's.
StressAccuracy accuracy_of(const Scene& scene, const StressRun& run, const StressReference& reference) {
  StressAccuracy accuracy;
  accuracy.tolerance = std::max(tolerance_of_places(scene), tightest_tolerance);
  accuracy.rounding = std::numeric_limits<double>::epsilon();
  accuracy.thinnest_film = run.thinnest_film;
  accuracy.steps = run.outcome.steps;
  accuracy.roundings = static_cast<double>(run.outcome.rhs_evaluations) / 10;
  accuracy.no_digit = leaves_no_digit(scene, run.thinnest_film);
  accuracy.unseen = unseen_error(scene, scene.joints.front(), run.outcome.integrator, run.thinnest_film);
  if (is_free_journal(scene)) {
    const double both = scene.run.relative_tolerance + scene.run.absolute_tolerance;
    accuracy.tolerance = std::sqrt(4.0) * std::max(both, tightest_tolerance);
    return accuracy;
  }
  accuracy.tolerance *= std::sqrt(6.0 * static_cast<double>(scene.bodies.size()));
  const SceneUnits units = scene_units(scene);
  accuracy.rate_share = std::max(1.0, units.rate / reference.rate_unit);
  double largest = units.length;
  for (const SceneBody& body : scene.bodies) largest = std::max(largest, body.position.norm());
  accuracy.rounding *= largest / scene.joints.front().clearance;
  return accuracy;
}

StressCell make_cell(const StressCase& scenario, const Scene& scene, const std::string& law,
                     const StressReference& reference) {
  const StressRun run = run_scene(scene);
  const bool finished = run.outcome.status == RunStatus::finished;
  StressCell cell;
  cell.scenario = scenario.name;
  cell.law = law;
  cell.integrator = scene.integrator;
  cell.status = StressStatus::wrong;  // until it is known not to be
  cell.deviation = deviation_of(run.samples, reference, accuracy_of(scene, run, reference));
  cell.seconds = run.seconds;
  cell.steps = run.outcome.steps + run.outcome.rejected_steps;
  cell.program = measuring_sources();
  cell.message = finished ? run.warning : run.outcome.message;
  if (run.fault.empty()) cell.status = stress_status(finished, cell.deviation, !run.warning.empty());
  if (!run.fault.empty()) {
    cell.message = run.fault;
  } else if (cell.status == StressStatus::wrong) {
    cell.message = cell.deviation.worst;
    if (!finished) cell.message += "; " + run.outcome.message;
  } else if (cell.status == StressStatus::unreferenced) {
    cell.message += (cell.message.empty() ? "" : "; ") + ("no reference: " + reference.why_none);
  }
  cell.message = without_commas(cell.message);
  for (std::optional<double>* error : {&cell.deviation.place, &cell.deviation.rate, &cell.deviation.force}) {
    if (*error) *error = in_four_digits(**error);
  }
  cell.deviation.over_expected = in_four_digits(cell.deviation.over_expected);
  return cell;
}

std::string error_field(const std::optional<double>& error) { return error ? number(*error) : ""; }

std::string csv_line(const StressCell& cell) {
  const StressDeviation& d = cell.deviation;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell.scenario, cell.law, cell.integrator,
                     stress_status_name(cell.status), error_field(d.place), error_field(d.rate), error_field(d.force),
                     d.compared > 0 ? number(d.over_expected) : "", d.compared, number(in_four_digits(cell.seconds)),
                     cell.steps, cell.program, cell.message);
}

/// By case, law and integrator.
using CellKey = std::array<std::string, 3>;

std::map<CellKey, StressCell> by_key(const CsvTable& table) {
  std::map<CellKey, StressCell> cells;
  for (const StressCell& cell : read_stress_cells(table)) {
    cells.emplace(CellKey{cell.scenario, cell.law, cell.integrator}, cell);
  }
  return cells;
}

}  // namespace

std::vector<StressCell> read_stress_cells(const CsvTable& table) {
  std::vector<StressCell> cells;
  const std::vector<std::string>& columns = table.columns();
  const bool compares_all = std::find(columns.begin(), columns.end(), "program") != columns.end();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto text = [&](const char* column) { return std::string(table.field(i, table.column(column))); };
    const auto known = [&](const char* column) -> std::optional<double> {
      if (text(column).empty()) return std::nullopt;
      return table.number(i, table.column(column));
    };
    StressCell cell;
    cell.scenario = text("case");
    cell.law = text("law");
    cell.integrator = text("integrator");
    cell.status = StressStatus::wrong;  // unless it has another's name
    cell.program = "an earlier program";
    cell.message = text("message");
    for (const StressStatus status :
         {StressStatus::finished, StressStatus::coarse, StressStatus::unreferenced, StressStatus::stopped}) {
      if (text("status") == stress_status_name(status)) cell.status = status;
    }
    cell.deviation.place = known("error");
    cell.seconds = table.number(i, table.column("seconds"));
    cell.steps = static_cast<std::size_t>(table.number(i, table.column("steps")));
    if (compares_all) {
      cell.deviation.rate = known("rate_error");
      cell.deviation.force = known("force_error");
      cell.deviation.over_expected = known("over_expected").value_or(0);
      cell.deviation.compared = static_cast<std::size_t>(table.number(i, table.column("compared")));
      cell.program = text("program");
    } else if (cell.status == StressStatus::finished) {
      cell.status = StressStatus::unreferenced;
    }
    cells.push_back(cell);
  }
  return cells;
}

StressSettings stress_settings(bool quick) {
  StressSettings settings;
  settings.threads = available_cores();
  settings.integrators.assign(integrator_names().begin(), integrator_names().end());
  if (quick) {
    settings.laws = {"short_half", "pinkus_sternlicht"};
    settings.most_steps = 10'000;
  } else {
    settings.laws.assign(film_law_names.begin(), film_law_names.end());
  }
  return settings;
}

Scene with_law(Scene scene, const std::string& law) {
  for (SceneJoint& joint : scene.joints) joint.film = law;
  return scene;
}

std::string stress_key(const std::vector<StressCase>& cases, const StressSettings& settings) {
  std::string key = fmt::format("{} steps; sources {};", settings.most_steps, measuring_sources());
  for (const auto& [motion, reference] : settings.references.all()) {
    for (const double apart : reference.apart) key += number(apart) + ' ';
  }
  key = sha256(key);
  std::map<std::string, std::string> scenes;  // checksums by file
  for (const StressCase& each : cases) {
    key += fmt::format(" {}", each.name);
    if (!scenes.contains(each.scene.file)) scenes[each.scene.file] = sha256(read_input(each.scene.file));
  }
  for (const auto& [file, checksum] : scenes) key += fmt::format(" {} {}", file, checksum);
  for (const auto* names : {&settings.laws, &settings.integrators}) {
    key += ';';
    for (const std::string& name : *names) key += fmt::format(" {}", name);
  }
  return key;
}

std::vector<StressCell> run_stress(const std::vector<StressCase>& cases, const StressSettings& settings) {
  KeptRows kept(settings.resume_file, stress_key(cases, settings), csv_header);
  const std::map<CellKey, StressCell> earlier =
      kept.earlier() ? by_key(*kept.earlier()) : std::map<CellKey, StressCell>();

  const std::size_t groups = cases.size() * settings.laws.size();
  std::vector<StressReference> references;
  for (const StressCase& each : cases) {
    for (const std::string& law : settings.laws)
      references.push_back(settings.references.of(with_law(each.scene, law)));
  }
  std::vector<std::vector<StressCell>> done(groups);
  std::mutex mutex;
  ProgressBar progress("stress", groups);
  run_parallel(groups, settings.threads, [&](std::size_t group) {
    const StressCase& scenario = cases[group / settings.laws.size()];
    const std::string& law = settings.laws[group % settings.laws.size()];
    Scene scene = with_law(scenario.scene, law);
    scene.run.max_steps = std::min(scene.run.max_steps, settings.most_steps);
    std::string rows;  // that are new
    for (const std::string& integrator : settings.integrators) {
      const auto known = earlier.find({scenario.name, law, integrator});
      if (known != earlier.end()) {
        done[group].push_back(known->second);
        continue;
      }
      scene.integrator = integrator;
      done[group].push_back(make_cell(scenario, scene, law, references[group]));
      rows += csv_line(done[group].back());
    }
    const std::lock_guard lock(mutex);
    if (!rows.empty()) kept.add(rows);
    progress.advance();
  });
  std::vector<StressCell> cells;
  for (const auto& group : done) cells.insert(cells.end(), group.begin(), group.end());
  return cells;
}

std::string stress_csv(const std::vector<StressCell>& cells) {
  std::string text = csv_header;
  for (const StressCell& cell : cells) text += csv_line(cell);
  return text;
}

}  // namespace lubjoint::reports
