/// A journal in a bearing on the ground, in the frame that turns with the mean spin: an own derivation of its equations
/// of motion with film, contact with the wall, and sliding of half films. It shares the film laws with the library (one
/// of them is written out again), and nothing else.
///
/// With ê = e/c as a complex number and Θ the angle through which the mean spin ω̄ = ½ω_J has turned, ê = z e^{iΘ}. In
/// that frame the wedge vanishes, u = ż is the pure-squeeze velocity, and
///   z̈ = (F(z, ż) + W e^{−iΘ})/(mc) − 2iω̄ż − iω̄˙z + ω̄²z.
/// A half film that slides has a = 0, that is z × ż = 0: z stays on a fixed ray n, z = ρn with
///   ρ̈ = (F_r + W·n)/(mc) + ω̄²ρ,   and the tangential force   F_t = mc(2ω̄ρ̇ + ω̄˙ρ) − W·n⊥.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/mechanisms/free_journal_case.hpp"
#include "oracle/mechanisms/journal_films.hpp"
#include "oracle/mechanisms/lobatto.hpp"

namespace lubjoint::mechanisms {

/// A free journal with the film F (journal_films.hpp).
template <class Film, class R>
class FreeJournalMotion {
 public:
  using State = ShortState<R, 6>;

  /// @param tolerance  of a step: of the gap to the film's wall, and of the velocity
  FreeJournalMotion(const FreeJournalCase<R>& journal, const R& tolerance) : c_(journal), method_(tolerance) {
    using std::abs;
    using std::sqrt;
    const R film_clearance = c_.wall ? R(c_.clearance + c_.wall->widening) : c_.clearance;
    const R across = Film::is_short ? c_.length : c_.journal_radius;
    scale_ = c_.viscosity * c_.length * c_.journal_radius * (across / film_clearance) * (across / film_clearance);
    in_film_ = c_.clearance / film_clearance;
    inertia_ = c_.mass * c_.clearance;
    free_spin_ = c_.inertia > 0;
    const R w = hypot(c_.load[0], c_.load[1]);
    // The journal's own rate: what it starts with, its spin, and what the load makes of it in so much film.
    rate_ = hypot(c_.velocity[0], c_.velocity[1]) + abs(c_.spin) + std::min<R>(sqrt(R(w / inertia_)), R(w / scale_));
    if (rate_ == 0) rate_ = 1;
  }

  /// To each of the times, which increase from 0.
  /// @param max_steps  where it gives up, and says so
  FreeJournalRun<R> run(const std::vector<R>& times, std::size_t max_steps = 200000) {
    FreeJournalRun<R> run;
    try {
      integrate(times, max_steps, run);
    } catch (const IntegrationError& error) {
      run.stopped = error.what();
    } catch (const std::domain_error& error) {
      run.stopped = error.what();
    }
    run.steps = method_.steps();
    return run;
  }

 private:
  using Where = JournalPiece::Where;
  using Pair = std::array<R, 2>;

  static R hypot(const R& x, const R& y) {
    using std::abs;
    using std::sqrt;
    const R size = std::max<R>(abs(x), abs(y));
    if (size == 0) return size;
    return size * sqrt(R((x / size) * (x / size) + (y / size) * (y / size)));
  }

  /// Polar state of the journal: where it is along r, and how fast.
  struct Polar {
    R rho;  ///< |z|
    Pair r;
    R b;     ///< u·r
    R turn;  ///< u·t
  };

  static Polar polar(const State& y) {
    Polar p{hypot(y[0], y[1]), {R(1), R(0)}, R(0), R(0)};
    if (p.rho > 0) {
      p.r = {y[0] / p.rho, y[1] / p.rho};
    } else {
      const R speed = hypot(y[2], y[3]);
      if (speed > 0) p.r = {y[2] / speed, y[3] / speed};
    }
    p.b = y[2] * p.r[0] + y[3] * p.r[1];
    p.turn = p.rho > 0 ? R(y[3] * p.r[0] - y[2] * p.r[1]) : R(0);
    return p;
  }

