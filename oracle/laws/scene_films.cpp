#include "oracle/laws/scene_films.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lubjoint/film/compiled_laws.hpp"

namespace lubjoint::reports {

void SceneFilms::provide(Scene& scene) {
  for (SceneJoint& joint : scene.joints) {
    if (!is_compiled_law(joint.film)) {
      joint.table.reset();
      continue;
    }
    const double shape = joint.length / (2 * joint.journal_radius);
    require_compiled_shape(joint.film, shape);
    joint.table = table(joint.film, shape);
  }
}

std::shared_ptr<const CompiledFilm> SceneFilms::table(const std::string& law, double length_to_diameter) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const CompiledFilm>& known = tables_[{law, length_to_diameter}];
  if (known == nullptr) known = std::make_shared<const CompiledFilm>(source_(law, length_to_diameter));
  return known;
}

std::string beyond_table_warning(const SceneJoint& joint, double farthest) {
  if (!is_compiled_law(joint.film) || joint.table == nullptr) return {};
  // A film that gives way to contact is widened, and beyond it there is none.
  const double clearance = joint.clearance + (joint.transition ? joint.transition->e1 : 0);
  const double ratio = std::min(farthest / clearance, 1.0);
  if (ratio <= joint.table->ratio_limit) return {};
  return fmt::format(
      "warning: the film of joint \"{}\" reached eccentricity ratio {:.6g}; the error of {}, {:.1e} of |F|, was "
      "measured "
      "up to {:g}, and is not known beyond.",
      joint.name, ratio, joint.film, joint.table->error, joint.table->ratio_limit);
}

}  // namespace lubjoint::reports
