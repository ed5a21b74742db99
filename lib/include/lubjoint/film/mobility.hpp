/// Mobility: the pure-squeeze velocity at which a film carries a given force. The inverse of a force law.
///
/// F(ê, u) = F* is solved for u. What a solution can be follows from the law:
/// - Full films are linear: closed form, one velocity.
/// - short_dynamic has a convex potential (proved in oracle/proofs): one velocity for every force.
/// - long_dynamic and pinkus_sternlicht are continuous and passive: there is a velocity for every force. That there is
///   one alone is measured (−∂F/∂u has a positive determinant at every state tried), not proved.
/// - Half films jump at a = 0: of the directions of force some have no velocity (the journal slides along a = 0), and
///   some have two, which differ in the sign of a (b < 0).
/// - Squeeze-only laws answer forces along ê alone, and every velocity across it carries them as well.
/// A journal without mass under the force W moves with ė = c u + ½(ω_J + ω_B)e⊥, F(ê, u) = −W.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/squeeze_only.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// How many velocities carry a force: one, none, two (half films) or a line of them (squeeze-only laws).
enum class MobilityStatus { found, none, two, many };

/// Their names, in order.
inline constexpr std::array<std::string_view, 4> mobility_status_names = {"found", "none", "two", "many"};

/// The velocities that carry a force.
template <class R>
struct Mobility {
  MobilityStatus status;                 ///< how many there are
  std::optional<Vector2<R>> velocity;    ///< u [1/s]; of two the one with a > 0, of many the smallest; nothing for none
  std::optional<Vector2<R>> other = {};  ///< of two the one with a < 0 [1/s]

  /// The same for `factor` times the force.
  Mobility scaled(const R& factor) const {
    Mobility result = *this;
    if (velocity) result.velocity = Vector2<R>(factor * *velocity);
    if (other) result.other = Vector2<R>(factor * *other);
    return result;
  }
};

