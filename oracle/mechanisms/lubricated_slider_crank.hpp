/// The slider-crank with a lubricated gudgeon pin in minimal coordinates: rod angle and slider position.
/// It shares the film laws with the library, and nothing else.
#pragma once

#include <array>

#include "lubjoint/film/law.hpp"
#include "oracle/mechanisms/slider_crank.hpp"

namespace lubjoint::mechanisms {

/// Which body carries the bearing; the journal is on the other.
enum class BearingOn { rod, slider };

/// Deviation from the ideal mechanism: y = [l(φ − φ_i)/c, (x − x_i)/c] and its rates over cΩ. Whoever integrates it
/// finds every component of the order of one, and no digit lost to the mechanism's own size.
template <class R>
using DeviationState = std::array<R, 4>;

/// The journal in its bearing.
template <class R>
struct GudgeonPin {
  Vector2<R> eccentricity;  ///< e/c [-]
  Vector2<R> velocity;      ///< its inertial rate [1/s]
  Vector2<R> force;         ///< of the film on the journal [N]
};

/// Crank at θ = Ωt, driven; no gravity; the law of film Law.
template <FilmLaw Law, class R>
class LubricatedSliderCrank {
 public:
  LubricatedSliderCrank(const SliderCrank<R>& mechanism, const R& crank_speed, const Bearing<R>& bearing,
                        const Lubricant<R>& oil, BearingOn side)
      : m_(mechanism),
        speed_(crank_speed),
        bearing_(bearing),
        scale_(lubjoint::force_scale(Law::limit, bearing, oil)),
        side_(side) {}

  /// ê alone, from the positions y₀ and y₁.
  Vector2<R> eccentricity(const R& t, const R& y0, const R& y1) const {
    using std::cos;
    using std::sin;
    const R c = bearing_.clearance();
    const R l = m_.rod_length;
    const R theta = speed_ * t;
    const IdealMotion<R> ideal = ideal_motion<R>(m_, {theta, speed_, R(0)});
    const R phi = ideal.rod.value + c * y0 / l;
    const R sign = side_ == BearingOn::rod ? R(1) : R(-1);
    const R x = ideal.slider.value + c * y1 - m_.crank_length * cos(theta) - l * cos(phi);
    const R y = -m_.crank_length * sin(theta) - l * sin(phi);
    return {R(x * (sign / c)), R(y * (sign / c))};
  }

  template <class T>
  GudgeonPin<T> pin(const R& t, const DeviationState<T>& y) const {
    return at(t, y).pin;
  }

  /// Moment of the driver on the crank, counter-clockwise positive [N m].
  R driving_moment(const R& t, const DeviationState<R>& y) const {
    const Instant<R> now = at(t, y);
    const R half = m_.rod_length / 2;
    const R turning = now.rod_acceleration;
    const R ax = now.pin_acceleration.x() - half * (now.sine * turning + now.cosine * now.rod_rate * now.rod_rate);
    const R ay = now.pin_acceleration.y() + half * (now.cosine * turning - now.sine * now.rod_rate * now.rod_rate);
    const Vector2<R> crank_pin(R(m_.rod_mass * ax + now.on_slider.x()), R(m_.rod_mass * ay + now.on_slider.y()));
    return cross(now.crank_pin, crank_pin);
  }

  /// dy/dt, on any scalar. @throws FilmDomainError where ε ≥ 1
  template <class T>
  void rate(const DeviationState<T>& y, DeviationState<T>& dydt, const R& t) const {
    const Instant<T> now = at(t, y);
    const R c = bearing_.clearance();
    dydt[0] = y[2] * speed_;
    dydt[1] = y[3] * speed_;
    dydt[2] = (now.rod_acceleration - now.ideal.rod.acceleration) * m_.rod_length / (c * speed_);
    dydt[3] = (now.on_slider.x() / m_.slider_mass - now.ideal.slider.acceleration) / (c * speed_);
  }

 private:
  template <class T>
  struct Instant {
    IdealMotion<R> ideal;
    Vector2<R> crank_pin;         ///< A
    Vector2<R> pin_acceleration;  ///< of A
    T sine;                       ///< of the rod's angle
    T cosine;
    T rod_rate;
    GudgeonPin<T> pin;
    Vector2<T> on_slider;  ///< force [N]
    T rod_acceleration;
  };

  template <class T>
  Instant<T> at(const R& t, const DeviationState<T>& y) const {
    using std::cos;
    using std::sin;
    Instant<T> now;
    const R c = bearing_.clearance();
    const R l = m_.rod_length;
    const R theta = speed_ * t;
    now.ideal = ideal_motion<R>(m_, {theta, speed_, R(0)});
    const T phi = now.ideal.rod.value + (c / l) * y[0];
    now.rod_rate = now.ideal.rod.rate + (c * speed_ / l) * y[2];
    now.sine = sin(phi);
    now.cosine = cos(phi);
    now.crank_pin = m_.crank_length * Vector2<R>(R(cos(theta)), R(sin(theta)));
    const T slider = now.ideal.slider.value + c * y[1];
    const T slider_rate = now.ideal.slider.rate + (c * speed_) * y[3];
    // From the rod's end to the slider's centre.
    const Vector2<T> gap(T(slider - now.crank_pin.x() - l * now.cosine), T(-now.crank_pin.y() - l * now.sine));
    const Vector2<T> gap_rate(T(slider_rate + speed_ * now.crank_pin.y() + l * now.sine * now.rod_rate),
                              T(-speed_ * now.crank_pin.x() - l * now.cosine * now.rod_rate));
    const R sign = side_ == BearingOn::rod ? R(1) : R(-1);
    const R per_clearance = sign / c;
    now.pin.eccentricity = {T(gap.x() * per_clearance), T(gap.y() * per_clearance)};
    now.pin.velocity = {T(gap_rate.x() * per_clearance), T(gap_rate.y() * per_clearance)};
    // The slider does not turn: the mean spin is half the rod's. u = ė/c − ω̄ (e/c)⊥.
    const T mean_spin = now.rod_rate / R(2);
    const Vector2<T>& e = now.pin.eccentricity;
    const FilmState<T> film(
        e, Vector2<T>(T(now.pin.velocity.x() + mean_spin * e.y()), T(now.pin.velocity.y() - mean_spin * e.x())));
    const Vector2<T> ratio = force_ratio<Law>(film);
    now.pin.force = {T(scale_ * ratio.x()), T(scale_ * ratio.y())};
    now.on_slider = {T(sign * now.pin.force.x()), T(sign * now.pin.force.y())};
    // The pair of forces acts at the journal's centre: on the slider, or at the rod's end.
    Vector2<T> arm(T(l * now.cosine), T(l * now.sine));
    if (side_ == BearingOn::rod) arm = {T(arm.x() + gap.x()), T(arm.y() + gap.y())};
    now.pin_acceleration = -speed_ * speed_ * now.crank_pin;
    const R inertia = m_.rod_inertia + m_.rod_mass * l * l / 4;
    const R carried = m_.rod_mass * l / 2;
    const T weight = carried * (now.cosine * now.pin_acceleration.y() - now.sine * now.pin_acceleration.x());
    now.rod_acceleration = (-(arm.x() * now.on_slider.y() - arm.y() * now.on_slider.x()) - weight) / inertia;
    return now;
  }

  SliderCrank<R> m_;
  R speed_;
  Bearing<R> bearing_;
  R scale_;
  BearingOn side_;
};

}  // namespace lubjoint::mechanisms
