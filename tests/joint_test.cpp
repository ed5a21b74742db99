#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"

namespace joint_test {

using namespace lubjoint;

namespace {

using Vec = Vector2<double>;

struct Pair {
  PlanarMotion<double> bearing_body;
  Vec bearing_centre;
  PlanarMotion<double> journal_body;
  Vec journal_centre;
};

/// Two bodies of the size of a crank drive, anywhere, in any motion.
std::vector<Pair> pairs() {
  std::mt19937_64 random(20090331);
  const auto part = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
  const auto body = [&] {
    return PlanarMotion<double>{Vec(part(1), part(1)), part(10), Vec(part(5), part(5)), part(500)};
  };
  std::vector<Pair> all;
  for (int i = 0; i < 100; ++i) {
    all.push_back({body(), Vec(part(0.2), part(0.2)), body(), Vec(part(0.2), part(0.2))});
  }
  return all;
}

JointKinematics<double> kinematics_of(const Pair& p) {
  return joint_kinematics(p.bearing_body, p.bearing_centre, p.journal_body, p.journal_centre);
}

/// Moment of a wrench, whose force acts at its body's mass centre, about a point.
double moment_about(const Vec& point, const PlanarMotion<double>& body, const Wrench<double>& wrench) {
  return wrench.moment + cross(Vec(body.position - point), wrench.force);
}

}  // namespace

TEST_CASE("joint: centres, e and v of a crank and a rod in a hand-drawn position") {
  // The bearing's body lies along y after a quarter turn; the journal's body does not turn.
  const PlanarMotion<double> bearing_body{Vec(1, 2), std::numbers::pi / 2, Vec(0.5, 0), 3};
  const PlanarMotion<double> journal_body{Vec(1, 2.5), 0, Vec(0, -1), 10};
  const auto joint = joint_kinematics(bearing_body, Vec(0.25, 0), journal_body, Vec(0.001, -0.25));
  CHECK((joint.bearing_arm - Vec(0, 0.25)).norm() <= 1e-16);  // rounding of the quarter turn
  CHECK((joint.journal_arm - Vec(0.001, -0.25)).norm() == 0);
  CHECK((joint.motion.eccentricity - Vec(0.001, 0)).norm() <= 1e-16);  // rounding
  // Ṗ_j = (0, −1) + 10 (0.25, 0.001), Ṗ_i = (0.5, 0) + 3 (−0.25, 0)
  CHECK((joint.motion.velocity - Vec(2.5 + 0.25, -0.99)).norm() <= 1e-15);  // rounding
  CHECK(joint.motion.bearing_spin == 3);
  CHECK(joint.motion.journal_spin == 10);
}

TEST_CASE("joint: v is the time derivative of e, by automatic differentiation of the position") {
  using InTime = Dual<double, 1>;
  const auto moving = [](double value, double rate) { return InTime(value, Eigen::Matrix<double, 1, 1>(rate)); };
  const auto in_time = [&](const PlanarMotion<double>& b) {
    return PlanarMotion<InTime>{
        Vector2<InTime>(moving(b.position.x(), b.velocity.x()), moving(b.position.y(), b.velocity.y())),
        moving(b.angle, b.spin), Vector2<InTime>(moving(b.velocity.x(), 0), moving(b.velocity.y(), 0)),
        moving(b.spin, 0)};
  };
  for (const Pair& p : pairs()) {
    const auto joint =
        joint_kinematics(in_time(p.bearing_body), p.bearing_centre, in_time(p.journal_body), p.journal_centre);
    const Vector2<InTime>& e = joint.motion.eccentricity;
    const Vec rate(e.x().derivatives()(0), e.y().derivatives()(0));
    const Vec v(joint.motion.velocity.x().value(), joint.motion.velocity.y().value());
    CHECK((rate - v).norm() <= 1e-13);  // rounding of speeds up to 150 m/s
  }
}

TEST_CASE("joint: v is the central difference of e as the bodies move on") {
  const double h = 1e-6;
  for (const Pair& p : pairs()) {
    const auto eccentricity_at = [&](double t) {
      Pair moved = p;
      for (PlanarMotion<double>* body : {&moved.bearing_body, &moved.journal_body}) {
        body->position += t * body->velocity;
        body->angle += t * body->spin;
      }
      return kinematics_of(moved).motion.eccentricity;
    };
    const Vec difference = (eccentricity_at(h) - eccentricity_at(-h)) / (2 * h);
    // h²/6 ω³ s ≤ 1e-12/6 · 500³ · 0.3 · 2 = 1.3e-5, and rounding of positions over h
    CHECK((difference - kinematics_of(p).motion.velocity).norm() <= 2e-5);
  }
}

TEST_CASE("joint: e is exact to rounding of the positions although e is a thousandth of them") {
  const double c = 2e-4;
  PlanarMotion<double> bearing_body{Vec(0, 0), 0, Vec(0, 0), 0};
  PlanarMotion<double> journal_body{Vec(0.5 + 0x1p-14, 0.25), 0, Vec(0, 0), 0};
  const auto joint = joint_kinematics(bearing_body, Vec(0.5, 0.25), journal_body, Vec(0, 0));
  CHECK(joint.motion.eccentricity.x() == 0x1p-14);  // all sums are exact
  CHECK(film_state(joint.motion, c).eccentricity.x() == 0x1p-14 / c);
}

TEST_CASE("joint: the pair of wrenches has no resultant and no moment about any point") {
  const Vec points[] = {{0, 0}, {1, -2}, {-30, 7}};
  for (const Pair& p : pairs()) {
    const auto joint = kinematics_of(p);
    const Vec force(3000 * std::sin(joint.motion.velocity.x()), -2000 * std::cos(joint.motion.velocity.y()));
    const JointWrenches<double> w = joint_wrenches(joint, force);
    CHECK(w.bearing.force == -w.journal.force);
    for (const Vec& point : points) {
      const double total =
          moment_about(point, p.bearing_body, w.bearing) + moment_about(point, p.journal_body, w.journal);
      const double scale = force.norm() * (point.norm() + 3);  // arms reach 3 m beyond the point's own
      CHECK(std::abs(total) <= 8 * 0x1p-52 * scale);           // rounding of the products
    }
  }
}

TEST_CASE("joint: the bearing's body feels the transport moment m_T = e_x F_y - e_y F_x against it") {
  for (const Pair& p : pairs()) {
    const auto joint = kinematics_of(p);
    const Vec force(120, -75);
    const Vec& e = joint.motion.eccentricity;
    const JointWrenches<double> w = joint_wrenches(joint, force);
    const double transport = e.x() * force.y() - e.y() * force.x();
    const double without = -cross(joint.bearing_arm, force);
    CHECK(std::abs(w.bearing.moment - (without - transport)) <= 16 * 0x1p-52 * force.norm() * 3);  // rounding
    CHECK(std::abs(transport) > 1e-3);  // large enough to be missed
    CHECK(w.journal.moment == cross(joint.journal_arm, force));
  }
}

TEST_CASE("joint: the force of a lubricated joint is the law's on the film state of its motion") {
  const Bearing<double> bearing(0.04, 0.0098, 0.0002);
  const Lubricant<double> oil(0.4);
  const JournalMotion<double> motion{Vec(0.8e-4, -1e-4), Vec(2e-3, 1e-3), 5, 50};
  const FilmState<double> film = film_state(motion, bearing.clearance());
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const LubricatedJoint<Law, double> joint(bearing, oil);
    CHECK(joint.force(film) == film_force<Law>(bearing, oil, film));
    if constexpr (PolarLaw<Law>) {
      const HalfFilmSide here = side_of(film);
      const HalfFilmSide other = here == HalfFilmSide::mirrored ? HalfFilmSide::converging : HalfFilmSide::mirrored;
      CHECK(joint.force(film, here) == joint.force(film));
      CHECK(joint.force(film, other) != joint.force(film));
      const FilmState<double> rest(film.eccentricity, Vec(0, 0));
      CHECK(is_zero(joint.force(rest, other)));
    }
  });
}

}  // namespace joint_test
