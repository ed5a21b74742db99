#pragma once

#include <limits>

#include "lubjoint/film/shaped_law.hpp"

namespace lubjoint {

/// Impedance of a finite bearing that cavitates, after Moes and Bosma, as used by Schwab et al.: a fit.
///   F = −2S|u||W| λ,   S = μLR³/c²,   |W| = 1/|M(ê·λ, ê·λ⊥)|,   Q = (1 − ξ)/(L/D)²,
///   M∥ = 0.150 (1 − ξ)^{3/2} (1 + 2.12Q),   M⊥ = −0.150 (1 − ξ)^{1/2} (3η/4)(1 + 3.60Q)
/// The load's direction λ is at the angle β from û. With x = ê·û, y = ê·û⊥, w = 1 − y², B = q/(L/D)²,
///   β = arcsin y − (1 − x/√w) [arcsin y − arctan(y/(k√w))],   k = 4(1 + 2.12B)/(3(1 + 3.60B)):
/// the published angle from the load to e is that of e from û less β; written so it needs no angle of e, and neither
/// y = 0 nor ê = 0 is singular.
/// Source: Childs, Moes and van Leeuwen (1977); Moes and Bosma (1981). Their text was not at hand: the constants are
/// recalled and pinned by limits, 0.150 by √2/(3π) (long film that closes, ε → 1), 0.150·2.12 by 1/π and 0.150·¾·3.60
/// by 4/π² (short film, ε → 0).
/// Accuracy: a few roundings of the fit. The fit is off the finite film with free onset by up to 3.4 % (ε ≤ 0.5) and
/// 26 % (ε ≤ 0.9) at L/D = ½, 12 % and 22 % at L/D = 1, 35 % at L/D = 2; its direction by at most 5°.
struct MoesImpedance {
  static constexpr std::string_view name = "moes_impedance";                           ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;                    ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                            ///< θs…θs + π
  static constexpr std::string_view words = "finite bearing, Moes' impedance, a fit";  ///< for people
  static constexpr bool has_pressure = false;                                          ///< the force is no integral
  static constexpr Potential potential = Potential::none;                     ///< nearly: ∂F/∂u is symmetric to 2 %
  static constexpr double longest = std::numeric_limits<double>::infinity();  ///< every L/D, with a warning

  /// What to know of a bearing of this shape; empty if there is nothing.
  static std::string warning(double shape) {
    if (shape < 1) return {};
    return "moes_impedance is a fit for short bearings: from L/D = 1 on its force is off by 10 % to 35 % at every "
           "eccentricity";
  }

  /// The direction of the load, as its angle from û.
  template <class T>
  static T load_angle(const T& x, const T& y, const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    using R = RealOf<T>;
    const T w = q + x * x;
    const T root = sqrt(w);
    const T ratio = q / (shape * shape);
    const T k = 4 * (1 + R(2.12L) * ratio) / (3 * (1 + R(3.60L) * ratio));
    const T share = value_of(x) > 0 ? T(q / (root * (root + x))) : T(1 - x / root);  // 1 − x/√w
    const T arc = polar_angle(y, root);
    return T(arc - share * (arc - polar_angle(y, T(k * root))));
  }

  /// |M| at ξ = ê·λ, η = ê·λ⊥.
  template <class T>
  static Vector2<T> mobility(const T& xi, const T& eta, const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    using R = RealOf<T>;
    const T room = value_of(xi) > 0 ? T((q + eta * eta) / (1 + xi)) : T(1 - xi);  // 1 − ξ
    const T ratio = room / (shape * shape);
    const T root = sqrt(room);
    return Vector2<T>(T(R(0.150L) * room * root * (1 + R(2.12L) * ratio)),
                      T(R(-0.150L) * root * (3 * eta / 4) * (1 + R(3.60L) * ratio)));
  }

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  /// @param shape  L/D > 0
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film, const RealOf<T>& shape) {
    using std::cos;
    using std::sin;
    const Vector2<T> along = detail::direction_in_range(film.velocity);
    const Vector2<T> across = perpendicular(along);
    const T x = dot(film.eccentricity, along);
    const T y = dot(film.eccentricity, across);
    const T angle = load_angle(x, y, film.q, shape);
    const T c = cos(angle);
    const T s = sin(angle);
    const Vector2<T> m = mobility(T(x * c + y * s), T(y * c - x * s), film.q, shape);
    const T size = -2 * detail::norm_in_range(film.velocity) / detail::norm_in_range(m);
    return Vector2<T>(T(size * (c * along.x() + s * across.x())), T(size * (c * along.y() + s * across.y())));
  }
};

}  // namespace lubjoint