  /// Spin, its rate by friction left out, and Θ.
  R spin(const R& t, const State& y, std::size_t at) const {
    return free_spin_ ? y[at + 1] : R(c_.spin + c_.spin_acceleration * t);
  }
  R angle(const R& t, const State& y, std::size_t at) const {
    return free_spin_ ? y[at] : R(t * (c_.spin + c_.spin_acceleration * t / 2) / 2);
  }

  struct Contact {
    R radial = R(0);      ///< [N]
    R tangential = R(0);  ///< [N]
    R couple = R(0);      ///< on the journal's body [N m]
  };

  /// Lankarani and Nikravesh, with friction at the wall, in the piece's terms.
  Contact contact(const R& rho, const R& b, const R& turn, const R& spin) const {
    using std::sqrt;
    const BearingWall<R>& w = *c_.wall;
    const R depth = c_.clearance * (rho - 1);
    if (!(depth > 0)) return {};
    const R loss = R(3) / 4 * (1 - w.restitution * w.restitution) / impact_speed_;
    const R normal = w.stiffness * depth * sqrt(depth) * (1 + loss * c_.clearance * b);
    Contact f;
    f.radial = -normal;
    if (w.friction > 0) {
      // In the inertial frame the journal's centre moves across with c(u_t + ω̄ρ), its surface ω_J R_J more.
      const R slip = c_.clearance * (turn + spin / 2 * rho) + spin * c_.journal_radius;
      f.tangential = -w.friction * normal * slip / sqrt(R(slip * slip + w.slow_sliding * w.slow_sliding));
      f.couple = c_.journal_radius * f.tangential;
    }
    return f;
  }

  /// F_r, F_t of the film alone [N], at ê = ρ.
  Pair film(const R& rho, const R& b, const R& turn, const FilmBranch& branch) const {
    const R epsilon = rho * in_film_;
    const R q = (1 - epsilon) * (1 + epsilon);
    if (!(q > 0)) throw std::domain_error("no film at the wall and beyond");
    // The rates are those of the film's own clearance.
    const PolarRatio<R> f = Film::ratio(epsilon, q, R(-2 * turn * in_film_), R(b * in_film_), branch);
    return {scale_ * f[0], scale_ * f[1]};
  }

  /// Share of the contact, 0 in the film and 1 beyond the blend.
  R contact_share(const R& rho) const {
    if (piece_.where == Where::film) return R(0);
    if (piece_.where == Where::dry) return R(1);
    return c_.clearance * (rho - 1) / c_.wall->blend;
  }

  struct Force {
    R radial;
    R tangential;
    R couple;
  };

  /// Film and contact at a state of the plane.
  Force force(const Polar& p, const R& spin) const {
    const R share = contact_share(p.rho);
    Force f{R(0), R(0), R(0)};
    if (piece_.where != Where::dry) {
      const Pair own = film(p.rho, p.b, p.turn, piece_.film);
      f.radial = (1 - share) * own[0];
      f.tangential = (1 - share) * own[1];
    }
    if (piece_.where != Where::film && piece_.touches) {
      const Contact wall = contact(p.rho, p.b, p.turn, spin);
      f.radial += share * wall.radial;
      f.tangential += share * wall.tangential;
      f.couple += share * wall.couple;
    }
    return f;
  }

  /// Load in the turning frame.
  Pair turned_load(const R& theta) const {
    using std::cos;
    using std::sin;
    const R cs = cos(theta);
    const R sn = sin(theta);
    return {c_.load[0] * cs + c_.load[1] * sn, c_.load[1] * cs - c_.load[0] * sn};
  }

  R spin_rate(const R& couple) const { return free_spin_ ? R(couple / c_.inertia) : c_.spin_acceleration; }

