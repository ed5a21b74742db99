/// What people and programs read about the run of a multibody scene: CSV, JSON, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// The summary that scripts read; keys as documented for `simulate`, and what only such scenes have.
nlohmann::ordered_json summary_json(const Scene& scene, const MultibodyTrajectory& run);
std::string summary_text(const Scene& scene, const MultibodyTrajectory& run);

/// From when to when a joint's half film slid [s]: pairs, or a line each.
nlohmann::ordered_json slides_json(const std::vector<JointSlide>& slides, std::size_t joint);
std::string slides_text(const std::vector<JointSlide>& slides, std::size_t joint);

/// Peaks of a driver's moment: max_moment, t_max_moment, min_moment, t_min_moment; of one that slides, of its force.
nlohmann::ordered_json driver_extremes_json(const SceneDriver& driver, const DriverExtremes& extremes);
/// The same in words.
std::string driver_words(const SceneDriver& driver, const DriverExtremes& extremes);

/// Peaks of a constraint's reaction: name, max_force, t_max_force, max_moment, t_max_moment (none of a pin).
nlohmann::ordered_json reaction_json(const Scene& scene, const ReactionExtremes& reaction);
/// The same in words.
std::string reaction_words(const ReactionExtremes& reaction);

}  // namespace lubjoint::reports
