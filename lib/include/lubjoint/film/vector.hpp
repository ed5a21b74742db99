/// Plane vectors of any scalar.
#pragma once

#include <limits>

#include "lubjoint/film/scalar.hpp"

namespace lubjoint {

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

/// |v| of a vector that is not zero; neither overflows nor underflows where |v| itself does not.
template <class T>
T norm(const Vector2<T>& v) {
  using std::sqrt;
  using R = RealOf<T>;
  const R size = detail::larger_magnitude<R>(value_of(v.x()), value_of(v.y()));
  const R safe = std::numeric_limits<R>::min() / std::numeric_limits<R>::epsilon();
  static const R lower = sqrt(safe);
  static const R upper = 1 / lower;
  if (size > lower && size < upper) {
    const T squared = v.x() * v.x() + v.y() * v.y();
    return T(sqrt(squared));
  }
  const T x = v.x() / size;
  const T y = v.y() / size;
  const T squared = x * x + y * y;
  return T(size * sqrt(squared));
}

/// v/|v| of a vector that is not zero, also where 1/|v| would overflow.
template <class T>
Vector2<T> direction(const Vector2<T>& v) {
  using R = RealOf<T>;
  const R size = detail::larger_magnitude<R>(value_of(v.x()), value_of(v.y()));
  const Vector2<T> scaled(T(v.x() / size), T(v.y() / size));
  const T length = norm(scaled);
  return Vector2<T>(T(scaled.x() / length), T(scaled.y() / length));
}

}  // namespace lubjoint
