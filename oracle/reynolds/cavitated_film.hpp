/// Finite-length film that ruptures where its pressure would become negative (Swift–Stieber).
#pragma once

#include <vector>

#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// Force of the cavitated film, extrapolated to a step of zero.
///
/// Grids of growing fineness, each started from the free boundary of the one before, until the error estimate is within
/// the tolerance or the finest grid is reached. The discretisation is of second order, so its forces are F₀ + C h² + r;
/// r is the rounding of the free boundary to the nodes, as large as h² but without a trend. F₀ and C are fitted by
/// least squares to the grids within a factor of two or so of the finest, each weighted by the inverse variance of its
/// r. The error estimate is the fit's standard error times Student's t for 99.9 %, plus the change from an earlier fit,
/// which sees what is systematic; it is not let fall faster than h² from the grid before; where the observed order is
/// far from 2, at least what the extrapolation changed. The four finest grids, of up to a second each, are for
/// tolerances of 1e-5 and below, where the estimate is still above 1e-5. Of 36 states of L/D ¼ to 4 and ε 0.1 to 0.9
/// that are four; then all reach 1e-5, in a second and a half at most.
/// @param pinned  P = 0 along the maximum film
ScaledForce cavitated_film_force(const ScaledFilm& film, bool pinned, double relative_tolerance);

/// Its side flow, from the balance of the half volumes along the edge, extrapolated likewise.
ScaledFlow cavitated_film_flow(const ScaledFilm& film, bool pinned, double relative_tolerance);

/// I₁ = ∬ dθ dζ/(2ΛH) over the part of the gap that carries pressure, onset free: what is sheared of the film.
/// Extrapolated likewise; a share of a volume at its bounds is as exact as the pressure there, so it is of second
/// order.
ScaledCouette cavitated_film_couette(const ScaledFilm& film, double relative_tolerance);

/// P at the product of the given angles (θ, from the maximum film) and ζ; row-major, one row per angle. From one grid
/// that is at least as fine as the one asked for, by linear interpolation: second order.
std::vector<double> cavitated_film_pressure(const ScaledFilm& film, bool pinned, const std::vector<double>& theta,
                                            const std::vector<double>& zeta);

/// P at one place, from a grid of 48 steps along half of the length. The error estimate is half of the change from a
/// grid of half as many, of which second order leaves a third, and a quarter of the largest P over the steps' square
/// for the rounding of the free boundary to the nodes. Accuracy, of the largest P: 6e-4 for L/D ¼ to 2, ε ≤ 0.9.
ScaledPressure cavitated_film_pressure_at(const ScaledFilm& film, bool pinned, double theta, double zeta);

}  // namespace lubjoint::oracle
