/// The arctangent and its remainder as polynomials: without a branch, so that rows of states are evaluated together,
/// and with bounds that are proved where they are compiled.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "lubjoint/number/scalar.hpp"

namespace lubjoint::detail {

/// Σ c_k x^k by the powers of x⁴: four chains of operations, none of which waits for another.
template <std::size_t n, class T>
T polynomial(const std::array<double, n>& c, const T& x) {
  static_assert(n % 4 == 0 && n >= 8, "as long chains");
  const T x2 = x * x, x4 = x2 * x2;
  T s0 = T(c[n - 4]), s1 = T(c[n - 3]), s2 = T(c[n - 2]), s3 = T(c[n - 1]);
  [&]<std::size_t... k>(std::index_sequence<k...>) {  // written out: a loop in the rows' loop would not be vectorised
    ((s0 = s0 * x4 + c[n - 8 - 4 * k], s1 = s1 * x4 + c[n - 7 - 4 * k], s2 = s2 * x4 + c[n - 6 - 4 * k],
      s3 = s3 * x4 + c[n - 5 - 4 * k]),
     ...);
  }(std::make_index_sequence<n / 4 - 1>());
  return T((s0 + x * s1) + x2 * (s2 + x * s3));
}

/// A polynomial that approximates a function, and a bound of its error.
template <std::size_t n>
struct BoundedPolynomial {
  std::array<double, n> coefficients{};
  long double error = 0;
};

/// (arctan(t)/t − 1)/t² in powers of t², |t| ≤ tan 2θ. With t = x tan 2θ and r = tan θ,
///   arctan t = 2 Σ_k (−1)^k r^{2k+1}/(2k+1) T_{2k+1}(x),
/// cut after some terms; as |T_m(x)| ≤ m|x| for odd m, what is cut is at most 2r^{2m+1}/(1 − r²) |x| for the first k =
/// m that is left out.
template <std::size_t n>
constexpr BoundedPolynomial<n> arctangent_series(long double r) {
  const long double largest = 2 * r / (1 - r * r);
  constexpr std::size_t terms = n + 1;
  std::array<long double, terms + 1> sum{}, before{}, here{};  // T_{2k±1}(x)/x in powers of x²
  before[0] = here[0] = 1;
  long double weight = 2 * r;
  for (std::size_t k = 0; k < terms; ++k) {
    for (std::size_t i = 0; i <= k; ++i) sum[i] += weight / static_cast<long double>(2 * k + 1) * here[i];
    weight *= -r * r;
    std::array<long double, terms + 1> next{};  // T_{m+2} = 2(2x² − 1)T_m − T_{m−2}
    for (std::size_t i = 0; i <= k + 1; ++i) {
      next[i] = -2 * here[i] - before[i] + (i > 0 ? 4 * here[i - 1] : 0);
    }
    before = here;
    here = next;
  }
  BoundedPolynomial<n> result;
  long double power = largest;
  for (std::size_t i = 0; i < n; ++i) {
    power *= largest * largest;
    result.coefficients[i] = static_cast<double>(sum[i + 1] / power);
  }
  // Of t; its own coefficient is 1 but for what is cut, and taking it for 1 errs by no more than that once more.
  result.error = 2 * (weight < 0 ? -weight : weight) / (1 - r * r) / largest;
  return result;
}

/// ρ(y) = (8/15) ₂F₁(1, 3; 7/2; y) for 0 ≤ y ≤ largest: its power series, whose terms are all positive, in Chebyshev
/// polynomials of 2y/largest − 1, cut; the error is what is cut.
template <std::size_t n>
constexpr BoundedPolynomial<n> arc_remainder_series(long double largest) {
  constexpr std::size_t terms = 60;
  std::array<long double, terms> power{};
  power[0] = 8.0L / 15;
  for (std::size_t k = 0; k + 1 < terms; ++k) {
    power[k + 1] = power[k] * static_cast<long double>(2 * k + 6) / static_cast<long double>(2 * k + 7);
  }
  std::array<long double, terms + 1> series{};  // Horner's rule; y = largest/2 (1 + z), z T_k = (T_{k+1} + T_{|k−1|})/2
  for (std::size_t k = terms; k-- > 0;) {
    std::array<long double, terms + 1> next{};
    for (std::size_t i = 0; i < terms; ++i) {
      const long double half = largest / 2 * series[i];
      next[i] += half;
      next[i + 1] += i == 0 ? half : half / 2;
      if (i > 0) next[i - 1] += half / 2;
    }
    next[0] += power[k];
    series = next;
  }
  BoundedPolynomial<n> result;
  for (std::size_t i = n; i < terms; ++i) result.error += series[i];
  // The power series' own rest: its coefficients fall.
  long double rest = power[terms - 1] / (1 - largest);
  for (std::size_t k = 0; k < terms; ++k) rest *= largest;
  result.error += rest;
  std::array<long double, n> sum{}, before{}, here{};  // T_k in powers of y
  here[0] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) sum[i] += series[k] * here[i];
    std::array<long double, n> next{};
    for (std::size_t i = 0; i < n; ++i) {
      const long double times_z = (i > 0 ? 2 / largest * here[i - 1] : 0) - here[i];
      next[i] = k == 0 ? times_z : 2 * times_z - before[i];
    }
    before = here;
    here = next;
  }
  for (std::size_t i = 0; i < n; ++i) result.coefficients[i] = static_cast<double>(sum[i]);
  return result;
}

