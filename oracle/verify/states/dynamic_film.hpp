/// Forces of the dynamic films by quadrature of their pressure, in extended precision: what answers are judged by where
/// no certified one is at hand. Shares no formula with the laws of the library, which are closed forms in another
/// frame.
#pragma once

namespace lubjoint::verify {

/// ε, 1 − ε, a and b of a dynamic film, θs…θs + π with θs = atan2(2b, a).
struct DynamicFilm {
  long double ratio;         ///< ε
  long double gap;           ///< 1 − ε, known better than ε can say
  long double slip_rate;     ///< a [1/s]
  long double squeeze_rate;  ///< b [1/s]
};

/// Radial and tangential force over the force scale [1/s].
struct DynamicForce {
  long double radial;
  long double tangential;
};

/// Short film: F_r/S = ½∫ (a sinθ − 2b cosθ) cosθ/H³ dθ, F_t/S the same with sinθ (Flores et al. 2009, eq. 3).
/// @param film  0 ≤ ε < 1, finite rates; at rest the force is zero
/// Accuracy: 1e-16 of |F| for 1 − ε ≥ 1e-12 (a test compares it with the certified data)
DynamicForce short_dynamic_by_quadrature(const DynamicFilm& film);

/// Long film: d/dθ(H³ dp/dθ) ∝ −(a sinθ − 2b cosθ), p = 0 at both ends. One integration gives dp/dθ, whose constant is
/// the mean of a cosθ + 2b sinθ with the weight 1/H³; by parts the force is the covariance of that function with cosθ
/// and sinθ. Parameters and accuracy as above.
DynamicForce long_dynamic_by_quadrature(const DynamicFilm& film);

}  // namespace lubjoint::verify
