/// The slider-crank with a lubricated gudgeon pin whose half film may slide on its jump, in minimal coordinates: rod
/// angle φ and slider position x. It shares the film laws with the library, and nothing else.
///
/// With e as a complex number, the bearing on the rod (ω_B = φ̇) and the journal on a slider that does not turn, the
/// mean spin is φ̇/2, and z = e exp(−iφ/2) is e in the frame that turns with it, ż the pure-squeeze velocity there. a =
/// 0 is Im(z̄ ż) = 0: z moves on a ray. It stays there while Im(z̄ z̈) = 0, which is
///   t·ë − φ̇ (r·ė) − ½ φ̈ (r·e) = 0   (r, t: the ray and its normal, turned back),
/// linear in the film's tangential force by way of φ̈ and ẍ.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/mechanisms/journal_films.hpp"
#include "oracle/mechanisms/lobatto.hpp"
#include "oracle/mechanisms/slider_crank.hpp"

namespace lubjoint::mechanisms {

/// The pin's bearing and its oil.
template <class R>
struct PinBearing {
  R length;          ///< L [m]
  R journal_radius;  ///< R [m]
  R clearance;       ///< c [m]
  R viscosity;       ///< μ [Pa s]
};

/// Which side of its jump a film is on.
enum class JumpSide { converging, mirrored, sliding };

/// The journal in its bearing at one time, inertial.
template <class R>
struct PinSample {
  R t;
  Vector2<R> eccentricity;  ///< e/c
  Vector2<R> velocity;      ///< ė/c [1/s]
  Vector2<R> force;         ///< of the film on the journal [N]
  JumpSide side;            ///< in which it is
};

/// The begin of a side.
template <class R>
struct SideChange {
  R t;
  JumpSide side;
};

template <class R>
struct PinRun {
  std::vector<PinSample<R>> samples;   ///< at the times asked for, or fewer if it stopped
  std::vector<SideChange<R>> changes;  ///< the first at the start
  std::string stopped;                 ///< why it did not reach the last time; empty if it did
};

/// Crank at θ = Ωt, no gravity, from the ideal mechanism's places and velocities; the half film Law.
/// States are deviations from the ideal mechanism: y = [l(φ − φ_i)/c, (x − x_i)/c] and their rates over cΩ.
template <HalfFilmLaw Law, class R>
class HalfFilmSliderCrank {
 public:
  using State = ShortState<R, 4>;

  /// @param tolerance  of a step: of the gap to the wall, and of the velocity
  HalfFilmSliderCrank(const SliderCrank<R>& mechanism, const R& crank_speed, const PinBearing<R>& pin,
                      const R& tolerance)
      : m_(mechanism), speed_(crank_speed), c_(pin.clearance), method_(tolerance) {
    const R across = LibraryFilm<Law>::is_short ? pin.length : pin.journal_radius;
    scale_ = pin.viscosity * pin.length * pin.journal_radius * (across / c_) * (across / c_);
  }

  /// To each of the times, which increase from 0.
  PinRun<R> run(const std::vector<R>& times) {
    PinRun<R> run;
    try {
      integrate(times, run);
    } catch (const std::exception& error) {
      run.stopped = error.what();
    }
    return run;
  }

  // What the integrator asks for.

  std::size_t states() const { return 4; }

  void rate(const R& t, const State& y, State& dydt) const {
    const Place p = place(t, y);
    const Push push = pushed(p, film_on(p));
    dydt = {y[2] * speed_, y[3] * speed_,
            (push.rod_acceleration - p.ideal.rod.acceleration) * m_.rod_length / (c_ * speed_),
            (push.slider_acceleration - p.ideal.slider.acceleration) / (c_ * speed_)};
  }

  void weights(const State& y, State& w) const {
    using std::abs;
    const R room = std::max<R>(room_, R(1) / 10000);
    const R pace = abs(y[2]) + abs(y[3]) + room;
    w = {room, room, pace, pace};
  }

