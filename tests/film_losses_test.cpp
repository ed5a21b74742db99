// Friction torque, power and side flow of the film, against published-style check values and against quadrature of the
// wall shear and the dissipation.
#include "oracle/reynolds/film_losses.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/film_reference.hpp"

namespace film_losses_test {

using namespace lubjoint;
using namespace lubjoint::oracle;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// μ = ¼ Pa s, L = R = ½ m, c = 2⁻¹⁰ m: every input is exact.
const Bearing<FiftyDigits> dyadic_bearing(FiftyDigits(0.5), FiftyDigits(0.5), FiftyDigits(0x1p-10));
const Lubricant<FiftyDigits> dyadic_oil(FiftyDigits(0.25));

template <FilmLaw Law>
FilmLosses<FiftyDigits> dyadic_losses(double ratio, double vx, double vy, double journal, double bearing) {
  const FiftyDigits c = dyadic_bearing.clearance();
  const JournalMotion<FiftyDigits> motion{Vector2<FiftyDigits>(c * ratio, FiftyDigits(0)),
                                          Vector2<FiftyDigits>(FiftyDigits(vx), FiftyDigits(vy)), FiftyDigits(bearing),
                                          FiftyDigits(journal)};
  return film_losses<Law>(dyadic_bearing, dyadic_oil, film_state(motion, c), FiftyDigits(journal - bearing));
}

/// Is the value the one whose digits are given, to half a unit of the last of 17?
bool has_digits(const FiftyDigits& value, const char* digits) {
  const FiftyDigits given(digits);
  return abs(value - given) <= abs(given) * FiftyDigits("1e-16");  // 17 digits: half a unit is at most 5e-17
}

}  // namespace

TEST_CASE("losses: check values of five states, all digits") {
  const auto first = dyadic_losses<ShortDynamic>(0.25, 0x1p-10, 0x1p-9, 8, -2);
  CHECK(has_digits(first.force.x(), "-55433.048428614145"));
  CHECK(has_digits(first.force.y(), "-42594.809183926523"));
  CHECK(has_digits(first.torque_journal, "-566.79221868427224"));
  CHECK(has_digits(first.torque_bearing, "577.19134202019181"));
  CHECK(has_digits(first.power(), "5826.0472565579866"));
  const auto longer = dyadic_losses<LongDynamic>(0.25, 0x1p-10, 0x1p-9, 8, -2);
  CHECK(has_digits(longer.torque_journal, "-519.40758563692678"));
  CHECK(has_digits(longer.torque_bearing, "624.57597506753726"));
  CHECK(has_digits(longer.power(), "6687.7622664185738"));
  const auto half = dyadic_losses<ShortHalf>(0.5, 0, 0, 8, 0);
  CHECK(has_digits(half.torque_journal, "-483.67983046245809"));
  CHECK(has_digits(half.torque_bearing, "444.98544402546145"));
  CHECK(has_digits(half.power(), "3869.4386436996647"));
  const auto full = dyadic_losses<LongFull>(0.5, 0, 0, 8, 0);
  CHECK(has_digits(full.torque_journal, "-1238.2203659838927"));
  CHECK(has_digits(full.torque_bearing, "619.11018299194636"));
  CHECK(has_digits(full.power(), "9905.7629278711418"));
  const auto turning = dyadic_losses<ShortDynamic>(0.90625, 0x1p-10, 0, 2, 2);
  CHECK(has_digits(turning.torque_journal, "-499.78272292706243"));
  CHECK(has_digits(turning.torque_bearing, "-499.78272292706243"));
  CHECK(has_digits(turning.power(), "11904.433657913556"));
}

