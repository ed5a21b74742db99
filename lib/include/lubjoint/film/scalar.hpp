/// Scalars that the film, the joint and the equations of motion accept: double, long double, Boost.Multiprecision
/// numbers, and Eigen's forward-mode AutoDiffScalar over any of them.
#pragma once

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unsupported/Eigen/AutoDiff>

namespace lubjoint {

template <class T>
struct ScalarTraits {
  using Real = T;  ///< the number itself, without derivatives
  static constexpr bool carries_derivatives = false;
  static const Real& value(const T& x) { return x; }
};

template <class Derivatives>
struct ScalarTraits<Eigen::AutoDiffScalar<Derivatives>> {
  using Real = typename Eigen::AutoDiffScalar<Derivatives>::Scalar;
  static constexpr bool carries_derivatives = true;
  static const Real& value(const Eigen::AutoDiffScalar<Derivatives>& x) { return x.value(); }
};

template <class T>
using RealOf = typename ScalarTraits<T>::Real;

/// The number that x holds, without its derivatives.
template <class T>
const RealOf<T>& value_of(const T& x) {
  return ScalarTraits<T>::value(x);
}

template <class T>
RealOf<T> pi() {
  return boost::math::constants::pi<RealOf<T>>();
}

/// Type in which constants of a bearing are formed before they are rounded to R: rounding them once costs a user
/// nothing and takes five roundings out of every force.
template <class R>
struct ExtendedFor {
  using Type = R;
};
template <>
struct ExtendedFor<double> {
  using Type = long double;
};

/// 1 − x², without cancellation. Floating point: one fused multiply-add, correctly rounded. Other scalars: the
/// product of 1 − x, exact for x ≥ ½, and 1 + x.
template <class T>
T one_minus_square(const T& x) {
  if constexpr (std::is_floating_point_v<T>) return std::fma(-x, x, T(1));
  const T minus = 1 - x;
  const T plus = 1 + x;
  return minus * plus;
}

/// 1 − x² − y², to two roundings of the result even where it is tiny.
/// Floating point: the squares are split exactly by fused multiply-add, so that the only rounding that the
/// difference sees is its own; the other scalars factor the larger coordinate. Derivatives are −2x dx − 2y dy.
template <class T>
T one_minus_squared_norm(const T& x, const T& y) {
  if constexpr (ScalarTraits<T>::carries_derivatives) {
    T result = T(one_minus_squared_norm(value_of(x), value_of(y)));
    result.derivatives() = -2 * x.value() * x.derivatives() - 2 * y.value() * y.derivatives();
    return result;
  } else if constexpr (std::is_floating_point_v<T>) {
    const T xx = x * x;
    const T yy = y * y;
    const T larger = xx < yy ? yy : xx;
    const T smaller = xx < yy ? xx : yy;
    // Exact where it cancels: 1 − x for x ≥ ½, and ½ − x for ¼ ≤ x ≤ 1 (both squares near ½, on the diagonal).
    const bool diagonal = smaller > T(0.25);
    const T rough = diagonal ? (T(0.5) - larger) + (T(0.5) - smaller) : (1 - larger) - smaller;
    if (rough > T(0.5)) return rough;  // no cancellation: three roundings of numbers near 1
    return rough - (std::fma(x, x, -xx) + std::fma(y, y, -yy));
  } else {
    using std::abs;
    const bool x_is_larger = abs(x) > abs(y);
    const T larger = x_is_larger ? abs(x) : abs(y);
    const T smaller = x_is_larger ? abs(y) : abs(x);
    return one_minus_square(larger) - smaller * smaller;
  }
}

}  // namespace lubjoint
