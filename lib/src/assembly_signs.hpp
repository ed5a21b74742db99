/// Signs that tell the branches of an assembly apart.
#pragma once

#include "lubjoint/scene/scene_assembly.hpp"

namespace lubjoint::detail {

/// Fills the signs of an assembly and of its branches.
/// @param closed  the scene with its joints as pins;  @param length  of the mechanism [m]
void find_signs(const Scene& closed, double length, SceneAssembly& assembly);

}  // namespace lubjoint::detail