TEST_CASE("side flow: check values, zero of the full film, and none of a long one") {
  const FiftyDigits c = dyadic_bearing.clearance();
  const auto flow = [&]<FilmLaw Law>(double ratio, double vx, double vy, double spins) {
    const JournalMotion<FiftyDigits> motion{Vector2<FiftyDigits>(c * ratio, FiftyDigits(0)),
                                            Vector2<FiftyDigits>(FiftyDigits(vx), FiftyDigits(vy)), FiftyDigits(0),
                                            FiftyDigits(spins)};
    return side_flow<Law>(dyadic_bearing, film_state(motion, c));
  };
  CHECK(has_digits(*flow.operator()<ShortDynamic>(0.25, 0x1p-10, 0x1p-9, 6), "7.8163137663975204e-4"));
  CHECK(*flow.operator()<ShortHalf>(0.5, 0, 0, 8) == FiftyDigits(0x1p-10));
  CHECK(*flow.operator()<ShortFull>(0.5, 0, 0, 8) == 0);
  CHECK(*flow.operator()<ShortDynamic>(0.5, 0, 0, 0) == 0);
  CHECK_FALSE(flow.operator()<LongFull>(0.5, 0, 0, 8).has_value());
  CHECK_FALSE(flow.operator()<LongDynamic>(0.5, 0, 0, 8).has_value());
  CHECK_FALSE(flow.operator()<PinkusSternlicht>(0.5, 0, 0, 8).has_value());
}

TEST_CASE("losses: torques, power and flow agree to 1e-12 with quadrature of wall shear, dissipation and axial flow") {
  for (const OneDimensionalFilmEntry& film : one_dimensional_films) {
    with_film_law(film.name, [&]<class Law>() {
      std::mt19937_64 draw(20090612);
      std::uniform_real_distribution<double> part(-1, 1);
      double worst = 0;
      for (int n = 0; n < 400; ++n) {
        const double ratio = n % 4 == 0 ? 1 - std::pow(10, -3 * std::abs(part(draw))) : std::abs(part(draw));
        const double a = n % 10 == 0 ? 0 : 100 * part(draw);
        const double b = n % 7 == 0 ? 0 : 60 * part(draw);
        const double spin = n % 11 == 0 ? 0 : 120 * part(draw);
        const PolarFilmState<double> state(ratio, a, b);
        const FilmLosses<double> losses = film_losses<Law>(bearing, oil, state.in_own_frame(), spin);
        const FilmLossEstimate wall = film_losses_by_quadrature(film.film, bearing, oil, state, spin);
        // Couette and pressure torque may cancel: 1e-12 is of the terms.
        const double moment = std::abs(bearing.clearance() * ratio * losses.force.y());
        const double torques = std::abs(losses.torque_bearing - losses.torque_journal) / 2 + moment;
        const double powers = losses.power();
        const auto near = [&](double value, const Estimate& estimate, double size) {
          if (size > 0) worst = std::max(worst, std::abs(value - estimate.value) / size);
          return std::abs(value - estimate.value) <= std::max(1e-12 * size, estimate.error);
        };
        INFO(film.name << ": eps " << ratio << ", a " << a << ", b " << b << ", omega " << spin);
        CHECK(near(losses.torque_journal, wall.torque_journal, torques));
        CHECK(near(losses.torque_bearing, wall.torque_bearing, torques));
        CHECK(near(losses.couette_power, wall.couette_power, powers));
        if (film.film != OneDimensionalFilm::long_half_eq5) {
          CHECK(near(losses.pressure_power, wall.pressure_power, powers));
        }
        const std::optional<double> flow = side_flow<Law>(bearing, state.in_own_frame());
        REQUIRE(flow.has_value() == wall.side_flow.has_value());
        const double flow_size =
            bearing.clearance() * bearing.radius() * bearing.length() * (std::abs(a) + std::abs(b));
        if (flow) CHECK(near(*flow, *wall.side_flow, flow_size));
      }
      INFO(film.name << ": worst " << worst);
      CHECK(worst < 1e-11);  // where the oracle's own estimate was the larger
    });
  }
}

