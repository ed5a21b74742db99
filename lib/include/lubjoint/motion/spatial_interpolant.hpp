/// The motion in space inside a step.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "lubjoint/multibody/spatial/body.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

namespace detail {

/// The quintic that meets a place, its rate and its second rate at both ends of a step.
template <class R>
struct Quintic {
  R value;  ///< at s
  R rate;   ///< its derivative by time there

  /// @param h  length of the step [s];  @param s  from 0 to 1
  Quintic(const R& x0, const R& x1, const R& v0, const R& v1, const R& a0, const R& a1, const R& h, const R& s) {
    const R start = h * v0;
    const R bend = h * h * a0;
    const R dx = (x1 - x0) - start - bend / 2;
    const R dv = h * v1 - start - bend;
    const R da = h * h * a1 - bend;
    const R c3 = 10 * dx - 4 * dv + da / 2;
    const R c4 = -15 * dx + 7 * dv - da;
    const R c5 = 6 * dx - 3 * dv + da / 2;
    value = x0 + s * (start + s * (bend / 2 + s * (c3 + s * (c4 + s * c5))));
    rate = (start + s * (bend + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
  }
};

/// The cubic that meets value and rate at both ends.
template <class R>
R cubic_between(const R& x0, const R& x1, const R& v0, const R& v1, const R& h, const R& s) {
  const R over = (x1 - x0) - h * v0;
  const R dv = h * (v1 - v0);
  return x0 + s * (h * v0 + s * ((3 * over - dv) + s * (dv - 2 * over)));
}

}  // namespace detail

/// The state inside a step of y = (r, p; ṙ, ω′; work), as StepInterpolant has it for q̇ = v: r and p by quintics, with
///   p̈ = ½L(p)ᵀω̇′ + ½L(ṗ)ᵀω′,
/// p normalised; ṙ and ω′ = 2Lṗ by their derivatives, or, in a step so short that rounding of places spoils those, by
/// the cubic of velocities and accelerations; work by the cubic, or, with its middle, by degree 5. Then step.inside, if
/// there is one.
template <class R>
void spatial_state_at(const StepInterpolant<std::vector<R>>& step, std::size_t bodies, const R& t, std::vector<R>& y) {
  using std::abs;
  const R h = step.t_new - step.t_old;
  const R s = (t - step.t_old) / h;
  const std::size_t places = spatial_coordinates * bodies;
  y.resize(step.y_old.size());
  const auto cubic = [&](std::size_t i) {
    return detail::cubic_between(step.y_old[i], step.y_new[i], step.rate_old[i], step.rate_new[i], h, s);
  };
  const std::size_t mechanical = places + spatial_velocities * bodies;
  for (std::size_t i = places; i < y.size(); ++i)
    y[i] = step.has_middle && i >= mechanical ? step.integral_at(t, i) : cubic(i);
  struct End {
    SpatialMotion<R> motion;
    Vector3<R> acceleration, spin_rate;
    EulerParameters<R> rate, second;
  };
  const R rounding = 2 * std::numeric_limits<R>::epsilon() / h;
  for (std::size_t b = 0; b < bodies; ++b) {
    const auto end = [&](const std::vector<R>& at, const std::vector<R>& rates) {
      const std::size_t v = places + spatial_velocities * b;
      End e{spatial_motion_in(at.data(), bodies, b),
            Vector3<R>(rates[v], rates[v + 1], rates[v + 2]),
            Vector3<R>(rates[v + 3], rates[v + 4], rates[v + 5]),
            {},
            {}};
      e.rate = euler_rate(e.motion.parameters, e.motion.body_spin);
      e.second = euler_rate(e.motion.parameters, e.spin_rate) + euler_rate(e.rate, e.motion.body_spin);
      return e;
    };
    const End a = end(step.y_old, step.rate_old);
    const End z = end(step.y_new, step.rate_new);
    const auto quintic = [&](const R& x0, const R& x1, const R& v0, const R& v1, R a0, R a1) {
      if (!step.smooth_rates) {  // those of the cubic
        a0 = (6 * (x1 - x0) / h - 4 * v0 - 2 * v1) / h;
        a1 = (2 * v0 + 4 * v1 - 6 * (x1 - x0) / h) / h;
      }
      return detail::Quintic<R>(x0, x1, v0, v1, a0, a1, h, s);
    };
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const detail::Quintic<R> q = quintic(a.motion.position(k), z.motion.position(k), a.motion.velocity(k),
                                           z.motion.velocity(k), a.acceleration(k), z.acceleration(k));
      y[spatial_coordinates * b + i] = q.value;
      R& v = y[places + spatial_velocities * b + i];
      if (abs(q.rate - v) > rounding * (abs(a.motion.position(k)) + abs(z.motion.position(k)))) v = q.rate;
    }
    EulerParameters<R> p, p_rate;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const detail::Quintic<R> q =
          quintic(a.motion.parameters(k), z.motion.parameters(k), a.rate(k), z.rate(k), a.second(k), z.second(k));
      p(k) = q.value;
      p_rate(k) = q.rate;
    }
    const R square = p.squaredNorm();
    const Vector3<R> e = p.template tail<3>();
    const Vector3<R> e_rate = p_rate.template tail<3>();
    const Vector3<R> turning = cross(e, e_rate);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const R spin = 2 * (p(0) * e_rate(k) - e(k) * p_rate(0) - turning(k)) / square;
      R& v = y[places + spatial_velocities * b + 3 + static_cast<std::size_t>(k)];
      if (abs(spin - v) > 8 * rounding) v = spin;
    }
    p = normalised(p);
    for (Eigen::Index k = 0; k < 4; ++k) y[spatial_coordinates * b + 3 + static_cast<std::size_t>(k)] = p(k);
  }
  if (step.inside) step.inside(t, y);
}

}  // namespace lubjoint
