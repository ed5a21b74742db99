/// The memory that evaluations of a system in space take.
#pragma once

#include <array>
#include <vector>

#include "lubjoint/multibody/envelope_cholesky.hpp"
#include "lubjoint/multibody/film_slide_state.hpp"
#include "lubjoint/multibody/spatial/constraint_row.hpp"
#include "lubjoint/multibody/spatial/joint_element.hpp"
#include "lubjoint/multibody/spatial/turn_history.hpp"
#include "lubjoint/multibody/table_curves.hpp"

namespace lubjoint {

template <class T>
struct SpatialWorkspace;

namespace detail {

/// What an evaluation needs beside the workspace on a scalar with derivatives; on a plain number, nothing.
template <class T, bool = ScalarTraits<T>::carries_derivatives>
struct SpatialDifferentiation {};
template <class T>
struct SpatialDifferentiation<T, true> {
  using R = RealOf<T>;
  using Derivatives = std::decay_t<decltype(std::declval<T>().derivatives())>;
  SpatialWorkspace<R> at;  ///< the values
  std::vector<R> state;    ///< y without derivatives
  std::vector<Derivatives> d_accelerations, d_multipliers, d_forces, d_kept;

  void resize(std::size_t states, std::size_t velocities, std::size_t constraint_rows, std::size_t kept_rows) {
    state.resize(states);
    d_accelerations.resize(velocities);
    d_multipliers.resize(constraint_rows);
    d_forces.resize(velocities);
    d_kept.resize(kept_rows);
  }
};

}  // namespace detail

/// What a run keeps of a system in space between evaluations, for one scalar T. Made by SpatialSystem::workspace; an
/// evaluation takes no other memory.
template <class T>
struct SpatialWorkspace {
  using R = RealOf<T>;                                 ///< the number itself
  std::vector<SpatialFrame<T>> frames;                 ///< of the bodies
  SpatialFrame<T> ground = spatial_ground_frame<T>();  ///< what stands in for a body
  std::vector<SpatialRow<T>> rows;                     ///< of Φ = 0, those that are left out as well
  std::vector<SpatialJointForce<T>> joints;            ///< what each joint does
  std::vector<T> forces;                   ///< f inertial, n′ − ω̃′J′ω′ in the body's frame; with
                                           ///< derivatives, these alone
  std::vector<T> accelerations;            ///< (r̈, ω̇′) of each body
  std::vector<T> multipliers;              ///< λ; 0 of rows that are left out
  std::vector<std::array<R, 6>> weighted;  ///< M⁻¹ times the columns of each side of each row
  EnvelopeCholesky<R> schur;               ///< Φ_v M⁻¹ Φ_vᵀ of the rows that are kept
  std::vector<R> kept;                     ///< work of a solve
  /// Of the journals that slide on the jump of their half film, if any.
  std::vector<FilmSlide<SpatialRow<T>>> slides;
  detail::SlideResponse<R> slide_response;  ///< of these; of numbers alone
  /// What counts revolutions of angles; none: angles are those of the revolution of their zero.
  const TurnHistory<R>* turns = nullptr;
  /// Of the tables of moving loads, one a load, where they are held; else null.
  const std::vector<TablePiece>* table_pieces = nullptr;
  detail::SpatialDifferentiation<T> implicit;  ///< derivatives through the solve
};

}  // namespace lubjoint
