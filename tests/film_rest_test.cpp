#include <catch2/catch.hpp>
#include <limits>

#include "support/film_jacobian.hpp"
#include "support/film_reference.hpp"

namespace film_rest_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

using Matrix2 = Eigen::Matrix<double, 2, 2>;
using Vec = Vector2<double>;
constexpr double half_turn = std::numbers::pi;

/// ∂F/∂u at ê = 0, u = 0, over S.
Matrix2 damping_at_centre(std::string_view law) {
  const Matrix2 one = Matrix2::Identity();
  if (law == "short_full") return -half_turn * one;
  if (law == "short_half" || law == "short_dynamic") return -half_turn / 2 * one;
  if (law == "long_full") return -12 * half_turn * one;
  if (law == "long_half") return -6 * (half_turn - 8 / half_turn) * one;  // r along u: all squeeze
  if (law == "long_half_eq5") return (Matrix2() << -6 * half_turn, -24, 24, -6 * half_turn).finished();
  return -6 * half_turn * one;  // long_dynamic, pinkus_sternlicht
}

/// ∂(F_r, F_t)/∂(u_r, u_t) at ε > 0 in the limit b → 0, a → 0+, over S: derivatives of the published forms, a = −2u_t.
Matrix2 damping_at_rest(std::string_view law, double e) {
  const double q = (1 - e) * (1 + e);
  const double d = 2 + e * e;
  const double q32 = std::pow(q, 1.5);
  Matrix2 j = Matrix2::Zero();
  if (law == "short_full") j.diagonal() << -half_turn * (1 + 2 * e * e) / (q32 * q), -half_turn / q32;
  if (law == "long_full") j.diagonal() << -12 * half_turn / q32, -24 * half_turn / (d * std::sqrt(q));
  if (law == "short_half" || law == "short_dynamic") {  // the pressure is zero where the dynamic film's ends move
    j << -half_turn * (1 + 2 * e * e) / (2 * q32 * q), 2 * e / (q * q), 2 * e / (q * q), -half_turn / (2 * q32);
  }
  const double wedge = -12 * half_turn / (d * std::sqrt(q));
  const double cross = 24 * e / (d * q);
  if (law == "long_half") j << -6 * (half_turn - 16 / (half_turn * d)) / q32, cross, cross, wedge;
  if (law == "long_half_eq5") j << -6 * half_turn / q32, cross, 24 / ((1 + e) * q), wedge;
  if (law == "pinkus_sternlicht") j << -6 * half_turn / q32, cross, 18 * half_turn * e / (d * q), wedge;
  return j;
}

/// Columns r and t of a frame whose r points along e.
Matrix2 frame_of(const Vec& e) {
  const Vec r = direction(e);
  return (Matrix2() << r.x(), -r.y(), r.y(), r.x()).finished();
}

const Vec centre(0, 0);
const Vec still(0, 0);
const Vec placements[] = {{0.3, 0.0}, {0.0, -0.5}, {-0.48, 0.64}, {0.7, 0.6}, {1e-3, 2e-3}, {-1e-12, 1e-12}};

}  // namespace

TEST_CASE("at rest in the centre there is no force, the damping is the law's and the stiffness is zero") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    const auto at_rest = exact_force_jacobian<Law>(centre, still);
    CHECK(is_zero(at_rest.force));
    CHECK(at_rest.in_eccentricity() == Matrix2::Zero());
    const Matrix2 expected = damping_at_centre(Law::name);
    CHECK((at_rest.in_velocity() - expected).norm() <= 8 * 0x1p-52 * expected.norm());  // rounding, some operations
  });
}

TEST_CASE("at rest off the centre there is no force and no stiffness, and the damping is the limit b → 0, a → 0+") {
  for_each_film_law([]<class Law>() {
    for (const Vec& e : placements) {
      INFO(Law::name << " at (" << e.x() << ", " << e.y() << ")");
      const auto at_rest = exact_force_jacobian<Law>(e, still);
      CHECK(is_zero(at_rest.force));
      CHECK(at_rest.in_eccentricity() == Matrix2::Zero());
      const Matrix2 turn = frame_of(e);
      const Matrix2 polar = turn.transpose() * at_rest.in_velocity() * turn;
      if (Law::name != "long_dynamic") {
        const Matrix2 expected = damping_at_rest(Law::name, e.norm());
        CHECK((polar - expected).norm() <= 50 * 0x1p-52 * expected.norm());  // rounding; q to a power at ε = 0.92
      }
    }
  });
}

