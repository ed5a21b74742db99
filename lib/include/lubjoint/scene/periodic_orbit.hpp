/// Periodic motions of scenes, found by shooting.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/scene_assembly.hpp"

namespace lubjoint {

/// A motion that repeats.
struct PeriodicOrbit {
  double period = 0;          ///< [s]
  std::vector<double> state;  ///< (q, q̇) at t = 0
  double miss = 0;            ///< what a period leaves between its start and its end, in the scene's units (clearances)
  std::size_t iterations = 0;  ///< of Newton's method
  std::size_t runs = 0;        ///< of a period each
  /// Largest modulus of the multipliers, the factors by which a small deviation grows in a period: below 1 it dies out.
  /// They are eigenvalues of a matrix of differences of runs, and known to `multiplier_doubt`, no better.
  double largest_multiplier = 0;
  /// What that modulus may be off by: the eigenvalues' conditions times what the matrix is off by, to first order. The
  /// latter is half of what differences of both directions are apart (what their step leaves of second order, and the
  /// runs' errors), and the runs' relative tolerance over the step. Infinite where eigenvectors coincide.
  double multiplier_doubt = 0;

  /// Does a small deviation die out (−1) or grow (1), or can that not be told from this multiplier (0)?
  int growth() const;
};

/// Newton's method on P(z) − z, where z are the coordinates and velocities that the constraints leave free and P is a
/// run of one period. P's derivatives are differences of runs; what they are off by slows the iteration, and is not in
/// its result. Two plain periods come first: a start's own motion has died out by then, or a guess is nearer.
/// @param period  [s]
/// @param tolerance  of `miss`; at least some ten times the run's relative tolerance
/// @throws SceneError  a run that stops, a free journal, or no orbit after 20 iterations
PeriodicOrbit periodic_orbit(const Scene& scene, double period, double tolerance);

}  // namespace lubjoint
