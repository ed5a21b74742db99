/// Linear stiffness and damping of a film about a steady state, in closed form and by exact derivatives.
///
/// K = −∂F/∂e and C = −∂F/∂v where a journal of spin ω ≠ 0 rests at ε in a bearing that does not turn: a = εω, b = 0.
/// In (r, t), with F_r(ε, a, b), F_t(ε, a, b) and ′ = d/dε along a = εω,
///   K_rr = −F_r′/c,  K_tr = −F_t′/c,  K_rt = F_t/(cε),  K_tt = −F_r/(cε),
///   C_rr = −∂_b F_r/c,  C_tr = −∂_b F_t/c,  C_rt = 2∂_a F_r/c,  C_tt = 2∂_a F_t/c.
/// Where the spin is negative the picture is mirrored: K_rt, K_tr, C_rt and C_tr change their signs.
#pragma once

#include <concepts>
#include <limits>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/rotor_threshold.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// K over S|ω|/c and C over S/c in (r, t), first index the force's direction; of ω > 0, or as said.
template <class R>
struct CoefficientRatios {
  Eigen::Matrix<R, 2, 2> stiffness;  ///< K c/(S|ω|) [-]
  Eigen::Matrix<R, 2, 2> damping;    ///< C c/S [-]

  /// Row by row: K_rr, K_rt, K_tr, K_tt, and C likewise.
  static CoefficientRatios of(const R& krr, const R& krt, const R& ktr, const R& ktt, const R& crr, const R& crt,
                              const R& ctr, const R& ctt) {
    CoefficientRatios ratios;
    ratios.stiffness << krr, krt, ktr, ktt;
    ratios.damping << crr, crt, ctr, ctt;
    return ratios;
  }

  /// Those of the opposite spin.
  CoefficientRatios mirrored() const {
    CoefficientRatios other = *this;
    for (auto* m : {&other.stiffness, &other.damping}) {
      (*m)(0, 1) = -(*m)(0, 1);
      (*m)(1, 0) = -(*m)(1, 0);
    }
    return other;
  }
};

/// A place of a steady journal: ε, with q = 1 − ε².
template <class R>
struct SteadyPlace {
  R eccentricity_ratio;  ///< 0 < ε < 1
  R q;                   ///< 1 − ε²

  /// @throws FilmDomainError unless 0 < ε < 1: at ε = 0 nothing is carried, and no direction is the load's
  explicit SteadyPlace(const R& epsilon) : SteadyPlace(epsilon, one_minus_square(epsilon)) {}
  /// For a caller that knows q better than ε can say.
  SteadyPlace(const R& epsilon, const R& known_q) : eccentricity_ratio(epsilon), q(known_q) {
    if (epsilon > 0 && epsilon < 1 && q > 0) return;
    Message message;
    message << "no steady state at eccentricity ratio " << epsilon << "; allowed are ratios above 0 and below 1";
    throw FilmDomainError(message.str());
  }
  /// The film there, of spin ±1: forces over S|ω|.
  PolarFilmState<R> film(int spin_sign) const {
    return {eccentricity_ratio, R(spin_sign * eccentricity_ratio), R(0), q};
  }
};

namespace detail {

/// Of the long films that lie on 0…π at b = 0; they differ in their answer to a squeeze.
template <class R>
CoefficientRatios<R> long_coefficients(const SteadyPlace<R>& at, const R& crr, const R& ctr) {
  using std::sqrt;
  const R& e = at.eccentricity_ratio;
  const R& q = at.q;
  const R ee = e * e;
  const R d = 2 + ee;
  const R dq = d * q;
  const R root = sqrt(q);
  return CoefficientRatios<R>::of(R(24 * e * (2 + ee * ee) / (dq * dq)), R(6 * pi<R>() / (d * root)),
                                  R(-6 * pi<R>() * (2 - ee + 2 * ee * ee) / (d * dq * root)), R(12 * e / dq), crr,
                                  R(-24 * e / dq), ctr, R(12 * pi<R>() / (d * root)));
}

}  // namespace detail

/// Closed coefficients of a law, ω > 0; a law that has none is differentiated. Each is proved in oracle/proofs.
template <class Law>
struct ClosedCoefficients;

/// Short full: only C_rr, C_tt, K_rt and K_tr.
template <>
struct ClosedCoefficients<ShortFull> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R& q = place.q;
    const R q32 = q * sqrt(q);
    const R growth = 1 + 2 * place.eccentricity_ratio * place.eccentricity_ratio;
    return CoefficientRatios<R>::of(R(0), R(pi<R>() / (2 * q32)), R(-pi<R>() * growth / (2 * q * q32)), R(0),
                                    R(pi<R>() * growth / (q * q32)), R(0), R(0), R(pi<R>() / q32));
  }
};

