/// Steps that a prescribed motion can be followed in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "lubjoint/multibody/constraint.hpp"

namespace lubjoint {

namespace detail {

/// A prescribed f, its rate and its acceleration: the unit vector of an angle, or a way.
template <bool Turns, class R>
std::array<Vector2<R>, 3> prescribed(const DrivenMotion<R>& f) {
  if constexpr (Turns) {
    using std::cos;
    using std::sin;
    const Vector2<R> e(cos(f.value), sin(f.value));
    return {e, f.rate * perpendicular(e), f.acceleration * perpendicular(e) - f.rate * f.rate * e};
  } else {
    return {Vector2<R>(f.value, R(0)), Vector2<R>(f.rate, R(0)), Vector2<R>(f.acceleration, R(0))};
  }
}

/// How far the quintic through f at both ends of a step, with rates and accelerations, is from it in the middle, beyond
/// rounding: of a unit vector, or of a way by the sizes of its terms, which do not pass 0 with it.
/// @param motion  motion(t) is f with its derivatives;  @param terms  terms(t): the sum of its terms' sizes
template <bool Turns, class Motion, class Terms, class R>
R quintic_miss(const Motion& motion, const Terms& terms, const R& t, const R& dt) {
  const std::array<Vector2<R>, 3> a = prescribed<Turns, R>(motion(t));
  const std::array<Vector2<R>, 3> b = prescribed<Turns, R>(motion(R(t + dt)));
  const Vector2<R> quintic = (a[0] + b[0]) / 2 + (5 * dt / 32) * (a[1] - b[1]) + (dt * dt / 64) * (a[2] + b[2]);
  const R miss = (prescribed<Turns, R>(motion(R(t + dt / 2)))[0] - quintic).norm();
  const R of_terms = std::max<R>(terms(t), terms(R(t + dt)));
  const R rounding = 16 * std::numeric_limits<R>::epsilon() * (Turns ? std::max<R>(R(1), of_terms) : of_terms);
  const R beyond = std::max<R>(R(0), R(miss - rounding));
  return Turns || !(of_terms > 0) ? beyond : R(beyond / of_terms);
}

}  // namespace detail

/// How well a step can follow what drivers prescribe: the largest miss of all of them; 0 without any.
template <class R>
R prescribed_miss(const std::vector<NamedConstraint<R>>& constraints, const R& t, const R& dt) {
  R worst(0);
  for (const NamedConstraint<R>& each : constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& driver) {
          if constexpr (requires { Constraint::turns; }) {
            const auto motion = [&](const R& at) { return driver.motion(at); };
            const auto terms = [&](const R& at) { return driver.size_of_terms(at); };
            worst = std::max<R>(worst, detail::quintic_miss<Constraint::turns>(motion, terms, t, dt));
          }
        },
        each.constraint);
  }
  return worst;
}

}  // namespace lubjoint
