/// A slider-crank with clearance in its gudgeon pin, from piece to piece of its motion: a film on one side or the
/// other of a half film's jump, and sliding on it. Minimal coordinates, as deviations from the ideal mechanism, so that
/// the eccentricity is no difference of lengths of the mechanism's size.
///
/// Crank pin A = r(cosθ, sinθ), θ = Ωt; rod of length l at φ, its end B = A + l(cosφ, sinφ); slider S = (x, 0), which
/// does not turn. With the ideal φᵢ and xᵢ (where B = S), δ = φ − φᵢ, φₘ = φᵢ + δ/2 and s = (2l/c) sin(δ/2),
///   (S − B)/c = ((x − xᵢ)/c + s sinφₘ, −s cosφₘ).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "oracle/measure/stress/reference_forces.hpp"
#include "oracle/measure/stress/reference_methods.hpp"
#include "oracle/mechanisms/slider_crank.hpp"

namespace lubjoint::reports::stress_reference {

/// A slider-crank in a scene's own numbers.
template <class R>
struct CrankNumbers {
  mechanisms::SliderCrank<R> mechanism;
  R speed;              ///< Ω [rad/s]
  R clearance;          ///< [m]
  bool bearing_on_rod;  ///< and the journal on the slider; else the other way round
};

/// Geometry and inertia: what moves under whatever force acts in the pin.
/// States: y = (lδ/c, (x − xᵢ)/c) and their rates over Ω.
template <class R>
class CrankMechanics {
 public:
  using State = Eigen::Matrix<R, 4, 1>;

  explicit CrankMechanics(const CrankNumbers<R>& n) : n_(n) {
    const auto& m = n_.mechanism;
    rod_inertia_ = m.rod_inertia + m.rod_mass * m.rod_length * m.rod_length / 4;  // about A
    sign_ = n_.bearing_on_rod ? R(1) : R(-1);
  }

  /// The journal in its bearing, inertial, in clearances, and what its acceleration is made of.
  struct Instant {
    Pair<R> e;         ///< e/c
    Pair<R> velocity;  ///< its rate [1/s]
    Pair<R> u;         ///< that without the turning of the mean spin [1/s]
    R mean_spin;       ///< ½φ˙ [1/s]
    Pair<R> free;      ///< rates of y₂ and y₃ without a force [1/s]
    Pair<R> free_e;    ///< ë/c without a force [1/s²]
    R free_turning;    ///< φ¨ without a force [1/s²]
    R sine, cosine;    ///< of φ
    Pair<R> arm;       ///< from A to the journal [m]
  };

  Instant at(const R& t, const State& y) const {
    using std::cos;
    using std::sin;
    const auto& m = n_.mechanism;
    const R& l = m.rod_length;
    const R& c = n_.clearance;
    const R& w = n_.speed;
    const auto ideal = mechanisms::ideal_motion<R>(m, {R(w * t), w, R(0)});
    const R delta = c * y(0) / l;
    const R delta_rate = c * w * y(2) / l;
    const R phi = ideal.rod.value + delta;
    const R phi_rate = ideal.rod.rate + delta_rate;
    const R middle = ideal.rod.value + delta / 2;
    const R sm = sin(middle);
    const R cm = cos(middle);
    const R s = 2 * l / c * sin(R(delta / 2));
    const R s_rate = cos(R(delta / 2)) * w * y(2);
    Instant now;
    now.sine = sin(phi);
    now.cosine = cos(phi);
    // S − B and its rates.
    const Pair<R> gap(R(y(1) + s * sm), R(-s * cm));
    const Pair<R> gap_rate(R(w * y(3) + now.sine * w * y(2) + ideal.rod.rate * s * cm),
                           R(-now.cosine * w * y(2) + ideal.rod.rate * s * sm));
    now.e = sign_ * gap;
    now.velocity = sign_ * gap_rate;
    now.mean_spin = phi_rate / 2;
    now.u = now.velocity - now.mean_spin * turned(now.e);
    // Without a force: the rod turns about A, which accelerates, and the slider goes on.
    const R theta = w * t;
    const Pair<R> a = -w * w * m.crank_length * Pair<R>(R(cos(theta)), R(sin(theta)));
    now.free_turning = -m.rod_mass * l / 2 * (now.cosine * a.y() - now.sine * a.x()) / rod_inertia_;
    now.free = {R((now.free_turning - ideal.rod.acceleration) * l / (c * w)), R(-ideal.slider.acceleration / (c * w))};
    const R middle_rate = ideal.rod.rate + delta_rate / 2;
    const Pair<R> turning(R(now.cosine * phi_rate * w * y(2) + ideal.rod.acceleration * s * cm +
                            ideal.rod.rate * (s_rate * cm - s * sm * middle_rate)),
                          R(now.sine * phi_rate * w * y(2) + ideal.rod.acceleration * s * sm +
                            ideal.rod.rate * (s_rate * sm + s * cm * middle_rate)));
    now.free_e = sign_ * (turning + pin_acceleration(now, now.free));
    now.arm = l * Pair<R>(now.cosine, now.sine);
    if (n_.bearing_on_rod) now.arm += c * gap;
    return now;
  }

