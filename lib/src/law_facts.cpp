#include "lubjoint/film/law_facts.hpp"

#include "lubjoint/film/every_law.hpp"

namespace lubjoint {

std::span<const LawFacts> film_law_facts() { return facts_of_laws<EveryFilmLaw>; }

const LawFacts& law_facts(std::string_view name) {
  return facts_of_laws<EveryFilmLaw>[film_law_index<EveryFilmLaw>(name)];
}

}  // namespace lubjoint
