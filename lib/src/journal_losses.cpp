#include "lubjoint/scene/journal_losses.hpp"

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/losses.hpp"
#include "lubjoint/scene/journal_scene.hpp"

namespace lubjoint {

LossSample journal_losses(const Scene& scene, const JournalSample& sample) {
  const SceneJoint& joint = scene.joints.front();
  if (!joint.shear) return {};
  const JournalScene parts = journal_scene(scene);
  const double half_sum = parts.drive.mean_spin();
  const auto& y = sample.state;
  const FilmState<double> film(Vector2<double>(y[0], y[1]),
                               Vector2<double>(y[2] + half_sum * y[1], y[3] - half_sum * y[0]));
  return with_film_law<NamedFilmLaws>(joint.film, [&]<class Law>() {
    const double rate = couette_scale(parts.bearing, parts.oil) * couette_integral<Law>(film, *joint.shear);
    const double relative_spin = parts.drive.journal_spin - parts.drive.bearing_spin;
    // With the recorded force: on the jump of a half film it is no force of the law's.
    const FilmLosses<double> losses =
        losses_of<double>(sample.force, film, parts.bearing.clearance(), rate, relative_spin);
    return LossSample{losses.torque_journal, losses.torque_bearing, losses.power(),
                      side_flow<Law>(parts.bearing, film)};
  });
}

}  // namespace lubjoint
