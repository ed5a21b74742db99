#include "oracle/laws/pinkus_sternlicht_difference.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

namespace pinkus_sternlicht_difference_test {

using namespace lubjoint::reports;

TEST_CASE("Pinkus-Sternlicht differs from a closing long dynamic film by 6 % in the median and by at most 11.4 %") {
  const auto differences = pinkus_sternlicht_difference(DifferenceGrid::uniform(0.97, 97, 180));
  const DifferenceSummary closing = summary_of(differences, SqueezeSign::closing);
  CHECK(closing.states == 97 * 90);
  CHECK(closing.median == Approx(0.0594).margin(0.0005));  // grid: a five times finer one gives 0.05936
  CHECK(closing.largest <= 0.114);                         // the limit as ε → 1, below
  CHECK(closing.largest >= 0.108);                         // grid: 0.1098 at ε = 0.97
}

TEST_CASE(
    "Pinkus-Sternlicht differs from an opening film by 16 % in the median, and by several times the force at 0.97") {
  const auto differences = pinkus_sternlicht_difference(DifferenceGrid::uniform(0.97, 97, 180));
  const DifferenceSummary opening = summary_of(differences, SqueezeSign::opening);
  CHECK(opening.median == Approx(0.1558).margin(0.001));  // grid: a five times finer one gives 0.1558
  CHECK(opening.largest > 4);
  CHECK(opening.eccentricity_ratio_of_largest > 0.96);
  const DifferenceSummary at_09 = summary_of(pinkus_sternlicht_difference({{0.9}, 3600}), SqueezeSign::opening);
  CHECK(at_09.largest == Approx(0.804).margin(0.001));  // grid: directions 0.1° apart
}

TEST_CASE("the largest difference of a closing film tends to 11.38 % as ε → 1") {
  double largest = 0;
  for (const double thinness : {1e-2, 1e-3, 1e-4}) {
    // 1e-4 of the directions lie near the wedge, b/|a| ~ √(1 − ε), where the largest difference is
    const auto d = pinkus_sternlicht_difference({{1 - thinness}, 20000});
    const double at_this = summary_of(d, SqueezeSign::closing).largest;
    CHECK(at_this > largest);
    CHECK(at_this < 0.1138);  // the supremum found with log-spaced directions to 1 − 1e-10: 0.11377
    largest = at_this;
  }
  CHECK(largest == Approx(0.11377).margin(1e-4));  // model: the limit is reached within O(√(1 − ε)) of itself squared
}

TEST_CASE("the difference is measured with an error that does not show") {
  for (const PinkusSternlichtDifference& d : pinkus_sternlicht_difference({{0, 0.5, 0.97, 1 - 1e-9}, 90})) {
    CHECK(d.error <= 1e-11 * (1 + d.difference));  // oracle: its estimate, relative to |F|
    CHECK(std::hypot(d.squeeze_rate, d.slip_rate / 2) == Approx(1));
  }
  CHECK_THROWS_AS(pinkus_sternlicht_difference({{0.5}, 0}), std::invalid_argument);
  CHECK_THROWS_AS(pinkus_sternlicht_difference({{1.0}, 4}), std::domain_error);
}

TEST_CASE("a concentric journal has no difference: both laws give isotropic damping there") {
  const auto differences = pinkus_sternlicht_difference({{0}, 36});
  for (const PinkusSternlichtDifference& d : differences) {
    CHECK(d.difference <= 1e-14);  // rounding of both
  }
}

}  // namespace pinkus_sternlicht_difference_test
