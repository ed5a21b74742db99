// The library's losses, stiffness and damping against the certified golden data.
#include <catch2/catch.hpp>

#include "lubjoint/film/coefficients.hpp"
#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/golden.hpp"

namespace golden_losses_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// Is an output the value, to its 30 digits? One that is not defined is empty.
bool has_output(const GoldenTable& table, std::size_t row, const std::string& column,
                const std::optional<Exact>& value) {
  const std::string text = table.text(row, column);
  const std::string uncertainty = table.text(row, column + "_uncertainty");
  if (!value || text.empty()) return !value && text.empty() && uncertainty.empty();
  // The uncertainty, and the rounding of a hundred digits where the output is exact.
  return abs(*value - Exact(text)) <= Exact(uncertainty) + Exact("1e-60") * abs(*value) + Exact("1e-90");
}

Bearing<Exact> exact_bearing(const GoldenTable& table, std::size_t row) {
  return {Exact(table.number(row, "length")), Exact(table.number(row, "radius")),
          Exact(table.number(row, "clearance"))};
}

}  // namespace

TEST_CASE("golden losses: torques, power and side flow of every law, all 30 digits") {
  const GoldenTable table("film_losses.csv");
  REQUIRE(table.rows() == 1080);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Bearing<Exact> bearing = exact_bearing(table, row);
    const Lubricant<Exact> oil(Exact(table.number(row, "viscosity")));
    const JournalMotion<double> given = table.motion(row);
    const JournalMotion<Exact> motion{given.eccentricity.cast<Exact>(), given.velocity.cast<Exact>(),
                                      Exact(given.bearing_spin), Exact(given.journal_spin)};
    with_film_law<StateFilmLaws>(table.text(row, "law"), [&]<class Law>() {
      INFO("row " << row + 1 << " " << Law::name);
      const FilmState<Exact> film = film_state(motion, bearing.clearance());
      const auto losses = film_losses<Law>(bearing, oil, film, Exact(motion.journal_spin - motion.bearing_spin));
      CHECK(has_output(table, row, "torque_journal", losses.torque_journal));
      CHECK(has_output(table, row, "torque_bearing", losses.torque_bearing));
      CHECK(has_output(table, row, "power", losses.power()));
      CHECK(has_output(table, row, "side_flow", side_flow<Law>(bearing, film)));
      CHECK_FALSE(has_output(table, row, "power", losses.power() * Exact("1.000000000000000001") + 1));
    });
  }
}

TEST_CASE("golden coefficients: load, attitude, stiffness, damping and thresholds of every law, all 30 digits") {
  const GoldenTable table("coefficients.csv");
  REQUIRE(table.rows() == 528);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    with_film_law(table.text(row, "law"), [&]<class Law>() {
      INFO("row " << row + 1 << " " << Law::name);
      const Exact omega(table.number(row, "omega"));
      const auto rest =
          steady_film<Law>(exact_bearing(table, row), Lubricant<Exact>(Exact(table.number(row, "viscosity"))),
                           SteadyPlace<Exact>(Exact(table.number(row, "eccentricity_ratio"))), omega);
      CHECK(has_output(table, row, "load", rest.load));
      CHECK(has_output(table, row, "attitude", rest.attitude));
      const char* const names[] = {"xx", "xy", "yx", "yy"};
      for (int i = 0; i < 4; ++i) {
        CHECK(has_output(table, row, std::string("k") + names[i], rest.stiffness(i / 2, i % 2)));
        CHECK(has_output(table, row, std::string("c") + names[i], rest.damping(i / 2, i % 2)));
      }
      const RotorThreshold<Exact>& threshold = rest.threshold;
      const bool there = threshold.critical_mass > 0 && !threshold.always_stable();
      const auto when_there = [&](const Exact& value) { return there ? std::optional<Exact>(value) : std::nullopt; };
      CHECK(has_output(table, row, "critical_mass", when_there(threshold.critical_mass)));
      CHECK(
          has_output(table, row, "whirl_ratio", when_there(threshold.whirl_frequency.value_or(Exact(0)) / abs(omega))));
    });
  }
}

}  // namespace golden_losses_test