  /// What a force on the journal [N] adds to the rates of y₂ and y₃ [1/s]. It acts at the journal's centre, on the
  /// slider and opposite on the rod.
  Pair<R> response(const Instant& now, const Pair<R>& force) const {
    const R per = 1 / (n_.clearance * n_.speed);
    return {R(-sign_ * wedge<R>(now.arm, force) / rod_inertia_ * n_.mechanism.rod_length * per),
            R(sign_ * force.x() / n_.mechanism.slider_mass * per)};
  }

  /// Rate of e × u = 0 if this were all that accelerates: e × ë − ½φ¨|e|².
  R turning_of_response(const Instant& now, const Pair<R>& response) const {
    const R phi_acceleration = response.x() * n_.clearance * n_.speed / n_.mechanism.rod_length;
    return wedge<R>(now.e, Pair<R>(sign_ * pin_acceleration(now, response))) - phi_acceleration / 2 * now.e.dot(now.e);
  }

  /// d(e × u)/dt without a force: e × ë − 2ω̄ e·ė − ω̄˙|e|².
  R free_turning(const Instant& now) const {
    return wedge<R>(now.e, now.free_e) - 2 * now.mean_spin * now.e.dot(now.velocity) -
           now.free_turning / 2 * now.e.dot(now.e);
  }

  const CrankNumbers<R>& numbers() const { return n_; }

 private:
  /// Share of the deviations' accelerations in that of S − B, over c.
  Pair<R> pin_acceleration(const Instant& now, const Pair<R>& rates) const {
    return n_.speed * Pair<R>(R(rates.y() + now.sine * rates.x()), R(-now.cosine * rates.x()));
  }

  CrankNumbers<R> n_;
  R rod_inertia_;
  R sign_;
};

/// One piece of the motion, as the methods want it.
template <class R>
struct CrankPiece {
  using Scalar = R;
  static constexpr int size = 4;
  using State = Eigen::Matrix<R, 4, 1>;
  using Instant = typename CrankMechanics<R>::Instant;

  const CrankMechanics<R>& mechanics;
  const JournalForces<R>& forces;
  int side = 0;          ///< as PieceOf's
  bool sliding = false;  ///< on a half film's jump
  bool filled = true;    ///< is there a film?

  struct Force {
    Pair<R> on_journal;  ///< [N]
    R needed = R(0);     ///< sliding: of the film along r turned, to keep a = 0
    R reach = R(0);      ///< what it could give
  };

