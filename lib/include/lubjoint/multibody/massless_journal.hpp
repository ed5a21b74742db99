/// A journal whose inertia is left out: its film carries the load at every moment, and the motion is of first order.
#pragma once

#include <Eigen/LU>
#include <array>

#include "lubjoint/multibody/free_journal.hpp"

namespace lubjoint {

/// State of the massless journal: ê.
template <class T>
using MasslessState = std::array<T, 2>;

/// ê̇ = u + ½(ω_J + ω_B) ê⊥,  F(ê, u) = −W.
/// Source: Booker's mobility method; the limit m → 0 of FreeJournal, which it follows, once the start has died away, to
/// first order in m. Law: one that moves_massless_journal, or ChosenLaw, whose film then has_velocity.
template <class Law, class R = double>
requires std::is_same_v<Law, ChosenLaw> || moves_massless_journal<Law>
class MasslessJournal {
 public:
  /// @param drive  its mass is not looked at
  MasslessJournal(const FilmOf<Law, R>& joint, const JournalDrive<R>& drive)
      : joint_(joint), drive_(drive), load_ratio_(-drive.load / joint.force_scale()) {}

  const FilmOf<Law, R>& joint() const { return joint_; }   ///< bearing, oil, law
  const JournalDrive<R>& drive() const { return drive_; }  ///< load, spins

  /// u, the pure-squeeze velocity at which the film carries the load [1/s].
  /// @throws FilmDomainError where ε ≥ 1
  Vector2<R> velocity(const MasslessState<R>& y) const {
    const Vector2<R> e_hat(y[0], y[1]);
    if constexpr (std::is_same_v<Law, ChosenLaw>) {
      return joint_.velocity(e_hat, Vector2<R>(-drive_.load));
    } else {
      return *mobility<Law>(e_hat, one_minus_squared_norm<R>(y[0], y[1]), load_ratio_).velocity;
    }
  }

  /// Right-hand side of the equation above.
  /// @throws FilmDomainError where ε ≥ 1
  void rate(const MasslessState<R>& y, MasslessState<R>& dydt) const {
    const Vector2<R> u = velocity(y);
    const R spin = drive_.mean_spin();
    dydt[0] = u.x() - spin * y[1];
    dydt[1] = u.y() + spin * y[0];
  }

  /// Its derivative, exact: ∂u/∂ê = −(∂F/∂u)⁻¹ ∂F/∂ê.
  /// @throws FilmDomainError where ε ≥ 1
  Eigen::Matrix<R, 2, 2> jacobian(const MasslessState<R>& y) const {
    using D = Dual<R, 4>;
    const Vector2<R> u = velocity(y);
    const Vector2<D> e_hat(D::variable(y[0], 0), D::variable(y[1], 1));
    const Vector2<D> velocity(D::variable(u.x(), 2), D::variable(u.y(), 3));
    const Vector2<D> force = joint_.force(FilmState<D>(e_hat, velocity));
    Eigen::Matrix<R, 2, 4> slopes;
    slopes << force.x().derivatives().transpose(), force.y().derivatives().transpose();
    const Eigen::Matrix<R, 2, 2> by_velocity = slopes.template rightCols<2>();
    Eigen::Matrix<R, 2, 2> result = -by_velocity.inverse() * slopes.template leftCols<2>();
    result(0, 1) -= drive_.mean_spin();
    result(1, 0) += drive_.mean_spin();
    return result;
  }

 private:
  FilmOf<Law, R> joint_;
  JournalDrive<R> drive_;
  Vector2<R> load_ratio_;  ///< −W/S
};

}  // namespace lubjoint
