#include <catch2/catch.hpp>
#include <random>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/film_reference.hpp"
#include "support/printed_value.hpp"

namespace squeeze_film_test {

using namespace lubjoint;
using namespace lubjoint::test;
using oracle::FilmForceEstimate;
using oracle::OneDimensionalFilm;

namespace {

template <FilmLaw Law, class R>
R radial(const R& epsilon, const R& b, const R& a = R(0)) {
  const PolarForce<R> f = polar_force_ratio<Law>(PolarFilmState<R>(epsilon, a, b));
  REQUIRE(f.tangential == 0);
  return f.radial;
}

/// The film whose pressure, at a = 0, is the squeeze law's: the oracle integrates it.
template <class Law>
constexpr OneDimensionalFilm film_of = OneDimensionalFilm::short_full;
template <>
constexpr OneDimensionalFilm film_of<SqueezeLongFull> = OneDimensionalFilm::long_full;
template <>
constexpr OneDimensionalFilm film_of<SqueezeShort> = OneDimensionalFilm::short_dynamic;
template <>
constexpr OneDimensionalFilm film_of<SqueezeLong> = OneDimensionalFilm::long_dynamic;

}  // namespace

TEST_CASE("squeeze laws: F_r/S has every printed digit of the reference at ε = 0.5 and 0.9375") {
  using F = FiftyDigits;
  const auto right = [](const F& value, const char* printed) {
    INFO(printed);
    CHECK(units_of_last_digit(value, printed) <= 0.51);  // the digits there, rounded
  };
  right(radial<SqueezeLongFull>(F(0.5), F(1)), "-58.041579655494971");
  right(radial<SqueezeLong>(F(0.5), F(1)), "-46.694386436996647");
  right(radial<SqueezeLong>(F(0.5), F(-1)), "11.347193218498324");
  right(radial<SqueezeShort>(F(0.5), F(1)), "-9.1157310728327746");
  right(radial<SqueezeShort>(F(0.5), F(-1)), "0.55786553641638729");
  right(radial<SqueezeLong>(F(0.9375), F(1)), "-886.32934154261166");
  right(radial<SqueezeLong>(F(0.9375), F(-1)), "8.3110994336870293");
  right(radial<SqueezeShort>(F(0.9375), F(1)), "-1697.6035352932361");
  right(radial<SqueezeShort>(F(0.9375), F(-1)), "0.28934462414796420");
}

TEST_CASE("squeeze laws equal the quadrature of their pressure to 1e-12, from ε = 0 to 1 - 1e-12") {
  for_each_film_law<SqueezeFilmLaws>([]<class Law>() {
    double worst = 0;
    for (int k = 0; k <= 48; ++k) {
      for (const double epsilon : {k / 49.0, 1 - std::pow(10, -0.25 * k)}) {
        for (const double b : {1.0, -1.0}) {
          const PolarFilmState<double> state(epsilon, 0, b);
          const FilmForceEstimate integral = film_force_by_quadrature(film_of<Law>, bearing, oil, state);
          const PolarForce<double> law = film_force<Law>(bearing, oil, state);
          worst = std::max(worst, std::abs(law.radial / integral.radial.value - 1));
          CHECK(law.tangential == 0);
          CHECK(std::abs(integral.tangential.value) <= 1e-12 * std::abs(integral.radial.value));  // of the quadrature
        }
      }
    }
    INFO(Law::name << ": " << worst);
    CHECK(worst <= 1e-12);  // what is promised; measured 4e-15
  });
}

TEST_CASE("squeeze laws in double are right to 70 roundings at every ε up to 1 - 1e-12, opening films included") {
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> part(0, 1);
  for_each_film_law<SqueezeFilmLaws>([&]<class Law>() {
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const double epsilon = i % 2 == 0 ? part(generator) : 1 - std::pow(10, -12 * part(generator));
      const double b = i % 4 < 2 ? 1 : -1;
      const FiftyDigits exact = radial<Law>(FiftyDigits(epsilon), FiftyDigits(b));
      worst = std::max(worst, static_cast<double>(abs(radial<Law>(epsilon, b) / exact - 1)));
    }
    INFO(Law::name << ": " << worst);
    CHECK(worst <= 70 * 0x1p-53);  // three roundings of terms that are 22 times the film's resistance (short, q = ½)
  });
}

