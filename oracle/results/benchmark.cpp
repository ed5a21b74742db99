#include "oracle/results/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/trajectory_table.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* residual_name = "energy_residual";

CsvTable read_literature(const std::filesystem::path& file) { return {read_input(file.string()), file.string()}; }

/// The rows of a problem, without what a run gives.
std::vector<BenchmarkRow> published_rows(const std::string& name, const std::filesystem::path& file) {
  const CsvTable table = read_literature(file);
  const std::size_t problem = table.column("problem");
  const std::size_t quantity = table.column("quantity");
  const std::size_t t = table.column("t");
  const std::size_t published = table.column("published");
  const std::size_t allowed = table.column("allowed");
  std::vector<BenchmarkRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.field(i, problem) != name) continue;
    rows.push_back({std::string(table.field(i, quantity)), table.number(i, t), table.number(i, published),
                    table.number(i, allowed), std::nullopt});
  }
  return rows;
}

/// The value of a column at a time; none if no row has it.
std::optional<double> value_at(const TrajectoryTable& table, const std::string& column, double t) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) {
    throw std::invalid_argument(fmt::format("the trajectory has no column \"{}\"; allowed is one of it", column));
  }
  const auto k = static_cast<std::size_t>(found - table.columns.begin());
  for (const auto& row : table.rows) {
    if (std::abs(*row[0] - t) <= 1e-12 * t) return row[k];  // rounding of i intervals
  }
  return std::nullopt;
}

/// Largest |difference| from a published place or angle; none if there is no such row, or one that was not reached.
std::optional<double> largest_error(const std::vector<BenchmarkRow>& rows) {
  std::optional<double> largest;
  for (const BenchmarkRow& row : rows) {
    if (row.quantity == residual_name) continue;
    const std::optional<double> difference = row.difference();
    if (!difference) return std::nullopt;
    largest = std::max(largest.value_or(0), std::abs(*difference));
  }
  return largest;
}

std::string shown(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

}  // namespace

std::optional<double> BenchmarkRow::difference() const {
  return computed ? std::optional<double>(*computed - published) : std::nullopt;
}

bool BenchmarkRow::agrees() const { return computed && std::abs(*computed - published) <= allowed; }

bool BenchmarkRun::agrees() const {
  return !rows.empty() && std::all_of(rows.begin(), rows.end(), [](const BenchmarkRow& row) { return row.agrees(); });
}

std::vector<std::string> benchmark_names(const std::filesystem::path& literature) {
  const CsvTable table = read_literature(literature);
  const std::size_t problem = table.column("problem");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string name(table.field(i, problem));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

BenchmarkRun run_benchmark(const std::string& name, const std::filesystem::path& literature,
                           const std::filesystem::path& scenes, const std::optional<double>& tolerance,
                           const std::string& integrator, const std::optional<std::size_t>& max_steps) {
  Scene scene = load_scene(scenes / (name + ".toml"));
  if (!integrator.empty()) scene.integrator = integrator;
  if (max_steps) scene.run.max_steps = *max_steps;
  if (tolerance) scene.run.relative_tolerance = scene.run.absolute_tolerance = *tolerance;
  const MultibodyTrajectory run = simulate_multibody(scene);
  BenchmarkRun result;
  result.name = name;
  result.integrator = run.outcome.integrator;
  result.message = run.outcome.message;
  result.rows = published_rows(name, literature);
  result.seconds = run.wall_seconds;
  result.steps = run.outcome.steps;
  const double residual = run.energy_residual.value_or(0);
  result.energy_drift = run.energy_scale > 0 ? residual / run.energy_scale : 0;
  result.closure_drift = run.drift.position;
  const TrajectoryTable table = trajectory_table(scene, run);
  for (BenchmarkRow& row : result.rows) {
    if (row.quantity != residual_name) {
      row.computed = value_at(table, row.quantity, row.t);
    } else if (run.outcome.status == RunStatus::finished) {
      row.computed = run.energy_residual;
    }
  }
  return result;
}

std::vector<WorkPrecision> work_precision(const std::string& name, const std::filesystem::path& literature,
                                          const std::filesystem::path& scenes) {
  std::vector<WorkPrecision> points;
  for (const std::string_view integrator : method_names()) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      const BenchmarkRun run = run_benchmark(name, literature, scenes, tolerance, std::string(integrator), 100'000);
      WorkPrecision point{name, run.integrator, tolerance, std::nullopt, run.seconds, run.steps};
      if (run.message.empty()) point.error = largest_error(run.rows);
      points.push_back(std::move(point));
    }
  }
  return points;
}

