/// Options whose value is one of a list of names.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lubjoint/text/nearest_name.hpp"

namespace lubjoint::cli {

/// @throws std::invalid_argument that names the option, the value, and the names there are
template <class Names>
void require_name(const std::string& option, const std::string& given, const Names& names) {
  if (std::find(names.begin(), names.end(), given) != names.end()) return;
  throw std::invalid_argument(option + " is \"" + given + "\"; allowed is " + one_of(names, given));
}

}  // namespace lubjoint::cli
