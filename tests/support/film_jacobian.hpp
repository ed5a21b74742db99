/// Exact Jacobian of a law in (ê, u), by automatic differentiation, and the same by differences.
#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint::test {

/// F/S with its derivatives: columns ∂/∂ê_x, ∂/∂ê_y, ∂/∂u_x, ∂/∂u_y.
template <class R>
struct ForceAndJacobian {
  Vector2<R> force;
  Eigen::Matrix<R, 2, 4> jacobian;

  Eigen::Matrix<R, 2, 2> in_eccentricity() const { return jacobian.template leftCols<2>(); }
  Eigen::Matrix<R, 2, 2> in_velocity() const { return jacobian.template rightCols<2>(); }
  bool is_finite() const { return force.allFinite() && jacobian.allFinite(); }
};

template <FilmLaw Law, class R>
ForceAndJacobian<R> exact_force_jacobian(const Vector2<R>& e_hat, const Vector2<R>& u) {
  using T = Dual<R, 4>;
  const Vector2<T> e_seeded(T::variable(e_hat.x(), 0), T::variable(e_hat.y(), 1));
  const Vector2<T> u_seeded(T::variable(u.x(), 2), T::variable(u.y(), 3));
  const Vector2<T> ratio = force_ratio<Law>(FilmState<T>(e_seeded, u_seeded));
  ForceAndJacobian<R> result;
  result.force = Vector2<R>(ratio.x().value(), ratio.y().value());
  result.jacobian.row(0) = ratio.x().derivatives().transpose();
  result.jacobian.row(1) = ratio.y().derivatives().transpose();
  return result;
}

/// Central differences with a step h: truncation h² times third derivatives, rounding eps/h.
template <FilmLaw Law, class R>
Eigen::Matrix<R, 2, 4> difference_jacobian(const Vector2<R>& e_hat, const Vector2<R>& u, const R& h) {
  const Vector2<R> axes[2] = {Vector2<R>(R(1), R(0)), Vector2<R>(R(0), R(1))};
  Eigen::Matrix<R, 2, 4> jacobian;
  for (int j = 0; j < 4; ++j) {
    const Vector2<R> step = h * axes[j % 2];
    const Vector2<R> none(R(0), R(0));
    const Vector2<R>& de = j < 2 ? step : none;
    const Vector2<R>& du = j < 2 ? none : step;
    const Vector2<R> ahead = force_ratio<Law>(FilmState<R>(Vector2<R>(e_hat + de), Vector2<R>(u + du)));
    const Vector2<R> behind = force_ratio<Law>(FilmState<R>(Vector2<R>(e_hat - de), Vector2<R>(u - du)));
    jacobian.col(j) = (ahead - behind) / (2 * h);
  }
  return jacobian;
}

}  // namespace lubjoint::test
