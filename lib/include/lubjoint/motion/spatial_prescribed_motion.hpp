/// Steps that a prescribed motion in space can be followed in.
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "lubjoint/motion/prescribed_motion.hpp"
#include "lubjoint/multibody/spatial/constraint.hpp"

namespace lubjoint {

/// As that of the plane's drivers.
template <class R>
R prescribed_miss(const std::vector<NamedSpatialConstraint<R>>& constraints, const R& t, const R& dt) {
  R worst(0);
  for (const NamedSpatialConstraint<R>& each : constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& driver) {
          if constexpr (requires { driver.motion; }) {
            const auto motion = [&](const R& at) { return driver.motion.at(at); };
            const auto terms = [&](const R& at) { return driver.motion.size_of_terms(at); };
            worst = std::max<R>(worst, detail::quintic_miss<!Constraint::is_length(0)>(motion, terms, t, dt));
          }
        },
        each.constraint);
  }
  return worst;
}

}  // namespace lubjoint
