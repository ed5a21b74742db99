/// What people and programs read about the branches of an assembled scene.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/scene/scene_assembly.hpp"

namespace lubjoint::reports {

/// The words of a branch's sign: "counter-clockwise", "clockwise", "forwards", "backwards", "aligned".
std::string sign_words(const AssemblySign& sign, int value);

/// Keys scene, freedoms, guesses_lead, other_starts, arrived, branches: of each branch number, moves, turns, velocity,
/// spin (its largest changes), signs, and bodies with name, position, angle, velocity, spin.
nlohmann::ordered_json assembly_json(const Scene& scene, const SceneAssembly& assembly);

/// The branches, a line each, and what tells them apart.
std::string assembly_text(const Scene& scene, const SceneAssembly& assembly);

}  // namespace lubjoint::reports
