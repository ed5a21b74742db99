/// Scalars that the film, the joint and the equations of motion accept: double, long double, Boost.Multiprecision
/// numbers, and dual numbers over any of them (dual.hpp).
#pragma once

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace lubjoint {

/// What is asked of a scalar: the number in it, and whether it carries derivatives. Here, a plain number.
template <class T>
struct ScalarTraits {
  using Real = T;                                     ///< the number itself, without derivatives
  static constexpr bool carries_derivatives = false;  ///< is it differentiated forward?
  static const Real& value(const T& x) { return x; }  ///< the number
};

/// The number itself of a scalar type, without derivatives.
template <class T>
using RealOf = typename ScalarTraits<T>::Real;

/// The number that x holds, without its derivatives.
template <class T>
const RealOf<T>& value_of(const T& x) {
  return ScalarTraits<T>::value(x);
}

/// π, to the precision of the scalar.
template <class T>
RealOf<T> pi() {
  return boost::math::constants::pi<RealOf<T>>();
}

/// Type in which constants of a bearing are formed before they are rounded to R: rounding them once costs a user
/// nothing and takes five roundings out of every force.
template <class R>
struct ExtendedFor {
  using Type = R;  ///< R itself, where nothing wider is at hand
};
/// For double.
template <>
struct ExtendedFor<double> {
  using Type = long double;  ///< 64 bits of mantissa on x86
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

namespace detail {

/// x² − xx for the rounded square xx, exactly: one fused multiply-add, or the halves of x (Dekker) for scalars wider
/// than double, which have no such instruction.
template <std::floating_point R>
R left_out_of_square(R x, R xx) {
  if constexpr (std::numeric_limits<R>::digits <= std::numeric_limits<double>::digits) return std::fma(x, x, -xx);
  constexpr R splitter = R(1ULL << ((std::numeric_limits<R>::digits + 1) / 2)) + 1;
  const R wide = splitter * x;
  const R high = wide - (wide - x);
  const R low = x - high;
  return ((high * high - xx) + 2 * (high * low)) + low * low;
}

/// What rounding left out of sum = x² + y², which was added up from the rounded squares xx and yy; the sum of two
/// ordered numbers leaves out what can be had back exactly.
template <std::floating_point R>
R left_out_of_square_sum(R x, R y, R xx, R yy, R sum) {
  const R larger = xx < yy ? yy : xx;
  const R smaller = xx < yy ? xx : yy;
  const R of_sum = smaller - (sum - larger);
  return of_sum + (left_out_of_square(x, xx) + left_out_of_square(y, yy));
}

}  // namespace detail

/// 1 − x² − y², to two roundings of the result even where it is tiny.
/// Floating point: where the sum of the squares exceeds ½ its difference from 1 is exact, and what rounding left out of
/// the sum is taken off; the other scalars factor the larger coordinate. Derivatives are −2x dx − 2y dy.
template <class T>
T one_minus_squared_norm(const T& x, const T& y) {
  if constexpr (ScalarTraits<T>::carries_derivatives) {
    T result = T(one_minus_squared_norm(value_of(x), value_of(y)));
    result.derivatives() = -2 * x.value() * x.derivatives() - 2 * y.value() * y.derivatives();
    return result;
  } else if constexpr (std::is_floating_point_v<T>) {
    const T xx = x * x;
    const T yy = y * y;
    const T sum = xx + yy;
    const T rough = 1 - sum;
    if (rough >= T(0.5)) return rough;  // no cancellation: three roundings of numbers below 1
    return rough - detail::left_out_of_square_sum(x, y, xx, yy, sum);
  } else {
    using std::abs;
    const bool x_is_larger = abs(x) > abs(y);
    const T larger = x_is_larger ? abs(x) : abs(y);
    const T smaller = x_is_larger ? abs(y) : abs(x);
    return one_minus_square(larger) - smaller * smaller;
  }
}

/// Angle of (x, y), atan2(y, x), in (−π, π]. Derivatives are (x dy − y dx)/(x² + y²).
template <class T>
T polar_angle(const T& y, const T& x) {
  if constexpr (ScalarTraits<T>::carries_derivatives) {
    const RealOf<T> square = x.value() * x.value() + y.value() * y.value();
    return T(polar_angle(y.value(), x.value()),
             y.derivatives() * RealOf<T>(x.value() / square) - x.derivatives() * RealOf<T>(y.value() / square));
  } else {
    using std::atan2;
    return T(atan2(y, x));
  }
}

}  // namespace lubjoint