  // Sliding: states ρ, ρ̇ on the ray n, and Θ, ω if friction turns the journal.

  struct Sliding {
    Polar p;
    R sign;        ///< −1 where ρ < 0: beyond the centre
    R radial;      ///< along n [N]
    R needed;      ///< film's own tangential force that keeps a = 0, along n⊥ [N]
    R reach;       ///< what it has at most
    R tangential;  ///< of all [N]
    R couple;
  };

  Sliding sliding(const R& t, const State& y) const {
    using std::abs;
    Sliding s;
    s.sign = y[0] < 0 ? R(-1) : R(1);
    const R rho = abs(y[0]);
    const R b = s.sign * y[1];
    const R omega = spin(t, y, 2);
    const Pair w = turned_load(angle(t, y, 2));
    const R share = contact_share(rho);
    Contact wall;
    if (piece_.where != Where::film && piece_.touches) wall = contact(rho, b, R(0), omega);
    const FilmBranch converging{1, piece_.film.squeeze};
    const Pair own = film(rho, b, R(0), converging);
    s.couple = share * wall.couple;
    s.radial = s.sign * ((1 - share) * own[0] + share * wall.radial);
    s.tangential = inertia_ * (omega * y[1] + spin_rate(s.couple) / 2 * y[0]) - (w[1] * ray_[0] - w[0] * ray_[1]);
    s.needed = s.tangential - s.sign * share * wall.tangential;
    s.reach = (1 - share) * own[1];
    return s;
  }

 public:
  // What the integrator asks for.

  std::size_t states() const { return (piece_.slides ? 2 : 4) + (free_spin_ ? 2 : 0); }

  void rate(const R& t, const State& y, State& dydt) const {
    if (piece_.slides) {
      const Sliding s = sliding(t, y);
      const R mean = spin(t, y, 2) / 2;
      const Pair w = turned_load(angle(t, y, 2));
      dydt[0] = y[1];
      dydt[1] = (s.radial + w[0] * ray_[0] + w[1] * ray_[1]) / inertia_ + mean * mean * y[0];
      if (free_spin_) {
        dydt[2] = mean;
        dydt[3] = spin_rate(s.couple);
      }
      return;
    }
    const R omega = spin(t, y, 4);
    const R mean = omega / 2;
    const Polar p = polar(y);
    const Force f = force(p, omega);
    const Pair w = turned_load(angle(t, y, 4));
    const R turning = spin_rate(f.couple) / 2;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (f.radial * p.r[0] - f.tangential * p.r[1] + w[0]) / inertia_ + omega * y[3] + turning * y[1] +
              mean * mean * y[0];
    dydt[3] = (f.radial * p.r[1] + f.tangential * p.r[0] + w[1]) / inertia_ - omega * y[2] - turning * y[0] +
              mean * mean * y[1];
    if (free_spin_) {
      dydt[4] = mean;
      dydt[5] = spin_rate(f.couple);
    }
  }

  void weights(const State& y, State& w) const {
    using std::abs;
    const bool line = piece_.slides;
    const R rho = line ? R(abs(y[0])) : hypot(y[0], y[1]);
    const R speed = line ? R(abs(y[1])) : hypot(y[2], y[3]);
    const R room = room_at(rho);
    const std::size_t half = line ? 1 : 2;
    for (std::size_t i = 0; i < half; ++i) {
      w[i] = room;
      w[half + i] = speed + rate_ * room;
    }
    if (free_spin_) {
      w[2 * half] = 1;
      w[2 * half + 1] = rate_;
    }
  }

  void increments(const State& y, State& d) const {
    using std::sqrt;
    weights(y, d);
    const R fine = sqrt(std::numeric_limits<R>::epsilon());
    for (std::size_t i = 0; i < states(); ++i) d[i] *= fine;
  }

