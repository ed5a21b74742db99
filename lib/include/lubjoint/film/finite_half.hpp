#pragma once

#include "lubjoint/film/chebyshev_series.hpp"
#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint {

/// Film force of a bearing of finite length, half film: p = 0 at |z| = L/2 and at θ = 0 and π (a ≥ 0) or π and 2π
/// (a < 0).
///   F_r = −S [εα|a| + βb],   F_t = S [τa + 2εα b sgn(a)],   S = μLR³/c²
/// with one α for both: on each side of a = 0 the force is a gradient (Potential::on_each_side). Over their harmonic
/// means of the short and the long film α, β and τ are Chebyshev series in (1−ε²)^¼, compiled for the L/D; beyond the
/// table, ε > 0.9998, they go on along their tangents.
///
/// F_t jumps at a = 0 by 4Sεα|b|, so that runs need both sides and the journal that slides between them, as with
/// short_half and long_half. With p_a and p_b the pressures of the wedge and of the squeeze on 0…π, whose sources are
/// sinθ and −2cosθ: p = 0 on the whole edge, Reynolds' operator is symmetric, and so ∬p_b sinθ = −2∬p_a cosθ. On the
/// left is half of the jump, on the right twice the radial force of the wedge: the film jumps wherever a wedge has a
/// radial force and b ≠ 0, which is everywhere but at ε = 0. In a closing film (b > 0) both sides push the journal to
/// a = 0, in an opening one away from it. The law depends on the direction of e at ε = 0, as every half film that is
/// not short.
/// Accuracy: the table states it, 1e-7 of |F| up to ε = 0.99 for L/D ¼ to 4 (tests).
class FiniteHalf {
 public:
  static constexpr std::string_view name = "finite_half";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;       ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::half;                  ///< by the sign of a
  static constexpr std::string_view words = "finite bearing, half film";  ///< for people
  static constexpr bool has_pressure = true;                              ///< the force is its integral
  static constexpr Potential potential = Potential::on_each_side;         ///< with a kink at a = 0
  static constexpr int terms = 28;                                        ///< of each series
  static constexpr double lowest = 0.14;                                  ///< (1−ε²)^¼ where the table ends
  static constexpr std::size_t coefficients = 3 * terms;                  ///< α's, β's, τ's

  /// @throws std::invalid_argument if the table is not one of this law
  explicit FiniteHalf(const CompiledFilm& table) : shape_(table.shape) {
    detail::require_table(table, name, coefficients);
    using Column = Eigen::Matrix<double, terms, 1>;
    alpha_ = {detail::series_of<Column>(table, 0), lowest, 1};
    beta_ = {detail::series_of<Column>(table, 1), lowest, 1};
    tau_ = {detail::series_of<Column>(table, 2), lowest, 1};
  }

  /// L/D that the table was compiled for.
  double shape() const { return shape_; }

  /// α, β and τ where their series are 1.
  template <class T>
  struct Means {
    T alpha;  ///< of the cross terms
    T beta;   ///< of the squeeze
    T tau;    ///< of the wedge

    /// @param q  1 − ε²;  @param shape  L/D
    Means(const T& q, const RealOf<T>& shape) {
      using std::sqrt;
      const RealOf<T> half_turn = pi<T>();
      const RealOf<T> square = shape * shape;
      const T root = sqrt(q);
      const T d = 3 - q;
      alpha = T(1 / (q * (q / (4 * square) + d / 12)));
      beta = T(
          1 / (q * root * (q / (2 * half_turn * square * (3 - 2 * q)) + 1 / (6 * (half_turn - 16 / (half_turn * d))))));
      tau = T(1 / (root * (q / (half_turn * square) + d / (6 * half_turn))));
    }
  };

  /// F_r/S and F_t/S [1/s]; a = 0 counts as a ≥ 0.
  template <class T>
  PolarForce<T> force_ratio(const PolarFilmState<T>& state, HalfFilmSide side) const {
    using std::sqrt;
    const Means<T> mean(state.q, RealOf<T>(shape_));
    const T root = sqrt(state.q);
    const T v = sqrt(root);
    const RealOf<T> sign(side == HalfFilmSide::converging ? 1 : -1);
    const T cross = state.eccentricity_ratio * alpha_(v) * mean.alpha;
    return {T(-(cross * (sign * state.slip_rate) + beta_(v) * mean.beta * state.squeeze_rate)),
            T(tau_(v) * mean.tau * state.slip_rate + 2 * sign * cross * state.squeeze_rate)};
  }

  /// F/S [1/s] in the frame of the film state; at ê = 0 the radial direction is that of u.
  template <class T>
  Vector2<T> force_ratio(const FilmState<T>& film) const {
    const PolarView<T> view = polar_view(film);
    return detail::in_plane(force_ratio(view.state, side_of(film)), view.radial);
  }

 private:
  double shape_;
  ChebyshevCurve<terms> alpha_;
  ChebyshevCurve<terms> beta_;
  ChebyshevCurve<terms> tau_;
};

}  // namespace lubjoint
