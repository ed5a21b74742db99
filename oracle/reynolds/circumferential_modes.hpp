/// Finite-length films without a free boundary by separation along the axis: a second solver, beside smooth_film.
#pragma once

#include "lubjoint/film/extent.hpp"
#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// Force of a film whose bounds do not depend on z (full, half, dynamic).
///
/// smooth_film expands P in cosines of ζ and solves an equation around the film for each. Here P is expanded around
/// the film instead, in the eigenfunctions of the other operator: with −(H³v′)′ = λ H³ v, v = 0 at cut ends,
///   P = Σ_j a_j(ζ) v_j(x),   a_j'' − λ_j a_j = −s_j,   a_j(±Λ) = 0,
/// whose mean over ζ is (s_j/λ_j)(1 − tanh(√λ_j Λ)/(√λ_j Λ)): the axis is exact in closed form, no series is cut.
/// The eigenfunctions are Legendre series (Galerkin, so that the force's error is the square of the pressure's) in
/// Sommerfeld's angle χ, tan(x/2) = √((1−ε)/(1+ε)) tan(χ/2), in which the pressure spike is as wide as the film.
/// A full film is solved on half of the circle: the wedge's pressure is odd, the squeeze's even about the line of
/// centres.
///
/// The two solvers share the film's equation and nothing else: no quadrature, coordinate, basis or sum.
///
/// The error estimate is the change from the last coarser basis, plus rounding.
/// Accuracy: 1e-10 of |F| for 0 ≤ ε ≤ 0.99 and L/D 0.05…10; a half film with squeeze, whose pressure has corners at its
/// cut ends, 1e-9. Beyond, the estimate says what was reached.
ScaledForce circumferential_film_force(FilmExtent extent, const ScaledFilm& film, double relative_tolerance);

/// Its side flow: a_j'(Λ) = −(s_j/√λ_j) tanh(√λ_j Λ), and so Σ_j (s_j/√λ_j) tanh(√λ_j Λ) ∫ H³ v_j dx. What a Galerkin
/// basis leaves of it is not the square of the pressure's error: with the source s at a cut end, s_j falls like 1/j,
/// and the error like the fourth power of the basis' size. Of a full film it is zero, and nothing is solved. Accuracy,
/// of ScaledFilm::displacement(): 1e-9; half films in squeeze 3e-7 for ε ≤ 0.9 and L/D ¼…4.
ScaledFlow circumferential_film_flow(FilmExtent extent, const ScaledFilm& film, double relative_tolerance);

}  // namespace lubjoint::oracle
