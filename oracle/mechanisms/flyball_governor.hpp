/// The flyball governor in the frame that turns with its shaft: by symmetry three coordinates, no constraint.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lubjoint::mechanisms {

/// Problem A05 of the IFToMM library of computational benchmark problems: a shaft that turns freely about the vertical
/// z axis, two rods pinned to its top (their lower ends out to both sides) with balls, points of mass, at their ends,
/// and a slider on the shaft, held by a spring with a damper from each of its sides to the middle of each rod. Both
/// sides move alike. Shaft, rods and slider are prisms of one density. No damping but the dampers', no torque: the
/// angular momentum h = I_z ω is constant.
///
/// With α the rods' angle below the horizontal and s the slider's height, the potentials being doubled for both sides:
///   2 J_A α̈ = ½ ω² I_z'(α) + 2 g (½ m + m_ball) l cosα + 2 Q_α,   m_s s̈ = −m_s g + 2 Q_s,   ω = h/I_z(α),
/// Q = −(k(D − D₀) + c Ḋ) ∂D, D the length of a spring.
template <class R>
struct FlyballGovernor {
  R height = R(1);           ///< of the shaft, and length of the rods [m]
  R thickness = R(1) / 100;  ///< of both
  R arm = R(5) / 100;        ///< distance of the rods' pins, and of the springs' ends on the slider, from the axis
  R cube = R(1) / 10;        ///< side of the slider
  R density = R(3000);
  R ball = R(5);             ///< mass
  R stiffness = R(800000);   ///< k
  R damping = R(40000);      ///< c
  R free_length = R(1) / 2;  ///< D₀
  R gravity = R(981) / 100;

  /// α, s, the shaft's angle ψ; α̇ and ṡ; h.
  using State = std::array<R, 6>;

  /// Rods at rest against the shaft, 30° below the horizontal, the slider at 0.5 m.
  State start(const R& speed) const {
    using std::asin;
    State y{asin(R(1) / 2), R(1) / 2, R(0), R(0), R(0), R(0)};
    y[5] = inertia(y[0]).value * speed;
    return y;
  }

  /// ω of the shaft.
  R speed(const State& y) const { return y[5] / inertia(y[0]).value; }

  void operator()(const State& y, State& rate, const R&) const {
    using std::cos;
    const Turning now = inertia(y[0]);
    const R omega = y[5] / now.value;
    const Spring spring = spring_at(y);
    const R pull = stiffness * (spring.length - free_length) + damping * spring.rate;
    rate = {y[3],
            y[4],
            omega,
            (omega * omega * now.slope / 4 + gravity * (rod_mass() / 2 + ball) * height * cos(y[0]) -
             pull * spring.along_angle) /
                swing_inertia(),
            -gravity - 2 * pull * spring.along_slider / slider_mass(),
            R(0)};
  }

  /// Kinetic, potential and the springs' energy [J].
  R energy(const State& y) const {
    using std::sin;
    const Spring spring = spring_at(y);
    const R stretch = spring.length - free_length;
    const R omega = speed(y);
    return y[5] * omega / 2 + swing_inertia() * y[3] * y[3] + slider_mass() * (y[4] * y[4] / 2 + gravity * y[1]) +
           2 * gravity * (rod_mass() * (height - height / 2 * sin(y[0])) + ball * (height - height * sin(y[0]))) +
           gravity * rod_mass() * height / 2 + stiffness * stretch * stretch;
  }
  /// Power of both dampers, never positive [W].
  R dissipation(const State& y) const {
    const R rate = spring_at(y).rate;
    return -2 * damping * rate * rate;
  }

 private:
  struct Turning {
    R value, slope;  ///< I_z and its derivative after α
  };
  struct Spring {
    R length, along_angle, along_slider, rate;  ///< D, ∂D/∂α, ∂D/∂s, Ḋ
  };

  R rod_mass() const { return density * height * thickness * thickness; }
  R slider_mass() const { return density * cube * cube * cube; }
  /// J_A of a rod with its ball about its pin.
  R swing_inertia() const {
    return rod_mass() * (height * height / 3 + thickness * thickness / 12) + ball * height * height;
  }

  Turning inertia(const R& alpha) const {
    using std::cos;
    using std::sin;
    const R c = cos(alpha);
    const R s = sin(alpha);
    const R along = rod_mass() * thickness * thickness / 6;
    const R across = rod_mass() * (height * height + thickness * thickness) / 12;
    const R middle = arm + height / 2 * c;
    const R end = arm + height * c;
    const R fixed = along + slider_mass() * cube * cube / 6;  // the shaft is as thick as the rods, and as long
    return {fixed + 2 * (along * s * s + across * c * c + rod_mass() * middle * middle + ball * end * end),
            4 * s * (c * (along - across) - rod_mass() * middle * height / 2 - ball * end * height)};
  }

  Spring spring_at(const State& y) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const R half = height / 2;
    const R c = half * cos(y[0]);  // both ends are one arm off the axis
    const R rise = height - half * sin(y[0]) - y[1];
    const R length = sqrt(c * c + rise * rise);
    const R by_angle = (-c * half * sin(y[0]) - rise * c) / length;
    const R by_slider = -rise / length;
    return {length, by_angle, by_slider, by_angle * y[3] + by_slider * y[4]};
  }
};

}  // namespace lubjoint::mechanisms
