#include "lubjoint/scene/simulate.hpp"

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"

namespace lubjoint {

namespace detail {
template <FilmLaw Law>
JournalTrajectory simulate_journal_with(const Scene& scene);  // one file each, made from journal_simulation.cpp.in
}

JournalTrajectory simulate_journal(const Scene& scene) {
  if (scene.joints.empty()) journal_scene(scene);  // says what is missing
  return with_film_law(scene.joints.front().film,
                       [&]<class Law>() { return detail::simulate_journal_with<Law>(scene); });
}

}  // namespace lubjoint
