#pragma once

#include "lubjoint/film/shaped_law.hpp"
#include "lubjoint/film/squeeze_short.hpp"

namespace lubjoint {

/// Force of a finite bearing after Butenschön (1976), as MBDyn has it: fits of a wedge and of a squeeze, added.
///   F_r = −2S[(So_D/ε)|a| cosβ + So_V b],   F_t = 2S(So_D/ε) a sinβ,   S = μLR³/c²,   λ = L/D,   σ = ε sgn b
///   So_D/ε = (λ²/2)√(π²q + 16ε²)/q² · a₁(1 − ε)/(−a₂ − ε),   β = atan2(π√q, 2ε)(a₃ + a₄ε + a₅ε² + a₆ε³ + a₇ε⁴)
///   So_V = 2λ² k(σ) a₈(1 − σ)/(−a₉ − σ),   k: the short squeeze film's resistance
/// a₁ … a₉ are polynomials in λ (their zeros of −aᵢ − ε lie above 1).
/// Source: Butenschön (1976), coefficients as in MBDyn's hydrodynamic plain bearing, which gives the force on the
/// bearing.
/// Accuracy: a few roundings of the fits, which are within 6 % of his table for λ from ⅛ to 1 and ε from 0.1 to 0.99.
/// The sum is not a film's force: against a film with both motions it is off by 12 % in the median, and many times over
/// where wedge and opening meet. Below ε = 0.02 (λ = 1) to 0.06 (λ = ⅛) the wedge pulls outward. Never above λ = 1,
/// where a₈ changes its sign.
struct Butenschoen {
  static constexpr std::string_view name = "butenschoen";                                ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;                      ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                              ///< of the film it stands for
  static constexpr std::string_view words = "finite bearing, Butenschoen's fits added";  ///< for people
  static constexpr bool has_pressure = false;                                            ///< the force is no integral
  static constexpr bool kinks = true;                      ///< wedge at a = 0, squeeze at b = 0
  static constexpr Potential potential = Potential::none;  ///< not even passive
  static constexpr double longest = 1;                     ///< the table's largest L/D
  static constexpr double shortest = 0.125;                ///< the table's smallest L/D

  /// What to know of a bearing of this shape; empty if there is nothing.
  static std::string warning(double shape) {
    if (shape >= shortest) return {};
    return "butenschoen is a fit of a table from L/D = 1/8 to 1: below 1/8 it is extrapolated";
  }

  /// So_D/ε, the wedge's force over 2S|a| [-].
  template <class T>
  static T wedge(const T& epsilon, const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    const T room = q / (1 + epsilon);  // 1 − ε
    const RealOf<T> square = pi<T>() * pi<T>();
    const T short_film = shape * shape * sqrt(T(square * q + 16 * epsilon * epsilon)) / (2 * q * q);
    const RealOf<T> a1 = quartic<T>(shape, 1.1642L, -1.9456L, 7.1161L, -10.1073L, 5.0141L);
    const RealOf<T> a2 = quartic<T>(shape, -1.000026L, -0.023634L, -0.4215L, -0.038817L, -0.090551L);
    return T(short_film * a1 * room / (room - (1 + a2)));
  }

  /// β, from the load to e [rad].
  template <class T>
  static T attitude(const T& epsilon, const T& q, const RealOf<T>& shape) {
    using std::sqrt;
    const auto linear = [&shape](long double constant, long double slope) {
      return RealOf<T>(constant) + RealOf<T>(slope) * shape;
    };
    const T polynomial =
        linear(1.152624L, -0.104565L) +
        epsilon * (linear(-2.5905L, 0.798745L) +
                   epsilon * (linear(8.73393L, -2.3291L) +
                              epsilon * (linear(-13.3414L, 3.424337L) + epsilon * linear(6.6294L, -1.591732L))));
    return T(polar_angle(T(pi<T>() * sqrt(q)), T(2 * epsilon)) * polynomial);
  }

  /// So_V, the squeeze's force over 2S|b| [-], of a film that closes or opens.
  template <class T>
  static T squeeze(const T& epsilon, const T& q, bool opens, const RealOf<T>& shape) {
    const PolarFilmState<T> unit(epsilon, T(0), T(opens ? -1 : 1), q, Unchecked());
    const T radial = SqueezeShort::force_ratio(unit, HalfFilmSide::converging).radial;
    const T resistance = opens ? radial : T(-radial);
    const T room = opens ? T(1 + epsilon) : T(q / (1 + epsilon));  // 1 − σ
    const RealOf<T> a8 = quartic<T>(shape, 0.70038L, 3.2415L, -12.2486L, 18.895L, -9.3561L);
    const RealOf<T> a9 = quartic<T>(shape, -0.999935L, 0.0157434L, -0.74224L, 0.42278L, -0.368928L);
    return T(2 * shape * shape * resistance * a8 * room / (room - (1 + a9)));
  }

  /// F/S [1/s], radial and tangential, as above.
  /// @param shape  L/D, 0 < L/D ≤ 1
  template <class T>
  static PolarForce<T> force_ratio(const PolarFilmState<T>& state, const RealOf<T>& shape) {
    using std::abs;
    using std::cos;
    using std::sin;
    const T& epsilon = state.eccentricity_ratio;
    const T beta = attitude(epsilon, state.q, shape);
    const T by_wedge = 2 * wedge(epsilon, state.q, shape) * state.slip_rate;
    const T by_squeeze = 2 * squeeze(epsilon, state.q, value_of(state.squeeze_rate) < 0, shape) * state.squeeze_rate;
    return {T(-abs(by_wedge) * cos(beta) - by_squeeze), T(by_wedge * sin(beta))};
  }

 private:
  template <class T>
  static RealOf<T> quartic(const RealOf<T>& x, long double a, long double b, long double c, long double d,
                           long double e) {
    using R = RealOf<T>;
    return R(R(a) + x * (R(b) + x * (R(c) + x * (R(d) + x * R(e)))));
  }
};

}  // namespace lubjoint
