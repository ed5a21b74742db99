// The library and the quadrature oracle against the certified golden data, and the checks of the data's own integrity.
#include "support/golden.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/pressure.hpp"
#include "lubjoint/joint/wrench.hpp"
#include "oracle/laws/published_forms.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace golden_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Σ|terms| of both components as published [1/s]: what their rounding is measured in. The dynamic laws have one
/// number a component.
PolarForce<double> term_sizes(const std::string& law, const PolarState& s) {
  using Exact = boost::multiprecision::cpp_bin_float_100;  // the dynamic forms lose 45 digits at 1 − ε = 1e-12
  if (s.slip_rate == 0 && s.squeeze_rate == 0) return {0, 0};
  const auto terms = reports::published_terms<Exact>(law, s.eccentricity_ratio, s.slip_rate, s.squeeze_rate);
  const auto total = [](const std::vector<Exact>& list) {
    Exact sum = 0;
    for (const Exact& term : list) sum += abs(term);
    return static_cast<double>(sum);
  };
  PolarForce<double> sizes{total(terms.radial), total(terms.tangential)};
  if (law.ends_with("dynamic")) sizes.radial = sizes.tangential = std::hypot(sizes.radial, sizes.tangential);
  return sizes;
}

/// The film whose pressure a law of the squeeze alone integrates.
std::string film_at_no_slip(const std::string& law) {
  const std::string limit = law_facts(law).is_short() ? "short" : "long";
  return limit + (law_facts(law).extent == FilmExtent::full ? "_full" : "_dynamic");
}

double size_of(const PolarForce<double>& f) { return std::hypot(f.radial, f.tangential); }

BearingLimit limit_of(const std::string& law) {
  return law_facts(law).limit;
}

}  // namespace

TEST_CASE("golden film forces: every law in double precision, to its rounding") {
  const GoldenTable table("film_force.csv");
  REQUIRE(table.rows() > 4000);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string law = table.text(row, "law");
    const PolarState s = table.polar(row);
    const auto [bearing, oil] = table.bearing(row);
    const PolarForce<double> f = with_film_law<StateFilmLaws>(law, [&, &bearing = bearing, &oil = oil]<class Law>() {
      return film_force<Law>(bearing, oil, PolarFilmState<double>(s.eccentricity_ratio, s.slip_rate, s.squeeze_rate));
    });
    const PolarForce<double> sizes = term_sizes(law, s);
    const double scale = force_scale(limit_of(law), bearing, oil);
    INFO(table.where(row));
    // Rounding, in the terms of the law; the dynamic ones lose a factor of up to 40 in films that open.
    const double allowed = (law.ends_with("dynamic") ? 64 : 32) * rounding * scale;
    CHECK(std::abs(f.radial - table.output(row, "radial")) <= allowed * sizes.radial);
    CHECK(std::abs(f.tangential - table.output(row, "tangential")) <= allowed * sizes.tangential);
  }
}

TEST_CASE("golden film forces: quadrature of the pressure is as close as it says") {
  const GoldenTable table("film_force.csv");
  for (std::size_t row = 0; row < table.rows(); row += 3) {
    const std::string law = table.text(row, "law");
    const PolarState s = table.polar(row);
    const double rate = std::abs(s.slip_rate) + std::abs(s.squeeze_rate);
    if (law == "pinkus_sternlicht" || rate > 1e100 || (rate > 0 && rate < 1e-100)) continue;
    const auto [bearing, oil] = table.bearing(row);
    const bool squeeze_only = law_facts(law).squeeze_only;  // the film of its extent, at a = 0
    const auto film = oracle::one_dimensional_film(squeeze_only ? film_at_no_slip(law) : law);
    const auto f = oracle::film_force_by_quadrature(
        film, bearing, oil,
        PolarFilmState<double>(s.eccentricity_ratio, squeeze_only ? 0.0 : s.slip_rate, s.squeeze_rate));
    const PolarForce<double> exact{table.output(row, "radial"), table.output(row, "tangential")};
    INFO(table.where(row));
    const double reading = 2 * rounding * size_of(exact);  // rounding of the golden value to double
    CHECK(std::abs(f.radial.value - exact.radial) <= f.radial.error + reading);
    CHECK(std::abs(f.tangential.value - exact.tangential) <= f.tangential.error + reading);
  }
}

TEST_CASE("golden film extents: the library's bounds of the film, to rounding") {
  const GoldenTable table("film_extent.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string name = table.text(row, "extent");
    const FilmExtent extent = name == "full"   ? FilmExtent::full
                              : name == "half" ? FilmExtent::half
                                               : FilmExtent::dynamic;
    const PolarFilmState<double> state(0.5, table.number(row, "slip_rate"), table.number(row, "squeeze_rate"));
    const FilmBounds<double> bounds = film_bounds(extent, state);
    const double start = table.output(row, "theta_s");
    INFO(table.where(row));
    CHECK(std::abs(bounds.start - start) <= 4 * rounding * std::abs(start) + 1e-307);  // rounding of atan2, underflow
    CHECK(std::abs(bounds.end - table.output(row, "theta_e")) <= 8 * rounding);        // rounding of θs + π
  }
}

