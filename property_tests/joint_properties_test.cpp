#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"
#include "support/law_property.hpp"

namespace joint_properties_test {

using namespace lubjoint;
using generate::Vec;

namespace {

constexpr double rounding = 0x1p-52;
const Bearing<double> bearing(0.04, 0.0098, generate::joint_clearance);
const Lubricant<double> oil(0.04);

template <FilmLaw Law>
Vec force_of(const JointKinematics<double>& joint) {
  return LubricatedJoint<Law, double>(bearing, oil).force(film_state(joint.motion, bearing.clearance()));
}

double moment_about(const Vec& point, const PlanarMotion<double>& body, const Wrench<double>& wrench) {
  return wrench.moment + cross(Vec(body.position - point), wrench.force);
}

/// The mistake: relative spin ω_J − ω_B in place of the frame of γ̇, which is inertial here.
PolarFilmState<double> state_with_relative_spin(const JournalMotion<double>& m) {
  const Vec r = direction(m.eccentricity);
  const double epsilon = m.eccentricity.norm() / bearing.clearance();
  const double gamma_rate = m.velocity.dot(perpendicular(r)) / m.eccentricity.norm();
  return {epsilon, epsilon * (m.journal_spin - m.bearing_spin - 2 * gamma_rate),
          m.velocity.dot(r) / bearing.clearance()};
}

}  // namespace

TEST_CASE("a joint's wrenches have no resultant and no moment about any point, whatever the joint and its film") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("ΣF = 0, ΣM = 0"), [] {
      const generate::JointedPair pair = *generate::jointed_pair();
      const Vec point(*generate::uniform(-10, 10), *generate::uniform(-10, 10));
      const JointKinematics<double> joint = pair.kinematics();
      const Vec force = force_of<Law>(joint);
      const JointWrenches<double> w = joint_wrenches(joint, force);
      RC_ASSERT(is_zero(Vec(w.bearing.force + w.journal.force)));
      const double moment =
          moment_about(point, pair.bearing_body, w.bearing) + moment_about(point, pair.journal_body, w.journal);
      RC_ASSERT(std::abs(moment) <= 8 * rounding * force.norm() * (point.norm() + 3));  // products of arms and force
    });
  });
}

TEST_CASE("without the transport moment two free bodies would gain angular momentum: counterexample") {
  const JointKinematics<double> joint{Vec(0.1, 0), Vec(-0.1, 0), {Vec(1e-4, 0), Vec(0, 1), 0, 50}};
  const Vec force(0, 1000);
  const JointWrenches<double> w = joint_wrenches(joint, force);
  const double naive = cross(joint.bearing_arm, w.bearing.force);  // −F moved to the bearing's centre, without e × F
  CHECK(w.bearing.moment - naive == Approx(-0.1).epsilon(1e-12));  // rounding
}

TEST_CASE("two free bodies joined by a film alone keep their linear and angular momentum") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("d/dt Σ m v = 0, d/dt Σ (r × m v + I ω) = 0"), [] {
      const generate::JointedPair pair = *generate::jointed_pair();
      const double mass_i = *generate::log_uniform(-2, 1);
      const double mass_j = *generate::log_uniform(-2, 1);
      const double inertia_i = *generate::log_uniform(-5, -1);
      const double inertia_j = *generate::log_uniform(-5, -1);
      const JointKinematics<double> joint = pair.kinematics();
      const JointWrenches<double> w = joint_wrenches(joint, force_of<Law>(joint));
      // Newton and Euler for each body, and from their accelerations the rates of the totals.
      const Vec acceleration_i = w.bearing.force / mass_i;
      const Vec acceleration_j = w.journal.force / mass_j;
      const double turning_i = w.bearing.moment / inertia_i;
      const double turning_j = w.journal.moment / inertia_j;
      const double scale = w.journal.force.norm();
      RC_ASSERT((mass_i * acceleration_i + mass_j * acceleration_j).norm() <= 4 * rounding * scale);  // quotients
      const double angular = mass_i * cross(pair.bearing_body.position, acceleration_i) + inertia_i * turning_i +
                             mass_j * cross(pair.journal_body.position, acceleration_j) + inertia_j * turning_j;
      RC_ASSERT(std::abs(angular) <= 16 * rounding * scale * 3);  // the same, arms below 3 m
    });
  });
}

TEST_CASE("a rotation of the whole system, with a spin, turns the film's force with it and changes nothing else") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F(rotated) = Q F, moments equal"), [] {
      const generate::JointedPair pair = *generate::jointed_pair();
      const generate::Rotation by = *generate::rotation();
      const generate::JointedPair moved = rotated(pair, by);
      const JointKinematics<double> here = pair.kinematics();
      const JointKinematics<double> there = moved.kinematics();
      if (Law::extent == FilmExtent::half) {  // not on the jump, nor so near that rounding crosses it
        const FilmState<double> film = film_state(here.motion, bearing.clearance());
        const double sine = cross(direction(film.eccentricity), direction(film.velocity));
        RC_PRE(std::abs(sine) > 1e-6);
      }
      const Vec force = force_of<Law>(here);
      const Vec seen = force_of<Law>(there);
      // Positions of 1 m round e, which is 2e-6 m at least, to 1e-10; laws magnify that by 2.5/q at most, and the
      // velocity's rounding, of 300 m/s over differences of some m/s, likewise.
      const double allowed = 1e-7 * force.norm();
      RC_ASSERT((seen - generate::turned(force, by.turn)).norm() <= allowed);
      const JointWrenches<double> w = joint_wrenches(here, force);
      const JointWrenches<double> w_seen = joint_wrenches(there, seen);
      RC_ASSERT(std::abs(w_seen.bearing.moment - w.bearing.moment) <= allowed);
      RC_ASSERT(std::abs(w_seen.journal.moment - w.journal.moment) <= allowed);
    });
  });
}

TEST_CASE("relative spin with an inertial γ̇ makes the force depend on the observer: wrong by -2εΩ in a") {
  rc::prop("a(rotated) - a = -2εΩ", [] {
    const generate::JointedPair pair = *generate::jointed_pair();
    const generate::Rotation by = *generate::rotation();
    const PolarFilmState<double> here = state_with_relative_spin(pair.kinematics().motion);
    const PolarFilmState<double> there = state_with_relative_spin(rotated(pair, by).kinematics().motion);
    const double error = -2 * here.eccentricity_ratio * by.spin;
    const double speed = pair.kinematics().motion.velocity.norm() / bearing.clearance();
    // Rounding of e, of which r is made, to 1e-10 of itself, and of velocities of 300 m/s, over the clearance.
    RC_ASSERT(std::abs(there.slip_rate - here.slip_rate - error) <= 1e-9 * (speed + 1e6));
  });
  // Counterexample in numbers: a journal that turns with its bearing, seen from the ground and from a turntable.
  const JournalMotion<double> still{Vec(1e-4, 0), Vec(0, 0), 0, 0};
  const JournalMotion<double> turning{Vec(1e-4, 0), Vec(0, 100 * 1e-4), 100, 100};
  CHECK(state_with_relative_spin(still).slip_rate == 0);
  CHECK(state_with_relative_spin(turning).slip_rate == Approx(-100).epsilon(1e-12));  // rounding; nothing slips
  CHECK(is_zero(film_state(still, bearing.clearance()).velocity));
  const FilmState<double> rigid = film_state(turning, bearing.clearance());
  CHECK(rigid.velocity.norm() <= 1e-13);  // rounding of 50 1/s
}

}  // namespace joint_properties_test