namespace detail {

/// Closed mobility of a full film; F/S in, u out.
template <class Law>
struct ClosedMobility;

/// u = −(q^{3/2}/(π(1 + 2ε²))) [q F + 3(ê⊥·F) ê⊥]/S: F − 3(ê·F)ê/(1 + 2ε²) with what cancels as ε → 1 taken out.
template <>
struct ClosedMobility<ShortFull> {
  template <class R>
  static Vector2<R> at(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
    using std::sqrt;
    const Vector2<R> across = perpendicular(e_hat);
    const R factor = -q * sqrt(q) / (pi<R>() * (1 + 2 * dot(e_hat, e_hat)));
    return factor * (q * force + R(3 * dot(across, force)) * across);
  }
};

/// u = −(√q/(24π)) [2q F + 3(ê⊥·F) ê⊥]/S, likewise.
template <>
struct ClosedMobility<LongFull> {
  template <class R>
  static Vector2<R> at(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
    using std::sqrt;
    const Vector2<R> across = perpendicular(e_hat);
    const R factor = -sqrt(q) / (24 * pi<R>());
    return factor * (R(2 * q) * force + R(3 * dot(across, force)) * across);
  }
};

template <class Law>
concept HasClosedMobility = requires(const Vector2<double>& v) {
  ClosedMobility<Law>::at(v, 1.0, v);
};

/// The film at a place, moving with the unit velocity n: the force over −S, and how it changes as n turns.
template <class R>
struct TurningResistance {
  Vector2<R> value;  ///< −F(n)/S
  Vector2<R> slope;  ///< its derivative in the angle of n; J n⊥ with J = −∂F/∂u, and J n is the value
};

/// By exact differentiation of F/S, a function of the film state.
template <class R, class Force>
TurningResistance<R> differentiated_resistance(const Vector2<R>& e_hat, const R& q, const Vector2<R>& n,
                                               const Force& force_of) {
  using D = Dual<R, 1>;
  using Slope = typename D::Derivatives;
  const Vector2<D> e(D(e_hat.x()), D(e_hat.y()));
  const Vector2<D> u(D(n.x(), Slope(-n.y())), D(n.y(), Slope(n.x())));
  const Vector2<D> force = force_of(FilmState<D>(e, u, D(q), Unchecked()));
  return {Vector2<R>(R(-force.x().value()), R(-force.y().value())),
          Vector2<R>(R(-force.x().derivatives()(0)), R(-force.y().derivatives()(0)))};
}

/// Of a law.
template <FilmLaw Law>
struct DirectionalResistance {
  template <class R>
  static TurningResistance<R> at(const Vector2<R>& e_hat, const R& q, const Vector2<R>& n) {
    return differentiated_resistance(e_hat, q, n, [](const auto& film) { return force_ratio<Law>(film); });
  }
};

/// Closed, by the second moments of the short film, I = ∫ d dᵀ/H³ dφ over |φ| < π/2 (dynamic_moments.hpp):
///   I₁₁ = W/q^{5/2},   I₁₂ = e₂E/q^{5/2},   I₂₂ = [(q + 3e₂²)V + 2e₁e₂²q√q/N⁴]/q^{5/2},
/// for an opening film I₂₂ = (m/N⁴)[2/3 + ρ(q + 3e₂²)/N²], where nothing cancels.
template <>
struct DirectionalResistance<ShortDynamic> {
  template <class R>
  static TurningResistance<R> at(const Vector2<R>& e_hat, const R& q, const Vector2<R>& n) {
    using std::sqrt;
    const Vector2<R> across = perpendicular(n);
    const R e1 = dot(e_hat, n);
    const R e2 = dot(e_hat, across);
    const R n2 = q + e1 * e1;
    const R y = q / n2;
    const R e22 = e2 * e2;
    const R n4 = n2 * n2;
    R i11, i12, i22;
    if (e1 < 0 && y < R(0.35)) {
      const R rho = arc_remainder(y);
      const R m = -e1;
      i11 = m / n4 * ((3 - 2 * y) * rho - R(4) / 3);
      i12 = e2 / (n4 * n2) * (2 * n2 - 3 * m * m * rho);
      i22 = m / n4 * (R(2) / 3 + rho * (q + 3 * e22) / n2);
    } else {
      const R root = sqrt(q);
      const R delta = angle_above(root, R(-e1));
      const R squares = 3 * e1 * e1;
      const R q52 = q * q * root;
      i11 = ((q + squares) * delta + 3 * e1 * root) / q52;
      i12 = e2 * (3 * e1 * delta + root * (2 * q + squares) / n2) / q52;
      i22 = ((q + 3 * e22) * (delta + e1 * root / n2) + 2 * e1 * e22 * q * root / n4) / q52;
    }
    return {Vector2<R>(i11 * n + i12 * across), Vector2<R>(i12 * n + i22 * across)};
  }
};

/// A direction from which to start, in the frame of the load λ: Booker's short film, and the long limit of Moes' fit.
template <class R>
Vector2<R> first_direction(BearingLimit limit, const Vector2<R>& e_hat, const Vector2<R>& load) {
  const Vector2<R> across = perpendicular(load);
  const R room = 1 - dot(e_hat, load);
  const R turn = R(limit == BearingLimit::short_bearing ? 1.2732 : 0.75) * dot(e_hat, across);
  return direction(Vector2<R>(room * load - turn * across));
}

/// Solves −F(ê, u) = `load`, a unit vector, for a continuous passive law.
///
/// With n the direction of u, −F = |u| f(n), and Newton's step in u is that of α f + β f′ = load: u = αn + βn⊥, since
/// −∂F/∂u maps n to f and n⊥ to f′. It is exact where the film is linear, however different its resistance along and
/// across e. The direction of f(n) is 90° behind or ahead of the load at least where n is at a right angle to it,
/// because f·n > 0; that brackets n, and steps that leave the bracket halve it.
/// @param resistance  gives the TurningResistance of a direction;  @param n  where to start
template <class R, class Resistance>
Vector2<R> velocity_against(const R& q, const Vector2<R>& load, Vector2<R> n, std::string_view law,
                            const Resistance& resistance) {
  using std::abs;
  const R negligible = std::numeric_limits<R>::epsilon() * q;  // of β²/α²: the next step's β is about β²/√q
  Vector2<R> behind = -perpendicular(load);
  Vector2<R> ahead = perpendicular(load);
  constexpr int most = 10 * std::numeric_limits<R>::digits;  // each eighth step halves the bracket
  for (int step = 0; step < most; ++step) {
    const TurningResistance<R> f = resistance(n);
    const R determinant = cross(f.value, f.slope);
    const R alpha = cross(load, f.slope) / determinant;
    const R beta = cross(f.value, load) / determinant;
    Vector2<R> next = alpha * n + beta * perpendicular(n);
    if (alpha > 0 && beta * beta <= negligible * alpha * alpha) {
      // Near the wall the determinant cancels; what it loses is a common factor of α and β.
      const Vector2<R> answer = alpha * f.value + beta * f.slope;
      return (dot(load, answer) / dot(answer, answer)) * next;
    }
    (cross(load, f.value) < 0 ? behind : ahead) = n;
    const bool inside = determinant > 0 && cross(behind, next) > 0 && cross(next, ahead) > 0;
    if (!inside || step % 8 == 7) next = behind + ahead;
    next = is_zero(next) ? load : direction(next);
    if (next == n) return (dot(load, f.value) / dot(f.value, f.value)) * n;  // the direction is right to rounding
    n = next;
  }
  throw std::runtime_error("the mobility of " + std::string(law) +
                           " was not found: the direction of its force did not settle");
}

/// u of a squeeze-only law: along ê, if the force is.
template <FilmLaw Law, class R>
Mobility<R> squeeze_mobility(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
  using std::abs;
  const bool central = is_zero(e_hat);
  const Vector2<R> r = central ? Vector2<R>(-direction(force)) : direction(e_hat);
  const R across = cross(r, force);
  const R along = dot(r, force);
  // Rounding of given doubles: a force along ê that they can't say exactly.
  const R rounding = 4 * R(std::numeric_limits<double>::epsilon());
  if (abs(across) > rounding * abs(along)) return {MobilityStatus::none, std::nullopt};
  const R sign(along > 0 ? -1 : 1);
  const PolarFilmState<R> unit(dot(r, e_hat), R(0), sign, q, Unchecked());
  const R speed = along / Law::force_ratio(unit, HalfFilmSide::converging).radial;
  return {central ? MobilityStatus::found : MobilityStatus::many, Vector2<R>(R(sign * speed) * r)};
}

/// a and b of a half film whose pressure is on one side, where it is linear; nothing if a has the other side's sign.
template <class Law, class R>
std::optional<PolarForce<R>> rates_on_side(const Law& law, const R& epsilon, const R& q, const PolarForce<R>& force,
                                           HalfFilmSide side) {
  const auto column = [&](int a, int b) {
    return law.force_ratio(PolarFilmState<R>(epsilon, R(a), R(b), q, Unchecked()), side);
  };
  const PolarForce<R> wedge = column(1, 0);
  const PolarForce<R> squeeze = column(0, 1);
  const R determinant = wedge.radial * squeeze.tangential - wedge.tangential * squeeze.radial;
  const R a = (force.radial * squeeze.tangential - force.tangential * squeeze.radial) / determinant;
  const R b = (wedge.radial * force.tangential - wedge.tangential * force.radial) / determinant;
  const bool on_side = side == HalfFilmSide::converging ? a >= 0 : a < 0;
  if (!on_side) return std::nullopt;
  return PolarForce<R>{b, a};
}

/// The velocities of a half film: of a formula, or of a table.
template <class Law, class R>
Mobility<R> half_film_mobility(const Law& law, const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
  if (is_zero(e_hat)) {
    // F turns with u: a quotient of plane vectors as of complex numbers. With u along x the radial direction is x.
    const PolarFilmState<R> along(R(0), R(0), R(1), q, Unchecked());
    const PolarForce<R> polar = law.force_ratio(along, HalfFilmSide::converging);
    const Vector2<R> unit(polar.radial, polar.tangential);
    const R square = dot(unit, unit);
    return {MobilityStatus::found, Vector2<R>(R(dot(unit, force) / square), R(cross(unit, force) / square))};
  }
  const Vector2<R> r = direction(e_hat);
  const Vector2<R> t = perpendicular(r);
  const PolarForce<R> polar{dot(r, force), dot(t, force)};
  Mobility<R> result{MobilityStatus::none, std::nullopt};
  for (const HalfFilmSide side : {HalfFilmSide::converging, HalfFilmSide::mirrored}) {
    const auto rates = rates_on_side(law, dot(r, e_hat), q, polar, side);
    if (!rates) continue;
    const Vector2<R> u = rates->radial * r - R(rates->tangential / 2) * t;
    (result.velocity ? result.other : result.velocity) = u;
    result.status = result.other ? MobilityStatus::two : MobilityStatus::found;
  }
  return result;
}

/// @throws FilmDomainError if ε ≥ 1 or the force is not finite
template <class R>
void require_mobility_state(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
  using std::isfinite;
  if (!(q > 0) || !isfinite(force.x()) || !isfinite(force.y())) {
    Message message;
    message << "no mobility at eccentricity (" << e_hat.x() << ", " << e_hat.y()
            << ") clearances and force over scale (" << force.x() << ", " << force.y()
            << ") 1/s; allowed are eccentricity ratios in [0, 1) and finite forces";
    throw FilmDomainError(message.str());
  }
}

}  // namespace detail

