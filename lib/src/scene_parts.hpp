/// Tables of a scene that others refer to, or that belong to multibody scenes.
#pragma once

#include <algorithm>

#include "lubjoint/scene/scene.hpp"
#include "lubjoint/text/nearest_name.hpp"
#include "table_reader.hpp"

namespace lubjoint {

inline std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

/// A number as messages show it; no unit for "".
std::string with_unit(double value, const char* unit);

template <class Items>
bool is_taken(const Items& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
}

/// The place of a name in a list. What it may be is named where it is none. @throws SceneError, as do all below
template <class Items>
std::size_t find_named(const TableReader& table, std::string_view key, const std::string& name, const Items& items,
                       const std::string& what) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  if (found != items.end()) return static_cast<std::size_t>(found - items.begin());
  std::string allowed = items.empty() ? "nothing: the scene has no " + what : "the name of a " + what + ":";
  for (const auto& item : items) allowed += " " + in_quotes(item.name);
  table.refuse(key, in_quotes(name), allowed);
}

/// The place of a body's point, in the plane or in space, by the name at a key.
/// @param holder  name of the body; "" of the ground;  @param axes  "[x, y]" or "[x, y, z]"
template <class Points>
auto find_point(TableReader& table, std::string_view key, const std::string& holder, const Points& points,
                const std::string& axes) {
  const std::string name = table.text(key);
  if (holder.empty()) table.refuse(key, in_quotes(name), axes + " [m], inertial: the ground's points have no names");
  const auto found = std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.name == name; });
  if (found != points.end()) return found->place;
  std::vector<std::string_view> names;
  for (const auto& point : points) names.push_back(point.name);
  table.refuse(key, in_quotes(name),
               names.empty() ? axes + " [m]: body " + in_quotes(holder) + " names no points"
                             : axes + " [m], or a point of body " + in_quotes(holder) + ": " + one_of(names, name));
}

/// A point of a body, given by its place or by its name; the mass centre where the key is missing.
Vector2<double> read_point(TableReader& table, std::string_view key, const Scene& scene, std::size_t body);

/// One of the names of bodies. @throws SceneError that lists them, as all below do
std::size_t read_body_name(TableReader& table, std::string_view key, const std::vector<std::string>& names,
                           bool ground_is_allowed);
/// A body by its name. @throws SceneError that lists the bodies, as do all below with what they refuse
std::size_t read_body_name(TableReader& table, std::string_view key, const Scene& scene, bool ground_is_allowed);
SceneAnchor read_anchor(TableReader table, const Scene& scene);

/// Keys transition and contact of a joint whose film and clearance are known.
void read_contact(TableReader& joint_table, SceneJoint& joint);

SceneConstraint read_constraint(TableReader table, const Scene& scene);
SceneStabilisation read_stabilisation(TableReader table);
/// Of a scene whose constraints and stabilisation are read.
SceneCoordinates read_coordinates(TableReader& root, bool constrained, const SceneStabilisation& stabilisation);

// What scenes in the plane and in space have alike; in scene_file.cpp.

/// Keys of a joint but for its two anchors, which are not read.
SceneJoint read_joint_film(TableReader& table);
double read_duration(TableReader& root);
/// Name and settings of the integrator.
void read_integrator(TableReader table, std::string& name, RunSettings& run);
/// @returns is there to be an energy ledger?
bool read_output(TableReader table, RunSettings& run);
/// @throws SceneError if the text is no TOML
toml::table parse_scene_text(const std::string& text, const std::string& name);

}  // namespace lubjoint
