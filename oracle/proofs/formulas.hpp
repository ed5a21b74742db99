/// The formulas under proof, written anew from their sources: nothing here is shared with the library.
///
/// Forces are over the scale S (short S = μRL³/c², long S = μLR³/c²); s stands for √(1 − ε²), s² = 1 − ε².
#pragma once

#include <ginac/ginac.h>

#include <tuple>

#include "oracle/proofs/algebra.hpp"

namespace lubjoint::proofs {

using GiNaC::cos;
using GiNaC::ex;
using GiNaC::Pi;
using GiNaC::pow;
using GiNaC::sin;
using GiNaC::symbol;

/// An exact fraction: a quotient of two C++ integers would be cut off.
inline ex frac(long numerator, long denominator) { return GiNaC::numeric(numerator, denominator); }

/// The symbols that the proofs share.
struct Symbols {
  symbol eps{"eps"};      ///< ε = |e|/c
  symbol s{"s"};          ///< √(1 − ε²)
  symbol a{"a"};          ///< slip rate
  symbol b{"b"};          ///< squeeze rate
  symbol sigma{"sigma"};  ///< sgn(a), so that |a| = σa
  symbol theta{"theta"};  ///< from the maximum film
  symbol psi{"psi"};      ///< Sommerfeld's angle
  symbol delta{"delta"};  ///< half the length of the dynamic film in Sommerfeld's angle
  symbol psi_start{"psi_start"};
  symbol cos_start{"cos_start"};  ///< cosθs
  symbol sin_start{"sin_start"};  ///< sinθs
  symbol speed{"speed"};          ///< |u|
};
const Symbols& sym();

ex q();                           ///< 1 − ε²
ex d_factor();                    ///< D = 2 + ε²
ex film_at(const ex& cos_theta);  ///< H = 1 + ε cosθ

/// Field of ε, s, σ, the angle θ and everything else as free symbols.
Algebra film_algebra();

struct Polar {
  ex radial;
  ex tangential;

  Polar subs(const GiNaC::exmap& map) const { return {radial.subs(map), tangential.subs(map)}; }
};
Polar operator+(const Polar& x, const Polar& y);
Polar operator-(const Polar& x, const Polar& y);
Polar operator*(const ex& factor, const Polar& x);
void equal(Proof& proof, const Algebra& algebra, const Polar& x, const Polar& y);

/// F·u with b = u·r and a = −2u·t.
ex power_of(const Polar& force);

// Published closed forms; the half films for sgn(a) = σ.
Polar short_full();
Polar short_half();
Polar long_full();
Polar long_half();
Polar long_half_eq5();

/// Pinkus and Sternlicht's law for given K (K² = q(a²/4 + b²)); closing: b ≥ 0.
Polar pinkus_sternlicht(const ex& k_upper, bool closing);

/// a sinθ − 2b cosθ.
ex reynolds_source(const ex& theta);
/// Short pressure without 3μ/c² · (L²/4 − z²).
ex short_profile();
/// Long pressure, eq. 5, without 6μ(R/c)²: with its division by ε, and with that division carried out.
ex long_profile_printed();
ex long_profile();

// Plane vectors.
struct Planar {
  ex x;
  ex y;
};
Planar operator+(const Planar& v, const Planar& w);
Planar operator-(const Planar& v, const Planar& w);
Planar operator*(const ex& factor, const Planar& v);
ex dot(const Planar& v, const Planar& w);
ex cross(const Planar& v, const Planar& w);
Planar turned_90(const Planar& v);
Planar turned(const Planar& v, const ex& cosine, const ex& sine);
void equal(Proof& proof, const Algebra& algebra, const Planar& v, const Planar& w);

/// Moments of the dynamic film in the frame of u, in closed form (δ is a symbol; s² = q = 1 − e₁² − e₂²).
struct FrameMoments {
  ex v;
  ex a;
  ex e;
  ex w;
};
FrameMoments frame_moments(const ex& e1, const ex& e2, const ex& root_q, const ex& delta);

/// F = −|u|(along û + across û⊥) of the dynamic films, over S.
struct Resistance {
  ex along;
  ex across;
};
Resistance short_dynamic(const ex& e1, const ex& e2, const ex& root_q, const ex& delta);
Resistance long_dynamic(const ex& e1, const ex& e2, const ex& root_q, const ex& delta);
/// Second moment of the short dynamic film across u, ∫ d₂²/H³ dφ: [(q + 3e₂²)V + 2e₁e₂²q√q/N⁴]/q^{5/2}.
ex short_dynamic_across(const ex& e1, const ex& e2, const ex& root_q, const ex& delta);

/// a = 2|u| cosθs and b = |u| sinθs.
GiNaC::exmap in_dynamic_motion();

/// The same in polar components, with a = 2|u| cosθs, b = |u| sinθs.
Polar in_polar_components(Resistance (*law)(const ex&, const ex&, const ex&, const ex&));

}  // namespace lubjoint::proofs
