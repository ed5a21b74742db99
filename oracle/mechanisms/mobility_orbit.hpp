/// The mobility method: the orbit of a journal without mass under a load that repeats.
#pragma once

#include <math.h>  // isnan without std::, which Boost's interpolators ask for

#include <array>
#include <boost/math/interpolators/makima.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lubjoint/film/mobility.hpp"

namespace lubjoint::mechanisms {

/// A load over one period, between whose rows lie Akima's modified cubics.
class PeriodicLoad {
 public:
  /// @param t, fx, fy  rows; the last one ends the period with the first one's force
  PeriodicLoad(const std::vector<double>& t, const std::vector<double>& fx, const std::vector<double>& fy)
      : times_(t), x_(repeated(t, fx)), y_(repeated(t, fy)) {}

  const std::vector<double>& times() const { return times_; }
  Vector2<double> at(double t) const { return {x_(t), y_(t)}; }  ///< 0 ≤ t ≤ period [N]

 private:
  using Points = std::vector<double>;
  using Interpolator = boost::math::interpolators::makima<Points>;

  /// With a period before and one after it: the middle one knows its neighbours.
  static Interpolator repeated(const Points& t, const Points& f) {
    Points x;
    Points y;
    for (const int turn : {-1, 0, 1}) {
      for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        x.push_back(t[i] + turn * (t.back() - t.front()));
        y.push_back(f[i]);
      }
    }
    x.push_back(2 * t.back() - t.front());
    y.push_back(f.back());
    return Interpolator(std::move(x), std::move(y));
  }

  Points times_;
  Interpolator x_, y_;
};

/// ê̇ = u + ω̄ ê⊥ with F(ê, u) = −W(t) (Booker): ê at the rows' times on the periodic orbit. Steps of Fehlberg's method
/// of order 8, some to each row, so that none crosses a knot; periods until one ends where it began.
template <class Law>
std::vector<Vector2<double>> mobility_orbit(const Bearing<double>& bearing, const Lubricant<double>& oil,
                                            double mean_spin, const PeriodicLoad& load, int steps_a_row) {
  using State = std::array<double, 2>;
  const double scale = force_scale(Law::limit, bearing, oil);
  const auto rate = [&](const State& y, State& dydt, double t) {
    const Vector2<double> e(y[0], y[1]);
    const Vector2<double> u =
        *mobility<Law>(e, one_minus_squared_norm<double>(y[0], y[1]), Vector2<double>(-load.at(t) / scale)).velocity;
    dydt = {u.x() - mean_spin * y[1], u.y() + mean_spin * y[0]};
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<State> method;
  State y{0, 0};
  for (int period = 0; period < 50; ++period) {
    const State start = y;
    std::vector<Vector2<double>> orbit{{y[0], y[1]}};
    for (std::size_t row = 0; row + 1 < load.times().size(); ++row) {
      const double h = (load.times()[row + 1] - load.times()[row]) / steps_a_row;
      for (int i = 0; i < steps_a_row; ++i) method.do_step(rate, y, load.times()[row] + i * h, h);
      orbit.emplace_back(y[0], y[1]);
    }
    if (std::hypot(y[0] - start[0], y[1] - start[1]) < 1e-12) return orbit;
  }
  throw std::runtime_error("the orbit of a journal without mass does not close within 50 periods");
}

}  // namespace lubjoint::mechanisms