/// The velocities at which a law's film carries a force; see above.
/// @param e_hat  ê, and q = 1 − ê·ê of a caller who may know it better;  @param force  F/S on the journal [1/s]
/// @throws FilmDomainError if ε ≥ 1 or the force is not finite
/// Accuracy: F(ê, u) is the force to a few roundings times the film's condition, about 6/q.
template <FilmLaw Law, class R>
Mobility<R> mobility(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
  detail::require_mobility_state(e_hat, q, force);
  constexpr bool squeeze_only = SqueezeOnlyLaw<Law>;
  if (is_zero(force)) {
    return {squeeze_only && !is_zero(e_hat) ? MobilityStatus::many : MobilityStatus::found, Vector2<R>(R(0), R(0))};
  }
  const R size = norm(force);
  const Vector2<R> unit = direction(force);
  if constexpr (squeeze_only) {
    return detail::squeeze_mobility<Law>(e_hat, q, unit).scaled(size);
  } else if constexpr (Law::extent == FilmExtent::half) {
    return detail::half_film_mobility(Law(), e_hat, q, unit).scaled(size);
  } else if constexpr (detail::HasClosedMobility<Law>) {
    return {MobilityStatus::found, Vector2<R>(size * detail::ClosedMobility<Law>::at(e_hat, q, unit))};
  } else {
    const Vector2<R> load = -unit;
    const Vector2<R> u = detail::velocity_against(
        q, load, detail::first_direction(Law::limit, e_hat, load), Law::name,
        [&](const Vector2<R>& n) { return detail::DirectionalResistance<Law>::at(e_hat, q, n); });
    return {MobilityStatus::found, Vector2<R>(size * u)};
  }
}

/// The same of a bearing: the force in newtons.
template <FilmLaw Law, class R>
Mobility<R> mobility(const Bearing<R>& bearing, const Lubricant<R>& oil, const Vector2<R>& e_hat,
                     const Vector2<R>& force) {
  const R scale = force_scale(Law::limit, bearing, oil);
  return mobility<Law>(e_hat, one_minus_squared_norm<R>(e_hat.x(), e_hat.y()), Vector2<R>(force / scale));
}

}  // namespace lubjoint
