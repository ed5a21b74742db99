#include "oracle/verify/trajectory/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/files/csv_table.hpp"
#include "oracle/verify/states/answers.hpp"

namespace lubjoint::verify {

namespace {

constexpr std::size_t least_rows = 5;  // of a piecewise cubic that looks at two neighbours on both sides

std::vector<double> numbers(const reports::CsvTable& table, const std::string& column) {
  const std::size_t place = table.column(column);
  std::vector<double> list;
  list.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) list.push_back(table.number(row, place));
  return list;
}

}  // namespace

Trajectory read_trajectory(std::string_view csv, const std::string& name, const Trajectory* known) {
  try {
    const reports::CsvTable table(csv, name);
    Trajectory trajectory{name, numbers(table, "t"), {}, {}};
    for (const std::string& column : table.columns()) {
      if (column == "t") continue;
      if (known == nullptr || known->has(column)) {
        trajectory.columns[column] = numbers(table, column);
      } else {
        trajectory.not_read.push_back(column);
      }
    }
    const std::vector<double>& t = trajectory.t;
    if (t.size() < least_rows) {
      throw UnjudgedError(fmt::format("{}: {} rows; required are at least {}", name, t.size(), least_rows));
    }
    const auto back = std::ranges::adjacent_find(t, [](double a, double b) { return !(a < b); });
    if (back != t.end()) {
      throw UnjudgedError(
          fmt::format("{}: t must increase from row to row; {} s follows {} s", name, back[1], back[0]));
    }
    return trajectory;
  } catch (const reports::CsvError& error) {
    throw UnjudgedError(error.what());
  }
}

void end_films_in_contact(const Scene& scene, Trajectory& trajectory) {
  for (const SceneJoint& joint : scene.joints) {
    const auto column = trajectory.columns.find(joint.name + ".film_thickness");
    if (!joint.contact || column == trajectory.columns.end()) continue;
    for (double& value : column->second) value = std::max(value, 0.0);
  }
}

Trajectory as_trajectory(const TrajectoryTable& table, const std::string& name) {
  Trajectory trajectory{name, {}, {}, {}};
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    std::vector<double> column;
    column.reserve(table.rows.size());
    for (const auto& row : table.rows) {
      if (row[k]) column.push_back(*row[k]);
    }
    if (column.size() < table.rows.size()) continue;
    if (table.columns[k] == "t") {
      trajectory.t = std::move(column);
    } else {
      trajectory.columns[table.columns[k]] = std::move(column);
    }
  }
  if (trajectory.t.size() < least_rows) {
    throw UnjudgedError(fmt::format("{}: {} rows; required are at least {}", name, trajectory.t.size(), least_rows));
  }
  return trajectory;
}

Samples thinned(const Samples& samples, std::size_t stride) {
  Samples few{{}, std::vector<std::vector<double>>(samples.components())};
  for (std::size_t i = 0; i < samples.t.size(); ++i) {
    if (i % stride != 0 && i + 1 != samples.t.size()) continue;
    few.t.push_back(samples.t[i]);
    for (std::size_t k = 0; k < samples.components(); ++k) few.x[k].push_back(samples.x[k][i]);
  }
  return few;
}

Curves::Curves(const Samples& samples) : first_(samples.t.front()), last_(samples.t.back()) {
  for (const std::vector<double>& x : samples.x) {
    curves_.emplace_back(std::vector<double>(samples.t), std::vector<double>(x));
  }
}

}  // namespace lubjoint::verify
