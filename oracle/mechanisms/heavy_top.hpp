/// The heavy symmetric top: steady precession, and nutation between two turning points from its three integrals.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace lubjoint::mechanisms {

/// A symmetric body held at a point of its axis, l below its mass centre. θ is the axis' angle from the upward
/// vertical, φ its azimuth, ψ the turn about it; I = J₁ + m l², and ω₃ = ψ̇ + φ̇ cosθ, the whole spin along the axis, is
/// constant, as are the momentum about the vertical and the energy. SI units.
template <class R>
struct HeavyTop {
  R mass;
  R distance;        ///< l
  R inertia_across;  ///< J₁ about the mass centre
  R inertia_along;   ///< J₃
  R gravity = R(981) / 100;

  R about_point() const { return inertia_across + mass * distance * distance; }

  /// φ̇ at which θ stays: the roots of I Ω² cosθ − J₃ω₃ Ω + m g l = 0, slower first. (From θ̈ = 0 in
  ///   I θ̈ = I φ̇² sinθ cosθ − J₃ω₃ φ̇ sinθ + m g l sinθ.)
  /// @throws std::domain_error  the top is too slow for that angle
  std::pair<R, R> steady(const R& theta, const R& spin) const {
    using std::abs;
    using std::cos;
    using std::sqrt;
    const R b = inertia_along * spin;
    const R a = about_point() * cos(theta);
    const R c = mass * gravity * distance;
    const R discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) throw std::domain_error("the top is too slow to precess steadily at this angle");
    const R q = (b + (b < 0 ? R(-1) : R(1)) * sqrt(discriminant)) / 2;
    return {c / q, q / a};
  }
};

/// Motion from a start with θ̇ = 0. With u = cosθ, v = u − u₀, β = 2 m g l/I, b = J₃ω₃/I and the start's Ω = φ̇:
///   u̇² = v [β v² − (b² + Ω² sin²θ₀ − 2u₀β) v + sin²θ₀ (2Ωb − β − 2u₀Ω²)],
/// a cubic whose root v = 0 is exact. u swings between it and the bracket's root that |u| < 1 allows:
///   u = u₁ + (u₂ − u₁) sn²(κ t [+ K]),  κ² = β(u₃ − u₁)/4,  k² = (u₂ − u₁)/(u₃ − u₁);
/// φ̇ = (Ω sin²θ₀ − b v)/(1 − u²) and ψ̇ = ω₃ − φ̇ u by quadrature.
template <class R>
class HeavyTopMotion {
 public:
  /// φ, θ, ψ.
  using Angles = std::array<R, 3>;

  HeavyTopMotion(const HeavyTop<R>& top, const R& theta, const R& precession, const R& spin)
      : u0_(cosine(theta)),
        square_((1 - u0_) * (1 + u0_)),
        precession_(precession),
        spin_(spin),
        b_(top.inertia_along * spin / top.about_point()) {
    using std::acos;
    using std::sqrt;
    const R beta = 2 * top.mass * top.gravity * top.distance / top.about_point();
    const R middle = b_ * b_ + precession * precession * square_ - 2 * u0_ * beta;
    const R last = square_ * (2 * precession * b_ - beta - 2 * u0_ * precession * precession);
    // The bracket's roots: one where |u| < 1, the other beyond u = 1.
    const R q = (middle + (middle < 0 ? R(-1) : R(1)) * sqrt(R(middle * middle - 4 * beta * last))) / 2;
    const R one = q / beta;
    const R other = last / q;
    const R far = one > other ? one : other;
    turning_ = one > other ? other : one;
    rising_ = turning_ > 0;
    const R span = rising_ ? far : R(far - turning_);  // u₃ − u₁
    modulus_ = sqrt(R((rising_ ? turning_ : R(-turning_)) / span));
    rate_ = sqrt(R(beta * span)) / 2;
    quarter_ = boost::math::ellint_1(modulus_);
  }

  /// θ at the start, and at the other turning point.
  R other_angle() const {
    using std::acos;
    return acos(R(u0_ + turning_));
  }
  /// Time from a turning point to the next [s].
  R half_period() const { return quarter_ / rate_; }

  Angles angles(const R& t) const {
    using std::acos;
    using std::floor;
    const R period = 2 * half_period();
    const R turns = floor(R(t / period));
    const R left = t - turns * period;
    const auto phi_rate = [&](const R& at) { return azimuth_rate(swing(at)); };
    const auto psi_rate = [&](const R& at) { return spin_ - azimuth_rate(swing(at)) * (u0_ + swing(at)); };
    R phi = integral(phi_rate, left);
    R psi = integral(psi_rate, left);
    if (turns > 0) {
      phi += turns * integral(phi_rate, period);
      psi += turns * integral(psi_rate, period);
    }
    return {phi, acos(R(u0_ + swing(t))), psi};
  }

 private:
  static R cosine(const R& theta) {
    using std::cos;
    return cos(theta);
  }
  /// v(t), zero at the start: its lower end where it rises, its upper end otherwise, where sn²(x + K) = cd²x.
  R swing(const R& t) const {
    const R sn = boost::math::jacobi_sn(modulus_, R(rate_ * t));
    if (rising_) return turning_ * sn * sn;
    // 1 − cd² = (1 − k²) sn²/dn², and dn² = cn² + (1 − k²) sn² where the usual quotient is 0/0.
    const R cn = boost::math::jacobi_cn(modulus_, R(rate_ * t));
    const R part = (1 - modulus_) * (1 + modulus_) * sn * sn;
    return turning_ * part / (cn * cn + part);
  }
  R azimuth_rate(const R& v) const {
    const R u = u0_ + v;
    return (precession_ * square_ - b_ * v) / ((1 - u) * (1 + u));
  }
  template <class F>
  static R integral(const F& f, const R& to) {
    if (to == 0) return R(0);
    return boost::math::quadrature::gauss_kronrod<R, 61>::integrate(f, R(0), to, 8, R(1) / 1000000000000LL);
  }

  R u0_;
  R square_;  ///< sin²θ₀
  R precession_;
  R spin_;
  R b_;
  R turning_;
  bool rising_ = false;
  R modulus_;
  R rate_;
  R quarter_;
};

}  // namespace lubjoint::mechanisms
