/// Sommerfeld's angle ψ, and antiderivatives that are polynomials in ψ, sinψ, cosψ, sinθ and cosθ.
///
///   cosψ = (ε + cosθ)/H,  sinψ = √q sinθ/H,  dψ/dθ = √q/H
/// ψ is the continuous branch with ψ(0) = 0: it grows by 2π with θ and has no jump, whereas its usual expression
/// 2 arctan(√((1−ε)/(1+ε)) tan(θ/2)) falls by 2π at θ = π.
#pragma once

#include "oracle/proofs/formulas.hpp"

namespace lubjoint::proofs {

/// An end of a film: the angle θ by its cosine and sine, and ψ there.
struct FilmEnd {
  ex cos_theta;
  ex sin_theta;
  ex psi;
};
FilmEnd film_end_at_half_turns(int half_turns);  ///< θ = ψ = nπ
FilmEnd dynamic_film_start();                    ///< θs, ψs
FilmEnd dynamic_film_end();                      ///< θs + π, ψs + 2δ

ex cos_psi_of(const ex& cos_theta);
ex sin_psi_of(const ex& cos_theta, const ex& sin_theta);

/// The integrand g(θ) dθ as G(ψ) dψ.
ex integrand_in_psi(const ex& integrand);

/// Antiderivative in `angle` of a polynomial in sin(angle) and cos(angle).
/// @throws std::domain_error if it is not such a polynomial (Algebra: relations of the coefficients)
ex trigonometric_antiderivative(const ex& integrand, const symbol& angle);

/// Antiderivative in ψ of an integrand in θ.
ex antiderivative(const ex& integrand);

/// Antiderivatives of p cosθ and p sinθ by parts: p sinθ − ∫p′ sinθ dθ and −p cosθ + ∫p′ cosθ dθ, with the slope p′
/// in the form (a cosθ + 2b sinθ + C)/H³; p itself may contain ψ.
Polar antiderivatives_of_force(const ex& pressure, const ex& slope);

/// d/dθ of an expression in θ and ψ(θ), with ψ eliminated except where it stands alone.
ex total_derivative(const ex& expression);

/// Value of an expression in θ and ψ at an end of the film.
ex value_at(const ex& expression, const FilmEnd& end);
ex between(const ex& antiderivative, const FilmEnd& from, const FilmEnd& to);

/// One closed form: the antiderivatives differentiate to p cosθ and p sinθ, and their differences are the force.
/// @param scale  S-scaled factor before the integral: 1/2 (short), 6 (long)
void prove_force(Proof& proof, const ex& pressure, const Polar& primitive, const FilmEnd& from, const FilmEnd& to,
                 const ex& scale, const Polar& claimed);

}  // namespace lubjoint::proofs
