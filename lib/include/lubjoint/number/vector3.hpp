/// Vectors in space of any scalar.
#pragma once

#include "lubjoint/number/vector.hpp"

namespace lubjoint {

/// A vector in space.
template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
/// A 3×3 matrix.
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// a·b
template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return T(a(0) * b(0) + a(1) * b(1) + a(2) * b(2));
}

/// a × b
template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return Vector3<T>(T(a(1) * b(2) - a(2) * b(1)), T(a(2) * b(0) - a(0) * b(2)), T(a(0) * b(1) - a(1) * b(0)));
}

/// a + b
template <class T>
Vector3<T> sum(const Vector3<T>& a, const Vector3<T>& b) {
  return Vector3<T>(T(a(0) + b(0)), T(a(1) + b(1)), T(a(2) + b(2)));
}

/// a − b
template <class T>
Vector3<T> difference(const Vector3<T>& a, const Vector3<T>& b) {
  return Vector3<T>(T(a(0) - b(0)), T(a(1) - b(1)), T(a(2) - b(2)));
}

/// k a
template <class T>
Vector3<T> scaled(const T& k, const Vector3<T>& a) {
  return Vector3<T>(T(k * a(0)), T(k * a(1)), T(k * a(2)));
}

/// −a
template <class T>
Vector3<T> negative(const Vector3<T>& a) {
  return Vector3<T>(T(-a(0)), T(-a(1)), T(-a(2)));
}

/// A b, of a vector whose scalar may be the matrix' real one.
template <class T, class S>
Vector3<T> product(const Matrix3<T>& a, const Vector3<S>& b) {
  return Vector3<T>(T(a(0, 0) * b(0) + a(0, 1) * b(1) + a(0, 2) * b(2)),
                    T(a(1, 0) * b(0) + a(1, 1) * b(1) + a(1, 2) * b(2)),
                    T(a(2, 0) * b(0) + a(2, 1) * b(1) + a(2, 2) * b(2)));
}

/// Aᵀ b
template <class T>
Vector3<T> transposed_product(const Matrix3<T>& a, const Vector3<T>& b) {
  return Vector3<T>(T(a(0, 0) * b(0) + a(1, 0) * b(1) + a(2, 0) * b(2)),
                    T(a(0, 1) * b(0) + a(1, 1) * b(1) + a(2, 1) * b(2)),
                    T(a(0, 2) * b(0) + a(1, 2) * b(1) + a(2, 2) * b(2)));
}

/// 0
template <class T>
Vector3<T> zero_vector() {
  return Vector3<T>(T(0), T(0), T(0));
}

/// Are all three components 0? Derivatives are not looked at.
template <class T>
bool is_zero(const Vector3<T>& v) {
  return value_of(v(0)) == 0 && value_of(v(1)) == 0 && value_of(v(2)) == 0;
}

/// |v| of a vector that is not zero; neither overflows nor underflows where |v| itself does not.
template <class T>
T norm(const Vector3<T>& v) {
  using std::sqrt;
  using R = RealOf<T>;
  const R size =
      detail::larger_magnitude<R>(detail::larger_magnitude<R>(value_of(v(0)), value_of(v(1))), R(value_of(v(2))));
  if (detail::squares_are_in_range(size)) return T(sqrt(dot(v, v)));
  const Vector3<T> small(T(v(0) / size), T(v(1) / size), T(v(2) / size));
  return T(size * sqrt(dot(small, small)));
}

/// v/|v| of a vector that is not zero.
template <class T>
Vector3<T> direction(const Vector3<T>& v) {
  using R = RealOf<T>;
  const R size =
      detail::larger_magnitude<R>(detail::larger_magnitude<R>(value_of(v(0)), value_of(v(1))), R(value_of(v(2))));
  const Vector3<T> small(T(v(0) / size), T(v(1) / size), T(v(2) / size));
  const T length = norm(small);
  return Vector3<T>(T(small(0) / length), T(small(1) / length), T(small(2) / length));
}

/// A unit vector across a unit vector, the same for the same one: along the cross product with the coordinate axis that
/// it has least of.
template <class R>
Vector3<R> any_perpendicular(const Vector3<R>& unit) {
  using std::abs;
  Eigen::Index least = 0;
  for (Eigen::Index k = 1; k < 3; ++k) {
    if (abs(unit(k)) < abs(unit(least))) least = k;
  }
  Vector3<R> axis = zero_vector<R>();
  axis(least) = R(1);
  return direction(cross(unit, axis));
}

}  // namespace lubjoint
