// The transition and dry contact in the golden data, against their formulas in double precision.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "lubjoint/film/every_law.hpp"
#include "support/golden.hpp"

namespace golden_contact_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// |e| − c without cancellation: (|e|² − c²)/(|e| + c).
double penetration(const Vector2<double>& e, double c) {
  return (one_minus_squared_norm<double>(e.x() / c, e.y() / c)) * -c / (e.norm() / c + 1);
}

struct DryForce {
  Vector2<double> force;
  double rounding;  ///< what the rounding of the penetration does to it [N]
};

DryForce dry_force(const GoldenTable& table, std::size_t row) {
  const Vector2<double> e(table.number(row, "ex"), table.number(row, "ey"));
  const Vector2<double> v(table.number(row, "vx"), table.number(row, "vy"));
  const double c = table.number(row, "clearance");
  const double depth = penetration(e, c);
  if (depth <= 0) return {{0, 0}, 0};
  const double c_r = table.number(row, "restitution");
  const Vector2<double> r = e / e.norm();
  const double bracket = 1 + 3 * (1 - c_r * c_r) / 4 * v.dot(r) / table.number(row, "impact_speed");
  if (bracket <= 0) return {{0, 0}, 0};
  const double stiffness = table.number(row, "contact_stiffness") * bracket;
  return {-stiffness * std::pow(depth, 1.5) * r, 1.5 * stiffness * std::sqrt(depth) * 4 * rounding * c};
}

}  // namespace

TEST_CASE("golden dry contact: Lankarani and Nikravesh's force, and no adhesion") {
  const GoldenTable table("dry_contact.csv");
  int pressed = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const DryForce dry = dry_force(table, row);
    const Vector2<double> exact(table.output(row, "fx"), table.output(row, "fy"));
    INFO(table.where(row));
    CHECK((dry.force - exact).norm() <= dry.rounding + 32 * rounding * exact.norm());  // rounding
    CHECK(exact.x() * table.number(row, "ex") + exact.y() * table.number(row, "ey") <= 0);
    pressed += exact.norm() > 0;
  }
  CHECK(pressed > 20);
}

TEST_CASE("golden transition: the film in the clearance c + e1, dry contact, and their blend between the seams") {
  const GoldenTable table("transition.csv");
  int regimes[3] = {0, 0, 0};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string law = table.text(row, "law");
    const auto [bearing, oil] = table.bearing(row);
    const JournalMotion<double> motion = table.motion(row);
    const double c = bearing.clearance();
    const double e0 = table.number(row, "e0");
    const double depth = penetration(motion.eccentricity, c);
    const double share = std::clamp(depth / e0, 0.0, 1.0);  // of dry contact
    ++regimes[share <= 0 ? 0 : share < 1 ? 1 : 2];
    Vector2<double> film(0, 0);
    double conditioning = 0;
    if (share < 1) {
      const Bearing<double> wider(bearing.length(), bearing.radius(), c + table.number(row, "e1"));
      const FilmState<double> state = film_state(motion, wider.clearance());
      conditioning = 1 / state.q;
      film = with_film_law<StateFilmLaws>(law, [&, &oil = oil]<class Law>() { return film_force<Law>(wider, oil, state); });
    }
    const DryForce dry = dry_force(table, row);
    const Vector2<double> force = (1 - share) * film + share * dry.force;
    const Vector2<double> exact(table.output(row, "fx"), table.output(row, "fy"));
    INFO(table.where(row));
    // Rounding: of the film's state against 1 − ε, of the penetration, and of the share.
    const double allowed = 64 * rounding * (film.norm() * conditioning + dry.force.norm()) + dry.rounding +
                           4 * rounding * c / e0 * (film.norm() + dry.force.norm());
    CHECK((force - exact).norm() <= allowed);
  }
  for (const int count : regimes) CHECK(count > 90);
}

TEST_CASE("golden contact stiffness: Hertz's cylinder of Lankarani and Nikravesh") {
  const GoldenTable table("contact_stiffness.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double radius = table.number(row, "radius");
    const double clearance = table.number(row, "clearance");
    const auto compliance = [&](const std::string& side) {
      const double nu = table.number(row, "poisson_" + side);
      return (1 - nu * nu) / table.number(row, "modulus_" + side);
    };
    const double stiffness = 4.0 / 3 * std::sqrt((radius + clearance) * radius / clearance) /
                             (compliance("bearing") + compliance("journal"));
    CHECK(stiffness == Approx(table.output(row, "contact_stiffness")).epsilon(16 * rounding));  // rounding
  }
}

TEST_CASE("golden exit speeds: the energy that an impact leaves, whatever the stiffness") {
  const GoldenTable table("contact_exit_speed.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double speed = table.number(row, "impact_speed");
    const double c_r = table.number(row, "restitution");
    const double exit = table.output(row, "exit_speed");
    const double d = 3 * (1 - c_r * c_r) / (4 * speed);
    const double in = d * speed - std::log1p(d * speed);
    const double out = -d * exit - std::log1p(-d * exit);
    INFO(table.where(row));
    CHECK(std::abs(in - out) <= 8 * rounding * d * speed);  // rounding of terms of the size d δ̇₀
    CHECK(exit < speed);
    CHECK(exit > c_r * speed * (1 - 8 * rounding));  // the law loses less than its coefficient says
  }
}

}  // namespace golden_contact_test
