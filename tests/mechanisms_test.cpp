#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "oracle/mechanisms/lubricated_slider_crank.hpp"

namespace mechanisms_test {

using namespace lubjoint;
using namespace lubjoint::mechanisms;

namespace {

const double speed = 5000 * boost::math::constants::two_pi<double>() / 60;

/// Largest value of f over one turn: the best of 720 samples, refined.
template <class F>
double largest(const F& f) {
  const double step = boost::math::constants::two_pi<double>() / 720;
  int best = 0;
  for (int i = 1; i < 720; ++i) {
    if (f(i * step) > f(best * step)) best = i;
  }
  return -boost::math::tools::brent_find_minima([&](double x) { return -f(x); }, (best - 1) * step, (best + 1) * step,
                                                40)
              .second;
}

}  // namespace

TEST_CASE("ideal slider-crank at 5000 rpm: peak gudgeon-pin force 2718.71 N, driving moment ±138.52 N m") {
  const SliderCrank<double> m;
  const auto at = [&](double angle) { return ideal_reactions<double>(m, {angle, speed, 0}); };
  // Half the last digit of the published numbers.
  CHECK(std::abs(largest([&](double a) { return at(a).gudgeon_pin.norm(); }) - 2718.71) < 0.005);
  CHECK(std::abs(largest([&](double a) { return at(a).driving_moment; }) - 138.52) < 0.005);
  CHECK(std::abs(largest([&](double a) { return -at(a).driving_moment; }) - 138.52) < 0.005);
}

TEST_CASE("ideal slider-crank: the driving moment is the rate of the kinetic energy over the crank's speed") {
  const SliderCrank<long double> m;
  for (const long double angle : {0.3L, 1.1L, 2.9L, 4.0L, 5.8L}) {
    for (const long double acceleration : {0.0L, -2e4L}) {
      const long double omega = speed;
      const auto energy = [&](long double a) { return effective_inertia(m, a) / 2; };
      const long double h = 1e-5L;
      const long double slope =
          (8 * (energy(angle + h) - energy(angle - h)) - (energy(angle + 2 * h) - energy(angle - 2 * h))) / (12 * h);
      const long double expected = slope * omega * omega + effective_inertia(m, angle) * acceleration;
      const long double found = ideal_reactions<long double>(m, {angle, omega, acceleration}).driving_moment;
      // Fourth-order difference: h⁴ = 1e-20 of truncation, rounding 1e-19/h.
      CHECK(std::abs(found - expected) < 1e-11L * std::abs(omega * omega * energy(angle)));
    }
  }
}

TEST_CASE("ideal slider-crank: rates and accelerations are the derivatives of the positions") {
  const SliderCrank<long double> m;
  const auto crank = [](long double t) {
    return Motion<long double>{0.4L + 500 * t - 1000 * t * t, 500 - 2000 * t, -2000};
  };
  const long double t = 0.003L;
  const long double h = 1e-6L;
  const auto before = ideal_motion(m, crank(t - h));
  const auto now = ideal_motion(m, crank(t));
  const auto after = ideal_motion(m, crank(t + h));
  const auto is_derivative = [&](const Motion<long double>& a, const Motion<long double>& b,
                                 const Motion<long double>& c) {
    // Central differences: relative truncation (ωh)²/6 = 4e-8.
    CHECK(std::abs((c.value - a.value) / (2 * h) - b.rate) < 1e-7L * 500 * 0.1L);
    CHECK(std::abs((c.rate - a.rate) / (2 * h) - b.acceleration) < 1e-7L * 500 * 500);
  };
  is_derivative(before.rod, now.rod, after.rod);
  is_derivative(before.slider, now.slider, after.slider);
}

TEST_CASE("torque-driven slider-crank: its speed is the derivative of the angle that its time inverts") {
  const SliderCrank<double> m;
  const auto integrate = [](const auto& f, double a, double b) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, a, b, 12, 1e-14);
  };
  const double h = 1e-4;
  for (const double angle : {0.5, 2.0, 6.0, 11.0}) {
    const double slope =
        (torque_driven_time(m, 10.0, angle + h, integrate) - torque_driven_time(m, 10.0, angle - h, integrate)) /
        (2 * h);
    CHECK(slope * torque_driven_speed(m, 10.0, angle) == Approx(1).epsilon(1e-7));  // truncation h²
  }
}

TEST_CASE("lubricated slider-crank in minimal coordinates: a stiff film leaves the ideal force and moment") {
  // Centre of the pin at rest in the deviation: a thick oil in a small clearance follows the ideal mechanism.
  using Mechanism = LubricatedSliderCrank<PinkusSternlicht, double>;
  const SliderCrank<double> m;
  double last = 1;
  for (const double c : {4e-5, 2e-5}) {
    const Mechanism pin(m, speed, Bearing<double>(0.04, 0.01 - c, c), Lubricant<double>(0.4), BearingOn::rod);
    DeviationState<double> y{0, 0, 0, 0};
    namespace odeint = boost::numeric::odeint;
    const auto stepper = odeint::make_controlled(1e-9, 1e-9, odeint::runge_kutta_dopri5<DeviationState<double>>());
    const double t_end = 0.0135;
    odeint::integrate_adaptive(
        stepper, [&](const auto& x, auto& dxdt, double t) { pin.rate(x, dxdt, t); }, y, 0.0, t_end, 1e-9);
    const auto ideal = ideal_reactions<double>(m, {speed * t_end, speed, 0});
    const double force = (pin.pin(t_end, y).force - ideal.gudgeon_pin).norm() / ideal.gudgeon_pin.norm();
    const double moment = std::abs(pin.driving_moment(t_end, y) - ideal.driving_moment) / 138;
    CHECK(force < 0.02);  // model: the film's deviation is of the order of c/l times the speed's acceleration
    CHECK(moment < 0.02);
    CHECK(force < last);
    last = force;
  }
}

}  // namespace mechanisms_test