std::string work_precision_text(const std::vector<WorkPrecision>& points) {
  std::string text = fmt::format("{:<16} {:<24} {:>9} {:>9} {:>10} {:>8}\n", "problem", "integrator", "tolerance",
                                 "error", "time [s]", "steps");
  for (const WorkPrecision& point : points) {
    text += fmt::format("{:<16} {:<24} {:>9.0e} {:>9} {:>10.2e} {:>8}\n", point.name, point.integrator, point.tolerance,
                        shown(point.error, "{:.1e}"), point.seconds, point.steps);
  }
  return text;
}

nlohmann::ordered_json work_precision_json(const std::vector<WorkPrecision>& points) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const WorkPrecision& point : points) {
    list.push_back({{"name", point.name},
                    {"integrator", point.integrator},
                    {"tolerance", point.tolerance},
                    {"error", point.error ? nlohmann::ordered_json(*point.error) : nlohmann::ordered_json(nullptr)},
                    {"seconds", point.seconds},
                    {"steps", point.steps}});
  }
  return list;
}

nlohmann::ordered_json benchmark_json(const std::vector<BenchmarkRun>& runs) {
  using Json = nlohmann::ordered_json;
  const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  Json list = Json::array();
  for (const BenchmarkRun& run : runs) {
    for (const BenchmarkRow& row : run.rows) {
      list.push_back({{"name", run.name},
                      {"quantity", row.quantity},
                      {"t", row.t},
                      {"published", row.published},
                      {"computed", or_null(row.computed)},
                      {"difference", or_null(row.difference())},
                      {"allowed", row.allowed},
                      {"agrees", row.agrees()},
                      {"seconds", run.seconds},
                      {"integrator", run.integrator},
                      {"energy_drift", run.energy_drift}});
    }
  }
  return list;
}

std::string benchmark_text(const std::vector<BenchmarkRun>& runs) {
  std::string text = fmt::format("{:<16} {:<16} {:>6} {:>20} {:>20} {:>10} {:>8}  agrees\n", "problem", "quantity",
                                 "t [s]", "published", "computed", "difference", "allowed");
  for (const BenchmarkRun& run : runs) {
    for (const BenchmarkRow& row : run.rows) {
      text += fmt::format("{:<16} {:<16} {:>6g} {:>20.15g} {:>20} {:>10} {:>8.1e}  {}\n", run.name, row.quantity, row.t,
                          row.published, shown(row.computed, "{:.15g}"), shown(row.difference(), "{:.1e}"), row.allowed,
                          row.agrees() ? "yes" : "no");
    }
  }
  text += fmt::format("\n{:<16} {:<12} {:>8} {:>10} {:>13} {:>14}\n", "problem", "integrator", "steps", "time [s]",
                      "energy drift", "closure drift");
  for (const BenchmarkRun& run : runs) {
    text += fmt::format("{:<16} {:<12} {:>8} {:>10.3f} {:>13.1e} {:>14.1e}\n", run.name, run.integrator, run.steps,
                        run.seconds, run.energy_drift, run.closure_drift);
    if (!run.message.empty()) text += "  " + run.message + "\n";
  }
  return text;
}

}  // namespace lubjoint::reports
