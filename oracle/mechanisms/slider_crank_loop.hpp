/// The ideal slider-crank once more, without an angle of the rod in its mechanics: from the loop A + s = x by
/// differentiation after the crank's angle, and its driving moment from the energy.
#pragma once

#include <array>
#include <cmath>

#include "oracle/mechanisms/slider_crank.hpp"

namespace lubjoint::mechanisms {

/// A function of the crank's angle θ with its first two derivatives after θ.
template <class R>
struct OfCrankAngle {
  R value;
  R first;
  R second;
};

/// Places of the mechanism as functions of θ. Crank pin A = r(cosθ, sinθ); the rod reaches s = √(l² − A_y²) further
/// along x, from A down to the axis.
template <class R>
struct SliderCrankLoop {
  std::array<OfCrankAngle<R>, 2> crank_pin;  ///< A [m]
  OfCrankAngle<R> reach;                     ///< s [m]
  OfCrankAngle<R> rod_angle;                 ///< φ, sinφ = −A_y/l, so that φ' = −A_y'/s [rad]
  OfCrankAngle<R> slider;                    ///< x = A_x + s [m]
  std::array<OfCrankAngle<R>, 2> rod;        ///< the rod's mass centre, (A_x + s/2, A_y/2) [m]

  SliderCrankLoop(const SliderCrank<R>& m, const R& theta) {
    using std::atan2;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const R c = m.crank_length * cos(theta);
    const R s = m.crank_length * sin(theta);
    crank_pin = {OfCrankAngle<R>{c, R(-s), R(-c)}, OfCrankAngle<R>{s, c, R(-s)}};
    const OfCrankAngle<R>& y = crank_pin[1];
    reach.value = sqrt(R((m.rod_length - y.value) * (m.rod_length + y.value)));
    reach.first = -y.value * y.first / reach.value;  // from s² + A_y² = l²
    reach.second = -(y.first * y.first + y.value * y.second + reach.first * reach.first) / reach.value;
    rod_angle.value = atan2(R(-y.value), reach.value);
    rod_angle.first = -y.first / reach.value;
    rod_angle.second = (y.first * reach.first / reach.value - y.second) / reach.value;
    slider = plus(crank_pin[0], reach, R(1));
    rod = {plus(crank_pin[0], reach, R(1) / 2), OfCrankAngle<R>{R(y.value / 2), R(y.first / 2), R(y.second / 2)}};
  }

  /// Moment that keeps the crank at a constant speed Ω: its power MΩ is the rate of the kinetic energy, so
  ///   M = Ω² Σ (m x'·x'' + J φ'φ'').
  R driving_moment(const SliderCrank<R>& m, const R& speed) const {
    const auto share = [](const R& inertia, const OfCrankAngle<R>& x) { return R(inertia * x.first * x.second); };
    // The crank's own energy is constant.
    return speed * speed *
           (share(m.rod_mass, rod[0]) + share(m.rod_mass, rod[1]) + share(m.rod_inertia, rod_angle) +
            share(m.slider_mass, slider));
  }

 private:
  static OfCrankAngle<R> plus(const OfCrankAngle<R>& a, const OfCrankAngle<R>& b, const R& factor) {
    return {R(a.value + factor * b.value), R(a.first + factor * b.first), R(a.second + factor * b.second)};
  }
};

}  // namespace lubjoint::mechanisms
