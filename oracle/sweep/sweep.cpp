#include "oracle/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/scene/start_check.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/files/quoted_csv.hpp"
#include "oracle/laws/scene_films.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/late_extremes.hpp"
#include "oracle/results/multibody_report.hpp"

namespace lubjoint::reports {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* joint_extremes[] = {
    "max_eccentricity_ratio", "max_force",         "t_max_force", "min_film_thickness",
    "t_min_film_thickness",   "min_film_over_safe"};
constexpr const char* late_joint_extremes[] = {"t",           "max_eccentricity_ratio", "max_force",
                                               "t_max_force", "min_film_thickness",     "t_min_film_thickness"};
constexpr const char* joint_ends[] = {"ex_over_c", "ey_over_c", "fx", "fy"};
constexpr const char* driver_extremes[] = {"max_", "t_max_", "min_", "t_min_"};  // of its moment or force
constexpr const char* reaction_extremes[] = {"max_force", "t_max_force", "max_moment", "t_max_moment"};
constexpr const char* sensor_extremes[] = {"max", "t_max", "min", "t_min"};
constexpr const char* costs[] = {"steps", "rejected_steps", "rhs_evaluations"};

std::vector<std::string> columns_of(const Scene& scene, const SweepGrid& grid, bool late) {
  std::vector<std::string> columns{"index"};
  for (const SweptKey& swept : grid.keys()) columns.push_back(swept.key);
  columns.insert(columns.end(), {"status", "message", "t_end"});
  for (const SceneJoint& joint : scene.joints) {
    for (const char* name : joint_extremes) columns.push_back(joint.name + "." + name);
    for (const char* name : late_joint_extremes) {
      if (late) columns.push_back(joint.name + ".after." + name);
    }
    for (const char* name : joint_ends) columns.push_back(joint.name + "." + name);
  }
  for (const SceneDriver& driver : scene_drivers(scene)) {
    for (const char* name : driver_extremes) columns.push_back(driver.name + "." + name + driver.effort);
    for (const char* name : driver_extremes) {
      if (late) columns.push_back(driver.name + ".after." + name + driver.effort);
    }
  }
  columns.emplace_back("energy_residual");
  columns.insert(columns.end(), std::begin(costs), std::end(costs));
  for (const SceneConstraint& each : scene.constraints) {
    if (each.is_driver()) continue;
    for (const char* name : reaction_extremes) columns.push_back(each.name + "." + name);
    for (const char* name : reaction_extremes) {
      if (late) columns.push_back(each.name + ".after." + name);
    }
  }
  for (const Sensor& sensor : scene.sensors) {
    for (const char* quantity : sensor_quantities(sensor)) {
      for (const char* name : sensor_extremes) columns.push_back(sensor.name + "." + quantity + "." + name);
    }
  }
  return columns;
}

Json summary(const Scene& scene) {
  return is_free_journal(scene) ? summary_json(scene, simulate_journal(scene))
                                : summary_json(scene, simulate_multibody(scene));
}

std::string field(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return quoted_field(value.get<std::string>());
  return value.is_number_float() ? number(value.get<double>()) : value.dump();
}

/// The summary's values in the order of the columns, from status on.
std::vector<std::string> fields_of(const Json& run, bool late) {
  std::vector<std::string> fields;
  const auto add = [&](const Json& object, const auto& names) {
    for (const char* name : names) fields.push_back(object.is_null() ? std::string() : field(object.at(name)));
  };
  constexpr const char* ends[] = {"status", "message", "t_end"};
  add(run, ends);
  for (const Json& joint : run.at("joints")) {
    add(joint, joint_extremes);
    if (late) add(joint.value("after", Json()), late_joint_extremes);
    add(joint.at("final"), joint_ends);
  }
  for (const Json& driver : run.at("drivers")) {
    const std::string effort = driver.contains("max_force") ? "force" : "moment";
    const auto add_driver = [&](const Json& object) {
      for (const char* name : driver_extremes)
        fields.push_back(object.is_null() ? std::string() : field(object.at(name + effort)));
    };
    add_driver(driver);
    if (late) add_driver(driver.value("after", Json()));
  }
  fields.push_back(field(run.at("energy_residual")));
  add(run, costs);
  for (const Json& reaction : run.value("reactions", Json::array())) {
    add(reaction, reaction_extremes);
    if (late) add(reaction.value("after", Json()), reaction_extremes);
  }
  for (const Json& sensor : run.value("sensors", Json::array())) {
    for (const auto& [quantity, extremes] : sensor.items()) {
      if (quantity != "name") add(extremes, sensor_extremes);
    }
  }
  return fields;
}

/// A field of a column of numbers.
Json number_of_field(const std::string& text) {
  if (text.empty()) return nullptr;
  std::int64_t whole = 0;
  double real = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, whole).ptr == end) return whole;
  std::from_chars(text.data(), end, real);
  return real;
}

/// A value that the sweep sets; a number as its field shows it.
Json value_of(const SceneValue& value, const std::string& field) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  return number_of_field(field);
}

}  // namespace

