/// The part of simulate_journal that has a journal without mass; its law is chosen when the program runs.
#pragma once

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::detail {

/// @throws SceneError as journal_scene
JournalTrajectory simulate_massless_journal(const Scene& scene);

}  // namespace lubjoint::detail
