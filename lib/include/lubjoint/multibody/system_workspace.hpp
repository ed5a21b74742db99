/// What a run keeps of a system between evaluations.
#pragma once

#include <Eigen/QR>
#include <type_traits>
#include <utility>
#include <vector>

#include "lubjoint/multibody/constraint_row.hpp"
#include "lubjoint/multibody/envelope_cholesky.hpp"
#include "lubjoint/multibody/joint_element.hpp"
#include "lubjoint/multibody/table_curves.hpp"

namespace lubjoint {

namespace detail {

/// What the solve needs beside the workspace on a scalar with derivatives: the numbers, and the derivatives as
/// right-hand sides of the same factors. On a plain number, nothing.
template <class T, bool = ScalarTraits<T>::carries_derivatives>
struct ImplicitDifferentiation {
  void resize(std::size_t, std::size_t) {}
};
template <class T>
struct ImplicitDifferentiation<T, true> {
  using R = RealOf<T>;
  using Derivatives = std::decay_t<decltype(std::declval<T>().derivatives())>;
  std::vector<ConstraintRow<R>> rows;
  std::vector<R> accelerations;
  std::vector<R> multipliers;
  std::vector<Derivatives> d_accelerations;
  std::vector<Derivatives> d_multipliers;

  void resize(std::size_t coordinates, std::size_t constraint_rows) {
    rows.resize(constraint_rows);
    accelerations.resize(coordinates);
    multipliers.resize(constraint_rows);
    d_accelerations.resize(coordinates);
    d_multipliers.resize(constraint_rows);
  }
};

/// Numbers behind the tangential forces of journals that slide: what a unit of each does.
template <class R>
struct SlideResponse {
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<R, Eigen::Dynamic, 1>;
  Matrix accelerations;  ///< of every coordinate, a column each slide
  Matrix multipliers;    ///< of every constraint row
  Vector weights;        ///< units of the forces
  /// Of what a unit of each does to the acceleration across each line.
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
  std::vector<R> solution, lambda;  ///< work

  /// Forces that change the accelerations across the lines by so much. Of journals that hold each other, such as two on
  /// one pin, only the sum is determined: each then has a part in proportion to its reach.
  template <class Right>
  auto forces_for(const Right& accelerations_across) const {
    return (weights.asDiagonal() * decomposition.solve(accelerations_across)).eval();
  }
};

}  // namespace detail

/// A journal that slides on a = 0, held by the force T n⊥ on it and −T n⊥ at the same point of the bearing's body.
template <class T>
struct FilmSlide {
  std::size_t joint;            ///< its number
  SlidePlace<T> place;          ///< on its line
  ConstraintRow<T> row;         ///< of n⊥·e = 0: first the bearing's body
  std::array<T, 3> on_bearing;  ///< what T = 1 puts on the bearing's body: force, moment
  std::array<T, 3> on_journal;  ///< on the journal's
  T force;                      ///< T, the share of eq. 20 in it [N]
};

/// What a run keeps of a system between evaluations, for one scalar T. Made by PlanarSystem::workspace; an evaluation
/// takes no other memory.
template <class T>
struct SystemWorkspace {
  using R = RealOf<T>;                        ///< the number itself
  std::vector<PlanarFrame<T>> frames;         ///< of the bodies
  PlanarFrame<T> ground{ground_motion<T>()};  ///< what stands in for a body
  std::vector<ConstraintRow<T>> rows;         ///< of Φ = 0
  std::vector<JointForce<T>> joints;          ///< what each joint does
  std::vector<T> shear_torques;               ///< T_J of each joint with shear, in the order of sheared_joints
  std::vector<T> forces;                      ///< g: loads, weights and joints
  std::vector<T> accelerations;               ///< q̈
  std::vector<T> multipliers;                 ///< λ
  std::vector<FilmSlide<T>> slides;           ///< of the journals that slide, if any
  detail::SlideResponse<R> slide_response;    ///< of these
  EnvelopeCholesky<R> schur;                  ///< Φq M⁻¹ Φqᵀ
  /// Memory for derivatives through the solve.
  detail::ImplicitDifferentiation<T> implicit;
  /// Of the tables of moving loads, one a load, where a run holds them; kept by whoever evaluates.
  const std::vector<TablePiece>* table_pieces = nullptr;
};

}  // namespace lubjoint