Sweep::Sweep(SceneFile file, SweepGrid grid, std::function<void(Scene&)> change, LateStart late)
    : file_(std::move(file)), grid_(std::move(grid)), change_(std::move(change)), late_(std::move(late)) {
  require_valid({0}, 1);
  const Scene first = scene(0);
  name_ = first.name;
  columns_ = columns_of(first, grid_, late_ != nullptr);
}

Scene Sweep::scene(std::size_t point) const {
  Scene scene = file_.scene(grid_.point(point));
  change_(scene);
  return scene;
}

void Sweep::require_valid(const std::vector<std::size_t>& points, unsigned threads) const {
  std::mutex mutex;
  std::optional<std::pair<std::size_t, std::string>> first;  // whatever thread came first
  run_parallel(points.size(), threads, [&](std::size_t i) {
    std::string reason;
    try {
      const Scene checked = scene(points[i]);
      require_start(checked);
      if (late_) late_(checked);
      if (!columns_.empty() && columns_of(checked, grid_, late_ != nullptr) != columns_) {
        reason = file_.name() + ": other joints or drivers than those of point 0; allowed are the same";
      }
    } catch (const std::exception& error) {
      reason = error.what();
    }
    if (reason.empty()) return;
    const std::lock_guard lock(mutex);
    if (!first || points[i] < first->first) first = {points[i], reason};
  });
  if (first) throw SceneError(grid_.name(first->first) + ": " + first->second);
}

std::string Sweep::header() const {
  std::string text;
  for (const std::string& column : columns_) text += (text.empty() ? "" : ",") + quoted_field(column);
  return text;
}

std::string Sweep::row(std::size_t point) const {
  std::string text = std::to_string(point);
  for (const SceneChange& change : grid_.point(point)) text += "," + quoted_field(shown(change.value));
  std::vector<std::string> fields;
  try {
    const Scene at = scene(point);
    Json run = summary(at);
    if (late_ && run.at("status") == "finished") add_late_extremes(run, at, late_extremes(at, late_(at)));
    fields = fields_of(run, late_ != nullptr);
  } catch (const std::exception& error) {  // a start at which a film or a constraint fails
    fields = {"stopped", quoted_field(error.what())};
    fields.resize(columns_.size() - 1 - grid_.keys().size());
  }
  for (const std::string& each : fields) text += "," + each;
  return text;
}

bool Sweep::is_stopped(const std::string& row, const SweepGrid& grid) {
  return split_quoted(row).at(1 + grid.keys().size()) == "stopped";
}

std::vector<std::string> Sweep::beyond_table_warnings(const std::map<std::size_t, std::string>& rows) const {
  struct Beyond {
    std::size_t points = 0;
    double farthest = 0;  // eccentricity ratio
    std::string warning;
    std::string place;
  };
  const Scene first = scene(0);
  // Most sweeps have no such film, and then no scene is read again.
  const auto is_compiled = [](const SceneJoint& joint) { return is_compiled_law(joint.film); };
  const auto is_film = [](const SweptKey& swept) { return swept.key.ends_with(".film"); };
  if (std::none_of(first.joints.begin(), first.joints.end(), is_compiled) &&
      std::none_of(grid_.keys().begin(), grid_.keys().end(), is_film)) {
    return {};
  }
  std::vector<Beyond> seen(first.joints.size());
  for (const auto& [point, row] : rows) {
    const std::vector<std::string> fields = split_quoted(row);
    const Scene at = scene(point);
    for (std::size_t j = 0; j < at.joints.size(); ++j) {
      const SceneJoint& joint = at.joints[j];
      const auto column = std::find(columns_.begin(), columns_.end(), joint.name + "." + joint_extremes[0]);
      const Json ratio = number_of_field(fields.at(static_cast<std::size_t>(column - columns_.begin())));
      if (ratio.is_null()) continue;  // stopped before it began
      const std::string warning = beyond_table_warning(joint, ratio.get<double>() * joint.clearance);
      if (warning.empty()) continue;
      Beyond& beyond = seen[j];
      ++beyond.points;
      if (ratio.get<double>() <= beyond.farthest) continue;
      beyond.farthest = ratio.get<double>();
      beyond.warning = warning;
      beyond.place = grid_.name(point);
    }
  }
  std::vector<std::string> warnings;
  for (const Beyond& each : seen) {
    if (each.points == 0) continue;
    warnings.push_back(each.points == 1 ? fmt::format("{} At {}.", each.warning, each.place)
                                        : fmt::format("{} At {}, and less far at {} more.", each.warning, each.place,
                                                      each.points - 1));
  }
  return warnings;
}

Json Sweep::row_json(const std::string& row) const {
  const std::vector<std::string> fields = split_quoted(row);
  const std::vector<SceneChange> point = grid_.point(std::stoul(fields.front()));
  Json object;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool is_key = i >= 1 && i <= point.size();
    const bool is_text = i == point.size() + 1 || i == point.size() + 2;  // status and message
    object[columns_[i]] = is_key    ? value_of(point[i - 1].value, fields.at(i))
                          : is_text ? Json(fields.at(i))
                                    : number_of_field(fields.at(i));
  }
  return object;
}

}  // namespace lubjoint::reports