TEST_CASE("squeeze films that open keep a finite resistance at the wall: 8 long, 4/15 short") {
  const double gap = 1e-12;
  CHECK(radial<SqueezeLong>(1 - gap, -1.0) == Approx(8).epsilon(1e-11));          // the gap itself
  CHECK(radial<SqueezeShort>(1 - gap, -1.0) == Approx(4.0 / 15).epsilon(1e-11));  // likewise
}

TEST_CASE("squeeze laws do not see the wedge: force, shear, power and side flow are those of a = 0") {
  for_each_film_law<SqueezeFilmLaws>([]<class Law>() {
    INFO(Law::name);
    static_assert(SqueezeOnlyLaw<Law>);
    for (const double b : {0.5, -0.25}) {
      CHECK(radial<Law>(0.625, b, 3.0) == radial<Law>(0.625, b));
      const Vector2<double> e(0.375, 0.5);  // |ê| = 0.625, r = (0.6, 0.8)
      const auto film = [&](double u_t) {
        const Vector2<double> r = direction(e);
        return FilmState<double>(e, Vector2<double>(b * r + u_t * perpendicular(r)));
      };
      const auto with = film_losses<Law>(bearing, oil, film(2), 8.0);
      const auto without = film_losses<Law>(bearing, oil, film(0), 8.0);
      const double rounding = 1e-14;  // of r, and of b from u
      CHECK((with.force - without.force).norm() <= rounding * without.force.norm());
      CHECK(with.torque_journal == Approx(without.torque_journal).epsilon(rounding));
      CHECK(with.power() == Approx(without.power()).epsilon(rounding));
      const auto flow_with = side_flow<Law>(bearing, film(2));
      const auto flow_without = side_flow<Law>(bearing, film(0));
      REQUIRE(flow_with.has_value() == flow_without.has_value());
      if (flow_with) CHECK(*flow_with == Approx(*flow_without).epsilon(rounding).margin(0));
    }
  });
}

TEST_CASE("the closing and the opening squeeze film together are the full one, and each is the dynamic film at a = 0") {
  for (int k = 0; k < 20; ++k) {
    const FiftyDigits epsilon = FiftyDigits(k) / 20;
    const FiftyDigits one(1);
    const auto small = [](const FiftyDigits& x, const FiftyDigits& of) {
      CHECK(static_cast<double>(abs(x)) <= 1e-45 * static_cast<double>(abs(of)));  // 50 digits, less 5 for cancellation
    };
    const FiftyDigits long_full = radial<SqueezeLongFull>(epsilon, one);
    const FiftyDigits short_full = radial<SqueezeShortFull>(epsilon, one);
    small(radial<SqueezeLong>(epsilon, one) - radial<SqueezeLong>(epsilon, FiftyDigits(-1)) - long_full, long_full);
    small(radial<SqueezeShort>(epsilon, one) - radial<SqueezeShort>(epsilon, FiftyDigits(-1)) - short_full, short_full);
    for (const int b : {1, -1}) {
      const PolarFilmState<FiftyDigits> state(epsilon, FiftyDigits(0), FiftyDigits(b));
      const FiftyDigits l = polar_force_ratio<LongDynamic>(state).radial;
      const FiftyDigits s = polar_force_ratio<ShortDynamic>(state).radial;
      small(radial<SqueezeLong>(epsilon, FiftyDigits(b)) - l, l);
      small(radial<SqueezeShort>(epsilon, FiftyDigits(b)) - s, s);
    }
  }
}

}  // namespace squeeze_film_test
