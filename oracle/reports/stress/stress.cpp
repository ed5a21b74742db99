#include "oracle/reports/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "lubjoint/dynamics/integrators.hpp"
#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/film_resolution.hpp"
#include "oracle/reports/golden_files.hpp"
#include "oracle/reports/kept_rows.hpp"
#include "oracle/reports/parallel.hpp"
#include "oracle/reports/progress.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* csv_header = "case,law,integrator,status,error,seconds,steps,message\n";

/// Where a run was, and how it ended.
struct StressRun {
  RunOutcome outcome;
  std::vector<double> times;
  std::vector<Vector2<double>> positions;  ///< ê at these times
  double seconds = 0;
  double thinnest_film = 1;  ///< in clearances
  std::string fault;         ///< what no run may do; empty if it did not
};

void look_at(const Vector2<double>& e_hat, double t, const Vector2<double>& force, bool may_touch, StressRun& run) {
  const auto fault = [&](const char* what) {
    if (run.fault.empty()) run.fault = fmt::format("{} at t = {} s", what, t);
  };
  if (!e_hat.allFinite()) fault("eccentricity is no number");
  if (!force.allFinite()) fault("force is no number");
  if (!may_touch && !(one_minus_squared_norm(e_hat.x(), e_hat.y()) > 0)) fault("a sample lies beyond the wall");
  if (!run.times.empty() && !(t > run.times.back())) fault("samples are not in order");
  run.times.push_back(t);
  run.positions.push_back(e_hat);
}

StressRun run_journal(const Scene& scene) {
  StressRun run;
  const JournalTrajectory trajectory = simulate_journal(scene);
  run.outcome = trajectory.outcome;
  run.seconds = trajectory.wall_seconds;
  run.thinnest_film = thinnest_film(scene, trajectory);
  for (const JournalSample& sample : trajectory.samples) {
    look_at({sample.state[0], sample.state[1]}, sample.t, sample.force, false, run);
  }
  if (!std::isfinite(trajectory.max_force + trajectory.min_film_thickness)) run.fault = "an extreme is no number";
  return run;
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
    look_at(at.eccentricity / joint.clearance, sample.t, at.force, joint.contact.has_value(), run);
  }
  for (const JointExtremes& each : trajectory.joints) {
    if (!std::isfinite(each.force.value + each.eccentricity.value)) run.fault = "an extreme is no number";
  }
  return run;
}

StressRun run_scene(const Scene& scene) {
  try {
    StressRun run = is_free_journal(scene) ? run_journal(scene) : run_multibody(scene);
    const RunOutcome& outcome = run.outcome;
    const auto fault = [&](const std::string& what) {
      if (run.fault.empty()) run.fault = what;
    };
    if (run.times.empty()) fault("no sample was kept");
    if (!run.times.empty() && run.times.back() != outcome.t_end) fault("the last state was not kept");
    if (outcome.status == RunStatus::stopped && outcome.message.empty()) fault("it stopped without a reason");
    if (outcome.status == RunStatus::finished && outcome.t_end != scene.run.duration) fault("it ended before its end");
    return run;
  } catch (const std::exception& error) {
    StressRun run;
    run.fault = std::string("exception: ") + error.what();
    return run;
  }
}

/// Largest distance of two runs at their common times.
double distance(const StressRun& a, const StressRun& b) {
  double largest = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.times.size(); ++i) {
    while (j < b.times.size() && b.times[j] < a.times[i]) ++j;
    if (j == b.times.size()) break;
    if (b.times[j] == a.times[i]) largest = std::max(largest, (a.positions[i] - b.positions[j]).norm());
  }
  return largest;
}

struct StressReference {
  std::optional<StressRun> run;  ///< none if no two runs agree
  double agreement = 0;          ///< with a second one
  std::string why_none;
};

/// References closer than this need no better ones.
constexpr double good_agreement = 1e-6;
/// References further apart than this are none.
constexpr double poor_agreement = 1e-3;

/// The best of runs at much tighter tolerances, implicit and explicit: of the two that agree best, the tighter one.
StressReference reference_of(Scene scene, std::size_t max_steps) {
  struct Attempt {
    const char* integrator;
    double tolerance;
  };
  // The last ones for scenes in which rounding leaves no tighter tolerance any meaning.
  constexpr std::array<Attempt, 6> attempts = {Attempt{"radau_iia5", 1e-12}, Attempt{"fehlberg78", 1e-12},
                                               Attempt{"radau_iia5", 1e-11}, Attempt{"radau_iia5", 1e-10},
                                               Attempt{"rosenbrock4", 1e-9}, Attempt{"radau_iia5", 1e-9}};
  scene.run.max_steps = max_steps;
  std::vector<StressRun> runs;
  std::optional<std::size_t> best;
  double agreement = std::numeric_limits<double>::infinity();
  for (const Attempt& attempt : attempts) {
    scene.integrator = attempt.integrator;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = attempt.tolerance;
    StressRun run = run_scene(scene);
    if (run.outcome.status != RunStatus::finished || !run.fault.empty()) continue;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double apart = distance(runs[i], run);
      if (!(apart < agreement)) continue;
      agreement = apart;
      best = i;
    }
    runs.push_back(std::move(run));
    if (agreement <= good_agreement) break;
  }
  if (!best) return {std::nullopt, 0, "no reference: no two runs of tighter tolerance finish"};
  if (agreement > poor_agreement) {
    return {std::nullopt, 0, fmt::format("no reference: runs of tighter tolerance differ by {:.1e}", agreement)};
  }
  return {std::move(runs[*best]), agreement, ""};
}

