/// A free journal's reference trajectory by one integrator, from mode to mode of a half film.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/trajectories/journal_methods.hpp"
#include "oracle/trajectories/journal_motion.hpp"

namespace lubjoint::reports::journal_reference {

/// One integrator's pass over all output times, through all modes.
template <template <class> class Method>
class Pass {
 public:
  struct Sample {
    State<4> state;
    std::array<Real, 2> force;
  };
  struct Change {
    Real t;
    std::string mode;
  };

  Pass(const Journal& journal, const std::vector<double>& times, const Real& tolerance)
      : journal_(journal), times_(times), tolerance_(tolerance) {
    y_.fill(Real(0));
    if (!journal.jumps()) {
      run_plane(0);
      return;
    }
    int mode = first_mode();
    while (next_ < times_.size()) {
      changes.push_back({t_, mode == 0 ? "sliding" : mode > 0 ? "converging" : "mirrored"});
      if (changes.size() > 50) throw std::runtime_error("reference trajectory: too many changes of mode");
      mode = mode == 0 ? run_line() : run_plane(mode);
    }
  }

  std::vector<Sample> samples;
  std::vector<Change> changes;

 private:
  static constexpr int slide = 0;

  /// Film on one side until a changes sign; returns the next mode.
  int run_plane(int side) {
    const PlaneMotion motion{journal_, side};
    Method<PlaneMotion> method(motion, tolerance_);
    // Pinkus–Sternlicht: the method begins anew where ε̇ = ê·u/ε changes sign.
    const auto squeeze = [&](const State<4>& y) { return Real(y[0] * y[2] + y[1] * y[3]); };
    const auto turning = [&](const State<4>& y) {
      return Real(y[0] * (y[3] - journal_.spin * y[0]) - y[1] * (y[2] + journal_.spin * y[1]));
    };
    Real dt = t_ == 0 ? Real(1e-9) : Real(1e-8);
    while (next_ < times_.size()) {
      const Real goal(times_[next_]);
      bool event = false;
      if (side != 0) {
        event = step_to_event(method, y_, t_, goal, dt,
                              [&](const State<4>& y, const Real&) { return Real(-side * turning(y)); });
        if (event) return decide(side);
      } else if (journal_.kinks()) {
        const int sign = squeeze(y_) < 0 ? -1 : 1;
        event = step_to_event(method, y_, t_, goal, dt,
                              [&](const State<4>& y, const Real&) { return Real(sign * squeeze(y)); });
        if (event) {
          nudge(method, dt);
          continue;
        }
      } else {
        step_to(method, y_, t_, goal, dt);
      }
      samples.push_back({y_, journal_.force(y_, side)});
      ++next_;
    }
    return side;
  }

  /// One short step over the zero of ε̇, so that its sign is the new one.
  template <class M>
  void nudge(M& method, Real& dt) {
    Real step = Real(1e-12);
    while (!method.try_step(y_, t_, step)) {
    }
    dt = std::max<Real>(dt, Real(1e-9));
  }

  /// Sliding on a = 0; returns the side that it leaves to.
  int run_line() {
    const bool centred = y_[0] == 0 && y_[1] == 0;
    const Real angle = centred ? atan2(journal_.load[1], journal_.load[0]) : atan2(y_[1], y_[0]);
    const LineMotion motion{journal_, t_, angle};
    Method<LineMotion> method(motion, tolerance_);
    const auto n = motion.line(t_);
    State<2> y = {y_[0] * n[0] + y_[1] * n[1], y_[2] * n[0] + y_[3] * n[1]};
    Real dt = t_ == 0 ? Real(1e-9) : Real(1e-8);
    while (next_ < times_.size()) {
      const Real goal(times_[next_]);
      const bool event = step_to_event(method, y, t_, goal, dt, [&](const State<2>& x, const Real& t) {
        return Real(motion.reach(x) - abs(motion.needed(x, t)));
      });
      y_ = motion.plane(y, t_);
      if (event) return motion.needed(y, t_) > 0 ? 1 : -1;
      samples.push_back({y_, motion.force(y, t_)});
      ++next_;
    }
    return slide;
  }

  /// At a = 0: slide if both sides push back, else go on to the other side.
  int decide(int side) const {
    const LineMotion motion{journal_, t_, atan2(y_[1], y_[0])};
    const auto n = motion.line(t_);
    const State<2> y = {y_[0] * n[0] + y_[1] * n[1], y_[2] * n[0] + y_[3] * n[1]};
    return abs(motion.needed(y, t_)) <= motion.reach(y) ? slide : -side;
  }

  /// From rest at the centre the journal falls along the load: after a moment τ, ρ = Wτ²/2mc and ρ̇ = Wτ/mc.
  int first_mode() const {
    const LineMotion motion{journal_, Real(0), atan2(journal_.load[1], journal_.load[0])};
    const Real tau(1e-12);
    const Real size = sqrt(journal_.load[0] * journal_.load[0] + journal_.load[1] * journal_.load[1]);
    const Real speed = size / journal_.inertia * tau;
    const State<2> y = {speed * tau / 2, speed};
    if (abs(motion.needed(y, tau)) <= motion.reach(y)) return slide;
    return motion.needed(y, tau) > 0 ? 1 : -1;
  }

  const Journal& journal_;
  const std::vector<double>& times_;
  Real tolerance_;
  State<4> y_;
  Real t_ = 0;
  std::size_t next_ = 0;
};

}  // namespace lubjoint::reports::journal_reference