  void increments(const State& y, State& d) const {
    using std::sqrt;
    weights(y, d);
    for (R& x : d) x *= sqrt(std::numeric_limits<R>::epsilon());
  }

 private:
  /// Positions and velocities, and the journal seen along r.
  struct Place {
    IdealMotion<R> ideal;
    R sine, cosine;               ///< of φ
    R turn;                       ///< φ̇
    Vector2<R> arm;               ///< from the crank pin to the slider's centre
    Vector2<R> pin_acceleration;  ///< of the crank pin
    Vector2<R> e, v;              ///< e/c and ė/c
    Vector2<R> r;                 ///< unit vector along e, or of the ray
    R rho, b, slip;               ///< r·e/c, and u along r and t
  };

  Place place(const R& t, const State& y) const {
    using std::cos;
    using std::sin;
    Place p;
    const R theta = speed_ * t;
    p.ideal = ideal_motion<R>(m_, {theta, speed_, R(0)});
    const R phi = p.ideal.rod.value + c_ / m_.rod_length * y[0];
    p.turn = p.ideal.rod.rate + c_ * speed_ / m_.rod_length * y[2];
    p.sine = sin(phi);
    p.cosine = cos(phi);
    const Vector2<R> pin(R(m_.crank_length * cos(theta)), R(m_.crank_length * sin(theta)));
    p.pin_acceleration = -speed_ * speed_ * pin;
    const R slider = p.ideal.slider.value + c_ * y[1];
    const R slider_rate = p.ideal.slider.rate + c_ * speed_ * y[3];
    p.arm = {R(slider - pin.x()), R(-pin.y())};
    p.e = {R((p.arm.x() - m_.rod_length * p.cosine) / c_), R((p.arm.y() - m_.rod_length * p.sine) / c_)};
    p.v = {R((slider_rate + speed_ * pin.y() + m_.rod_length * p.sine * p.turn) / c_),
           R((-speed_ * pin.x() - m_.rod_length * p.cosine * p.turn) / c_)};
    const Vector2<R> u(R(p.v.x() + p.turn / 2 * p.e.y()), R(p.v.y() - p.turn / 2 * p.e.x()));
    if (side_ == JumpSide::sliding) {
      const R c = cos(R(phi / 2 - ray_angle_));
      const R s = sin(R(phi / 2 - ray_angle_));
      p.r = {R(c * ray_.x() - s * ray_.y()), R(s * ray_.x() + c * ray_.y())};
    } else {
      p.r = is_zero(p.e) ? direction_or_x(u) : Vector2<R>(p.e / norm(p.e));
    }
    p.rho = dot(p.r, p.e);
    p.b = dot(p.r, u);
    p.slip = side_ == JumpSide::sliding || is_zero(p.e) ? R(0) : cross(p.r, u);
    return p;
  }

  static Vector2<R> direction_or_x(const Vector2<R>& v) {
    return is_zero(v) ? Vector2<R>(R(1), R(0)) : Vector2<R>(v / norm(v));
  }

  /// What a force on the slider does.
  struct Push {
    R rod_acceleration;
    R slider_acceleration;
  };

  /// The rod turns about the crank pin; −F acts on it at the slider's centre.
  Push pushed(const Place& p, const Vector2<R>& force) const {
    const R l = m_.rod_length;
    const R inertia = m_.rod_inertia + m_.rod_mass * l * l / 4;
    const R carried = m_.rod_mass * l / 2 * (p.cosine * p.pin_acceleration.y() - p.sine * p.pin_acceleration.x());
    return {(-cross(p.arm, force) - carried) / inertia, force.x() / m_.slider_mass};
  }

  /// ë
  Vector2<R> relative_acceleration(const Place& p, const Push& push) const {
    const R l = m_.rod_length;
    const R square = p.turn * p.turn;
    return {
        R(push.slider_acceleration - p.pin_acceleration.x() + l * (p.sine * push.rod_acceleration + p.cosine * square)),
        R(-p.pin_acceleration.y() - l * (p.cosine * push.rod_acceleration - p.sine * square))};
  }