std::string without_commas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

StressCell make_cell(const StressCase& scenario, const Scene& scene, const std::string& law,
                     const StressReference& reference) {
  const StressRun run = run_scene(scene);
  const bool finished = run.outcome.status == RunStatus::finished;
  StressCell cell{scenario.name,
                  law,
                  scene.integrator,
                  StressStatus::wrong,
                  std::nullopt,
                  run.seconds,
                  run.outcome.steps + run.outcome.rejected_steps,
                  run.outcome.message};
  const std::string warning = resolution_warning(scene, scene.joints.front(), run.thinnest_film);
  if (finished) cell.message = warning;
  if (reference.run) cell.error = distance(run, *reference.run);
  const double limit = stress_error_limit(scene.run.relative_tolerance, reference.agreement);
  if (run.fault.empty()) cell.status = stress_status(finished, cell.error, limit, !warning.empty());
  if (!run.fault.empty()) {
    cell.message = run.fault;
  } else if (cell.status == StressStatus::wrong) {
    cell.message = fmt::format("error {:.1e} where the tolerance of {:.0e} lets one expect less than {:.0e}",
                               *cell.error, scene.run.relative_tolerance, limit);
    if (!finished) cell.message += "; " + run.outcome.message;
  } else if (!reference.run && finished) {
    cell.message += (cell.message.empty() ? "" : "; ") + reference.why_none;
  }
  cell.message = without_commas(cell.message);
  return cell;
}

std::string csv_line(const StressCell& cell) {
  return fmt::format("{},{},{},{},{},{},{},{}\n", cell.scenario, cell.law, cell.integrator,
                     stress_status_name(cell.status), cell.error ? number(*cell.error) : "", number(cell.seconds),
                     cell.steps, cell.message);
}

/// By case, law and integrator.
using CellKey = std::array<std::string, 3>;

std::map<CellKey, StressCell> cells_of(const CsvTable& table) {
  std::map<CellKey, StressCell> cells;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto text = [&](const char* column) { return std::string(table.field(i, table.column(column))); };
    StressCell cell{text("case"), text("law"), text("integrator"), StressStatus::finished, {}, 0, 0, text("message")};
    for (const StressStatus status : {StressStatus::coarse, StressStatus::stopped, StressStatus::wrong}) {
      if (text("status") == stress_status_name(status)) cell.status = status;
    }
    if (!text("error").empty()) cell.error = table.number(i, table.column("error"));
    cell.seconds = table.number(i, table.column("seconds"));
    cell.steps = static_cast<std::size_t>(table.number(i, table.column("steps")));
    cells.emplace(CellKey{cell.scenario, cell.law, cell.integrator}, cell);
  }
  return cells;
}

}  // namespace

const char* stress_status_name(StressStatus status) {
  switch (status) {
    case StressStatus::finished:
      return "finished";
    case StressStatus::coarse:
      return "coarse";
    case StressStatus::stopped:
      return "stopped";
    case StressStatus::wrong:
      break;
  }
  return "wrong";
}

double stress_error_limit(double tolerance, double reference_agreement) {
  return std::max({std::min(1e3 * tolerance, 0.1), 1e-3, 10 * reference_agreement});
}

StressStatus stress_status(bool finished, std::optional<double> error, double limit, bool warned) {
  const bool far_off = error && !(*error <= limit);
  if (far_off && !warned) return StressStatus::wrong;
  if (!finished) return StressStatus::stopped;
  return far_off ? StressStatus::coarse : StressStatus::finished;
}

StressSettings stress_settings(bool quick) {
  StressSettings settings;
  settings.threads = available_cores();
  settings.integrators.assign(integrator_names.begin(), integrator_names.end());
  if (quick) {
    settings.laws = {"short_half", "pinkus_sternlicht"};
    settings.most_steps = 10'000;
  } else {
    settings.laws.assign(film_law_names.begin(), film_law_names.end());
  }
  return settings;
}

std::string stress_key(const std::vector<StressCase>& cases, const StressSettings& settings) {
  std::string key = fmt::format("{} steps;", settings.most_steps);
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
      kept.earlier() ? cells_of(*kept.earlier()) : std::map<CellKey, StressCell>();

  const std::size_t groups = cases.size() * settings.laws.size();
  std::vector<std::vector<StressCell>> done(groups);
  std::mutex mutex;
  ProgressBar progress("stress", groups);
  run_parallel(groups, settings.threads, [&](std::size_t group) {
    const StressCase& scenario = cases[group / settings.laws.size()];
    const std::string& law = settings.laws[group % settings.laws.size()];
    Scene scene = scenario.scene;
    scene.run.max_steps = std::min(scene.run.max_steps, settings.most_steps);
    for (SceneJoint& joint : scene.joints) joint.film = law;
    std::optional<StressReference> reference;
    std::string rows;  // that are new
    for (const std::string& integrator : settings.integrators) {
      const auto known = earlier.find({scenario.name, law, integrator});
      if (known != earlier.end()) {
        done[group].push_back(known->second);
        continue;
      }
      if (!reference) reference = reference_of(scene, 2 * settings.most_steps);
      scene.integrator = integrator;
      done[group].push_back(make_cell(scenario, scene, law, *reference));
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