/// Short half. Source: also Friswell et al., Dynamics of Rotating Machines (2010), in other variables.
template <>
struct ClosedCoefficients<ShortHalf> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R& e = place.eccentricity_ratio;
    const R& q = place.q;
    const R q2 = q * q;
    const R q32 = q * sqrt(q);
    const R growth = 1 + 2 * e * e;
    const R cross = -2 * e / q2;
    return CoefficientRatios<R>::of(R(2 * e * (1 + e * e) / (q2 * q)), R(pi<R>() / (4 * q32)),
                                    R(-pi<R>() * growth / (4 * q * q32)), R(e / q2),
                                    R(pi<R>() * growth / (2 * q * q32)), cross, cross, R(pi<R>() / (2 * q32)));
  }
};

/// Short dynamic: those of short half, since the pressure vanishes at the moving ends.
template <>
struct ClosedCoefficients<ShortDynamic> : ClosedCoefficients<ShortHalf> {};

/// Long full: only C_rr, C_tt, K_rt and K_tr.
template <>
struct ClosedCoefficients<LongFull> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R ee = place.eccentricity_ratio * place.eccentricity_ratio;
    const R& q = place.q;
    const R root = sqrt(q);
    const R d = 2 + ee;
    return CoefficientRatios<R>::of(R(0), R(12 * pi<R>() / (d * root)),
                                    R(-12 * pi<R>() * (2 - ee + 2 * ee * ee) / (d * d * q * root)), R(0),
                                    R(12 * pi<R>() / (q * root)), R(0), R(0), R(24 * pi<R>() / (d * root)));
  }
};

/// The published long half film. Its damping at the centre depends on the direction (C_rr = 6(π − 8/π), C_tt = 6π), so
/// that it foretells a whirl of up to 1.149 times the spin.
template <>
struct ClosedCoefficients<LongHalf> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R d = 2 + place.eccentricity_ratio * place.eccentricity_ratio;
    const R crr = 6 * (pi<R>() - 16 / (pi<R>() * d)) / (place.q * sqrt(place.q));
    return detail::long_coefficients<R>(place, crr, R(-24 * place.eccentricity_ratio / (d * place.q)));
  }
};

/// The long film cut at π.
template <>
struct ClosedCoefficients<LongHalfEq5> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R crr = 6 * pi<R>() / (place.q * sqrt(place.q));
    return detail::long_coefficients<R>(place, crr, R(-24 / ((1 + place.eccentricity_ratio) * place.q)));
  }
};

/// Long dynamic: C is not symmetric.
template <>
struct ClosedCoefficients<LongDynamic> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R& e = place.eccentricity_ratio;
    const R& q = place.q;
    const R d = 2 + e * e;
    const R crr = 6 * (pi<R>() - 16 * e * e / (pi<R>() * d * d)) / (q * sqrt(q));
    return detail::long_coefficients<R>(place, crr, R(-48 * e * (1 + e * e) / (d * d * q)));
  }
};

/// Pinkus and Sternlicht's law, whose slopes at b = 0 are the same from both sides.
template <>
struct ClosedCoefficients<PinkusSternlicht> {
  /// At a place.
  template <class R>
  static CoefficientRatios<R> at(const SteadyPlace<R>& place) {
    using std::sqrt;
    const R& e = place.eccentricity_ratio;
    const R crr = 6 * pi<R>() / (place.q * sqrt(place.q));
    return detail::long_coefficients<R>(place, crr, R(-18 * pi<R>() * e / ((2 + e * e) * place.q)));
  }
};

/// Has a law closed coefficients?
template <class Law>
concept HasClosedCoefficients = requires(const SteadyPlace<double>& place) {
  { ClosedCoefficients<Law>::at(place) } -> std::same_as<CoefficientRatios<double>>;
};

/// Coefficients by differentiation of a law, exact to rounding.
/// @param force_ratio  F/S of a film state of any scalar;  @param spin_sign  1 or −1: of ω
template <class R, class Force>
CoefficientRatios<R> differentiated_coefficients_of(const Force& force_ratio, const SteadyPlace<R>& place,
                                                    int spin_sign) {
  using D = Dual<R, 4>;  // ê along r and t, then v/c likewise
  const R& epsilon = place.eccentricity_ratio;
  const Vector2<D> e(D::variable(epsilon, 0), D::variable(R(0), 1));
  const D half_spin(R(spin_sign) / 2);
  const Vector2<D> u(D(D::variable(R(0), 2) + half_spin * e.y()), D(D::variable(R(0), 3) - half_spin * e.x()));
  D q(place.q);
  q.derivatives()(0) = -2 * epsilon;
  const Vector2<D> force = force_ratio(FilmState<D>(e, u, q));
  CoefficientRatios<R> ratios;
  for (int i = 0; i < 2; ++i) {
    ratios.stiffness.row(i) = -force(i).derivatives().template head<2>().transpose();
    ratios.damping.row(i) = -force(i).derivatives().template tail<2>().transpose();
  }
  return ratios;
}

