#include "lubjoint/scene/scene.hpp"

#include <algorithm>

#include "lubjoint/motion/multibody_results.hpp"

namespace lubjoint {

bool is_free_journal(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.joints.size() != 1 || !scene.constraints.empty() || scene.energy_ledger) {
    return false;
  }
  const SceneJoint& joint = scene.joints.front();
  const bool turned = std::any_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.moment != 0; });
  const bool slows_down = joint.shear && !scene.bodies.front().spin_is_held;
  const bool steady =
      std::all_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.is_constant(); });
  if (!steady || !scene.springs.empty() || !scene.sensors.empty()) return false;
  return !joint.contact && !turned && !slows_down && joint.bearing.on_ground() && is_zero(joint.journal.point);
}

std::size_t ledger_works(const Scene& scene) {
  const auto& all = scene.springs;
  const bool damped = std::any_of(all.begin(), all.end(), [](const auto& s) { return s.is_damped(); });
  return damped ? ledger_names.size() : ledger_terms;
}

bool is_massless_journal(const Scene& scene) { return is_free_journal(scene) && scene.bodies.front().mass == 0; }

}  // namespace lubjoint
