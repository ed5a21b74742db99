/// Can a scene start?
#pragma once

#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// Refuses what a run of the scene would refuse before its first step, and runs nothing.
/// @throws SceneError  constraints that repeat or contradict each other, a journal that starts outside its bearing
void require_start(const Scene& scene);

}  // namespace lubjoint
