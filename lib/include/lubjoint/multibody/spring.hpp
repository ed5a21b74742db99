/// Springs with dampers between two bodies, or a body and the ground.
#pragma once

#include <stdexcept>
#include <string>
#include <variant>

#include "lubjoint/multibody/constraint_row.hpp"

namespace lubjoint {

/// A spring of length 0 pulls in no direction.
class SpringWithoutDirection : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// A spring with a damper between P_i and P_j.
///   d = P_j − P_i, L = |d|, n = d/L:  S = S₀ + k(L − L₀) + c n·ḋ pulls P_j along −n and P_i along n
/// Elastic energy ½k(L − L₀)² + S₀(L − L₀); the damper's power is −c(n·ḋ)².
template <class R>
struct TranslationalSpring {
  BodyPoint<R> first;   ///< P_i
  BodyPoint<R> second;  ///< P_j
  R stiffness;          ///< k [N/m]
  R damping;            ///< c [N s/m]
  R free_length;        ///< L₀ [m]
  R preload;            ///< S₀, the tension at L₀ without motion [N]

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j

  /// On another scalar.
  template <class S>
  TranslationalSpring<S> cast() const {
    return {first.template cast<S>(), second.template cast<S>(), S(stiffness), S(damping), S(free_length), S(preload)};
  }

  /// Where it is and what it does.
  template <class T>
  struct State {
    Vector2<T> first_arm;   ///< s_i [m]
    Vector2<T> second_arm;  ///< s_j [m]
    Vector2<T> direction;   ///< n
    T length;               ///< L [m]
    T rate;                 ///< n·ḋ [m/s]
    T tension;              ///< S [N]
  };
  /// From the motions of its two bodies. @throws SpringWithoutDirection
  template <class T>
  State<T> state(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    const PointMotion<T> p_i = point_motion(body_i, first.point);
    const PointMotion<T> p_j = point_motion(body_j, second.point);
    const Vector2<T> d(T(p_j.position.x() - p_i.position.x()), T(p_j.position.y() - p_i.position.y()));
    if (is_zero(d)) throw SpringWithoutDirection("a spring of length 0 has no direction");
    const T length = norm(d);
    const Vector2<T> n = direction(d);
    const T rate = n.x() * (p_j.velocity.x() - p_i.velocity.x()) + n.y() * (p_j.velocity.y() - p_i.velocity.y());
    return {p_i.arm, p_j.arm, n, length, rate, T(preload + stiffness * (length - free_length) + damping * rate)};
  }
  /// Adds force and moment about the mass centre on both bodies: add(body, force, moment).
  template <class T, class Add>
  void apply(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Add& add) const {
    const State<T> s = state(body_i, body_j);
    const Vector2<T> on_first(T(s.tension * s.direction.x()), T(s.tension * s.direction.y()));
    const Vector2<T> on_second(T(-on_first.x()), T(-on_first.y()));
    add(first.body, on_first, cross(s.first_arm, on_first));
    add(second.body, on_second, cross(s.second_arm, on_second));
  }
  /// Elastic energy [J].
  template <class T>
  T energy(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    const T stretch = state(body_i, body_j).length - free_length;
    return T(stretch * (preload + stiffness * stretch / 2));
  }
  /// Power of the damper on both bodies, never positive [W].
  template <class T>
  T damper_power(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    const T rate = state(body_i, body_j).rate;
    return T(-damping * rate * rate);
  }
};

/// A spring with a damper that turns body j against body i.
///   θ = φ_j − φ_i:  the moment on j is −(k(θ − θ₀) + c θ̇), that on i its opposite
template <class R>
struct RotationalSpring {
  std::size_t first;   ///< body i; may be the ground
  std::size_t second;  ///< body j; may be the ground
  R stiffness;         ///< k [N m/rad]
  R damping;           ///< c [N m s/rad]
  R free_angle;        ///< θ₀ [rad]

  std::size_t first_body() const { return first; }    ///< i
  std::size_t second_body() const { return second; }  ///< j

  /// On another scalar.
  template <class S>
  RotationalSpring<S> cast() const {
    return {first, second, S(stiffness), S(damping), S(free_angle)};
  }
  /// k(θ − θ₀) + c θ̇, against the turning of body j [N m].
  template <class T>
  T torque(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    return T(stiffness * (body_j.angle - body_i.angle - free_angle) + damping * (body_j.spin - body_i.spin));
  }
  /// As that of the translational one.
  template <class T, class Add>
  void apply(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Add& add) const {
    const Vector2<T> no_force(T(0), T(0));
    const T moment = torque(body_i, body_j);
    add(first, no_force, moment);
    add(second, no_force, T(-moment));
  }
  /// Elastic energy [J].
  template <class T>
  T energy(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    const T twist = body_j.angle - body_i.angle - free_angle;
    return T(stiffness * twist * twist / 2);
  }
  /// Power of the damper on both bodies, never positive [W].
  template <class T>
  T damper_power(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j) const {
    const T rate = body_j.spin - body_i.spin;
    return T(-damping * rate * rate);
  }
};

/// A spring of either kind, and the name that messages and results give it.
template <class R>
struct NamedSpring {
  std::string name;                                                  ///< unique among the springs
  std::variant<TranslationalSpring<R>, RotationalSpring<R>> spring;  ///< the spring itself

  /// Number of body i, or ground_body.
  std::size_t first_body() const {
    return std::visit([](const auto& s) { return s.first_body(); }, spring);
  }
  /// Number of body j, or ground_body.
  std::size_t second_body() const {
    return std::visit([](const auto& s) { return s.second_body(); }, spring);
  }
  /// Has it a damper?
  bool is_damped() const {
    return std::visit([](const auto& s) { return s.damping != 0; }, spring);
  }
  /// On another scalar.
  template <class S>
  NamedSpring<S> cast() const {
    return {name, std::visit(
                      [](const auto& s) -> std::variant<TranslationalSpring<S>, RotationalSpring<S>> {
                        return s.template cast<S>();
                      },
                      spring)};
  }
};

}  // namespace lubjoint
