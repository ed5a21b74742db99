/// Names of properties that are checked law by law.
#pragma once

#include <string>

#include "lubjoint/film/law_list.hpp"

namespace lubjoint {

/// A property's name with its law's. Catch enters a section of a loop again only if its name is another: without the
/// law's name the first law alone would be tested.
template <FilmLaw Law>
std::string of_law(const char* property) {
  return std::string(Law::name) + ": " + property;
}

}  // namespace lubjoint