  /// Force of the film as if on the side a ≥ 0 or a ≤ 0, along r and t [N]; on a = 0, F_r and X.
  std::array<R, 2> film(const Place& p, int side) const {
    const R sign = p.rho < 0 ? R(-1) : R(1);
    const R epsilon = sign * p.rho;
    const R q = (1 - epsilon) * (1 + epsilon);
    if (!(q > 0)) throw std::domain_error("no film at the wall and beyond");
    const PolarRatio<R> f = LibraryFilm<Law>::ratio(epsilon, q, R(-2 * p.slip), R(sign * p.b), {side, 1});
    return {R(sign * scale_ * f[0]), R(scale_ * f[1])};
  }

  /// Film forces on a = 0.
  struct Slide {
    R radial;
    R needed;  ///< tangential force that keeps a = 0
    R reach;   ///< X
  };

  Slide slide(Place p) const {
    p.slip = R(0);
    const std::array<R, 2> f = film(p, 1);
    const Vector2<R> t = perpendicular(p.r);
    const auto leaving = [&](const R& tangential) {
      const Push push =
          pushed(p, Vector2<R>(R(f[0] * p.r.x() + tangential * t.x()), R(f[0] * p.r.y() + tangential * t.y())));
      return R(dot(t, relative_acceleration(p, push)) / c_ - p.turn * dot(p.r, p.v) -
               push.rod_acceleration / 2 * p.rho);
    };
    const R free = leaving(R(0));
    const R unit = scale_ * speed_;
    return {f[0], R(-free * unit / (leaving(unit) - free)), f[1]};
  }

  Vector2<R> film_on(const Place& p) const {
    std::array<R, 2> f;
    if (side_ == JumpSide::sliding) {
      const Slide s = slide(p);
      f = {s.radial, s.needed};
    } else {
      f = film(p, side_ == JumpSide::converging ? 1 : -1);
    }
    return {R(f[0] * p.r.x() - f[1] * p.r.y()), R(f[0] * p.r.y() + f[1] * p.r.x())};
  }

  /// Positive while the side lasts; at most 1.
  R margin(const R& t, const State& y) const {
    using std::abs;
    const Place p = place(t, y);
    if (side_ == JumpSide::sliding) {
      const Slide s = slide(p);
      const R size = abs(s.reach) + abs(s.needed);
      return size > 0 ? R((s.reach - abs(s.needed)) / size) : R(0);
    }
    const R size = abs(p.slip) + abs(p.b);
    if (!(size > 0)) return R(0);
    return (side_ == JumpSide::converging ? R(-p.slip) : p.slip) / size;
  }

  /// Filippov's rule at a = 0, at (t, y), with the ray r.
  void choose_side(const R& t, const State& y, const Vector2<R>& r) {
    using std::abs;
    side_ = JumpSide::converging;
    Place p = place(t, y);
    p.r = r;
    p.rho = dot(r, p.e);
    p.b = dot(r, Vector2<R>(R(p.v.x() + p.turn / 2 * p.e.y()), R(p.v.y() - p.turn / 2 * p.e.x())));
    const Slide s = slide(p);
    if (s.reach > 0 && abs(s.needed) <= s.reach) {
      side_ = JumpSide::sliding;
      ray_ = r;
      ray_angle_ = (p.ideal.rod.value + c_ / m_.rod_length * y[0]) / 2;
    } else {
      side_ = s.needed > 0 ? JumpSide::converging : JumpSide::mirrored;
    }
  }