  Force force(const Instant& now) const {
    Force f{{R(0), R(0)}};
    if (!filled) return f;
    const R distance = now.e.norm();
    const R speed = now.u.norm();
    Pair<R> r(R(1), R(0));
    if (distance > 0) {
      r = now.e / distance;
    } else if (speed > 0) {
      r = now.u / speed;
    }
    const R gap = 1 - distance;
    if (!sliding) {
      const auto film = forces.film(gap, R(-2 * now.u.dot(turned(r))), R(now.u.dot(r)), side);
      f.on_journal = film[0] * r + film[1] * turned(r);
      return f;
    }
    const auto film = forces.film(gap, R(0), R(now.u.dot(r)), 1);
    const Pair<R> radial = film[0] * r;
    const R without = mechanics.free_turning(now) + mechanics.turning_of_response(now, mechanics.response(now, radial));
    const R unit = mechanics.turning_of_response(now, mechanics.response(now, turned(r)));
    f.needed = -without / unit;
    f.reach = film[1];
    f.on_journal = radial + f.needed * turned(r);
    return f;
  }

  State rate(const R& t, const State& y) const {
    const Instant now = mechanics.at(t, y);
    const Pair<R> rates = now.free + mechanics.response(now, force(now).on_journal);
    const R& w = mechanics.numbers().speed;
    return State(R(w * y(2)), R(w * y(3)), rates.x(), rates.y());
  }

  /// The gap, but not less than what rounding leaves of a step at the tolerances used here.
  State scale(const R& t, const State& y) const {
    const R gap = 1 - mechanics.at(t, y).e.norm();
    return State::Constant(std::min(R(1), std::max(gap, R(1) / 1000)));
  }

  static R noise() { return 1000 * std::numeric_limits<R>::epsilon(); }

  std::array<R, 1> margins(const R& t, const State& y) const {
    using std::abs;
    const Instant now = mechanics.at(t, y);
    if (sliding) {
      const Force f = force(now);
      const R sum = abs(f.reach) + abs(f.needed) + std::numeric_limits<R>::min();
      return {R((f.reach - abs(f.needed)) / sum)};
    }
    const R sizes = now.e.norm() * now.u.norm();
    if (!(sizes > 0)) return {R(0)};
    if (forces.jumps()) return {R(-side * wedge<R>(now.e, now.u) / sizes)};
    if (forces.kinks()) return {R(side * now.e.dot(now.u) / sizes)};
    return {R(1)};
  }
};

/// Where in its motion a slider-crank is.
template <class R>
struct CrankSituation {
  R t{};
  Eigen::Matrix<R, 4, 1> y = Eigen::Matrix<R, 4, 1>::Zero();
  int side = 0;
  bool sliding = false;
};

/// The slider-crank's motion by one of the methods.
template <class R, template <class> class Method>
class CrankMotionBy {
 public:
  using Situation = CrankSituation<R>;
  using State = Eigen::Matrix<R, 4, 1>;

  CrankMotionBy(const CrankMechanics<R>& mechanics, const JournalForces<R>& forces, const R& tolerance,
                const R& duration)
      : mechanics_(mechanics), forces_(forces), tolerance_(tolerance), step_(R(1e-9) * duration) {}

  /// From the ideal mechanism's state: e = 0 at rest. There inertia parts journal and bearing before any film acts, and
  /// their first ten thousandth of a radian says on which side the film is; or, of a law that jumps at e = 0 already,
  /// that it slides. A slide has a line of centres from its first instant on: the film is left out for 1e-10 rad.
  /// In these the line turns otherwise than a slide's; it stays 2e-11 rad off, a tenth of what it is after ten times the
  /// angle. A shorter start leaves the methods' first steps a line that is known less well.
  Situation start() const {
    Situation s;
    if (!forces_.sides()) return s;
    const Situation soon = dry(R(1e-4));
    const auto now = mechanics_.at(soon.t, soon.y);
    s.side = forces_.kinks() ? (now.e.dot(now.u) < 0 ? -1 : 1) : (wedge<R>(now.e, now.u) < 0 ? 1 : -1);
    if (!forces_.jumps()) return s;
    Situation held = dry(R(1e-10));
    held.side = -s.side;
    decide(held);
    return held.sliding ? held : s;
  }

