// Orbits fill their plots, and the clearance circle beside them does not lie on them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "oracle/plot/orbit.hpp"

namespace orbit_plot_test {

using namespace lubjoint::reports;
using Catch::Contains;

namespace {

std::vector<PlotPoint> circle(double x, double y, double radius) {
  std::vector<PlotPoint> places;
  for (int i = 0; i <= 200; ++i) {
    const double angle = i * std::numbers::pi / 100;
    places.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return places;
}

std::vector<PlotPoint> spiral(double size) {
  std::vector<PlotPoint> places;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i / 100.0;
    places.push_back({size * (1 - std::exp(-t / 5) * std::cos(t)), -size * std::exp(-t / 5) * std::sin(t)});
  }
  return places;
}

/// How much of the smaller side of its window an orbit takes.
double filled(const std::vector<PlotPoint>& places, const OrbitWindow& window) {
  double share = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end(),
                                                 [i](const PlotPoint& a, const PlotPoint& b) { return a[i] < b[i]; });
    share = std::max(share, ((*high)[i] - (*low)[i]) / (2 * (i == 0 ? window.half_width : window.half_height)));
  }
  return share;
}

}  // namespace

TEST_CASE("orbit plots: an orbit takes two thirds of its plot at least, and all of it is inside") {
  for (const double aspect : {1.0, 1.5}) {
    for (const auto& places : {circle(0.06, 0, 0.06), circle(-0.3, 0.2, 0.01), spiral(0.117), spiral(0.24),
                               std::vector<PlotPoint>{{0, 0}, {0.3, 0.3}, {0.3, -0.3}}}) {
      const OrbitWindow window = orbit_window(places, aspect);
      REQUIRE(window.has_inset);
      CHECK(filled(places, window) > 0.66);
      for (const PlotPoint& p : places) {
        CHECK(std::abs(p[0] - window.centre[0]) < window.half_width);
        CHECK(std::abs(p[1] - window.centre[1]) < window.half_height);
        CHECK(std::hypot(p[0] - window.inset[0], p[1] - window.inset[1]) > window.inset_radius);
      }
      // The inset is inside, too.
      CHECK(std::abs(window.inset[0] - window.centre[0]) + window.inset_radius < window.half_width);
      CHECK(std::abs(window.inset[1] - window.centre[1]) + window.inset_radius < window.half_height);
    }
  }
}

TEST_CASE("orbit plots: one that goes through the whole clearance is shown in its circle, without an inset") {
  for (const auto& places : {circle(0, 0, 0.99), circle(0.1, 0, 0.8), std::vector<PlotPoint>{}}) {
    const OrbitWindow window = orbit_window(places);
    CHECK_FALSE(window.has_inset);
    CHECK(window.half_width == 1.05);
    CHECK(window.centre == PlotPoint{0, 0});
  }
  CHECK(orbit_script(circle(0, 0, 0.99), std::nullopt).find("$part") == std::string::npos);
  CHECK_THAT(orbit_script(spiral(0.2), PlotPoint{0.2, 0}), Contains("$part") && Contains("set label 1 at 0.2,0 "));
}

}  // namespace orbit_plot_test
