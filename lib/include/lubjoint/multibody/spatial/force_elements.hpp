/// Springs and moving loads in space.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lubjoint/multibody/spatial/constraint_row.hpp"
#include "lubjoint/multibody/spring.hpp"

namespace lubjoint {

/// A spring with a damper between P_i and P_j in space.
///   d = P_j − P_i, L = |d|, n = d/L:  S = S₀ + k(L − L₀) + c n·ḋ pulls P_j along −n and P_i along n
/// Elastic energy ½k(L − L₀)² + S₀(L − L₀); the damper's power is −c(n·ḋ)².
template <class R>
struct SpatialSpring {
  std::string name;            ///< unique among the springs
  SpatialBodyPoint<R> first;   ///< P_i
  SpatialBodyPoint<R> second;  ///< P_j
  R stiffness;                 ///< k [N/m]
  R damping;                   ///< c [N s/m]
  R free_length;               ///< L₀ [m]
  R preload;                   ///< S₀, the tension at L₀ without motion [N]

  /// On another scalar.
  template <class S>
  SpatialSpring<S> cast() const {
    return {name,      first.template cast<S>(), second.template cast<S>(), S(stiffness), S(damping), S(free_length),
            S(preload)};
  }

  /// Where it is and what it does.
  template <class T>
  struct State {
    Vector3<T> first_arm;   ///< s_i [m]
    Vector3<T> second_arm;  ///< s_j [m]
    Vector3<T> direction;   ///< n
    T length;               ///< L [m]
    T rate;                 ///< n·ḋ [m/s]
    T tension;              ///< S [N]
  };
  /// From the motions of its two bodies. @throws SpringWithoutDirection
  template <class T>
  State<T> state(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j) const {
    const SpatialPoint<T> p_i = point_motion(body_i, first.point);
    const SpatialPoint<T> p_j = point_motion(body_j, second.point);
    const Vector3<T> d = difference(p_j.position, p_i.position);
    if (is_zero(d)) throw SpringWithoutDirection("a spring of length 0 has no direction");
    const T length = norm(d);
    const Vector3<T> n = direction(d);
    const T rate = dot(n, difference(p_j.velocity, p_i.velocity));
    return {p_i.arm, p_j.arm, n, length, rate, T(preload + stiffness * (length - free_length) + damping * rate)};
  }
};

/// A force at a point fixed to a body, and a moment: constant, or A cos(ωt + ψ) with the given ones as amplitudes A.
template <class R>
struct SpatialPointLoad {
  SpatialBodyPoint<R> at;  ///< where the force acts
  Vector3<R> force;        ///< or its amplitude [N]
  Vector3<R> moment;       ///< or its amplitude [N m]
  bool turns_with_body;    ///< are both given in the body's axes?
  bool is_harmonic;        ///< else constant
  R rate;                  ///< ω [rad/s]
  R phase;                 ///< ψ [rad]

  /// On another scalar.
  template <class S>
  SpatialPointLoad<S> cast() const {
    return {at.template cast<S>(),
            force.template cast<S>(),
            moment.template cast<S>(),
            turns_with_body,
            is_harmonic,
            S(rate),
            S(phase)};
  }

  /// Adds force and moment about the mass centre, inertial: add(body, force, moment).
  template <class T, class Time, class Add>
  void apply(const SpatialFrame<T>& body, const Time& t, const Add& add) const {
    using std::cos;
    const T share = is_harmonic ? T(cos(Time(rate * t + phase))) : T(1);
    const auto acting = [&](const Vector3<R>& given) {
      return scaled(share, turns_with_body ? inertial_vector(body, given) : Vector3<T>(given.template cast<T>()));
    };
    const Vector3<T> f = acting(force);
    add(at.body, f, sum(acting(moment), cross(inertial_vector(body, at.point), f)));
  }
};

/// Forces in space that depend on places, velocities and time, other than those of joints and constraints.
template <class R>
struct SpatialForceElements {
  std::vector<SpatialSpring<R>> springs;   ///< in the scene's order
  std::vector<SpatialPointLoad<R>> loads;  ///< likewise

  bool empty() const { return springs.empty() && loads.empty(); }  ///< is there none?
  /// Does any spring have a damper?
  bool has_dampers() const {
    return std::any_of(springs.begin(), springs.end(), [](const auto& s) { return s.damping != 0; });
  }

  /// Calls add(body, force, moment about its mass centre) for all of them, inertial.
  /// @param frame  frame(body) is the frame of a body or of the ground
  /// @throws SpringWithoutDirection
  template <class T, class Time, class Frame, class Add>
  void apply(const Time& t, const Frame& frame, const Add& add) const {
    for (const SpatialSpring<R>& spring : springs) {
      const auto s = spring.template state<T>(frame(spring.first.body), frame(spring.second.body));
      const Vector3<T> on_first = scaled(s.tension, s.direction);
      const Vector3<T> on_second = negative(on_first);
      add(spring.first.body, on_first, cross(s.first_arm, on_first));
      add(spring.second.body, on_second, cross(s.second_arm, on_second));
    }
    for (const SpatialPointLoad<R>& load : loads) load.apply(frame(load.at.body), t, add);
  }

  /// Power of the loads [W].
  template <class T, class Time, class Frame>
  T load_power(const Time& t, const Frame& frame) const {
    T power(0);
    for (const SpatialPointLoad<R>& load : loads) {
      const SpatialFrame<T>& body = frame(load.at.body);
      load.apply(body, t, [&](std::size_t, const Vector3<T>& force, const Vector3<T>& moment) {
        power += dot(force, body.velocity) + dot(moment, body.spin);
      });
    }
    return power;
  }

  /// Elastic energy of the springs [J]. @throws SpringWithoutDirection
  template <class T, class Frame>
  T energy(const Frame& frame) const {
    T total(0);
    for (const SpatialSpring<R>& spring : springs) {
      const T stretch =
          spring.template state<T>(frame(spring.first.body), frame(spring.second.body)).length - spring.free_length;
      total += stretch * (spring.preload + spring.stiffness * stretch / 2);
    }
    return total;
  }

  /// Power of the dampers, never positive [W]. @throws SpringWithoutDirection
  template <class T, class Frame>
  T damper_power(const Frame& frame) const {
    T total(0);
    for (const SpatialSpring<R>& spring : springs) {
      const T rate = spring.template state<T>(frame(spring.first.body), frame(spring.second.body)).rate;
      total -= spring.damping * rate * rate;
    }
    return total;
  }
};

}  // namespace lubjoint
