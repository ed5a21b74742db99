#include "lubjoint/joint/touching_journal.hpp"

#include <catch2/catch.hpp>

#include "lubjoint/film/law_list.hpp"

namespace touching_journal_test {

using namespace lubjoint;

namespace {

const Bearing<double> bearing(0.04, 0.01, 2e-4);
const Lubricant<double> oil(0.4);
const TransitionTolerances<double> tolerances(4e-6, 1e-5);
const ContactSurface<double> surface{1e10, 0.9};
constexpr double impact_speed = 0.1;

JournalMotion<double> motion_at(double distance) { return {{0.6 * distance, 0.8 * distance}, {0.03, -0.02}, 5, -70}; }

template <class Law>
Vector2<double> force_at(double distance) {
  return touching_journal_force<Law>(bearing, oil, tolerances, surface, motion_at(distance), impact_speed);
}

}  // namespace

TEST_CASE("transition: the force is continuous at both seams, for every law") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    for (const double seam : {2e-4, 2.04e-4}) {
      const Vector2<double> inside = force_at<Law>(seam * (1 - 1e-12));
      const Vector2<double> outside = force_at<Law>(seam * (1 + 1e-12));
      // continuity: the slope times 2e-12 of the way, at most 1e12 N/m here
      CHECK((inside - outside).norm() <= 1e-6 * (1 + inside.norm()));
    }
  });
}

TEST_CASE("transition: inside the clearance it is the film in the clearance c + e1, beyond the blend the contact") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const Bearing<double> wide(bearing.length(), bearing.radius(), bearing.clearance() + tolerances.e1);
    const auto inside = motion_at(1.3e-4);
    CHECK(force_at<Law>(1.3e-4) == film_force<Law>(wide, oil, film_state(inside, wide.clearance())));
    const auto outside = motion_at(2.2e-4);
    CHECK(force_at<Law>(2.2e-4) == dry_contact_force(outside, bearing, surface, impact_speed).force);
    CHECK(force_at<Law>(0.1).allFinite());
  });
}

TEST_CASE("dry contact: it never pulls, is nothing without penetration, and is Hertz's where the rate is zero") {
  const auto normal = [](double depth, double rate) {
    const JournalMotion<double> motion{{2e-4 + depth, 0}, {rate, 0}, 0, 0};
    return -dry_contact_force(motion, bearing, surface, impact_speed).force.x();
  };
  CHECK(normal(-1e-6, 1) == 0);
  CHECK(normal(0, 1) == 0);
  CHECK(normal(1e-6, -100) == 0);
  // depth is a difference of lengths near 2e-4: a rounding of 200 units of it
  CHECK(normal(1e-6, 0) == Approx(10).epsilon(1e-12));
  // at the impact's own speed the damping adds 3(1 − c_r²)/4
  CHECK(normal(1e-6, impact_speed) == Approx(10 * (1 + 0.75 * 0.19)).epsilon(1e-12));
}

TEST_CASE("dry contact: the stiffness is that of a sphere in a spherical seat") {
  // 4/3 √(R_B R_J/c) E/(2(1 − ν²)) for equal materials
  const double expected = 4.0 / 3 * std::sqrt(0.0102 * 0.01 / 2e-4) * 207e9 / (2 * (1 - 0.09));
  const Elasticity<double> steel{207e9, 0.3};
  CHECK(contact_stiffness(0.01, 2e-4, steel, steel) == Approx(expected).epsilon(1e-14));  // rounding
}

TEST_CASE("transition and contact: parameters that can't be are refused by name") {
  using Catch::Contains;
  CHECK_THROWS_WITH(TransitionTolerances<double>(2e-6, 1e-6), Contains("e0") && Contains("e0 < e1"));
  CHECK_THROWS_WITH(TransitionTolerances<double>(-1, 1e-6), Contains("e0 is -1"));
  CHECK_THROWS_WITH(require_contact(ContactSurface<double>{1e10, 1.5}, 0.1), Contains("restitution is 1.5"));
  CHECK_THROWS_WITH(require_contact(ContactSurface<double>{0, 0.5}, 0.1), Contains("contact_stiffness"));
  CHECK_THROWS_WITH(require_contact(ContactSurface<double>{1, 0.5}, 0.0), Contains("impact_speed"));
}

}  // namespace touching_journal_test
