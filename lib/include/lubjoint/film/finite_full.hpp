#pragma once

#include "lubjoint/film/chebyshev_series.hpp"
#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint {

/// Film force of a bearing of finite length, full film: Reynolds' equation with p = 0 at |z| = L/2, periodic around.
///   F = −S [A u + B (ê·u) ê],   S = μLR³/c²,
///   A = α/√q / (q/(4πΛ²) + D/(24π)),   B = β/q^{3/2} / (q/(12πΛ²) + D/(36π)),   D = 2 + ε², Λ = L/D:
/// α = β = 1 is the harmonic mean of the short and the long film. α and β are Chebyshev series in (1−ε²)^¼, compiled
/// for the L/D; beyond the table, ε > 0.9998, they go on along their tangents.
/// Linear in u, so the derivatives and the potential are exact, whatever the table's error.
/// Accuracy: the table states it, 1e-8 of |F| up to ε = 0.99 for L/D ¼ to 4 (tests).
class FiniteFull {
 public:
  static constexpr std::string_view name = "finite_full";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;       ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::full;                  ///< negative pressure kept
  static constexpr std::string_view words = "finite bearing, full film";  ///< for people
  static constexpr bool has_pressure = true;                              ///< the force is its integral
  static constexpr Potential potential = Potential::convex;               ///< of the dissipation
  static constexpr int terms = 28;                                        ///< of each series
  static constexpr double lowest = 0.14;                                  ///< (1−ε²)^¼ where the table ends
  static constexpr std::size_t coefficients = 2 * terms;                  ///< α's, then β's

  /// @throws std::invalid_argument if the table is not one of this law
  explicit FiniteFull(const CompiledFilm& table) : shape_(table.shape) {
    detail::require_table(table, name, coefficients);
    using Column = Eigen::Matrix<double, terms, 1>;
    alpha_ = {detail::series_of<Column>(table, 0), lowest, 1};
    beta_ = {detail::series_of<Column>(table, 1), lowest, 1};
  }

  /// L/D that the table was compiled for.
  double shape() const { return shape_; }

  /// A where α = 1.
  template <class T>
  static T isotropic(const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    const RealOf<T> four_pi = 4 * pi<T>();
    const T root = sqrt(q);
    return T(1 / (root * (q / (four_pi * shape * shape) + (3 - q) / (6 * four_pi))));
  }
  /// B where β = 1.
  template <class T>
  static T along_eccentricity(const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    const RealOf<T> twelve_pi = 12 * pi<T>();
    const T root = sqrt(q);
    return T(1 / (q * root * (q / (twelve_pi * shape * shape) + (3 - q) / (3 * twelve_pi))));
  }

  /// F/S [1/s] in the frame of the film state, as above.
  template <class T>
  Vector2<T> force_ratio(const FilmState<T>& film) const {
    using std::sqrt;
    const RealOf<T> shape(shape_);
    const T root = sqrt(film.q);
    const T v = sqrt(root);
    const T a = alpha_(v) * isotropic(film.q, shape);
    const T b = beta_(v) * along_eccentricity(film.q, shape) * dot(film.eccentricity, film.velocity);
    return Vector2<T>(T(-(a * film.velocity.x() + b * film.eccentricity.x())),
                      T(-(a * film.velocity.y() + b * film.eccentricity.y())));
  }

 private:
  double shape_;
  ChebyshevCurve<terms> alpha_;
  ChebyshevCurve<terms> beta_;
};

}  // namespace lubjoint
