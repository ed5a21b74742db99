/// Loads in space that change with time, with an angle or with the body they act on. Constant ones through the mass
/// centre are the body's own.
#pragma once

#include <memory>
#include <variant>

#include "lubjoint/multibody/spatial/turn.hpp"
#include "lubjoint/multibody/table_curves.hpp"

namespace lubjoint {

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

  std::size_t body() const { return at.body; }  ///< that it acts on

  /// Adds force and moment about the mass centre, inertial: add(force, moment).
  /// @param in  as a spring's
  template <class T, class Time, class In, class Add>
  void apply(const In& in, const Time& t, const TablePiece*, const Add& add) const {
    using std::cos;
    const SpatialFrame<T>& frame = in.frame(at.body);
    const T share = is_harmonic ? T(cos(Time(rate * t + phase))) : T(1);
    const auto acting = [&](const Vector3<R>& given) {
      return scaled(share, turns_with_body ? inertial_vector(frame, given) : Vector3<T>(given.template cast<T>()));
    };
    const Vector3<T> f = acting(force);
    add(f, sum(acting(moment), cross(inertial_vector(frame, at.point), f)));
  }
};

/// The unbalance U = m_u r of a body whose spin is held: −ω × (ω × U u) through the mass centre, u fixed to the body.
/// A body whose mass centre lies U/m along u off its axis of rotation moves that axis in the same way: its mass
/// centre's acceleration differs from the axis' by ω × (ω × u) U/m.
template <class R>
struct SpatialUnbalance {
  std::size_t number;      ///< of the body
  Vector3<R> mass_radius;  ///< U u, in the body's axes [kg m]

  /// On another scalar.
  template <class S>
  SpatialUnbalance<S> cast() const {
    return {number, mass_radius.template cast<S>()};
  }
  std::size_t body() const { return number; }  ///< that it acts on

  /// As that of a point load.
  template <class T, class Time, class In, class Add>
  void apply(const In& in, const Time&, const TablePiece*, const Add& add) const {
    const SpatialFrame<T>& frame = in.frame(number);
    const Vector3<T> turning = cross(frame.spin, inertial_vector(frame, mass_radius));
    add(negative(cross(frame.spin, turning)), zero_vector<T>());
  }
};

/// A force at a point fixed to a body, and a moment, from a table of time or of a counted angle.
template <class R>
struct SpatialTableLoad {
  SpatialBodyPoint<R> at;                       ///< where the force acts
  bool turns_with_body;                         ///< are both given in the body's axes?
  std::shared_ptr<const TableCurves<6>> table;  ///< F_x, F_y, F_z [N], M_x, M_y, M_z [N m]
  bool of_angle;                                ///< of an angle, in place of time?
  std::size_t angle;                            ///< its number among the system's counted angles

  /// On another scalar.
  template <class S>
  SpatialTableLoad<S> cast() const {
    return {at.template cast<S>(), turns_with_body, table, of_angle, angle};
  }
  std::size_t body() const { return at.body; }  ///< that it acts on

  /// As that of a point load. @param piece  of a table of an angle: the one that is read if it is held; may be null
  template <class T, class Time, class In, class Add>
  void apply(const In& in, const Time& t, const TablePiece* piece, const Add& add) const {
    const auto from = [&](const auto& values) {
      const SpatialFrame<T>& frame = in.frame(at.body);
      const auto acting = [&](std::size_t k) {
        const Vector3<T> given{T{values[k]}, T{values[k + 1]}, T{values[k + 2]}};
        return turns_with_body ? product(frame.rotation, given) : given;
      };
      const Vector3<T> f = acting(0);
      add(f, sum(acting(3), cross(inertial_vector(frame, at.point), f)));
    };
    if (of_angle) {
      const T now = in.angle(angle).angle;
      from(piece != nullptr && piece->is_held ? table->at(now, *piece) : table->at(now));
    } else {
      from(table->at(t));
    }
  }
};

/// Any of them.
template <class R>
using SpatialMovingLoad = std::variant<SpatialPointLoad<R>, SpatialUnbalance<R>, SpatialTableLoad<R>>;

}  // namespace lubjoint
