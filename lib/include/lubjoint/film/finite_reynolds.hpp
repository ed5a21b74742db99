#pragma once

#include "lubjoint/film/chebyshev_series.hpp"
#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/film/film_place.hpp"

namespace lubjoint {

/// Film force of a bearing of finite length whose film ruptures and reforms where its pressure would become negative
/// (Swift–Stieber), with a free onset: p = 0 at |z| = L/2, p ≥ 0, p = ∂p/∂n = 0 at the film's own bounds.
///   F = −S|u| [W∥ û + W⊥ û⊥],   W∥ = W e^g,   W⊥ = ½ (y ∂_x − x ∂_y) W∥,   S = μLR³/c²   (W, x, y: film_place.hpp)
/// The force is a gradient, F = −½ ∂Φ/∂u with Φ = S|u|² W∥, so that one scalar is the whole law: g, a sum of products
/// of Chebyshev polynomials in the coordinates t and r, compiled for the L/D. W⊥ is its derivative, in closed form
///   W⊥ = ½ W∥ (y/N) [x/(2N) + 3/2 + κ²/(Λ² + 2Nκ) + s m g_t/4 + x g_r/(2r)],
/// and the law is symmetric whatever the table's error. Smooth away from u = 0, at ê = 0, too; mirrored with its state
/// exactly. Beyond the table (|t| > 0.8 or r < 0.36: nothing below ε = 0.99) g goes on along its tangents: the force is
/// continuous, its derivatives are not.
/// Accuracy: the table states it, 1.4e-4 of |F| up to ε = 0.95 for L/D ¼ to 4 (tests).
class FiniteReynolds {
 public:
  static constexpr std::string_view name = "finite_reynolds";                   ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;             ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                     ///< nearly: its bounds are its own
  static constexpr std::string_view words = "finite bearing, cavitating film";  ///< for people
  static constexpr bool has_pressure = true;                                    ///< the force is its integral
  static constexpr bool has_free_boundary = true;                               ///< where the film shears oil
  static constexpr Potential potential = Potential::convex;                     ///< of the dissipation
  static constexpr int around = 20;                                             ///< polynomials in t
  static constexpr int outward = 12;                                            ///< and in r
  static constexpr double reach = 0.80;                                         ///< |t| where the table ends
  static constexpr double lowest = 0.36;                                        ///< r where it ends
  static constexpr std::size_t coefficients = around * outward;                 ///< g's

  /// @throws std::invalid_argument if the table is not one of this law
  explicit FiniteReynolds(const CompiledFilm& table) : shape_(table.shape) {
    detail::require_table(table, name, coefficients);
    g_ = {detail::series_of<Eigen::Matrix<double, around, outward>>(table, 0), reach, lowest};
  }

  /// L/D that the table was compiled for.
  double shape() const { return shape_; }

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  Vector2<T> force_ratio(const FilmState<T>& film) const {
    using std::exp;
    const RealOf<T> square(RealOf<T>(shape_) * RealOf<T>(shape_));
    const Vector2<T> along = detail::direction_in_range(film.velocity);
    const Vector2<T> across = perpendicular(along);
    const detail::FilmPlace<T> place(dot(film.eccentricity, along), dot(film.eccentricity, across), film.q);
    const Jet<T> g = g_.template jet<T>(place.t, place.r);
    const T size = -detail::norm_in_range(film.velocity) * place.size(RealOf<T>(shape_));
    const T ahead = size * exponential(g.value);
    const T turn = place.x / (2 * place.n) + RealOf<T>(1.5) +
                   place.kappa * place.kappa / (square + 2 * place.n * place.kappa) +
                   place.s * place.m * g.by_first / 4 + place.x * g.by_second / (2 * place.r);
    const T aside = ahead * (place.y / (2 * place.n)) * turn;
    return Vector2<T>(T(ahead * along.x() + aside * across.x()), T(ahead * along.y() + aside * across.y()));
  }

 private:
  /// e^x of any scalar: dual numbers have the number's own derivative.
  template <class T>
  static T exponential(const T& x) {
    using std::exp;
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      const RealOf<T> value = exp(value_of(x));
      return T(value + value * T(x - value_of(x)));
    } else {
      return T(exp(x));
    }
  }

  double shape_;
  ChebyshevSurface<around, outward> g_;
};

}  // namespace lubjoint
