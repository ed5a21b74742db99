#include "oracle/reports/journal_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "lubjoint/dynamics/radau_iia5.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/published_forms.hpp"

namespace lubjoint::reports {

namespace {

namespace odeint = boost::numeric::odeint;
using Real = boost::multiprecision::float128;
template <std::size_t N>
using State = std::array<Real, N>;

/// All constants of a case, and the law.
class Journal {
 public:
  Journal(const std::string& law, const JournalCase& c) : law_(law) {
    const Real l(c.length);
    const Real r(c.journal_radius);
    const Real gap(c.clearance);
    const Real product = Real(c.viscosity) * l * r;
    scale = product * (law.starts_with("short") ? Real(l * l) : Real(r * r)) / (gap * gap);
    inertia = Real(c.mass) * gap;
    for (std::size_t i = 0; i < 2; ++i) load[i] = Real(c.load[i]) + Real(c.mass) * Real(c.gravity[i]);
    spin = Real(c.spin) / 2;
  }

  bool jumps() const { return law_.find("half") != std::string::npos; }
  /// Pinkus–Sternlicht is once differentiable where ε̇ changes sign: an integrator of high order must stop there.
  bool kinks() const { return law_ == "pinkus_sternlicht"; }

  /// F_r/S, F_t/S with the half film on the side of the sign given.
  std::array<Real, 2> ratio(const Real& epsilon, const Real& a, const Real& b, int side) const {
    const auto terms = published_terms<Real>(law_, epsilon, a, b, side);
    std::array<Real, 2> sum = {Real(0), Real(0)};
    for (const Real& term : terms.radial) sum[0] += term;
    for (const Real& term : terms.tangential) sum[1] += term;
    return sum;
  }

  /// Force at ê, w; side 0 reads it off the sign of a.
  std::array<Real, 2> force(const State<4>& y, int side) const {
    const Real ux = y[2] + spin * y[1];
    const Real uy = y[3] - spin * y[0];
    const Real epsilon = sqrt(y[0] * y[0] + y[1] * y[1]);
    const Real speed = sqrt(ux * ux + uy * uy);
    if (speed == 0) return {Real(0), Real(0)};
    if (epsilon >= 1) throw std::domain_error("journal beyond the wall");
    const Real rx = epsilon == 0 ? ux / speed : y[0] / epsilon;
    const Real ry = epsilon == 0 ? uy / speed : y[1] / epsilon;
    const Real b = ux * rx + uy * ry;
    const Real a = -2 * (uy * rx - ux * ry);
    const auto f = ratio(epsilon, a, b, side);
    return {scale * (f[0] * rx - f[1] * ry), scale * (f[0] * ry + f[1] * rx)};
  }

  Real scale;
  Real inertia;  ///< m c
  std::array<Real, 2> load;
  Real spin;  ///< mean

 private:
  std::string law_;
};

/// ê, w with the film on one side, or (side 0) wherever the sign of a says.
struct PlaneMotion {
  static constexpr std::size_t dimension = 4;
  const Journal& journal;
  int side;

  void operator()(const State<4>& y, State<4>& dydt, const Real&) const {
    const auto f = journal.force(y, side);
    dydt = {y[2], y[3], (f[0] + journal.load[0]) / journal.inertia, (f[1] + journal.load[1]) / journal.inertia};
  }
};

/// ρ, ρ̇ on the line of centres, which turns with the mean spin while a = 0 (Filippov's sliding).
struct LineMotion {
  static constexpr std::size_t dimension = 2;
  const Journal& journal;
  Real t0;
  Real angle0;

