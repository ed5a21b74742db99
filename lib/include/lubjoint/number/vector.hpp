/// Plane vectors of any scalar.
#pragma once

#include <limits>

#include "lubjoint/number/scalar.hpp"

namespace lubjoint {

/// A vector in the plane.
template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;

/// v turned 90° counter-clockwise.
template <class T>
Vector2<T> perpendicular(const Vector2<T>& v) {
  return Vector2<T>(T(-v.y()), v.x());
}

/// a·b
template <class T>
T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return T(a.x() * b.x() + a.y() * b.y());
}

/// a × b, the component out of the plane.
template <class T>
T cross(const Vector2<T>& a, const Vector2<T>& b) {
  return T(a.x() * b.y() - a.y() * b.x());
}

/// Are both components 0? Derivatives are not looked at.
template <class T>
bool is_zero(const Vector2<T>& v) {
  return value_of(v.x()) == 0 && value_of(v.y()) == 0;
}

namespace detail {
template <class R>
R larger_magnitude(const R& x, const R& y) {
  using std::abs;
  const R ax = abs(x);
  const R ay = abs(y);
  return ax > ay ? ax : ay;
}
}  // namespace detail

namespace detail {

/// True where squares of numbers of this magnitude neither overflow nor lose digits to underflow.
template <class R>
bool squares_are_in_range(const R& size) {
  using std::sqrt;
  const R safe = std::numeric_limits<R>::min() / std::numeric_limits<R>::epsilon();
  static const R lower = sqrt(safe);
  static const R upper = 1 / lower;
  return size > lower && size < upper;
}

/// |v| where squares_are_in_range.
template <class T>
T norm_in_range(const Vector2<T>& v) {
  using std::sqrt;
  const T squared = v.x() * v.x() + v.y() * v.y();
  return T(sqrt(squared));
}

/// v/|v| where squares_are_in_range.
template <class T>
Vector2<T> direction_in_range(const Vector2<T>& v) {
  const T length = norm_in_range(v);
  return Vector2<T>(T(v.x() / length), T(v.y() / length));
}

}  // namespace detail

/// |v| of a vector that is not zero; neither overflows nor underflows where |v| itself does not.
template <class T>
T norm(const Vector2<T>& v) {
  using R = RealOf<T>;
  const R size = detail::larger_magnitude<R>(value_of(v.x()), value_of(v.y()));
  if (detail::squares_are_in_range(size)) return detail::norm_in_range(v);
  const Vector2<T> scaled(T(v.x() / size), T(v.y() / size));
  return T(size * detail::norm_in_range(scaled));
}

/// v/|v| of a vector that is not zero, also where 1/|v| would overflow.
template <class T>
Vector2<T> direction(const Vector2<T>& v) {
  using R = RealOf<T>;
  const R size = detail::larger_magnitude<R>(value_of(v.x()), value_of(v.y()));
  if (detail::squares_are_in_range(size)) return detail::direction_in_range(v);
  return detail::direction_in_range(Vector2<T>(T(v.x() / size), T(v.y() / size)));
}

}  // namespace lubjoint
