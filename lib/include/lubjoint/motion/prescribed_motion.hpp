/// Steps that a prescribed motion can be followed in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

/// How far the quintic through f at both ends of a step, with rates and accelerations, is from it in the middle: of a
/// unit vector, or of a way over its larger end.
/// @param motion  motion(t) is f with its derivatives
template <bool Turns, class Motion, class R>
R quintic_miss(const Motion& motion, const R& t, const R& dt) {
  const std::array<Vector2<R>, 3> a = prescribed<Turns, R>(motion(t));
  const std::array<Vector2<R>, 3> b = prescribed<Turns, R>(motion(R(t + dt)));
  const Vector2<R> quintic = (a[0] + b[0]) / 2 + (5 * dt / 32) * (a[1] - b[1]) + (dt * dt / 64) * (a[2] + b[2]);
  const R miss = (prescribed<Turns, R>(motion(R(t + dt / 2)))[0] - quintic).norm();
  const R size = std::max<R>(a[0].norm(), b[0].norm());
  return size > 0 ? R(miss / size) : R(0);
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
            worst = std::max<R>(worst, detail::quintic_miss<Constraint::turns>(motion, t, dt));
          }
        },
        each.constraint);
  }
  return worst;
}

}  // namespace lubjoint