  std::array<Real, 2> line(const Real& t) const {
    const Real angle = angle0 + journal.spin * (t - t0);
    return {cos(angle), sin(angle)};
  }
  Real needed(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    return 2 * journal.inertia * journal.spin * y[1] - (journal.load[1] * n[0] - journal.load[0] * n[1]);
  }
  /// Radial force along the line and the tangential reach; ρ < 0 is the journal beyond the centre.
  std::array<Real, 2> film(const State<2>& y) const {
    const Real sign = y[0] < 0 ? -1 : 1;
    if (sign * y[0] >= 1) throw std::domain_error("sliding journal beyond the wall");
    const auto f = journal.ratio(Real(sign * y[0]), Real(0), Real(sign * y[1]), 1);
    return {journal.scale * sign * f[0], journal.scale * f[1]};
  }
  Real reach(const State<2>& y) const { return film(y)[1]; }
  State<4> plane(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    const Real across = journal.spin * y[0];
    return {y[0] * n[0], y[0] * n[1], y[1] * n[0] - across * n[1], y[1] * n[1] + across * n[0]};
  }
  std::array<Real, 2> force(const State<2>& y, const Real& t) const {
    const auto n = line(t);
    const Real radial = film(y)[0];
    const Real tangential = needed(y, t);
    return {radial * n[0] - tangential * n[1], radial * n[1] + tangential * n[0]};
  }
  void operator()(const State<2>& y, State<2>& dydt, const Real& t) const {
    const auto n = line(t);
    const Real radial = film(y)[0];
    const Real weight = journal.load[0] * n[0] + journal.load[1] * n[1];
    dydt = {y[1], journal.spin * journal.spin * y[0] + (radial + weight) / journal.inertia};
  }
};

template <class Motion>
struct ImplicitMethod {
  static constexpr std::size_t n = Motion::dimension;
  const Motion& motion;
  Real tolerance;
  RadauIIA5<Real, n> stepper;

  /// Its estimate is of order 3 only: three more digits of tolerance make it as exact as the explicit pair.
  ImplicitMethod(const Motion& m, const Real& tol)
      : motion(m), tolerance(tol), stepper(Real(tol / 1000), absolute(Real(tol / 1000))) {}
  static State<n> absolute(const Real& tol) {
    State<n> all;
    all.fill(tol);
    return all;
  }
  bool try_step(State<n>& y, Real& t, Real& dt) {
    const auto rate = [this](const State<n>& x, State<n>& d, const Real& s) { motion(x, d, s); };
    // Newton's iterations need no more than an approximate Jacobian: half of the digits by differences.
    const auto jacobian = [this](const State<n>& x, auto& j, const Real& s) {
      State<n> up;
      State<n> down;
      for (std::size_t k = 0; k < n; ++k) {
        State<n> moved = x;
        const Real step = Real(1e-12) * (1 + abs(x[k]));
        moved[k] = x[k] + step;
        motion(moved, up, s);
        moved[k] = x[k] - step;
        motion(moved, down, s);
        for (std::size_t i = 0; i < n; ++i) {
          j(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = (up[i] - down[i]) / (2 * step);
        }
      }
    };
    return stepper.try_step(std::make_pair(rate, jacobian), y, t, dt) == odeint::success;
  }
};

/// Odeint's Fehlberg 7(8) pair. Its step control is written out: Odeint's own does not know this scalar.
template <class Motion>
struct ExplicitMethod {
  static constexpr std::size_t n = Motion::dimension;
  using Pair = odeint::runge_kutta_fehlberg78<State<n>, Real, State<n>, Real>;
  const Motion& motion;
  Real tolerance;
  Pair pair;

