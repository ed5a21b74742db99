#include "lubjoint/film/law_facts.hpp"

#include "lubjoint/film/law_list.hpp"

namespace lubjoint {

std::span<const LawFacts> film_law_facts() { return facts_of_film_laws; }

const LawFacts& law_facts(std::string_view name) { return facts_of_film_laws[film_law_index(name)]; }

}  // namespace lubjoint
