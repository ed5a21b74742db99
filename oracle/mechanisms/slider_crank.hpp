/// The slider-crank in closed form: every joint ideal, no gravity.
#pragma once

#include <cmath>

#include "lubjoint/number/vector.hpp"

namespace lubjoint::mechanisms {

/// A crank on the ground at the origin, a connecting rod, and a slider on the x axis; mass centres at mid-length.
/// Defaults: Flores et al. (2009), Table 2.
template <class R>
struct SliderCrank {
  R crank_length = R(5) / 100;     ///< r [m]
  R crank_mass = R(3) / 10;        ///< [kg]
  R crank_inertia = R(1) / 10000;  ///< about its mass centre [kg m²]
  R rod_length = R(12) / 100;      ///< l [m]
  R rod_mass = R(21) / 100;        ///< [kg]
  R rod_inertia = R(25) / 100000;  ///< about its mass centre [kg m²]
  R slider_mass = R(14) / 100;     ///< [kg]
};

/// A function of time with its first two derivatives.
template <class R>
struct Motion {
  R value;
  R rate;
  R acceleration;
};

/// Rod angle φ (from the x axis, sin φ = −(r/l) sin θ) and slider position x = r cos θ + l cos φ of a crank at θ.
template <class R>
struct IdealMotion {
  Motion<R> rod;
  Motion<R> slider;
};

template <class R>
IdealMotion<R> ideal_motion(const SliderCrank<R>& m, const Motion<R>& crank) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const R ratio = m.crank_length / m.rod_length;
  const R s = sin(crank.value);
  const R c = cos(crank.value);
  const R sine = -ratio * s;
  const R cosine = sqrt((1 - sine) * (1 + sine));
  IdealMotion<R> ideal;
  using std::atan2;
  ideal.rod.value = atan2(sine, cosine);
  ideal.rod.rate = -ratio * c * crank.rate / cosine;
  // (sin φ)¨ = cos φ φ¨ − sin φ φ˙²
  ideal.rod.acceleration =
      (-ratio * (c * crank.acceleration - s * crank.rate * crank.rate) + sine * ideal.rod.rate * ideal.rod.rate) /
      cosine;
  const auto turning = [](const R& length, const R& sn, const R& cs, const Motion<R>& angle) {
    return -length * (sn * angle.acceleration + cs * angle.rate * angle.rate);
  };
  ideal.slider.value = m.crank_length * c + m.rod_length * cosine;
  ideal.slider.rate = -m.crank_length * s * crank.rate - m.rod_length * sine * ideal.rod.rate;
  ideal.slider.acceleration = turning(m.crank_length, s, c, crank) + turning(m.rod_length, sine, cosine, ideal.rod);
  return ideal;
}

/// What the joints of the ideal mechanism carry.
template <class R>
struct IdealReactions {
  Vector2<R> gudgeon_pin;  ///< force on the slider [N]
  Vector2<R> crank_pin;    ///< force on the rod [N]
  R driving_moment;        ///< on the crank, counter-clockwise positive [N m]
};

/// Newton and Euler: the slider gives the pin's force along x, the rod's moments about the crank pin its force along
/// y, the rod's resultant the crank pin's force, the crank's moments about the ground the driving moment.
template <class R>
IdealReactions<R> ideal_reactions(const SliderCrank<R>& m, const Motion<R>& crank) {
  using std::cos;
  using std::sin;
  const IdealMotion<R> ideal = ideal_motion(m, crank);
  const R s = sin(crank.value);
  const R c = cos(crank.value);
  const R sr = sin(ideal.rod.value);
  const R cr = cos(ideal.rod.value);
  const R half = m.rod_length / 2;
  const Motion<R>& rod = ideal.rod;
  // Acceleration of the rod's mass centre.
  const R ax = -m.crank_length * (s * crank.acceleration + c * crank.rate * crank.rate) -
               half * (sr * rod.acceleration + cr * rod.rate * rod.rate);
  const R ay = m.crank_length * (c * crank.acceleration - s * crank.rate * crank.rate) +
               half * (cr * rod.acceleration - sr * rod.rate * rod.rate);
  const R fx = m.slider_mass * ideal.slider.acceleration;
  const R moment = m.rod_inertia * rod.acceleration + m.rod_mass * half * (cr * ay - sr * ax);
  const R fy = (m.rod_length * sr * fx - moment) / (m.rod_length * cr);
  const Vector2<R> pin(fx, fy);
  const Vector2<R> crank_pin(R(m.rod_mass * ax + fx), R(m.rod_mass * ay + fy));
  const R inertia = m.crank_inertia + m.crank_mass * m.crank_length * m.crank_length / 4;
  const R drive = inertia * crank.acceleration + m.crank_length * (c * crank_pin.y() - s * crank_pin.x());
  return {pin, crank_pin, drive};
}

/// I_eff(θ), so that the kinetic energy is ½ I_eff θ˙² [kg m²].
template <class R>
R effective_inertia(const SliderCrank<R>& m, const R& angle) {
  using std::cos;
  using std::sin;
  const IdealMotion<R> unit = ideal_motion(m, {angle, R(1), R(0)});
  const R half = m.rod_length / 2;
  const R vx = -m.crank_length * sin(angle) - half * sin(unit.rod.value) * unit.rod.rate;
  const R vy = m.crank_length * cos(angle) + half * cos(unit.rod.value) * unit.rod.rate;
  return m.crank_inertia + m.crank_mass * m.crank_length * m.crank_length / 4 + m.rod_mass * (vx * vx + vy * vy) +
         m.rod_inertia * unit.rod.rate * unit.rod.rate + m.slider_mass * unit.slider.rate * unit.slider.rate;
}

/// Speed of the crank at θ > 0 under a constant moment M, from rest at θ = 0: ½ I_eff(θ) θ˙² = Mθ [rad/s].
template <class R>
R torque_driven_speed(const SliderCrank<R>& m, const R& moment, const R& angle) {
  using std::sqrt;
  return sqrt(2 * moment * angle / effective_inertia(m, angle));
}

/// Time at which it gets there, t = ∫ dθ/θ˙ [s]. With θ = s² the integrand √(2 I_eff(s²)/M) is smooth at the start.
/// @param integrate  integrate(f, a, b), a quadrature of a smooth function
template <class R, class Quadrature>
R torque_driven_time(const SliderCrank<R>& m, const R& moment, const R& angle, const Quadrature& integrate) {
  using std::sqrt;
  return integrate([&](const R& s) { return R(sqrt(2 * effective_inertia(m, R(s * s)) / moment)); }, R(0),
                   R(sqrt(angle)));
}

}  // namespace lubjoint::mechanisms
