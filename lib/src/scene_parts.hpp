/// Tables of a scene that others refer to, or that belong to multibody scenes.
#pragma once

#include <algorithm>

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

inline std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

/// A number as messages show it; no unit for "".
std::string with_unit(double value, const char* unit);

template <class Items>
bool is_taken(const Items& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
}

/// A body by its name. @throws SceneError that lists the bodies, as do all below with what they refuse
std::size_t read_body_name(TableReader& table, std::string_view key, const Scene& scene, bool ground_is_allowed);
SceneAnchor read_anchor(TableReader table, const Scene& scene);

/// Keys transition and contact of a joint whose film and clearance are known.
void read_contact(TableReader& joint_table, SceneJoint& joint);

SceneConstraint read_constraint(TableReader table, const Scene& scene);
SceneStabilisation read_stabilisation(TableReader table);

}  // namespace lubjoint
