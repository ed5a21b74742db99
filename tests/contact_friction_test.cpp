#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/joint/transition.hpp"

namespace contact_friction_test {

using namespace lubjoint;

namespace {

using Vec = Vector2<double>;

const Bearing<double> bearing(0.04, 0.01, 2e-4);
constexpr double distance_at_contact = 2.01e-4;

/// A journal pressed by 1 µm into the wall in the direction (0.6, 0.8), without a normal rate.
JournalMotion<double> pressed(double along_wall, double bearing_spin, double journal_spin) {
  const Vec r(0.6, 0.8);
  return {Vec(distance_at_contact * r), Vec(along_wall * perpendicular(r)), bearing_spin, journal_spin};
}

ContactForce<double> force_of(const JournalMotion<double>& motion, double friction) {
  return dry_contact_force(motion, bearing, ContactSurface<double>{1e10, 0.9, friction}, 0.1);
}

constexpr double normal = 10;  // 1e10 · (1e-6)^1.5

}  // namespace

TEST_CASE("dry contact: smooth surfaces exert no couple, and no force along the wall") {
  const ContactForce<double> contact = force_of(pressed(0.3, 5, -70), 0);
  CHECK(contact.couple == 0);
  CHECK(std::abs(cross(Vec(0.6, 0.8), contact.force)) < 1e-14 * normal);  // rounding
}

TEST_CASE(
    "dry contact: friction opposes the sliding of one surface on the other, at its coefficient, with its couple") {
  // Relative velocity of the touching points along t: the journal's v_t + ω_J R less the wall's ω_B (|e| + R).
  for (const auto& [motion, direction] :
       {std::pair{pressed(0.5, 0, 0), 1.0}, std::pair{pressed(0, 0, 50), 1.0}, std::pair{pressed(0, 50, 0), -1.0},
        std::pair{pressed(-0.5, 0, 0), -1.0}, std::pair{pressed(0.5, 100, 0), -1.0},
        std::pair{pressed(-0.5, 0, 100), 1.0}}) {
    const ContactForce<double> contact = force_of(motion, 0.1);
    const double along = dot(Vec(perpendicular(Vec(0.6, 0.8))), contact.force);
    INFO("v " << motion.velocity.transpose() << ", spins " << motion.bearing_spin << " and " << motion.journal_spin);
    // Sliding at 0.5 m/s is 500 times slow_sliding: a part of 2e-6 is missing; 10 N has 1e-10 of its depth's rounding.
    CHECK(along == Approx(-0.1 * normal * direction).epsilon(3e-6));
    CHECK(dot(Vec(0.6, 0.8), contact.force) == Approx(-normal).epsilon(1e-9));
    CHECK(contact.couple == Approx(0.01 * along).epsilon(1e-14));  // at the journal's surface
  }
}

TEST_CASE("dry contact: surfaces that roll on each other have no friction") {
  const double bearing_spin = 30;
  const double journal_spin = bearing_spin * (0.01 + distance_at_contact) / 0.01;
  const ContactForce<double> contact = force_of(pressed(0, bearing_spin, journal_spin), 0.1);
  CHECK(std::abs(contact.couple) < 1e-14);  // rounding of 0.3 m/s, over 1e-3 m/s, times 0.01 N m
}

TEST_CASE("dry contact: at slow_sliding, a millimetre a second unless given, friction is its 1/sqrt(2)") {
  const double couple = force_of(pressed(1e-3, 0, 0), 0.1).couple;
  CHECK(couple == Approx(-0.01 * 0.1 * normal / std::sqrt(2.0)).epsilon(1e-9));  // rounding of the depth
}

TEST_CASE("contact phases: named, with the seams at c and c + e0") {
  const TransitionTolerances<double> tolerances(4e-6, 1e-5);
  const auto name = [&](double distance) {
    return std::string(contact_phase_name(contact_phase(distance, 2e-4, tolerances)));
  };
  CHECK(name(0) == "film");
  CHECK(name(2e-4) == "film");
  CHECK(name(2.001e-4) == "blend");
  CHECK(name(2.039e-4) == "blend");
  CHECK(name(2.041e-4) == "dry");
}

}  // namespace contact_friction_test