 private:
  /// What the journal's place is measured by: its gap; in contact, a part of the blend.
  R room_at(const R& rho) const {
    const R least = c_.wall ? R(c_.wall->blend / c_.clearance) : R(0);
    return std::max<R>(least, std::min<R>(R(1), R(1 - rho)));
  }

  // Margins: positive while the piece lasts.

  enum class Event { inwards, outwards, slip, squeeze, pull };
  struct Margin {
    Event event;
    R value;
  };

  std::vector<Margin> margins(const R& t, const State& y) const {
    std::vector<Margin> all;
    using std::abs;
    const Polar p = piece_.slides ? Polar{R(abs(y[0])), ray_, y[0] < 0 ? R(-y[1]) : y[1], R(0)} : polar(y);
    if (c_.wall) {
      const R over = p.rho - 1;
      const R width = c_.wall->blend / c_.clearance;
      if (piece_.where == Where::film) all.push_back({Event::outwards, R(-over)});
      if (piece_.where == Where::blend) {
        all.push_back({Event::inwards, over});
        all.push_back({Event::outwards, R(width - over)});
      }
      if (piece_.where == Where::dry) all.push_back({Event::inwards, R(over - width)});
      if (piece_.where != Where::film) {
        const R loss = R(3) / 4 * (1 - c_.wall->restitution * c_.wall->restitution) / impact_speed_;
        const R push = 1 + loss * c_.clearance * p.b;
        all.push_back({Event::pull, piece_.touches ? push : R(-push)});
      }
    }
    if (piece_.where == Where::dry) return all;
    if (piece_.slides) {
      const Sliding s = sliding(t, y);
      all.push_back({Event::slip, R(s.reach - abs(s.needed))});
    } else if (Film::jumps) {
      all.push_back({Event::slip, R(-piece_.film.side * p.turn * p.rho)});
    }
    if (Film::kinks) all.push_back({Event::squeeze, R(piece_.film.squeeze * p.b * p.rho)});
    return all;
  }

  /// Plane state of a sliding one.
  State in_plane(const State& y) const {
    State plane{};
    plane[0] = y[0] * ray_[0];
    plane[1] = y[0] * ray_[1];
    plane[2] = y[1] * ray_[0];
    plane[3] = y[1] * ray_[1];
    plane[4] = y[2];
    plane[5] = y[3];
    return plane;
  }

  /// Puts the journal on the ray through a plane state, whose a is 0.
  State on_ray(const State& plane) {
    const Polar p = polar(plane);
    ray_ = p.r;
    State line{};
    line[0] = p.rho;
    line[1] = p.b;
    line[2] = plane[4];
    line[3] = plane[5];
    return line;
  }

  /// A half film at a = 0: does it slide, and if not, on which side does it go on?
  void choose_side(const R& t, const State& plane) {
    const State line = on_ray(plane);
    piece_.slides = true;
    const Sliding s = sliding(t, line);
    if (s.reach >= 0 && s.needed <= s.reach && -s.needed <= s.reach) return;
    piece_.slides = false;
    piece_.film.side = s.needed > 0 ? 1 : -1;  // u_t˙ = (F_t − needed)/mc, a = −2u_t
  }

  void start(State& y) {
    using std::abs;
    const R mean = c_.spin / 2;
    State plane{};
    plane[0] = c_.eccentricity[0];
    plane[1] = c_.eccentricity[1];
    plane[2] = c_.velocity[0] + mean * plane[1];
    plane[3] = c_.velocity[1] - mean * plane[0];
    plane[5] = c_.spin;
    piece_ = {};
    if (c_.wall) {
      impact_speed_ = c_.wall->min_impact_speed;
      const R over = hypot(plane[0], plane[1]) - 1;
      if (over > 0) piece_.where = over > c_.wall->blend / c_.clearance ? Where::dry : Where::blend;
    }
    y = plane;
    enter(R(0), y);
  }

