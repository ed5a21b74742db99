/// What a run keeps of a system between evaluations.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "lubjoint/multibody/constraint_row.hpp"
#include "lubjoint/multibody/envelope_cholesky.hpp"
#include "lubjoint/multibody/film_slide_state.hpp"
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

}  // namespace detail

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
  detail::SlideResponse<R> slide_response;    ///< of the journals that slide, if any
  /// These, in their order.
  std::vector<FilmSlide<ConstraintRow<T>>> slides;
  EnvelopeCholesky<R> schur;  ///< Φq M⁻¹ Φqᵀ
  /// Memory for derivatives through the solve.
  detail::ImplicitDifferentiation<T> implicit;
  /// Of the tables of moving loads, one a load, where a run holds them; kept by whoever evaluates.
  const std::vector<TablePiece>* table_pieces = nullptr;
};

}  // namespace lubjoint