inline constexpr double largest_narrow = 0.5;  ///< y up to which ρ is asked for
inline constexpr auto arctangent = arctangent_series<12>(0.19891236737965800691159762264467623L);  // tan(π/16)
inline constexpr auto narrow_remainder = arc_remainder_series<24>(largest_narrow);
static_assert(arctangent.error < 0x1p-57L);        // of the angle: a sixteenth of a rounding
static_assert(narrow_remainder.error < 0x1p-57L);  // of ρ ≥ 8/15

/// Is a number of double precision at the bottom of T? Others take functions that know more digits.
template <class T>
inline constexpr bool holds_double = std::is_same_v<RealOf<T>, double>;

/// Angle of (x, y), atan2(y, x), where y > 0: in (0, π). In double to about an ulp: the polynomial's bound, above, and
/// the roundings. The angle is that of the nearest direction out of 0, π/4, π/2, 3π/4, π, and the arctangent, at most
/// tan(π/8), of what is left.
inline double angle_above(double y, double x) {
  constexpr double steep = 2.414213562373095;  // tan(3π/8)
  const double quarter = pi<double>() / 4, size = x < 0 ? -x : x;
  const bool is_steep = y > steep * size, is_flat = steep * y < size;
  const double above = is_steep ? -size : is_flat ? y : y - size;  // of the angle from ±x
  const double along = is_steep ? y : is_flat ? size : y + size;
  const double nearest = is_steep ? 2 * quarter : is_flat ? 0 : quarter;
  const double t = (x < 0 ? -above : above) / along;
  const double w = t * t;
  const double arc = t + t * w * polynomial(arctangent.coefficients, w);
  return (x < 0 ? 4 * quarter - nearest : nearest) + arc;
}
template <class T>
T angle_above(const T& y, const T& x) {
  if constexpr (ScalarTraits<T>::carries_derivatives && holds_double<T>) {
    const double square = x.value() * x.value() + y.value() * y.value();
    return T(angle_above(y.value(), x.value()),
             y.derivatives() * (x.value() / square) - x.derivatives() * (y.value() / square));
  } else {
    return polar_angle(y, x);
  }
}

/// ρ(y) = (δ/(sinδ cosδ) − 1 − 2y/3)/y², y = sin²δ, 0 ≤ y ≤ largest_narrow: in double by the polynomial, else by its
/// series of positive terms.
template <class T>
T arc_remainder(const T& y) {
  if constexpr (holds_double<T>) {
    return polynomial(narrow_remainder.coefficients, y);
  } else {
    using R = RealOf<T>;
    T sum = T(1);
    T term = T(1);
    const R negligible = std::numeric_limits<R>::epsilon() / 4;
    for (int n = 0; value_of(term) > negligible * value_of(sum); ++n) {
      term = term * y * (R(2 * n + 6) / R(2 * n + 7));
      sum = sum + term;
    }
    return T(R(8) / R(15) * sum);
  }
}

}  // namespace lubjoint::detail