  /// The branches of the film and of the contact at a plane state; where a, b or the push are 0 those an instant later.
  void enter(const R& t, State& y) {
    const Polar p = polar(y);
    piece_.slides = false;
    if (piece_.where != Where::film) {
      const R loss = R(3) / 4 * (1 - c_.wall->restitution * c_.wall->restitution) / impact_speed_;
      piece_.touches = 1 + loss * c_.clearance * p.b > 0;
    }
    State later = y;
    if (p.rho == 0 || p.b == 0 || p.turn == 0) {
      // With no film yet: what the load and the frame do in so short a time that the film's force is nothing.
      const R moment = R(1e-12) / (rate_ + scale_ / inertia_);
      const Pair w = turned_load(angle(t, y, 4));
      const R omega = spin(t, y, 4);
      const Pair push = {w[0] / inertia_ + omega * y[3], w[1] / inertia_ - omega * y[2]};
      for (std::size_t i = 0; i < 2; ++i) {
        later[i] += moment * (y[2 + i] + moment * push[i] / 2);
        later[2 + i] += moment * push[i];
      }
      const Polar soon = polar(later);
      if (p.b == 0 || p.rho == 0) piece_.film.squeeze = soon.b < 0 ? -1 : 1;
      if (p.b != 0 && p.rho != 0) piece_.film.squeeze = p.b < 0 ? -1 : 1;
    } else {
      piece_.film.squeeze = p.b < 0 ? -1 : 1;
    }
    if (!Film::jumps || piece_.where == Where::dry) return;
    if (p.turn != 0) {
      piece_.film.side = p.turn > 0 ? -1 : 1;
      return;
    }
    State at = later;
    if (p.rho > 0) {
      at[0] = y[0];
      at[1] = y[1];
      // On the ray: the tangential part of the later velocity is what is to be decided.
      const R b = later[2] * p.r[0] + later[3] * p.r[1];
      at[2] = b * p.r[0];
      at[3] = b * p.r[1];
    }
    if (at[0] == 0 && at[1] == 0) return;  // rests at the centre
    choose_side(t, at);
    if (piece_.slides && p.rho == 0) {
      y[0] = 0;  // ray_ has the direction
      y[1] = y[2] * ray_[0] + y[3] * ray_[1];
      y[2] = y[4];
      y[3] = y[5];
    } else if (piece_.slides) {
      y = on_ray(y);
    }
  }

  FreeJournalSample<R> sample(const R& t, const State& y) const {
    using std::cos;
    using std::sin;
    const std::size_t at = piece_.slides ? 2 : 4;
    const R theta = angle(t, y, at);
    const R omega = spin(t, y, at);
    const State plane = piece_.slides ? in_plane(y) : y;
    Pair f;
    if (piece_.slides) {
      const Sliding s = sliding(t, y);
      f = {s.radial * ray_[0] - s.tangential * ray_[1], s.radial * ray_[1] + s.tangential * ray_[0]};
    } else {
      const Polar p = polar(y);
      const Force all = force(p, omega);
      f = {all.radial * p.r[0] - all.tangential * p.r[1], all.radial * p.r[1] + all.tangential * p.r[0]};
    }
    const R cs = cos(theta);
    const R sn = sin(theta);
    const auto turned = [&](const R& x, const R& z) { return Pair{x * cs - z * sn, x * sn + z * cs}; };
    FreeJournalSample<R> s;
    s.t = t;
    s.eccentricity = turned(plane[0], plane[1]);
    // ė = (ż + iω̄z) e^{iΘ}
    s.velocity = turned(R(plane[2] - omega / 2 * plane[1]), R(plane[3] + omega / 2 * plane[0]));
    s.force = turned(f[0], f[1]);
    s.spin = omega;
    s.piece = piece_;
    return s;
  }

