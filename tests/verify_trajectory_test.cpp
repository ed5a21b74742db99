#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/verify/answers.hpp"
#include "oracle/verify/trajectory.hpp"

using namespace lubjoint::verify;
using Catch::Contains;

namespace {

/// A damped orbit, sampled every `step` seconds, late by `delay` and larger by `factor`.
Path orbit(double step, double delay = 0, double factor = 1) {
  Path path;
  for (double t = 0; t <= 1; t += step) {
    const double s = t - delay;
    path.t.push_back(t);
    path.ex.push_back(factor * std::exp(-s) * std::cos(20 * s));
    path.ey.push_back(factor * std::exp(-s) * std::sin(20 * s));
  }
  return path;
}

}  // namespace

TEST_CASE("trajectory: a path on other times agrees to the interpolation's error") {
  const PathComparison coarse = compare_paths(orbit(0.01), orbit(0.0037));
  const PathComparison fine = compare_paths(orbit(0.01), orbit(0.0037 / 2));
  CHECK(coarse.worst < 1e-3);
  CHECK(std::log2(coarse.mean / fine.mean) > 1.9);  // modified Akima: at least second order in the step
}

TEST_CASE("trajectory: a phase shift is told from an amplitude error, with its size") {
  const PathComparison late = compare_paths(orbit(0.01), orbit(0.002, 0.013));
  CHECK_THAT(late.words(), Contains("a phase shift") && Contains("late"));
  CHECK(late.delay == Approx(0.013).epsilon(1e-3));  // interpolation
  const PathComparison large = compare_paths(orbit(0.01), orbit(0.002, 0, 1.05));
  CHECK_THAT(large.words(), Contains("an amplitude error"));
  CHECK(large.amplitude == Approx(1.05).epsilon(1e-3));  // interpolation
  CHECK(large.worst == Approx(0.05).epsilon(1e-2));      // at t = 0, where |e| is 1
  CHECK(!large.agrees(1e-2));
  CHECK(large.agrees(0.06));
}

TEST_CASE("trajectory: files that can't be compared are refused with the reason") {
  const auto read = [](const std::string& csv) { return read_path(csv, "file.csv", "bearing", 2e-4); };
  CHECK_THROWS_WITH(read("t,a.ex,a.ey\n0,0,0\n"), Contains("bearing.ex"));
  CHECK_THROWS_WITH(read("t,bearing.ex,bearing.ey\n0,0,0\n"), Contains("at least 5"));
  CHECK_THROWS_WITH(read("t,bearing.ex,bearing.ey\n0,0,0\n1,0,0\n1,0,0\n2,0,0\n3,0,0\n"), Contains("increase"));
  CHECK_THROWS_WITH(read("t,bearing.ex,bearing.ey\n0,0,x\n"), Contains("bearing.ey is \"x\""));
  CHECK(read("t,bearing.ex,bearing.ey\n0,2e-4,0\n1,0,0\n2,0,0\n3,0,0\n4,0,0\n").ex[0] == Approx(1));
  Path brief = orbit(0.01);
  for (auto* list : {&brief.t, &brief.ex, &brief.ey}) list->resize(20);
  CHECK_THROWS_WITH(compare_paths(orbit(0.01), brief), Contains("at least half"));
}