  /// On to a time, through all pieces between.
  void to(Situation& s, const R& goal) {
    for (std::size_t pieces = 0; s.t < goal; ++pieces) {
      if (pieces > 5000) throw std::runtime_error("the reference has too many pieces");
      if (s.sliding) project(s);
      const CrankPiece<R> system = piece_of(s);
      Piece<CrankPiece<R>, Method> piece(system, tolerance_, step_);
      const PieceEnd end = piece.to(s.t, s.y, goal);
      step_ = piece.step();
      if (end.margin != 0) {
        if (system.margins(s.t, s.y)[0] < -1000 * system.noise()) {
          throw std::runtime_error("the reference is on the wrong side of a jump");
        }
        continue;
      }
      if (forces_.kinks()) {
        s.side = -s.side;
      } else if (s.sliding) {
        s.side = system.force(mechanics_.at(s.t, s.y)).needed > 0 ? 1 : -1;
        s.sliding = false;
      } else {
        decide(s);
      }
    }
  }

  /// Moved by a share of its scales in one of the states; on the side of the jump or kink where that leaves it.
  Situation moved(Situation s, int component, const R& share) const {
    s.y(component) += share * piece_of(s).scale(s.t, s.y)(component);
    if (s.sliding) return s;
    const auto now = mechanics_.at(s.t, s.y);
    if (forces_.jumps()) s.side = wedge<R>(now.e, now.u) < 0 ? 1 : -1;
    if (forces_.kinks()) s.side = now.e.dot(now.u) < 0 ? -1 : 1;
    return s;
  }

  /// ê and its rate.
  Eigen::Matrix<R, 4, 1> plane(const Situation& s) const {
    const auto now = mechanics_.at(s.t, s.y);
    Eigen::Matrix<R, 4, 1> p;
    p << now.e.x(), now.e.y(), now.velocity.x(), now.velocity.y();
    return p;
  }

  /// On the journal [N].
  Pair<R> force(Situation s) const {
    if (s.sliding) project(s);
    return piece_of(s).force(mechanics_.at(s.t, s.y)).on_journal;
  }

 private:
  /// Without a film, after so small an angle of the crank.
  Situation dry(const R& angle) const {
    Situation s;
    CrankPiece<R> system{mechanics_, forces_};
    system.filled = false;
    Piece<CrankPiece<R>, Method> piece(system, tolerance_, R(angle / mechanics_.numbers().speed / 1000));
    piece.to(s.t, s.y, R(angle / mechanics_.numbers().speed));
    return s;
  }

  CrankPiece<R> piece_of(const Situation& s) const { return {mechanics_, forces_, s.side, s.sliding}; }

  /// Onto a = 0, by an impulse across the line of centres.
  void project(Situation& s) const {
    for (int i = 0; i < 2; ++i) {  // e × u is linear in the rates
      const auto now = mechanics_.at(s.t, s.y);
      const Pair<R> across = mechanics_.response(now, turned(Pair<R>(now.e / now.e.norm())));
      const Pair<R> change = -wedge<R>(now.e, now.u) / mechanics_.turning_of_response(now, across) * across;
      s.y(2) += change.x();
      s.y(3) += change.y();
    }
  }

  /// On a = 0: sliding if a half film on either side pushes back by more than what the motion needs; else on to the
  /// other side.
  void decide(Situation& s) const {
    using std::abs;
    Situation held = s;
    held.sliding = true;
    project(held);
    const auto f = piece_of(held).force(mechanics_.at(held.t, held.y));
    if (f.reach > 0 && abs(f.needed) <= f.reach) {
      s = held;
    } else {
      s.side = -s.side;
    }
  }

  const CrankMechanics<R>& mechanics_;
  const JournalForces<R>& forces_;
  R tolerance_;
  R step_;
};

}  // namespace lubjoint::reports::stress_reference
