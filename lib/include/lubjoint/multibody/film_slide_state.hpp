/// What a system keeps of journals that slide on the jump of their half film.
#pragma once

#include <Eigen/QR>
#include <cstddef>
#include <vector>

#include "lubjoint/multibody/joint_element.hpp"

namespace lubjoint {

namespace detail {

/// Numbers behind the tangential forces of journals that slide: what a unit of each does.
template <class R>
struct SlideResponse {
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<R, Eigen::Dynamic, 1>;
  Matrix accelerations;  ///< of every velocity, a column each slide
  Matrix multipliers;    ///< of every constraint row
  Vector weights;        ///< units of the forces
  /// Of what a unit of each does to the acceleration across each line.
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
  std::vector<R> forces, solution, lambda;  ///< work

  /// Forces that change the accelerations across the lines by so much. Of journals that hold each other, such as two on
  /// one pin, only the sum is determined: each then has a part in proportion to its reach.
  template <class Right>
  auto forces_for(const Right& accelerations_across) const {
    return (weights.asDiagonal() * decomposition.solve(accelerations_across)).eval();
  }
};

}  // namespace detail

/// A journal that slides on a = 0, held by the force T n⊥ on it and −T n⊥ at the same point of the bearing's body.
/// @tparam ConstraintRow  of the plane or of space
template <class ConstraintRow>
struct FilmSlide {
  using Columns = decltype(ConstraintRow::first);  ///< of a body's velocities
  using T = typename Columns::value_type;          ///< the scalar
  std::size_t joint;                               ///< its number
  SlidePlace<T> place;                             ///< on its line
  ConstraintRow row;                               ///< of n⊥·e = 0: first the bearing's body
  Columns on_bearing;                              ///< what T = 1 puts on the bearing's body: force, moment
  Columns on_journal;                              ///< on the journal's
  T force;                                         ///< T, the share of eq. 20 in it [N]
};

}  // namespace lubjoint
