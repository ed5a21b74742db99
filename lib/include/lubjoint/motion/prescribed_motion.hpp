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

/// What a driver prescribes, its rate and its acceleration: the unit vector of an angle, or a way.
template <class DriverOf, class R>
std::array<Vector2<R>, 3> prescribed_by(const DriverOf& driver, const R& t) {
  const DrivenMotion<R> f = driver.motion(t);
  if constexpr (DriverOf::turns) {
    using std::cos;
    using std::sin;
    const Vector2<R> e(cos(f.value), sin(f.value));
    return {e, f.rate * perpendicular(e), f.acceleration * perpendicular(e) - f.rate * f.rate * e};
  } else {
    return {Vector2<R>(f.value, R(0)), Vector2<R>(f.rate, R(0)), Vector2<R>(f.acceleration, R(0))};
  }
}

}  // namespace detail

/// How far the quintic through what drivers prescribe at both ends of a step, with rates and accelerations, is from it
/// in the middle: of a unit vector, or of a way over its larger end. The largest of all drivers; 0 without any.
template <class R>
R prescribed_miss(const std::vector<NamedConstraint<R>>& constraints, const R& t, const R& dt) {
  R worst(0);
  for (const NamedConstraint<R>& each : constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& driver) {
          if constexpr (requires { Constraint::turns; }) {
            const std::array<Vector2<R>, 3> a = detail::prescribed_by(driver, t);
            const std::array<Vector2<R>, 3> b = detail::prescribed_by(driver, R(t + dt));
            const Vector2<R> quintic =
                (a[0] + b[0]) / 2 + (5 * dt / 32) * (a[1] - b[1]) + (dt * dt / 64) * (a[2] + b[2]);
            const R miss = (detail::prescribed_by(driver, R(t + dt / 2))[0] - quintic).norm();
            const R size = std::max<R>(a[0].norm(), b[0].norm());
            if (size > 0) worst = std::max<R>(worst, miss / size);
          }
        },
        each.constraint);
  }
  return worst;
}

}  // namespace lubjoint