TEST_CASE(
    "at rest the damping of the long dynamic film is the derivative at a > 0, b = 0, by differences in 50 digits") {
  for (const double e : {1e-12, 0.3, 0.8, 0.92}) {
    using Big = Vector2<FiftyDigits>;
    const Big radial(FiftyDigits(e), FiftyDigits(0));
    const Big wedge(FiftyDigits(0), FiftyDigits(-1));
    const auto differences = difference_jacobian<LongDynamic, FiftyDigits>(radial, wedge, FiftyDigits("1e-20"));
    const Matrix2 expected = differences.rightCols<2>().cast<double>();
    const auto at_rest = exact_force_jacobian<LongDynamic>(Vec(e, 0), still);
    INFO("epsilon " << e);
    CHECK((at_rest.in_velocity() - expected).norm() <= 50 * 0x1p-52 * expected.norm());  // rounding of moments
  }
}

TEST_CASE("a film that starts from rest feels the damping of rest: F(e, u) = J u as u → 0 with b = 0, a > 0") {
  for_each_film_law([]<class Law>() {
    for (const Vec& e : placements) {
      INFO(Law::name << " at (" << e.x() << ", " << e.y() << ")");
      const Vec u = -1e-3 * perpendicular(direction(e));
      const auto at_rest = exact_force_jacobian<Law>(e, still);
      const Vec linear = at_rest.in_velocity() * u;
      const Vec force = force_ratio<Law>(FilmState<double>(e, u));
      // Homogeneous along the chosen direction, so no truncation; u is perpendicular to e to rounding alone.
      CHECK((force - linear).norm() <= 100 * 0x1p-52 * linear.norm());
    }
  });
}

TEST_CASE("the Jacobian at |u| = 1e-300 is that at |u| = 1: equal in u, 1e-300 times in e") {
  const double tiny = std::ldexp(1.0, -997);  // 7e-301, a power of two: scaling by it rounds nothing
  const Vec motions[] = {{1, 0}, {0, -1}, {0.6, 0.7}, {-1, 0.25}, {0.3, -0.9}};
  for_each_film_law([&]<class Law>() {
    for (const Vec& e : {centre, Vec(0.3, 0.0), Vec(-0.48, 0.64), Vec(0.7, 0.6), Vec(0.1, 0.2)}) {
      for (const Vec& u : motions) {
        INFO(Law::name << " at (" << e.x() << ", " << e.y() << "), u along (" << u.x() << ", " << u.y() << ")");
        const auto slow = exact_force_jacobian<Law>(e, Vec(tiny * u));
        const auto fast = exact_force_jacobian<Law>(e, u);
        REQUIRE(slow.is_finite());
        const double rounding = 100 * 0x1p-52;  // |u| is formed another way where its square underflows
        CHECK((slow.force / tiny - fast.force).norm() <= rounding * fast.force.norm());
        CHECK((slow.in_velocity() - fast.in_velocity()).norm() <= rounding * fast.in_velocity().norm());
        const Matrix2 stiffness = slow.in_eccentricity() / tiny;
        CHECK((stiffness - fast.in_eccentricity()).norm() <= rounding * fast.jacobian.norm());
      }
    }
  });
}

TEST_CASE("value and Jacobian are finite at every combination of zero, tiny and ordinary e and u") {
  const double denormal = std::numeric_limits<double>::denorm_min();
  const Vec eccentricities[] = {centre, {1e-300, 0}, {0, -1e-300}, {1e-160, 1e-160}, {0.3, -0.4}, {0.9, 0.4}};
  const Vec velocities[] = {still, {1e-300, 0}, {-1e-300, 1e-300}, {0, denormal}, {1, -2}, {1e150, 1e-150}, {0, 1e200}};
  for_each_film_law([&]<class Law>() {
    for (const Vec& e : eccentricities) {
      for (const Vec& u : velocities) {
        INFO(Law::name << " at (" << e.x() << ", " << e.y() << "), (" << u.x() << ", " << u.y() << ")");
        const auto both = exact_force_jacobian<Law>(e, u);
        CHECK(both.force.allFinite());
        CHECK(both.in_velocity().allFinite());
        // At |ê| = 1e-300 a half film's force turns with the direction of ê: its stiffness is |u|/|ê|, out of range.
        const bool representable = Law::extent != FilmExtent::half || is_zero(e) || e.norm() > 1e-100;
        if (representable) CHECK(both.in_eccentricity().allFinite());
      }
    }
  });
}

}  // namespace film_rest_test
