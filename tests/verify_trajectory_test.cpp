// One signal of a trajectory against a reference.
#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/trajectory/deviation.hpp"

namespace verify_trajectory_test {

using namespace lubjoint::verify;
using Catch::Contains;

namespace {

/// A damped orbit of a journal, sampled every `step` seconds, late by `delay`.
Trajectory orbit(double step, double delay = 0, double factor = 1) {
  Trajectory path{"orbit", {}, {}, {}};
  for (double t = 0; t <= 1; t += step) {
    const double s = t - delay;
    path.t.push_back(t);
    path.columns["pin.ex"].push_back(factor * std::exp(-s) * std::cos(20 * s));
    path.columns["pin.ey"].push_back(factor * std::exp(-s) * std::sin(20 * s));
  }
  return path;
}

Yardstick yardstick_of(const Signal& signal, const Trajectory& reference) {
  const Samples samples = samples_of(signal, reference);
  return {signal, samples, 8, std::vector<double>(samples.t.size(), 0), 1e-3};
}

const Signal eccentricity{SignalKind::eccentricity, "pin", "eccentricity", {"pin.ex", "pin.ey"}, 1, 1, "clearances"};

Yardstick reference() { return yardstick_of(eccentricity, orbit(0.01 / 8)); }

std::string words_of(const Trajectory& given) {
  const Yardstick yardstick = reference();
  const Deviation d = deviation(yardstick, given);
  CHECK(!d.agrees());
  const auto e = explanation(d, given, {yardstick});
  return e ? e->words : "nothing";
}

}  // namespace

TEST_CASE("trajectory: a right path on coarse times agrees, as what interpolation loses is allowed for") {
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    const Deviation d = deviation(reference(), orbit(i == 0 ? 0.037 : 0.0185));
    CHECK(d.agrees());
    errors[i] = d.rms;
  }
  CHECK(errors[0] > 1e-3);                        // more than the tolerance: interpolation
  CHECK(std::log2(errors[0] / errors[1]) > 1.9);  // modified Akima: at least second order in the step
}

TEST_CASE("trajectory: at the given times a wrong path is caught however coarse they are") {
  const Deviation d = deviation(reference(), orbit(0.083, 0, 1.01));
  CHECK(!d.agrees());
  CHECK(d.error(0) == Approx(0.01));  // at t = 0, where |e| is 1
}

TEST_CASE("trajectory: a phase shift is told from an amplitude error, with its size") {
  const Trajectory late = orbit(0.002, 0.013);
  const Yardstick yardstick = reference();
  const auto shifted = explanation(deviation(yardstick, late), late, {yardstick});
  REQUIRE(shifted);
  CHECK_THAT(shifted->words, Contains("a phase shift") && Contains("late"));
  CHECK(*shifted->delay == Approx(0.013).epsilon(1e-3));  // interpolation
  CHECK_THAT(words_of(orbit(0.002, -0.007)), Contains("a phase shift: 0.007 s early"));
  CHECK_THAT(words_of(orbit(0.002, 0, 1.05)), Contains("an amplitude error: 1.05 times"));
}

TEST_CASE("trajectory: signs, axes, units and offsets are told by name") {
  const auto changed = [](const auto& change) {
    Trajectory path = orbit(0.004);
    for (std::size_t i = 0; i < path.t.size(); ++i) change(path.columns["pin.ex"][i], path.columns["pin.ey"][i]);
    return words_of(path);
  };
  CHECK_THAT(changed([](double& x, double& y) { x = -x, y = -y; }), Contains("from the journal's centre"));
  CHECK_THAT(changed([](double& x, double& y) { std::swap(x, y); }), Contains("x and y are exchanged"));
  CHECK_THAT(changed([](double&, double& y) { y = -y; }), Contains("y has the opposite sign"));
  CHECK_THAT(changed([](double& x, double& y) { x *= 1000, y *= 1000; }), Contains("in millimetres"));
  CHECK_THAT(changed([](double& x, double&) { x += 0.3; }), Contains("a constant offset"));
}

