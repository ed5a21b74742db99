#include "lubjoint/scene/simulate.hpp"

#include "lubjoint/joint/chosen_film.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "massless_simulation.hpp"

namespace lubjoint {

namespace detail {
template <class Law>
JournalTrajectory simulate_journal_with(const Scene& scene);  // one file each, made from journal_simulation.cpp.in
}

JournalTrajectory simulate_journal(const Scene& scene) {
  if (scene.joints.empty()) journal_scene(scene);  // says what is missing
  if (is_massless_journal(scene)) return detail::simulate_massless_journal(scene);
  return with_film_law<NamedFilmLaws>(scene.joints.front().film,
                                      [&]<class Law>() { return detail::simulate_journal_with<RunLaw<Law>>(scene); });
}

}  // namespace lubjoint