  /// What follows an event at (t, y).
  void change(const R& t, State& y, Event event) {
    using std::max;
    if (event == Event::slip && piece_.slides) {
      const Sliding s = sliding(t, y);
      y = in_plane(y);
      piece_.slides = false;
      piece_.film.side = s.needed > 0 ? 1 : -1;
      return;
    }
    if (event == Event::slip) {
      // On a = 0 to the last digit.
      const Polar p = polar(y);
      y[2] = p.b * p.r[0];
      y[3] = p.b * p.r[1];
      choose_side(t, y);
      if (piece_.slides) y = on_ray(y);
      return;
    }
    if (event == Event::squeeze) {
      piece_.film.squeeze = -piece_.film.squeeze;
      return;
    }
    if (event == Event::pull) {
      piece_.touches = !piece_.touches;
      return;
    }
    const bool slid = piece_.slides;
    const State plane = slid ? in_plane(y) : y;
    const Polar p = polar(plane);
    if (piece_.where == Where::film) {
      impact_speed_ = max(R(c_.clearance * p.b), c_.wall->min_impact_speed);
      piece_.where = Where::blend;
      piece_.touches = true;
    } else if (piece_.where == Where::dry) {
      piece_.where = Where::blend;
      piece_.film.squeeze = p.b < 0 ? -1 : 1;
      piece_.film.side = p.turn > 0 ? -1 : 1;
    } else if (event == Event::inwards) {
      piece_.where = Where::film;
      piece_.touches = true;
    } else {
      piece_.where = Where::dry;
      if (slid) y = plane;
      piece_.slides = false;
    }
  }

  State hermite(const State& y0, const State& f0, const State& y1, const State& f1, const R& h, const R& s) const {
    const R r = 1 - s;
    State y{};
    for (std::size_t i = 0; i < states(); ++i) {
      y[i] = r * r * (1 + 2 * s) * y0[i] + s * s * (1 + 2 * r) * y1[i] + s * r * h * (r * f0[i] - s * f1[i]);
    }
    return y;
  }

  State reached(const R& t0, const State& y0, const R& t1) {
    State y = y0;
    if (t1 > t0) method_.reach(*this, t0, y, t1);
    return y;
  }

  struct Found {
    std::size_t index;
    R lower;
    R upper;
  };

  /// The first margin that a step crosses. Between its ends the cubic through them says where to look, the method
  /// itself whether it is so.
  std::optional<Found> crossing(const R& t0, const State& y0, const R& t1, const State& y1,
                                const std::vector<Margin>& first) {
    const std::vector<Margin> end = margins(t1, y1);
    State f0{};
    State f1{};
    rate(t0, y0, f0);
    rate(t1, y1, f1);
    constexpr int looks = 8;
    R before = t0;
    for (int i = 1; i <= looks; ++i) {
      const R s = R(i) / looks;
      const R t = i == looks ? t1 : R(t0 + s * (t1 - t0));
      std::vector<Margin> now = end;
      if (i < looks) {
        bool suspicious = false;
        try {
          now = margins(t, hermite(y0, f0, y1, f1, R(t1 - t0), s));
          for (std::size_t k = 0; k < now.size(); ++k) {
            if (now[k].value < std::min<R>(first[k].value, end[k].value) / 4) suspicious = true;
          }
        } catch (const std::domain_error&) {
          suspicious = true;
        }
        if (!suspicious) continue;
        now = margins(t, reached(t0, y0, t));
      }
      std::optional<Found> found;
      for (std::size_t k = 0; k < now.size(); ++k) {
        if (now[k].value < 0 && !found) found = Found{k, before, t};
      }
      if (found) return found;
      before = t;
    }
    return std::nullopt;
  }