  ExplicitMethod(const Motion& m, const Real& tol) : motion(m), tolerance(tol) {}
  bool try_step(State<n>& y, Real& t, Real& dt) {
    const auto rate = [this](const State<n>& x, State<n>& d, const Real& s) { motion(x, d, s); };
    State<n> next;
    State<n> error;
    Real size = 0;
    try {
      pair.do_step(rate, y, t, next, dt, error);
    } catch (const std::domain_error&) {
      dt /= 2;
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) size = std::max<Real>(size, abs(error[i]) / (tolerance * (1 + abs(y[i]))));
    const Real factor = size == 0 ? Real(4) : Real(0.9 * pow(size, Real(-0.125)));
    const Real tried = dt;
    dt *= std::clamp<Real>(factor, Real(0.2), Real(4));
    if (size > 1) return false;
    y = next;
    t += tried;
    return true;
  }
};

/// Steps to exactly t_goal.
template <class Method, class S>
void step_to(Method& method, S& y, Real& t, const Real& t_goal, Real& dt) {
  while (t < t_goal) {
    const Real wanted = dt;
    const bool last = t + dt * Real(1.0001) >= t_goal;
    if (last) dt = t_goal - t;
    if (dt < Real(1e-30)) throw std::runtime_error("reference trajectory: the step length has shrunk to nothing");
    const bool accepted = method.try_step(y, t, dt);
    if (accepted && last) {
      t = t_goal;
      dt = std::max<Real>(wanted, dt);
    }
  }
}

/// Steps to t_goal, or to where `margin` (positive at first) changes sign; true if it did.
template <class Method, class S, class Margin>
bool step_to_event(Method& method, S& y, Real& t, const Real& t_goal, Real& dt, const Margin& margin) {
  while (t < t_goal) {
    const S y_old = y;
    const Real t_old = t;
    const Real wanted = dt;
    const bool last = t + dt * Real(1.0001) >= t_goal;
    if (last) dt = t_goal - t;
    if (dt < Real(1e-30)) throw std::runtime_error("reference trajectory: the step length has shrunk to nothing");
    if (!method.try_step(y, t, dt)) continue;
    if (last) {
      t = t_goal;
      dt = std::max<Real>(wanted, dt);
    }
    if (margin(y, t) >= 0) continue;
    // Illinois' false position on the time of a step from the old state, to the last digits.
    const auto at = [&](const Real& s) {
      Method fresh(method.motion, method.tolerance);
      S state = y_old;
      Real time = t_old;
      Real step = s - t_old;
      step_to(fresh, state, time, s, step);
      return state;
    };
    Real lower = t_old;
    Real upper = t;
    Real f_lower = margin(y_old, t_old);
    Real f_upper = margin(y, t);
    if (f_lower <= 0) {  // starts on the event: it has been passed at once
      y = y_old;
      t = t_old;
      return true;
    }
    for (int i = 0; i < 100 && upper - lower > Real(1e-30) * upper; ++i) {
      const Real middle = upper - f_upper * (upper - lower) / (f_upper - f_lower);
      const Real f = margin(at(middle), middle);
      if (abs(f) < Real(1e-28)) {
        lower = upper = middle;
        break;
      }
      if (f > 0) {
        lower = middle;
        f_lower = f;
        f_upper /= 2;
      } else {
        upper = middle;
        f_upper = f;
        f_lower /= 2;
      }
    }
    y = at(upper);
    t = upper;
    dt = std::max<Real>(Real((t - t_old) / 8), Real(1e-9));
    return true;
  }
  return false;
}

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

std::string digits_of(const Real& value, int digits) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(digits) << std::scientific << value;
  return text.str();
}

}  // namespace

ReferenceTrajectory reference_trajectory(const std::string& law, const JournalCase& c, double tolerance) {
  const Journal journal(law, c);
  const Pass<ImplicitMethod> implicit_pass(journal, c.times, Real(tolerance));
  const Pass<ExplicitMethod> explicit_pass(journal, c.times, Real(tolerance));
  ReferenceTrajectory result;
  double worst = 0;
  for (std::size_t i = 0; i < c.times.size(); ++i) {
    const auto& one = implicit_pass.samples[i];
    const auto& other = explicit_pass.samples[i];
    const std::array<Real, 6> a = {one.state[0], one.state[1], one.state[2], one.state[3], one.force[0], one.force[1]};
    const std::array<Real, 6> b = {other.state[0], other.state[1], other.state[2],
                                   other.state[3], other.force[0], other.force[1]};
    TrajectoryRow row{c.times[i], {}, 0};
    for (std::size_t k = 0; k < 6; k += 2) {
      const Real size = sqrt(b[k] * b[k] + b[k + 1] * b[k + 1]);
      const Real apart = sqrt((a[k] - b[k]) * (a[k] - b[k]) + (a[k + 1] - b[k + 1]) * (a[k + 1] - b[k + 1]));
      row.disagreement = std::max(row.disagreement, static_cast<double>(apart / size));
      row.value[k] = digits_of(b[k], 15);
      row.value[k + 1] = digits_of(b[k + 1], 15);
    }
    worst = std::max(worst, row.disagreement);
    result.rows.push_back(row);
  }
  for (const auto& change : explicit_pass.changes) result.modes.push_back({digits_of(change.t, 16), change.mode});
  result.agreed_digits = -std::log10(std::max(worst, 1e-34));
  return result;
}

std::string trajectory_reference_csv(const ReferenceTrajectory& trajectory) {
  std::string csv = "t,ex_over_c,ey_over_c,wx,wy,fx,fy,disagreement\n";
  for (const TrajectoryRow& row : trajectory.rows) {
    csv += number(row.t);
    for (const std::string& value : row.value) csv += "," + value;
    // One digit: the difference itself is rounding and truncation.
    csv += fmt::format(",{:.0e}\n", row.disagreement);
  }
  return csv;
}

std::vector<double> reference_times(double duration) {
  std::vector<double> times;
  for (const double share : {1e-5, 1e-4, 1e-3, 2e-3, 5e-3, 1e-2}) times.push_back(share * duration);
  for (int i = 1; i <= 50; ++i) times.push_back(duration * i / 50);
  return times;
}

}  // namespace lubjoint::reports