TEST_CASE("losses: the film cut at π, whose pressure is not zero there, dissipates something else than its power") {
  const PolarFilmState<double> state(0.5, 10, 20);
  const FilmLosses<double> losses = film_losses<LongHalfEq5>(bearing, oil, state.in_own_frame(), 30.0);
  const FilmLossEstimate wall = film_losses_by_quadrature(OneDimensionalFilm::long_half_eq5, bearing, oil, state, 30.0);
  CHECK(std::abs(losses.pressure_power - wall.pressure_power.value) > 0.01 * losses.pressure_power);
}

TEST_CASE("losses: a concentric full film costs Petroff's power, and without relative spin both torques are equal") {
  const double omega = 52;
  const auto at_rest = FilmState<double>(Vector2<double>(0, 0), Vector2<double>(0, 0));
  const double petroff = 2 * std::numbers::pi * oil.viscosity() * omega * std::pow(bearing.radius(), 3) *
                         bearing.length() / bearing.clearance();
  const FilmLosses<double> losses = film_losses<ShortFull>(bearing, oil, at_rest, omega);
  CHECK(losses.torque_bearing == Approx(petroff).epsilon(1e-14));  // rounding of six factors
  CHECK(losses.torque_journal == -losses.torque_bearing);
  CHECK(losses.power() == Approx(omega * petroff).epsilon(1e-14));
  const FilmLosses<double> still =
      film_losses<ShortHalf>(bearing, oil, FilmState<double>(Vector2<double>(0.3, 0.2), Vector2<double>(1, 7)), 0.0);
  CHECK(still.torque_journal == still.torque_bearing);
  CHECK(still.torque_journal != 0);
}

TEST_CASE("losses: flooded and striated shear are what their gaps hold, striated for half films alone") {
  const FilmState<double> film(Vector2<double>(0.6, 0), Vector2<double>(0, -3));
  const double pi_over_root = std::numbers::pi / 0.8;
  CHECK(couette_integral<LongHalf>(film, ShearExtent::film) == Approx(pi_over_root).epsilon(1e-15));
  CHECK(couette_integral<LongHalf>(film, ShearExtent::flooded) == Approx(2 * pi_over_root).epsilon(1e-15));
  // π/√q + (1 − ε)π/q^{3/2}
  CHECK(couette_integral<LongHalf>(film, ShearExtent::striated) ==
        Approx(pi_over_root + 0.4 * std::numbers::pi / 0.512).epsilon(1e-15));
  CHECK(couette_integral<LongDynamic>(film, ShearExtent::flooded) == Approx(2 * pi_over_root).epsilon(1e-15));
  CHECK_THROWS_WITH((film_losses<LongDynamic>(bearing, oil, film, 3.0, ShearExtent::striated)),
                    Contains("striated") && Contains("long_dynamic") && Contains("half film"));
  CHECK_THROWS_WITH(shear_extent("wet"), Contains("\"wet\"") && Contains("film, flooded, striated"));
  CHECK(shear_extent("striated") == ShearExtent::striated);
}

TEST_CASE("losses: exact derivatives pass through torques and power") {
  using D = Dual<double, 1>;
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const double step = 1e-6;
    const auto at = [](const auto& x) {
      using T = std::decay_t<decltype(x)>;
      return FilmState<T>(Vector2<T>(T(0.3) + x, T(0.4)), Vector2<T>(T(2.0) - x, T(-1.0)));
    };
    const auto exact = film_losses<Law>(bearing, oil, at(D::variable(0, 0)), D(40.0));
    const auto more = film_losses<Law>(bearing, oil, at(step), 40.0);
    const auto less = film_losses<Law>(bearing, oil, at(-step), 40.0);
    // Central differences: step² of the third derivative, and rounding over the step.
    CHECK(exact.torque_journal.derivatives()(0) ==
          Approx((more.torque_journal - less.torque_journal) / (2 * step)).epsilon(1e-7));
    CHECK(exact.power().derivatives()(0) == Approx((more.power() - less.power()) / (2 * step)).epsilon(1e-7));
  });
}

}  // namespace film_losses_test