  /// The time of a crossing, by Illinois' false position; with several margins, of the one that is crossed first.
  R locate(const R& t0, const State& y0, Found& found) {
    using std::abs;
    const auto least = [&](const R& t, std::size_t& index) {
      const std::vector<Margin> m = t > t0 ? margins(t, reached(t0, y0, t)) : margins(t0, y0);
      for (std::size_t k = 0; k < m.size(); ++k) {
        if (k != index && m[k].value < 0 && m[index].value >= 0) index = k;
      }
      return m[index].value;
    };
    R lower = found.lower;
    R upper = found.upper;
    R f_lower = least(lower, found.index);
    R f_upper = least(upper, found.index);
    if (f_lower <= 0) return lower;
    const R close = 8 * std::numeric_limits<R>::epsilon();
    for (int i = 0; i < 300 && upper - lower > close * (upper + lower); ++i) {
      R middle = upper - f_upper * (upper - lower) / (f_upper - f_lower);
      if (i % 4 == 3 || !(middle > lower && middle < upper)) middle = (lower + upper) / 2;
      if (!(middle > lower && middle < upper)) break;
      const std::size_t index_before = found.index;
      const R f = least(middle, found.index);
      if (found.index != index_before) {  // another one comes first
        upper = middle;
        f_upper = f;
        f_lower = least(lower, found.index);
        if (f_lower <= 0) return lower;
        continue;
      }
      if (f > 0) {
        lower = middle;
        f_lower = f;
        f_upper /= 2;
      } else {
        upper = middle;
        f_upper = f;
        f_lower /= 2;
        if (f == 0) break;
      }
    }
    return upper;
  }

  void integrate(const std::vector<R>& times, std::size_t max_steps, FreeJournalRun<R>& run) {
    State y{};
    R t = 0;
    start(y);
    run.changes.push_back({t, piece_});
    R dt = R(1e-6) / rate_;
    std::size_t next = 0;
    int at_once = 0;
    bool settling = false;  // a step over the event just passed, which its margin does not see
    while (next < times.size()) {
      if (!(t < times[next])) {
        run.samples.push_back(sample(t, y));
        ++next;
        continue;
      }
      if (method_.steps() > max_steps) {
        run.stopped = "more steps than allowed";
        return;
      }
      const R goal = times[next];
      const R wanted = dt;
      const bool last = t + dt * R(1.01) >= goal;
      if (last) dt = goal - t;
      const R t_old = t;
      const State y_old = y;
      const std::vector<Margin> first = margins(t, y);
      const R tried = dt;
      const R made = method_.step(*this, t, y, dt);
      if (last && made == tried) {
        t = goal;
        dt = std::max<R>(dt, wanted);
      } else {
        t += made;
      }
      if (settling) {
        settling = false;
        if (piece_.slides) run.sliding_time += t - t_old;
        continue;
      }
      if (std::optional<Found> found = crossing(t_old, y_old, t, y, first)) {
        t = locate(t_old, y_old, *found);
        y = reached(t_old, y_old, t);
        if (piece_.slides) run.sliding_time += t - t_old;
        at_once = t > t_old ? 0 : at_once + 1;
        if (at_once > 10) {
          run.stopped = "can't leave an event";
          return;
        }
        change(t, y, first[found->index].event);
        run.changes.push_back({t, piece_});
        // One short step first: the margin just crossed is 0 here, to rounding.
        dt = std::max<R>(R(1e-6) * (t - t_old), R(1e-9) * tried);
        settling = true;
        continue;
      }
      if (piece_.slides) run.sliding_time += t - t_old;
    }
  }

  FreeJournalCase<R> c_;
  Lobatto<R, 6> method_;
  R scale_;
  R in_film_;  ///< c over the film's clearance
  R inertia_;  ///< mc
  R rate_;
  bool free_spin_;
  JournalPiece piece_;
  Pair ray_ = {R(1), R(0)};
  R impact_speed_ = R(1);
};

/// A journal's motion at the times asked for, with the law of that film.
template <class Film, class R>
FreeJournalRun<R> free_journal_run(const FreeJournalCase<R>& journal, const std::vector<R>& times, const R& tolerance,
                                   std::size_t max_steps = 200000) {
  return FreeJournalMotion<Film, R>(journal, tolerance).run(times, max_steps);
}

}  // namespace lubjoint::mechanisms
