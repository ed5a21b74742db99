/// Loads that change with time or with the body they act on. Constant ones through the mass centre are the body's own.
#pragma once

#include <memory>
#include <variant>

#include "lubjoint/multibody/constraint_row.hpp"
#include "lubjoint/multibody/table_curves.hpp"

namespace lubjoint {

/// A force at a point fixed to a body, and a moment: constant, or A cos(ωt + ψ) with the given ones as amplitudes A.
template <class R>
struct PointLoad {
  BodyPoint<R> at;       ///< where the force acts
  Vector2<R> force;      ///< or its amplitude [N]
  R moment;              ///< or its amplitude, counter-clockwise positive [N m]
  bool turns_with_body;  ///< is the force given in the body's axes?
  bool is_harmonic;      ///< else constant
  R rate;                ///< ω [rad/s]
  R phase;               ///< ψ [rad]

  /// On another scalar.
  template <class S>
  PointLoad<S> cast() const {
    return {
        at.template cast<S>(), force.template cast<S>(), S(moment), turns_with_body, is_harmonic, S(rate), S(phase)};
  }
  std::size_t body() const { return at.body; }  ///< that it acts on

  /// Adds force and moment about the mass centre: add(force, moment).
  template <class T, class Time, class Add>
  void apply(const PlanarFrame<T>& frame, const Time& t, const Add& add) const {
    using std::cos;
    const T share = is_harmonic ? T(cos(Time(rate * t + phase))) : T(1);
    const Vector2<T> given = turns_with_body ? inertial_vector(frame, force) : Vector2<T>(T(force.x()), T(force.y()));
    const Vector2<T> acting(T(share * given.x()), T(share * given.y()));
    add(acting, T(share * moment + cross(inertial_vector(frame, at.point), acting)));
  }
};

/// The unbalance U = m_u r of a body whose spin is held: U φ̇² along the body's axis turned by ψ, through the mass
/// centre. A body whose mass centre lies U/m off its axis of rotation moves that axis in the same way: its mass
/// centre's acceleration differs from the axis' by −(U/m) φ̇² along that direction.
template <class R>
struct Unbalance {
  std::size_t number;  ///< of the body
  R mass_radius;       ///< U [kg m]
  Vector2<R> along;    ///< (cos ψ, sin ψ), ψ from the body's x axis

  /// On another scalar.
  template <class S>
  Unbalance<S> cast() const {
    return {number, S(mass_radius), along.template cast<S>()};
  }
  std::size_t body() const { return number; }  ///< that it acts on

  /// As that of a point load.
  template <class T, class Time, class Add>
  void apply(const PlanarFrame<T>& frame, const Time&, const Add& add) const {
    const T size = mass_radius * frame.spin * frame.spin;
    const Vector2<T> n = inertial_vector(frame, along);
    add(Vector2<T>(T(size * n.x()), T(size * n.y())), T(0));
  }
};

/// A force at a point fixed to a body, and a moment, from a table of time or of a body's angle.
template <class R>
struct TableLoad {
  BodyPoint<R> at;                              ///< where the force acts
  bool turns_with_body;                         ///< is the force given in the body's axes?
  std::shared_ptr<const TableCurves<3>> table;  ///< F_x, F_y [N] and M, counter-clockwise positive [N m]
  bool of_angle;                                ///< of a body's angle, in place of time?
  std::size_t against;                          ///< that body
  R delay;                                      ///< a table of time is read at t + delay [s]
  /// Does that body turn evenly? Its knots are then times that a run is told, and no places that it looks for.
  bool at_known_times = false;

  /// On another scalar.
  template <class S>
  TableLoad<S> cast() const {
    return {at.template cast<S>(), turns_with_body, table, of_angle, against, S(delay), at_known_times};
  }
  std::size_t body() const { return at.body; }  ///< that it acts on

  /// As that of a point load, with frame(body), the frames of bodies.
  /// @param piece  of a table of an angle: the one that is read if it is held; may be null
  template <class T, class Time, class Frame, class Add>
  void apply_with(const Frame& frame_of, const Time& t, const TablePiece* piece, const Add& add) const {
    const auto from = [&](const auto& values) {
      const PlanarFrame<T>& frame = frame_of(at.body);
      const T along_x(values[0]);
      const T along_y(values[1]);
      const Vector2<T> given(along_x, along_y);
      const Vector2<T> acting = turns_with_body ? Vector2<T>(T(frame.cosine * given.x() - frame.sine * given.y()),
                                                             T(frame.sine * given.x() + frame.cosine * given.y()))
                                                : given;
      add(acting, T(T(values[2]) + cross(inertial_vector(frame, at.point), acting)));
    };
    if (of_angle) {
      const T& angle = frame_of(against).angle;
      from(piece != nullptr && piece->is_held ? table->at(angle, *piece) : table->at(angle));
    } else {
      from(table->at(Time(t + delay)));
    }
  }
};

/// Any of them.
template <class R>
using MovingLoad = std::variant<PointLoad<R>, Unbalance<R>, TableLoad<R>>;

/// Adds force and moment of a load about its body's mass centre: add(force, moment).
/// @param frame  frame(body) is the frame of a body;  @param piece  of a table; may be null
template <class T, class R, class Time, class Frame, class Add>
void apply_load(const MovingLoad<R>& load, const Time& t, const Frame& frame, const TablePiece* piece, const Add& add) {
  std::visit(
      [&](const auto& each) {
        if constexpr (requires { each.template apply_with<T>(frame, t, piece, add); }) {
          each.template apply_with<T>(frame, t, piece, add);
        } else {
          each.apply(frame(each.body()), t, add);
        }
      },
      load);
}

/// Number of the body that a load acts on.
template <class R>
std::size_t body_of(const MovingLoad<R>& load) {
  return std::visit([](const auto& each) { return each.body(); }, load);
}

}  // namespace lubjoint
