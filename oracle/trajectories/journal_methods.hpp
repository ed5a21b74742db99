/// The two integrators of a free journal's reference trajectory, and steps that end at a time or at an event.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lubjoint/ode/radau_iia.hpp"
#include "oracle/trajectories/journal_motion.hpp"

namespace lubjoint::reports::journal_reference {

namespace odeint = boost::numeric::odeint;

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

}  // namespace lubjoint::reports::journal_reference
