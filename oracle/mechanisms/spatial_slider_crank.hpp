/// The rigid slider-crank in space that others published, from its energy: one coordinate, the crank's angle.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>

namespace lubjoint::mechanisms {

/// A function of the crank's angle θ with its derivative after θ.
template <class R>
struct AlongCrank {
  R value;
  R slope;
};

/// "Spatial rigid slider-crank mechanism" of the IFToMM library of computational benchmark problems. The crank turns
/// about the x direction at A = (0, y_A, z_A), its pin B = A + r(0, −sinθ, cosθ); the slider C moves along the x axis
/// and does not turn; the rod from B to C has a ball at B and a cross at C, whose one axis is x and whose other, fixed
/// to the rod, is n, normal to x and to the rod: the rod's spin is ω = α x + β n. Gravity acts against z. Inertias
/// about the mass centres; that of the rod across is the same about both its axes. SI units.
template <class R>
struct SpatialSliderCrank {
  R crank_length = R(8) / 100;
  R crank_mass = R(12) / 100;
  R crank_inertia = R(1) / 10000;  ///< about x
  R crank_centre = R(4) / 100;     ///< distance of its mass centre from A
  R rod_length = R(3) / 10;
  R rod_mass = R(1) / 2;               ///< at mid-length
  R rod_inertia_along = R(4) / 10000;  ///< about its own axis
  R rod_inertia_cross = R(4) / 1000;   ///< about the cross's axis n
  R rod_inertia_third = R(4) / 1000;   ///< about the axis normal to both
  R slider_mass = R(2);
  R slider_inertia = R(0);   ///< about x, of a slider that swivels with n; 0: it does not turn
  R offset_y = R(1) / 10;    ///< y_A
  R offset_z = R(12) / 100;  ///< z_A
  R gravity = R(981) / 100;

  using Vector = std::array<AlongCrank<R>, 3>;

  /// B.
  Vector crank_pin(const R& angle) const {
    using std::cos;
    using std::sin;
    const R c = crank_length * cos(angle);
    const R s = crank_length * sin(angle);
    return {{{R(0), R(0)}, {offset_y - s, -c}, {offset_z + c, -s}}};
  }

  /// x of the slider: x² = l² − B_y² − B_z².
  AlongCrank<R> slider(const R& angle) const {
    using std::sqrt;
    const Vector b = crank_pin(angle);
    const R square = rod_length * rod_length - b[1].value * b[1].value - b[2].value * b[2].value;
    if (!(square > 0)) throw std::domain_error("the rod doesn't reach the x axis");
    const R x = sqrt(square);
    return {x, R(-(b[1].value * b[1].slope + b[2].value * b[2].slope) / x)};
  }

  /// M(θ): the kinetic energy is ½ M θ̇².
  R inertia(const R& angle) const {
    const Vector b = crank_pin(angle);
    const AlongCrank<R> x = slider(angle);
    // The rod's direction u = (C − B)/l and its derivative.
    const R ux = x.value / rod_length;
    const R uy = -b[1].value / rod_length;
    const R uz = -b[2].value / rod_length;
    const R dx = x.slope / rod_length;
    const R dy = -b[1].slope / rod_length;
    const R dz = -b[2].slope / rod_length;
    const R lever = uy * uy + uz * uz;  // |x × u|²
    // u' = (α x + β n) × u with n normal to u and x: its component along x × u is α |x × u|², and the rest β.
    const R alpha = (uy * dz - uz * dy) / lever;
    const R beta_squared = dx * dx + dy * dy + dz * dz - alpha * alpha * lever;
    const R rod_turning = alpha * alpha * (rod_inertia_along * ux * ux + rod_inertia_third * lever + slider_inertia) +
                          rod_inertia_cross * beta_squared;
    // Its mass centre: (B + C)/2.
    const R rod_centre = (x.slope * x.slope + b[1].slope * b[1].slope + b[2].slope * b[2].slope) / 4;
    return crank_inertia + crank_mass * crank_centre * crank_centre + rod_mass * rod_centre + rod_turning +
           slider_mass * x.slope * x.slope;
  }

  /// V(θ).
  R potential(const R& angle) const {
    using std::cos;
    return gravity * (crank_mass * (offset_z + crank_centre * cos(angle)) + rod_mass * crank_pin(angle)[2].value / 2);
  }
};

/// Its motion from a start at an angle with a speed: ½ M θ̇² + V is constant, so that t = ∫ dθ/θ̇(θ). Needs a crank that
/// never stops.
template <class R>
class SpatialSliderCrankMotion {
 public:
  /// @throws std::domain_error  the crank would stop
  SpatialSliderCrankMotion(const SpatialSliderCrank<R>& mechanism, const R& start, const R& speed)
      : m_(mechanism),
        start_(start),
        energy_(m_.inertia(start) * speed * speed / 2 + m_.potential(start)),
        revolution_(time_between(start, start + boost::math::constants::two_pi<R>())) {}

  /// θ̇ where the crank is at θ.
  R speed_at(const R& angle) const {
    using std::sqrt;
    const R square = 2 * (energy_ - m_.potential(angle)) / m_.inertia(angle);
    if (!(square > 0)) throw std::domain_error("the crank stops");
    return sqrt(square);
  }

  /// Time of a revolution [s].
  const R& revolution() const { return revolution_; }

  /// θ at t ≥ 0, counted through revolutions: Newton on t(θ), whose slope is 1/θ̇.
  R angle(const R& t) const {
    using std::abs;
    using std::floor;
    const R two_pi = boost::math::constants::two_pi<R>();
    const R turns = floor(R(t / revolution_));
    const R left = t - turns * revolution_;
    R theta = start_ + two_pi * left / revolution_;
    for (int k = 0; k < 60; ++k) {
      const R off = (time_between(start_, theta) - left) * speed_at(theta);
      theta -= off;
      if (abs(off) < 100 * std::numeric_limits<R>::epsilon()) break;
    }
    return theta + turns * two_pi;
  }

 private:
  R time_between(const R& from, const R& to) const {
    return boost::math::quadrature::gauss_kronrod<R, 61>::integrate([&](const R& theta) { return 1 / speed_at(theta); },
                                                                    from, to, 12, R(1) / 1000000000000LL);
  }

  SpatialSliderCrank<R> m_;
  R start_;
  R energy_;
  R revolution_;
};

}  // namespace lubjoint::mechanisms