TEST_CASE("golden pressures: the library's fields and the quadrature of the differential equation") {
  const GoldenTable table("film_pressure.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string field = table.text(row, "field");
    const PolarState s = table.polar(row);
    const auto [bearing, oil] = table.bearing(row);
    const double theta = table.number(row, "theta");
    const double z = table.number(row, "z");
    const double exact = table.output(row, "pressure");
    INFO(table.where(row));
    const auto pressure = [&, &bearing = bearing, &oil = oil](double a, double b) {
      const PolarFilmState<double> state(s.eccentricity_ratio, a, b);
      return field == "short" ? short_bearing_pressure(bearing, oil, state, theta, z)
                              : long_bearing_pressure(bearing, oil, state, theta);
    };
    if (field == "short" || field == "long_eq5") {
      // Rounding of the terms; θ and z are exact, and so is 1 + ε cosθ in half the angle.
      const double size = std::abs(pressure(s.slip_rate, 0)) + std::abs(pressure(0, s.squeeze_rate));
      CHECK(std::abs(pressure(s.slip_rate, s.squeeze_rate) - exact) <= 32 * rounding * size);
    } else {
      const PolarFilmState<double> state(s.eccentricity_ratio, s.slip_rate, s.squeeze_rate);
      const auto film = oracle::one_dimensional_film(field);
      const oracle::Estimate p = oracle::film_pressure_by_quadrature(film, bearing, oil, state, theta);
      CHECK(std::abs(p.value - exact) <= p.error + 4 * rounding * std::abs(exact));  // the oracle's own estimate
    }
  }
}

TEST_CASE("golden wrenches: force and moments on both bodies from absolute motions") {
  const GoldenTable table("joint_wrench.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string law = table.text(row, "law");
    const auto [bearing, oil] = table.bearing(row);
    const JournalMotion<double> motion = table.motion(row);
    const FilmState<double> film = film_state(motion, bearing.clearance());
    const Vector2<double> e = motion.eccentricity;
    const PolarState s = polar_in_extended(motion, bearing.clearance());
    // At a = 0 but for rounding a half film is on either side of its jump.
    const double rate = std::abs(s.slip_rate) + std::abs(s.squeeze_rate);
    if (law.find("half") != std::string::npos && std::abs(s.slip_rate) < 1e-13 * rate) continue;
    const Vector2<double> force = with_film_law<StateFilmLaws>(
        law, [&, &bearing = bearing, &oil = oil]<class Law>() { return film_force<Law>(bearing, oil, film); });
    JointKinematics<double> joint{{table.number(row, "sx_i"), table.number(row, "sy_i")},
                                  {table.number(row, "sx_j"), table.number(row, "sy_j")},
                                  motion};
    const JointWrenches<double> wrenches = joint_wrenches(joint, force);
    // Rounding of ê, u and q before the law: relative 1/(1 − ε) in q, and u in the sizes of its parts.
    const double spins = std::abs(motion.bearing_spin) + std::abs(motion.journal_spin);
    const double parts = motion.velocity.norm() / bearing.clearance() + spins * s.eccentricity_ratio;
    const double q = 1 - s.eccentricity_ratio;
    const double size = size_of(term_sizes(law, {s.eccentricity_ratio, parts, parts}));
    const double allowed = 16 * rounding * force_scale(limit_of(law), bearing, oil) * size / q;
    INFO(table.where(row));
    CHECK(std::abs(wrenches.journal.force.x() - table.output(row, "fx")) <= allowed);
    CHECK(std::abs(wrenches.journal.force.y() - table.output(row, "fy")) <= allowed);
    CHECK(wrenches.bearing.force == Vector2<double>(-wrenches.journal.force));
    const double arm_i = (joint.bearing_arm.norm() + e.norm()) * 2;
    const double arm_j = joint.journal_arm.norm() * 2;
    CHECK(std::abs(wrenches.bearing.moment - table.output(row, "mz_bearing")) <= allowed * arm_i);
    CHECK(std::abs(wrenches.journal.moment - table.output(row, "mz_journal")) <= allowed * arm_j);
  }
}

TEST_CASE("golden equilibria: the library's laws balance the load there") {
  const GoldenTable table("equilibrium.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string law = table.text(row, "law");
    const auto [bearing, oil] = table.bearing(row);
    const double half_spin = table.number(row, "omega_sum") / 2;
    const double ratio = table.output(row, "eccentricity_ratio");
    const Vector2<double> e(table.output(row, "ex_over_c"), table.output(row, "ey_over_c"));
    const Vector2<double> u(half_spin * e.y(), -half_spin * e.x());
    const Vector2<double> load(table.number(row, "load_x"), table.number(row, "load_y"));
    const Vector2<double> force = with_film_law<StateFilmLaws>(law, [&, &bearing = bearing, &oil = oil]<class Law>() {
      return film_force<Law>(bearing, oil, FilmState<double>(e, u));
    });
    INFO(table.where(row));
    const double allowed = 64 * rounding * load.norm() / (1 - ratio);  // rounding of ε, against 1 − ε
    CHECK((force + load).norm() <= allowed);
    // From the load to e, in the sense of the spin.
    const double turn = std::atan2(cross(load, e), dot(load, e)) * (half_spin > 0 ? 1 : -1);
    CHECK(std::abs(turn - table.output(row, "attitude")) <= 8 * rounding);  // rounding of two angles
  }
}

}  // namespace golden_test
