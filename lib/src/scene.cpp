#include "lubjoint/scene/scene.hpp"

#include <algorithm>

namespace lubjoint {

bool is_free_journal(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.joints.size() != 1 || !scene.constraints.empty() || scene.energy_ledger) {
    return false;
  }
  const SceneJoint& joint = scene.joints.front();
  const bool turned = std::any_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.moment != 0; });
  const bool slows_down = joint.shear && !scene.bodies.front().spin_is_held;
  return !joint.contact && !turned && !slows_down && joint.bearing.on_ground() && is_zero(joint.journal.point);
}

bool is_massless_journal(const Scene& scene) { return is_free_journal(scene) && scene.bodies.front().mass == 0; }

}  // namespace lubjoint
