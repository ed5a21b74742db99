/// The motion that a driver prescribes.
#pragma once

#include <cmath>
#include <memory>

#include "lubjoint/multibody/table_curves.hpp"

namespace lubjoint {

/// What a driver's motion has beside φ₀ + ωt + ½αt²: A cos(νt + ψ), and a table of t, twice differentiable.
template <class R>
struct MotionShape {
  R amplitude;                                    ///< A [rad or m]; 0: none
  R rate;                                         ///< ν [rad/s]
  R phase;                                        ///< ψ [rad]
  std::shared_ptr<const TableCurves<1>> table{};  ///< none: no table
  R delay{0};                                     ///< the table is read at t + delay [s]

  /// On another scalar.
  template <class S>
  MotionShape<S> cast() const {
    return {S(amplitude), S(rate), S(phase), table, S(delay)};
  }
};

/// f and its first two derivatives at a time.
template <class Time>
struct DrivenMotion {
  Time value;         ///< f
  Time rate;          ///< ḟ
  Time acceleration;  ///< f̈
};

/// Adds what a shape has. Not inlined: the path of drivers without any stays as it is.
template <class R, class Time>
[[gnu::noinline]] void add_shape(const MotionShape<R>& shape, const Time& t, DrivenMotion<Time>& motion) {
  using std::cos;
  using std::sin;
  if (shape.amplitude != 0) {
    const Time angle = shape.rate * t + shape.phase;
    const Time c = shape.amplitude * cos(angle);
    motion.value += c;
    motion.rate -= shape.amplitude * shape.rate * sin(angle);
    motion.acceleration -= shape.rate * shape.rate * c;
  }
  if (shape.table) {
    const auto f = shape.table->with_derivatives(Time(t + shape.delay));
    motion.value += f.value[0];
    motion.rate += f.slope[0];
    motion.acceleration += f.curvature[0];
  }
}

/// f = φ₀ + ωt + ½αt² and what the shape adds, with ḟ and f̈.
/// @param shape  none: nothing
template <class R, class Time>
DrivenMotion<Time> driven_motion(const R& start, const R& speed, const R& acceleration,
                                 const std::shared_ptr<const MotionShape<R>>& shape, const Time& t) {
  DrivenMotion<Time> motion{Time(start + t * (speed + t * acceleration / 2)), Time(speed + t * acceleration),
                            Time(acceleration)};
  if (shape) add_shape(*shape, t, motion);
  return motion;
}

/// Sum of the sizes of the terms of f, by which its rounding is measured: also where f itself passes 0.
template <class R>
R size_of_terms(const R& start, const R& speed, const R& acceleration,
                const std::shared_ptr<const MotionShape<R>>& shape, const R& t) {
  using std::abs;
  R size = abs(start) + abs(t) * (abs(speed) + abs(R(t * acceleration / 2)));
  if (!shape) return size;
  size += abs(shape->amplitude);
  if (shape->table) size += R(shape->table->largest());
  return size;
}

/// The shape of a driver on another scalar.
template <class S, class R>
std::shared_ptr<const MotionShape<S>> cast_shape(const std::shared_ptr<const MotionShape<R>>& shape) {
  if (!shape) return nullptr;
  return std::make_shared<const MotionShape<S>>(shape->template cast<S>());
}

/// What a driver prescribes: f = f₀ + f₁ t + ½ f₂ t² and its shape.
template <class R>
struct PrescribedMotion {
  R start;                                                ///< f₀ [rad or m]
  R speed;                                                ///< f₁ [rad/s or m/s]
  R acceleration;                                         ///< f₂ [rad/s² or m/s²]
  std::shared_ptr<const MotionShape<R>> shape = nullptr;  ///< none: f is what the three before it say

  /// f with ḟ and f̈.
  template <class Time>
  DrivenMotion<Time> at(const Time& t) const {
    return driven_motion(start, speed, acceleration, shape, t);
  }
  /// Of f: see there.
  R size_of_terms(const R& t) const { return lubjoint::size_of_terms(start, speed, acceleration, shape, t); }
  /// On another scalar.
  template <class S>
  PrescribedMotion<S> cast() const {
    return {S(start), S(speed), S(acceleration), cast_shape<S>(shape)};
  }
};

/// The motion a time later, f(t + T) as a function of t: start, speed and shape are changed.
template <class R>
void move_start(R& start, R& speed, const R& acceleration, std::shared_ptr<const MotionShape<R>>& shape, const R& by) {
  start += by * (speed + by * acceleration / 2);
  speed += by * acceleration;
  if (!shape) return;
  MotionShape<R> later = *shape;
  later.phase += by * later.rate;
  later.delay += by;
  shape = std::make_shared<const MotionShape<R>>(later);
}

}  // namespace lubjoint
