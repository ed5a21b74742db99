/// What is given by name and may not be allowed: options of commands, arguments of other languages.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "lubjoint/text/nearest_name.hpp"

namespace lubjoint::reports {

/// @throws std::invalid_argument that names the option, the value, and the names there are
template <class Names>
void require_name(const std::string& option, const std::string& given, const Names& names) {
  if (std::find(names.begin(), names.end(), given) != names.end()) return;
  throw std::invalid_argument(option + " is \"" + given + "\"; allowed is " + one_of(names, given));
}

/// A number that an option gave. @throws std::invalid_argument that names it, the value and what is allowed
inline void require_option(const std::string& name, double given, bool allowed, const std::string& words) {
  if (std::isfinite(given) && allowed) return;
  std::ostringstream message;
  message << name << " is " << given << "; allowed is " << words;
  throw std::invalid_argument(message.str());
}

}  // namespace lubjoint::reports
