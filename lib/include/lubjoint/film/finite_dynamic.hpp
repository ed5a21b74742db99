#pragma once

#include "lubjoint/film/chebyshev_series.hpp"
#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/film/film_place.hpp"

namespace lubjoint {

/// Film force of a bearing of finite length, dynamic film: p = 0 at |z| = L/2 and at θs and θs + π, the bounds of the
/// short film.
///   F = −S|u| W [ρ û + (y/N) σ û⊥],   S = μLR³/c²   (W, N, y and the coordinates t, r: film_place.hpp)
/// ρ and σ are sums of products of Chebyshev polynomials in t and r, compiled for the L/D. Smooth away from u = 0, at
/// ê = 0 and where the film turns from closing to opening, too; mirrored with its state exactly. Beyond the table
/// (|t| > 0.92 or r < 0.18: nothing below ε = 0.999) the sums go on along their tangents.
/// Accuracy: the table states it, up to ε = 0.99 7e-6 of |F| at L/D ¼ and below 1e-6 from ½ to 4 (tests).
class FiniteDynamic {
 public:
  static constexpr std::string_view name = "finite_dynamic";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;          ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                  ///< θs…θs + π
  static constexpr std::string_view words = "finite bearing, dynamic film";  ///< for people
  static constexpr bool has_pressure = true;                                 ///< the force is its integral
  static constexpr Potential potential = Potential::none;                    ///< ∂F/∂u is not symmetric
  static constexpr int around = 28;                                          ///< polynomials in t
  static constexpr int outward = 14;                                         ///< and in r
  static constexpr double reach = 0.92;                                      ///< |t| where the table ends
  static constexpr double lowest = 0.18;                                     ///< r where it ends
  static constexpr std::size_t coefficients = 2 * around * outward;          ///< ρ's, then σ's

  /// @throws std::invalid_argument if the table is not one of this law
  explicit FiniteDynamic(const CompiledFilm& table) : shape_(table.shape) {
    detail::require_table(table, name, coefficients);
    using Table = Eigen::Matrix<double, around, outward>;
    rho_ = {detail::series_of<Table>(table, 0), reach, lowest};
    sigma_ = {detail::series_of<Table>(table, 1), reach, lowest};
  }

  /// L/D that the table was compiled for.
  double shape() const { return shape_; }

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  Vector2<T> force_ratio(const FilmState<T>& film) const {
    const Vector2<T> along = detail::direction_in_range(film.velocity);
    const Vector2<T> across = perpendicular(along);
    const detail::FilmPlace<T> place(dot(film.eccentricity, along), dot(film.eccentricity, across), film.q);
    const T size = -detail::norm_in_range(film.velocity) * place.size(RealOf<T>(shape_));
    const T ahead = size * rho_(place.t, place.r);
    const T aside = size * (place.y / place.n) * sigma_(place.t, place.r);
    return Vector2<T>(T(ahead * along.x() + aside * across.x()), T(ahead * along.y() + aside * across.y()));
  }

 private:
  double shape_;
  ChebyshevSurface<around, outward> rho_;
  ChebyshevSurface<around, outward> sigma_;
};

}  // namespace lubjoint
