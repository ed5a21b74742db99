/// Springs with dampers in space, between two bodies, or a body and the ground.
#pragma once

#include <string>
#include <variant>

#include "lubjoint/multibody/spatial/turn.hpp"
#include "lubjoint/multibody/spring.hpp"

namespace lubjoint {

/// A spring with a damper between P_i and P_j in space.
///   d = P_j − P_i, L = |d|, n = d/L:  S = S₀ + k(L − L₀) + c n·ḋ pulls P_j along −n and P_i along n
/// Elastic energy ½k(L − L₀)² + S₀(L − L₀); the damper's power is −c(n·ḋ)².
template <class R>
struct SpatialTranslationalSpring {
  SpatialBodyPoint<R> first;   ///< P_i
  SpatialBodyPoint<R> second;  ///< P_j
  R stiffness;                 ///< k [N/m]
  R damping;                   ///< c [N s/m]
  R free_length;               ///< L₀ [m]
  R preload;                   ///< S₀, the tension at L₀ without motion [N]

  /// On another scalar.
  template <class S>
  SpatialTranslationalSpring<S> cast() const {
    return {first.template cast<S>(), second.template cast<S>(), S(stiffness), S(damping), S(free_length), S(preload)};
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

  /// Adds force and moment about the mass centre on both bodies, inertial: add(body, force, moment).
  /// @param in  frames of bodies and motions of angles: in.frame(body), in.angle(number)
  template <class T, class In, class Add>
  void apply(const In& in, const Add& add) const {
    const State<T> s = state<T>(in.frame(first.body), in.frame(second.body));
    const Vector3<T> on_first = scaled(s.tension, s.direction);
    const Vector3<T> on_second = negative(on_first);
    add(first.body, on_first, cross(s.first_arm, on_first));
    add(second.body, on_second, cross(s.second_arm, on_second));
  }
  /// Elastic energy [J].
  template <class T, class In>
  T energy(const In& in) const {
    const T stretch = state<T>(in.frame(first.body), in.frame(second.body)).length - free_length;
    return T(stretch * (preload + stiffness * stretch / 2));
  }
  /// Power of the damper on both bodies, never positive [W].
  template <class T, class In>
  T damper_power(const In& in) const {
    const T rate = state<T>(in.frame(first.body), in.frame(second.body)).rate;
    return T(-damping * rate * rate);
  }
  /// The tension [N].
  template <class T, class In>
  T effort(const In& in) const {
    return state<T>(in.frame(first.body), in.frame(second.body)).tension;
  }
};

/// A spring with a damper that turns body j against body i about the axis of a joint: the moment on j about a is
/// −(k(θ − θ₀) + c θ̇), that on i its opposite, θ and a as in turn.hpp. Elastic energy ½k(θ − θ₀)²; the damper's power
/// is −c θ̇².
template <class R>
struct SpatialRotationalSpring {
  std::size_t angle;   ///< number of θ among the system's counted angles
  std::size_t first;   ///< body i; may be the ground
  std::size_t second;  ///< body j; may be the ground
  R stiffness;         ///< k [N m/rad]
  R damping;           ///< c [N m s/rad]
  R free_angle;        ///< θ₀ [rad]

  /// On another scalar.
  template <class S>
  SpatialRotationalSpring<S> cast() const {
    return {angle, first, second, S(stiffness), S(damping), S(free_angle)};
  }
  /// As those of the translational one.
  template <class T, class In, class Add>
  void apply(const In& in, const Add& add) const {
    const AngleMotion<T> motion = in.angle(angle);
    const Vector3<T> moment = scaled(moment_of(motion), motion.axis);
    add(first, zero_vector<T>(), moment);
    add(second, zero_vector<T>(), negative(moment));
  }
  /// Elastic energy [J].
  template <class T, class In>
  T energy(const In& in) const {
    const T twist = in.angle(angle).angle - free_angle;
    return T(stiffness * twist * twist / 2);
  }
  /// Power of the damper on both bodies, never positive [W].
  template <class T, class In>
  T damper_power(const In& in) const {
    const T rate = in.angle(angle).rate;
    return T(-damping * rate * rate);
  }
  /// k(θ − θ₀) + c θ̇, against the turning of body j [N m].
  template <class T, class In>
  T effort(const In& in) const {
    return moment_of<T>(in.angle(angle));
  }

 private:
  template <class T>
  T moment_of(const AngleMotion<T>& motion) const {
    return T(stiffness * (motion.angle - free_angle) + damping * motion.rate);
  }
};

/// A spring of either kind, and the name that messages and results give it.
template <class R>
struct NamedSpatialSpring {
  std::string name;                                                                ///< unique among the springs
  std::variant<SpatialTranslationalSpring<R>, SpatialRotationalSpring<R>> spring;  ///< the spring itself

  /// Has it a damper?
  bool is_damped() const {
    return std::visit([](const auto& s) { return s.damping != 0; }, spring);
  }
  /// On another scalar.
  template <class S>
  NamedSpatialSpring<S> cast() const {
    return {name,
            std::visit([](const auto& s) -> decltype(NamedSpatialSpring<S>::spring) { return s.template cast<S>(); },
                       spring)};
  }
};

}  // namespace lubjoint
