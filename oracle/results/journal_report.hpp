/// What people and programs read about a journal's run: CSV, JSON, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// The summary that scripts read; keys as documented for `simulate`.
nlohmann::ordered_json summary_json(const Scene& scene, const JournalTrajectory& run);
std::string summary_text(const Scene& scene, const JournalTrajectory& run);

nlohmann::ordered_json equilibrium_json(const Scene& scene, const JournalEquilibrium& rest);
std::string equilibrium_text(const Scene& scene, const JournalEquilibrium& rest);

/// "decays", "grows" or "neither".
std::string stability_word(Stability stability);

}  // namespace lubjoint::reports
