#include "lubjoint/film/law_facts.hpp"

#include "lubjoint/film/compiled_laws.hpp"

namespace lubjoint {

std::span<const LawFacts> film_law_facts() { return facts_of_laws<NamedFilmLaws>; }

const LawFacts& law_facts(std::string_view name) {
  return facts_of_laws<NamedFilmLaws>[film_law_index<NamedFilmLaws>(name)];
}

}  // namespace lubjoint