TEST_CASE("trajectory: columns of another joint are recognised") {
  const Yardstick yardstick = reference();
  Signal other = eccentricity;
  other.owner = "big-end";
  Trajectory theirs = orbit(0.01 / 8, 0.3);
  const Trajectory given = orbit(0.004, 0.3);
  const auto e = explanation(deviation(yardstick, given), given, {yardstick, yardstick_of(other, theirs)});
  REQUIRE(e);
  CHECK(e->whose == "big-end");
}

TEST_CASE("trajectory: angles agree up to full turns") {
  const double turn = 8 * std::atan(1.0);
  const Signal angle{SignalKind::angle, "crank", "angle", {"crank.phi"}, 1, 1, "rad"};
  const auto turning = [&](double step, const auto& phi) {
    Trajectory path{"angle", {}, {}, {}};
    for (double t = 0; t <= 1; t += step) {
      path.t.push_back(t);
      path.columns["crank.phi"].push_back(phi(30 * t + std::sin(5 * t)));
    }
    return path;
  };
  const Yardstick yardstick = yardstick_of(angle, turning(1e-3, [](double phi) { return phi; }));
  CHECK(deviation(yardstick, turning(4e-3, [&](double phi) { return std::remainder(phi, turn); })).agrees());
  CHECK(deviation(yardstick, turning(4e-3, [&](double phi) { return phi - 3 * turn; })).agrees());
  CHECK(!deviation(yardstick, turning(4e-3, [](double phi) { return phi + 0.01; })).agrees());
}

TEST_CASE("trajectory: what a scene does to small errors is allowed, and where it does too much nothing is judged") {
  Yardstick yardstick = reference();
  for (std::size_t i = 0; i < yardstick.fine.t.size(); ++i) {
    yardstick.sensitivity[i] = 1e-6 * std::exp(20 * yardstick.fine.t[i]);  // 0.025 at t = 0.506
  }
  CHECK(yardstick.horizon() == Approx(std::log(0.025 / 1e-6) / 20).epsilon(0.01));
  Trajectory given = orbit(0.005);
  for (std::size_t i = 0; i < given.t.size(); ++i) given.columns["pin.ex"][i] += 2e-6 * std::exp(20 * given.t[i]);
  const Deviation d = deviation(yardstick, given);
  CHECK(d.agrees());
  CHECK(d.judged_until <= d.horizon);
  for (double& x : given.columns["pin.ex"]) x *= 1.01;
  CHECK(!deviation(yardstick, given).agrees());
}

TEST_CASE("trajectory: files that can't be compared are refused with the reason") {
  const auto read = [](const std::string& csv) { return read_trajectory(csv, "file.csv"); };
  CHECK_THROWS_WITH(read("a,b\n0,0\n"), Contains("\"t\"") && Contains("a, b"));
  CHECK_THROWS_WITH(read("t,pin.ex\n0,0\n"), Contains("at least 5"));
  CHECK_THROWS_WITH(read("t,pin.ex\n0,0\n1,0\n1,0\n2,0\n3,0\n"), Contains("increase"));
  CHECK_THROWS_WITH(read("t,pin.ex\n0,0\n1,x\n"), Contains("file.csv:3") && Contains("pin.ex is \"x\""));
  const Trajectory known = read("t,pin.ex\n0,1\n1,2\n2,3\n3,4\n4,5\n");
  CHECK(known.columns.at("pin.ex")[4] == 5);
  const Trajectory given = read_trajectory("t,note,pin.ex\n0,a,1\n1,b,2\n2,c,3\n3,d,4\n4,e,5\n", "given", &known);
  CHECK(given.not_read == std::vector<std::string>{"note"});
  Trajectory brief = orbit(0.01);
  brief.t.resize(20);
  for (auto& [name, column] : brief.columns) column.resize(20);
  CHECK_THROWS_WITH(deviation(reference(), brief), Contains("at least half"));
}

}  // namespace verify_trajectory_test
