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

  GudgeonPin<R> pin(const R& t, const DeviationState<R>& y) const { return at(t, y).pin; }

  /// Moment of the driver on the crank, counter-clockwise positive [N m].
  R driving_moment(const R& t, const DeviationState<R>& y) const {
    const Instant now = at(t, y);
    const R half = m_.rod_length / 2;
    const R turning = now.rod_acceleration;
    const R ax = now.pin_acceleration.x() - half * (now.sine * turning + now.cosine * now.rod_rate * now.rod_rate);
    const R ay = now.pin_acceleration.y() + half * (now.cosine * turning - now.sine * now.rod_rate * now.rod_rate);
    const Vector2<R> crank_pin(R(m_.rod_mass * ax + now.on_slider.x()), R(m_.rod_mass * ay + now.on_slider.y()));
    return cross(now.crank_pin, crank_pin);
  }

  /// dy/dt. @throws FilmDomainError where ε ≥ 1
  void rate(const DeviationState<R>& y, DeviationState<R>& dydt, const R& t) const {
    const Instant now = at(t, y);
    const R c = bearing_.clearance();
    dydt[0] = y[2] * speed_;
    dydt[1] = y[3] * speed_;
    dydt[2] = (now.rod_acceleration - now.ideal.rod.acceleration) * m_.rod_length / (c * speed_);
    dydt[3] = (now.on_slider.x() / m_.slider_mass - now.ideal.slider.acceleration) / (c * speed_);
  }

 private:
  struct Instant {
    IdealMotion<R> ideal;
    Vector2<R> crank_pin;         ///< A
    Vector2<R> pin_acceleration;  ///< of A
    R sine;                       ///< of the rod's angle
    R cosine;
    R rod_rate;
    GudgeonPin<R> pin;
    Vector2<R> on_slider;  ///< force [N]
    R rod_acceleration;
  };

  Instant at(const R& t, const DeviationState<R>& y) const {
    using std::cos;
    using std::sin;
    Instant now;
    const R c = bearing_.clearance();
    const R l = m_.rod_length;
    const R theta = speed_ * t;
    now.ideal = ideal_motion<R>(m_, {theta, speed_, R(0)});
    const R phi = now.ideal.rod.value + c * y[0] / l;
    now.rod_rate = now.ideal.rod.rate + c * speed_ * y[2] / l;
    now.sine = sin(phi);
    now.cosine = cos(phi);
    now.crank_pin = m_.crank_length * Vector2<R>(R(cos(theta)), R(sin(theta)));
    const R slider = now.ideal.slider.value + c * y[1];
    const R slider_rate = now.ideal.slider.rate + c * speed_ * y[3];
    // From the rod's end to the slider's centre.
    const Vector2<R> gap(R(slider - now.crank_pin.x() - l * now.cosine), R(-now.crank_pin.y() - l * now.sine));
    const Vector2<R> gap_rate(R(slider_rate + speed_ * now.crank_pin.y() + l * now.sine * now.rod_rate),
                              R(-speed_ * now.crank_pin.x() - l * now.cosine * now.rod_rate));
    const R sign = side_ == BearingOn::rod ? R(1) : R(-1);
    now.pin.eccentricity = gap * (sign / c);
    now.pin.velocity = gap_rate * (sign / c);
    // The slider does not turn: the mean spin is half the rod's.
    const R mean_spin = now.rod_rate / 2;
    const FilmState<R> film(now.pin.eccentricity,
                            Vector2<R>(now.pin.velocity - mean_spin * perpendicular(now.pin.eccentricity)));
    now.pin.force = scale_ * force_ratio<Law>(film);
    now.on_slider = sign * now.pin.force;
    // The pair of forces acts at the journal's centre: on the slider, or at the rod's end.
    const Vector2<R> end(R(l * now.cosine), R(l * now.sine));
    const Vector2<R> arm = side_ == BearingOn::rod ? Vector2<R>(end + gap) : end;
    now.pin_acceleration = -speed_ * speed_ * now.crank_pin;
    const R inertia = m_.rod_inertia + m_.rod_mass * l * l / 4;
    const R carried =
        m_.rod_mass * l / 2 * (now.cosine * now.pin_acceleration.y() - now.sine * now.pin_acceleration.x());
    now.rod_acceleration = (-cross<R>(arm, now.on_slider) - carried) / inertia;
    return now;
  }

  SliderCrank<R> m_;
  R speed_;
  Bearing<R> bearing_;
  R scale_;
  BearingOn side_;
};

}  // namespace lubjoint::mechanisms
