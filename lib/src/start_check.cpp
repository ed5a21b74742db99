#include "lubjoint/scene/start_check.hpp"

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "multibody_simulation.hpp"

namespace lubjoint {

void require_start(const Scene& scene) {
  if (is_free_journal(scene)) {
    journal_scene(scene);
  } else {
    detail::prepare(scene);
  }
}

}  // namespace lubjoint
