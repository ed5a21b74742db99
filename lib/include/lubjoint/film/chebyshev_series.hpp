/// Sums of Chebyshev polynomials of one and of two variables, with their derivatives, as tables of forces are made of.
#pragma once

#include <utility>

#include "lubjoint/number/vector.hpp"

namespace lubjoint {

/// T_0 … T_{N−1} at one place, with Order derivatives (0, 1 or 2). Beyond [−1, 1] each polynomial goes on along its
/// tangent: sums of them are continuous there with their first derivative, and grow no faster than linearly.
template <class R, int N, int Order>
struct ChebyshevBasis {
  using Column = Eigen::Matrix<R, N, 1>;  ///< one number for each polynomial
  Column value;                           ///< T_k
  Column slope;                           ///< T_k', if Order ≥ 1
  Column curvature;                       ///< T_k'', if Order = 2

  /// @param place  any finite number
  explicit ChebyshevBasis(const R& place) {
    const R inside = place < R(-1) ? R(-1) : (place > R(1) ? R(1) : place);
    const R beyond = place - inside;
    const bool needs_slope = Order > 0 || beyond != R(0);
    value[0] = R(1);
    value[1] = inside;
    for (int k = 2; k < N; ++k) value[k] = 2 * inside * value[k - 1] - value[k - 2];
    if (needs_slope) {
      slope[0] = R(0);
      slope[1] = R(1);
      for (int k = 2; k < N; ++k) slope[k] = 2 * value[k - 1] + 2 * inside * slope[k - 1] - slope[k - 2];
    }
    if constexpr (Order > 1) {
      curvature[0] = R(0);
      curvature[1] = R(0);
      for (int k = 2; k < N; ++k) curvature[k] = 4 * slope[k - 1] + 2 * inside * curvature[k - 1] - curvature[k - 2];
    }
    if (beyond != R(0)) {
      value += beyond * slope;
      if constexpr (Order > 1) curvature.setZero();
    }
  }
};

/// A sum of N Chebyshev polynomials of one variable on [low, high].
template <int N>
struct ChebyshevCurve {
  Eigen::Matrix<double, N, 1> coefficients;  ///< of T_0 … T_{N−1}
  double low;                                ///< where the polynomials' variable is −1
  double high;                               ///< where it is 1

  /// The sum at x; its derivatives are exact.
  template <class T>
  T operator()(const T& x) const {
    using R = RealOf<T>;
    constexpr int order = ScalarTraits<T>::carries_derivatives ? 1 : 0;
    const R stretch = 2 / (R(high) - R(low));
    const R at(value_of(x));
    const ChebyshevBasis<R, N, order> basis((at - R(low)) * stretch - 1);
    const Eigen::Matrix<R, N, 1> c = coefficients.template cast<R>();
    if constexpr (order == 0) {
      return c.dot(basis.value);
    } else {
      return T(R(c.dot(basis.value)) + R(stretch * c.dot(basis.slope)) * T(x - at));
    }
  }
};

/// A function of two variables at one place: its value and its first derivatives.
template <class T>
struct Jet {
  T value;      ///< f
  T by_first;   ///< ∂f/∂x
  T by_second;  ///< ∂f/∂y
};

/// A sum of N×M products of Chebyshev polynomials: of x on [−reach, reach] and of y on [low, 1].
template <int N, int M>
struct ChebyshevSurface {
  Eigen::Matrix<double, N, M> coefficients;  ///< (k, l) of T_k(x) T_l(y)
  double reach;                              ///< where the variable of the first is 1
  double low;                                ///< where the variable of the second is −1

  /// The sum at (x, y); its derivatives are exact.
  template <class T>
  T operator()(const T& x, const T& y) const {
    using R = RealOf<T>;
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      const R at_x(value_of(x));
      const R at_y(value_of(y));
      const Jet<R> f = jet<R>(at_x, at_y);
      return T(f.value + f.by_first * T(x - at_x) + f.by_second * T(y - at_y));
    } else {
      const ChebyshevBasis<R, N, 0> first(R(x / R(reach)));
      const ChebyshevBasis<R, M, 0> second(to_second(y));
      return R(first.value.dot(table<R>() * second.value));
    }
  }

  /// The sum with its derivatives, which have exact derivatives themselves.
  template <class T>
  Jet<T> jet(const T& x, const T& y) const {
    using R = RealOf<T>;
    constexpr bool differentiated = ScalarTraits<T>::carries_derivatives;
    constexpr int order = differentiated ? 2 : 1;
    const R by_x = 1 / R(reach);
    const R by_y = 2 / (1 - R(low));
    const R at_x(value_of(x));
    const R at_y(value_of(y));
    const ChebyshevBasis<R, N, order> first(R(at_x * by_x));
    const ChebyshevBasis<R, M, order> second(to_second(at_y));
    const auto& c = table<R>();
    const auto [along, rise] = products(c, second.value, second.slope);
    const R value = first.value.dot(along);
    const R f_x = by_x * first.slope.dot(along);
    const R f_y = by_y * first.value.dot(rise);
    if constexpr (!differentiated) {
      return {value, f_x, f_y};
    } else {
      const Eigen::Matrix<R, N, 1> bend = c * second.curvature;
      const R f_xx = by_x * by_x * first.curvature.dot(along);
      const R f_xy = by_x * by_y * first.slope.dot(rise);
      const R f_yy = by_y * by_y * first.value.dot(bend);
      const T dx = T(x - at_x);
      const T dy = T(y - at_y);
      return {T(value + f_x * dx + f_y * dy), T(f_x + f_xx * dx + f_xy * dy), T(f_y + f_xy * dx + f_yy * dy)};
    }
  }

 private:
  /// c v and c w, both in one pass over c, whose rows are taken in pieces small enough for their sums to stay in
  /// registers: a sixth less of a force's time than by two products.
  template <class R>
  static std::pair<Eigen::Matrix<R, N, 1>, Eigen::Matrix<R, N, 1>> products(const Eigen::Matrix<R, N, M>& c,
                                                                            const Eigen::Matrix<R, M, 1>& v,
                                                                            const Eigen::Matrix<R, M, 1>& w) {
    constexpr int rows = N > 10 && N % 2 == 0 ? N / 2 : N;
    std::pair<Eigen::Matrix<R, N, 1>, Eigen::Matrix<R, N, 1>> both;
    for (int from = 0; from < N; from += rows) {
      Eigen::Matrix<R, rows, 1> by_v = v[0] * c.template block<rows, 1>(from, 0);
      Eigen::Matrix<R, rows, 1> by_w = w[0] * c.template block<rows, 1>(from, 0);
      for (int column = 1; column < M; ++column) {
        by_v += v[column] * c.template block<rows, 1>(from, column);
        by_w += w[column] * c.template block<rows, 1>(from, column);
      }
      both.first.template segment<rows>(from) = by_v;
      both.second.template segment<rows>(from) = by_w;
    }
    return both;
  }
  template <class R>
  decltype(auto) table() const {
    if constexpr (std::is_same_v<R, double>) {
      return (coefficients);
    } else {
      return Eigen::Matrix<R, N, M>(coefficients.template cast<R>());
    }
  }
  template <class R>
  R to_second(const R& y) const {
    return R((y - R(low)) * (2 / (1 - R(low))) - 1);
  }
};

}  // namespace lubjoint
