/// What a film of the bearing's real length is judged by: its forces, flow, shear and pressure, as a solver has them.
#pragma once

#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/steady_film.hpp"

namespace lubjoint::verify {

/// Largest relative errors of what follows at rest: of |F| over itself, of an entry of K or C over the matrix.
struct RestErrors {
  double force = 0;
  double stiffness = 0;
  double damping = 0;
};

/// Films of one kind of onset, each at any L/D. The films are laws with is_solved_film.
class SolvedFilms {
 public:
  virtual ~SolvedFilms() = default;

  /// Force and slopes where a = ε, b = 0. Outside of least_ratio…largest_ratio they go on as powers of ε and 1 − ε, and
  /// say no more than which way it goes.
  virtual SteadySlopes slopes(Law film, Real shape, Real ratio) const = 0;
  virtual RestErrors errors_at_rest(Law film, Real shape, Real ratio) const = 0;
  /// @param a, b  slip and squeeze rate [1/s]
  virtual SolvedForce force(Law film, Real shape, Real ratio, Real a, Real b) const = 0;
  /// Flow and shear.
  virtual SolvedCosts costs(Law film, Real shape, Real ratio, Real a, Real b) const = 0;
  /// @param theta  from the maximum film [rad]; @param zeta  z/R. Zero outside of the film, and of the bearing.
  virtual SolvedPressure pressure(Law film, Real shape, Real ratio, Real a, Real b, Real theta, Real zeta) const = 0;

  /// The same films with the other onset.
  virtual const SolvedFilms& with_other_onset() const = 0;

  static constexpr double least_ratio = 0.002;
  static constexpr double largest_ratio = 0.975;
};

}  // namespace lubjoint::verify