/// The same of a law that is a formula.
template <FilmLaw Law, class R>
CoefficientRatios<R> differentiated_coefficients(const SteadyPlace<R>& place, int spin_sign) {
  return differentiated_coefficients_of([](const auto& film) { return force_ratio<Law>(film); }, place, spin_sign);
}

/// Coefficients of a law: closed where it has them, differentiated otherwise.
template <FilmLaw Law, class R>
CoefficientRatios<R> coefficient_ratios(const SteadyPlace<R>& place, int spin_sign) {
  if constexpr (HasClosedCoefficients<Law>) {
    const CoefficientRatios<R> forward = ClosedCoefficients<Law>::at(place);
    return spin_sign < 0 ? forward.mirrored() : forward;
  } else {
    return differentiated_coefficients<Law>(place, spin_sign);
  }
}

/// Largest difference of two matrices over the larger of their largest entries; of K or of C, whichever is worse.
template <class R>
R coefficient_difference(const CoefficientRatios<R>& x, const CoefficientRatios<R>& y) {
  const auto apart = [](const auto& m, const auto& n) {
    const R size = std::max<R>(m.cwiseAbs().maxCoeff(), n.cwiseAbs().maxCoeff());
    return R((m - n).cwiseAbs().maxCoeff() / size);
  };
  return std::max<R>(apart(x.stiffness, y.stiffness), apart(x.damping, y.damping));
}

/// A journal at rest on its film, and its coefficients in the frame of its load: x along the load on the journal, y 90°
/// counter-clockwise of it.
template <class R>
struct SteadyFilm {
  SteadyPlace<R> place;              ///< ε
  R spin;                            ///< ω [rad/s]
  R load;                            ///< W = |F| [N]
  R attitude;                        ///< from the load's direction to e, positive in the sense of the spin [rad]
  Eigen::Matrix<R, 2, 2> stiffness;  ///< K [N/m]
  Eigen::Matrix<R, 2, 2> damping;    ///< C [N s/m]
  RotorThreshold<R> threshold;       ///< of a rigid rotor, mass per bearing, by Routh's condition
};

/// The steady film of ratios in (r, t).
/// @param scale  S [N s];  @param force_ratio  F/S of a PolarFilmState<R>;  @param ratios  of this spin's sign
/// @throws FilmDomainError unless ω is finite and not 0
template <class R, class Force>
SteadyFilm<R> steady_film_of(const Bearing<R>& bearing, const R& scale, const Force& force_ratio,
                             const SteadyPlace<R>& place, const R& spin, const CoefficientRatios<R>& ratios) {
  using std::abs;
  using std::atan2;
  using std::hypot;
  using std::isfinite;
  if (!isfinite(spin) || spin == 0) {
    std::ostringstream message;
    message << "no steady state at spin " << spin << " rad/s; allowed is a finite spin other than 0";
    throw FilmDomainError(message.str());
  }
  const int sign = spin < 0 ? -1 : 1;
  const PolarForce<R> f = force_ratio(place.film(sign));
  const R size = hypot(f.radial, f.tangential);
  const R along = -f.radial / size;
  const R across = -f.tangential / size;
  Eigen::Matrix<R, 2, 2> frame;  // columns: x and y in (r, t)
  frame << along, -across, across, along;
  const R spin_rate = abs(spin);
  const R damping_unit = scale / bearing.clearance();
  const R stiffness_unit = damping_unit * spin_rate;
  // In (r, t), where the zeros of the full films are exact.
  RotorThreshold<R> threshold = routh_threshold<R>(ratios.stiffness, ratios.damping);
  threshold.critical_mass *= R(damping_unit / spin_rate);
  if (threshold.whirl_frequency) *threshold.whirl_frequency *= spin_rate;
  return {place,
          spin,
          R(scale * spin_rate * size),
          R(atan2(R(sign * f.tangential), R(-f.radial))),
          stiffness_unit * (frame.transpose() * ratios.stiffness * frame),
          damping_unit * (frame.transpose() * ratios.damping * frame),
          threshold};
}

/// The same of a law that is a formula.
template <FilmLaw Law, class R>
SteadyFilm<R> steady_film(const Bearing<R>& bearing, const Lubricant<R>& oil, const SteadyPlace<R>& place,
                          const R& spin, const CoefficientRatios<R>& ratios) {
  const auto force_ratio = [](const PolarFilmState<R>& film) { return polar_force_ratio<Law>(film); };
  return steady_film_of<R>(bearing, force_scale(Law::limit, bearing, oil), force_ratio, place, spin, ratios);
}

/// The same with the law's own coefficients.
template <FilmLaw Law, class R>
SteadyFilm<R> steady_film(const Bearing<R>& bearing, const Lubricant<R>& oil, const SteadyPlace<R>& place,
                          const R& spin) {
  return steady_film<Law>(bearing, oil, place, spin, coefficient_ratios<Law>(place, spin < 0 ? -1 : 1));
}

}  // namespace lubjoint