  /// At rest with centres coincident: looked at a moment later, along the acceleration.
  void start(const State& y) {
    using std::sqrt;
    const Place p = place(R(0), y);
    const Vector2<R> away = relative_acceleration(p, pushed(p, Vector2<R>(R(0), R(0))));
    const R moment = R(1e-6) / sqrt(R(norm(away) / c_));
    State dydt;
    rate(R(0), y, dydt);
    State later = y;
    for (std::size_t i = 0; i < 2; ++i) {
      later[i] += moment * moment / 2 * speed_ * dydt[2 + i];
      later[2 + i] += moment * dydt[2 + i];
    }
    const Vector2<R> r = away / norm(away);
    choose_side(moment, later, r);
    ray_angle_ = p.ideal.rod.value / 2;
  }

  void integrate(const std::vector<R>& times, PinRun<R>& run) {
    State y{};
    R t(0);
    start(y);
    run.changes.push_back({t, side_});
    R dt = R(1e-7) / speed_;
    // A side begins with a margin of 0 but for errors of the integration, from which it may part slowly: it is watched
    // once it is seen to be above them.
    bool watched = false;
    for (std::size_t next = 0; next < times.size();) {
      if (!(t < times[next])) {
        const Place p = place(t, y);
        run.samples.push_back({t, p.e, p.v, film_on(p), side_});
        ++next;
        continue;
      }
      const Place p = place(t, y);
      room_ = 1 - norm_or_zero(p.e);
      const R wanted = dt;
      const bool last = t + dt * R(1.01) >= times[next];
      if (last) dt = times[next] - t;
      const R t_old = t;
      const State y_old = y;
      const R tried = dt;
      const R made = method_.step(*this, t, y, dt);
      t = last && made == tried ? times[next] : R(t + made);
      if (last && made == tried) dt = std::max<R>(dt, wanted);
      if (!watched) {
        const R parted = margin(t, y);
        watched = parted > above_errors;
        if (parted < -wrong_side) {
          throw std::runtime_error("a side of the film ends as it begins");
        }
        continue;
      }
      const std::optional<R> event = crossing(t_old, y_old, t, y);
      if (!event) continue;
      t = *event;
      y = reached(t_old, y_old, t);
      const JumpSide before = side_;
      const Place at = place(t, y);
      if (before == JumpSide::sliding) {
        side_ = slide(at).needed > 0 ? JumpSide::converging : JumpSide::mirrored;
      } else {
        choose_side(t, y, at.r);
      }
      if (side_ != before) run.changes.push_back({t, side_});
      dt = std::max<R>(R(1e-3) * (t - t_old), R(1e-9) / speed_);
      watched = false;
    }
  }

  // Margins above errors of the integration, and far above them.
  static constexpr double above_errors = 1e-8;
  static constexpr double wrong_side = 1e-3;

  static R norm_or_zero(const Vector2<R>& v) { return is_zero(v) ? R(0) : norm(v); }

  State reached(const R& t0, const State& y0, const R& t1) {
    State y = y0;
    if (t1 > t0) method_.reach(*this, t0, y, t1);
    return y;
  }

  /// Where the margin is first crossed in a step, looked for inside it as well.
  std::optional<R> crossing(const R& t0, const State& y0, const R& t1, const State& y1) {
    const auto value = [&](const R& t) { return t < t1 ? margin(t, reached(t0, y0, t)) : margin(t1, y1); };
    constexpr int looks = 4;
    R low = t0;
    for (int i = 1; i <= looks; ++i) {
      R high = i == looks ? t1 : R(t0 + (t1 - t0) * i / looks);
      if (!(value(high) < 0)) {
        low = high;
        continue;
      }
      for (int k = 0; k < 60; ++k) {
        const R middle = (low + high) / 2;
        if (!(middle > low && middle < high)) break;
        (value(middle) < 0 ? high : low) = middle;
      }
      return high;
    }
    return std::nullopt;
  }

  SliderCrank<R> m_;
  R speed_;
  R c_;
  R scale_;
  Lobatto<R, 4> method_;
  JumpSide side_ = JumpSide::converging;
  Vector2<R> ray_{R(1), R(0)};
  R ray_angle_{0};  ///< half the rod's angle where the ray was ray_
  R room_{1};       ///< 1 − ε at the step's start
};

}  // namespace lubjoint::mechanisms
