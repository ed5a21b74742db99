// The laws of dry contact, by integrating the impact that each of them means: what speed a free body leaves with. None
// of their formulas, and no first integral, is in here.
//
// What is known of the speeds: Gonthier's law is made to return c_r exactly. Hunt and Crossley's is f = k x^n (1 + 3/2
// c v) for c_r = 1 - c v (Hunt and Crossley, J. Appl. Mech. 42, 1975, 440-445; so in the documentation of SimTK's
// HuntCrossleyForce), right to first order in 1 - c_r, as Lankarani and Nikravesh's is. Flores' is made for soft
// materials: near c_r = 1 it takes 16/15 of the loss.
#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/verify/states/solution.hpp"

namespace contact_laws_test {

using namespace lubjoint::verify;

namespace {

/// Speed at which a body of mass 1 that meets the wall at speed 1 leaves it, over that speed.
double exit_speed(std::string_view law, double restitution) {
  State state;
  state.clearance = 0.5;
  state.contact_stiffness = 20;
  state.restitution = restitution;
  state.impact_speed = 1;
  const auto acceleration = [&](double depth, double speed) {
    state.ex = state.clearance + std::max(depth, 0.0);
    state.vx = speed;
    return static_cast<double>(solve(Quantities::contact, law_of(law), state).answer[0]);
  };
  double depth = 0;
  double speed = 1;
  const double step = 2e-4;
  for (int steps = 0; steps < 100000; ++steps) {  // Runge and Kutta's method of fourth order; an impact takes 3000
    const double a1 = acceleration(depth, speed);
    const double a2 = acceleration(depth + step / 2 * speed, speed + step / 2 * a1);
    const double a3 = acceleration(depth + step / 2 * (speed + step / 2 * a1), speed + step / 2 * a2);
    const double a4 = acceleration(depth + step * (speed + step / 2 * a2), speed + step * a3);
    const double next = depth + step * (speed + step / 6 * (a1 + a2 + a3));
    const double faster = speed + step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (next <= 0) return -(speed + (faster - speed) * depth / (depth - next));
    depth = next;
    speed = faster;
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("contact laws: Gonthier's returns the coefficient of restitution, and no other does") {
  for (const double restitution : {0.2, 0.5, 0.8, 0.95}) {
    INFO(restitution);
    CHECK(std::abs(exit_speed("gonthier", restitution) - restitution) < 1e-6);  // the method's steps at the seam
    if (restitution > 0.9) continue;
    CHECK(exit_speed("lankarani_nikravesh", restitution) > restitution + 1e-3);  // it dissipates too little
    CHECK(exit_speed("hunt_crossley", restitution) > restitution + 1e-3);
    CHECK(std::abs(exit_speed("flores", restitution) - restitution) > 1e-3);
  }
}

TEST_CASE("contact laws: near c_r = 1 each loses the share of 1 - c_r that its authors give it") {
  const double loss = 1e-3;
  const auto share = [loss](std::string_view law) { return (1 - exit_speed(law, 1 - loss)) / loss; };
  // To first order in the loss; the second is of its size, the method's steps are below 1e-3 of it.
  CHECK(share("gonthier") == Approx(1).epsilon(3e-3));
  CHECK(share("hunt_crossley") == Approx(1).epsilon(3e-3));
  CHECK(share("lankarani_nikravesh") == Approx(1).epsilon(3e-3));
  CHECK(share("flores") == Approx(16.0 / 15).epsilon(3e-3));
}

}  // namespace contact_laws_test
