/// Where a film is as its own motion sees it: coordinates in which the forces of finite films are smooth.
///
/// Let û = u/|u|, x = ê·û, y = ê·û⊥. A film that carries pressure in front of the journal ends near the diameter across
/// û; as ε → 1 a layer of width √q forms there, which no fixed grid in the direction of ê resolves. In Sommerfeld's
/// angle of the dynamic film (dynamic_moments.hpp)
///     N² = q + x² = 1 − y²,   cosδ = −x/N,   sinδ = √q/N
/// the layer is all of 0 < δ < π, and every exact law of the short and the long film is a power of N times a function
/// of δ (the long dynamic one also of y²). There is no singular point at ê = 0, as there is in ε and an angle. With
///     s = √(sinδ),   t = (x/N)/√((1+s)(1+s²)) = ±√(1−s),   r = √N
/// the disc ε < 1 is the rectangle |t| < 1, 0 < r ≤ 1; t is odd in x and analytic, r even in y; √s and √N make the
/// powers of (1−ε)^¼ smooth that appear as ε → 1. Closing films are at t → 1, opening ones at t → −1.
///
/// The force's size is taken out by a function with the right powers on either side, which needs no angle:
///     W = 12π r/(κ√κ (1 + 2Nκ/Λ²)),   κ = 2(N − x):
/// κ^{−3/2} where the film is long, κ^{−5/2} where it is short.
#pragma once

#include "lubjoint/number/vector.hpp"

namespace lubjoint::detail {

/// The coordinates of a film place.
template <class T>
struct FilmPlace {
  T x;      ///< ê·û
  T y;      ///< ê·û⊥
  T n;      ///< N
  T s;      ///< √(sinδ)
  T m;      ///< √((1+s)(1+s²)) = x/(N t)
  T t;      ///< around the film
  T r;      ///< √N
  T kappa;  ///< κ

  /// @param e_along  ê·û;  @param e_across  ê·û⊥;  @param q  1 − ε²
  FilmPlace(const T& e_along, const T& e_across, const T& q) : x(e_along), y(e_across) {
    using std::sqrt;
    const T square = q + x * x;
    n = T(sqrt(square));
    r = T(sqrt(n));
    const T root = sqrt(q);
    const T sine = root / n;
    s = T(sqrt(sine));
    const T product = (1 + s) * (1 + sine);
    m = T(sqrt(product));
    t = T(x / (n * m));
    kappa = value_of(x) > 0 ? T(2 * q / (n + x)) : T(2 * (n - x));
  }

  /// W of a bearing of this L/D.
  T size(const RealOf<T>& shape) const {
    using std::sqrt;
    const RealOf<T> twelve_pi = 12 * pi<T>();
    const T root = sqrt(kappa);
    return T(twelve_pi * r / (kappa * root * (1 + 2 * n * kappa / (shape * shape))));
  }
};

}  // namespace lubjoint::detail
