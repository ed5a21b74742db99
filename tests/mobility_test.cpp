#include "lubjoint/film/mobility.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "lubjoint/film/squeeze_long.hpp"
#include "lubjoint/film/squeeze_short_full.hpp"
#include "support/film_reference.hpp"
#include "support/printed_value.hpp"

namespace mobility_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using oracle::FilmForceEstimate;
using oracle::OneDimensionalFilm;
using Vec = Vector2<double>;
using Vec50 = Vector2<FiftyDigits>;

namespace {

/// Random places and directions: ε to 0.98, or 1 − ε down to `nearest`.
class Places {
 public:
  explicit Places(double nearest) : nearest_(nearest) {}
  Vec eccentricity() {
    const double epsilon =
        nearest_ > 0 ? 1 - std::pow(10, -2 + (2 + std::log10(nearest_)) * part()) : 0.98 * std::sqrt(part());
    return epsilon * direction_at();
  }
  Vec direction_at() {
    const double angle = 2 * std::numbers::pi * part();
    return Vec(std::cos(angle), std::sin(angle));
  }

 private:
  double part() { return std::uniform_real_distribution<double>(0, 1)(generator_); }
  double nearest_;
  std::mt19937_64 generator_{1965};
};

template <class R>
R q_of(const Vector2<R>& e) {
  return one_minus_squared_norm<R>(e.x(), e.y());
}

template <FilmLaw Law, class R>
Vector2<R> ratio(const Vector2<R>& e, const Vector2<R>& u) {
  return force_ratio<Law>(FilmState<R>(e, u));
}

Vec50 wide(const Vec& v) { return Vec50(FiftyDigits(v.x()), FiftyDigits(v.y())); }

/// Quadrature of the law's pressure at a state, over S, in the frame of ê.
Vec by_quadrature(std::string_view law, BearingLimit limit, const Vec& e, const Vec& u) {
  const PolarView<double> view = polar_view(FilmState<double>(e, u));
  for (const auto& film : oracle::one_dimensional_films) {
    if (film.name != law) continue;
    const FilmForceEstimate f = film_force_by_quadrature(film.film, bearing, oil, view.state);
    const double scale = force_scale(limit, bearing, oil);
    return (f.radial.value * view.radial + f.tangential.value * perpendicular(view.radial)) / scale;
  }
  throw std::logic_error("no film of that name");
}

}  // namespace

TEST_CASE("M(F(u)) is u to 1e-12 over random states with ε ≤ 0.98; half films: one of the velocities is") {
  for_each_film_law([]<class Law>() {
    Places random(0);
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec e = random.eccentricity();
      const Vec u = random.direction_at();
      const Mobility<double> m = mobility<Law>(e, q_of(e), ratio<Law>(e, u));
      REQUIRE(m.velocity);
      double apart = (*m.velocity - u).norm();
      if (m.other) apart = std::min(apart, (*m.other - u).norm());
      worst = std::max(worst, apart);
      if (Law::extent != FilmExtent::half) CHECK(m.status == MobilityStatus::found);
    }
    INFO(Law::name << ": " << worst);
    CHECK(worst <= 1e-12);  // what is promised; the film's condition, about 6/q = 150, times rounding
  });
}

TEST_CASE("M(F(u)) is u to 1e-38 in fifty digits, and to 1e-36 at 1 - ε from 1e-2 to 1e-12") {
  for_each_film_law([]<class Law>() {
    for (const double nearest : {0.0, 1e-12}) {
      Places random(nearest);
      double worst = 0;
      for (int i = 0; i < 100; ++i) {
        const Vec50 e = wide(random.eccentricity());
        const Vec50 u = wide(random.direction_at());
        const Mobility<FiftyDigits> m = mobility<Law>(e, q_of(e), ratio<Law>(e, u));
        REQUIRE(m.velocity);
        double apart = static_cast<double>((*m.velocity - u).norm());
        if (m.other) apart = std::min(apart, static_cast<double>((*m.other - u).norm()));
        worst = std::max(worst, apart);
      }
      INFO(Law::name << ": " << worst);
      CHECK(worst <= (nearest > 0 ? 1e-36 : 1e-45));  // 50 digits, less the film's condition: 6/q, 6e12 at the wall
    }
  });
}

TEST_CASE("the force at M(F) is F by quadrature of the pressure: to 1e-12, and to 1e-10 at 1 - ε down to 1e-9") {
  for_each_film_law([]<class Law>() {
    if constexpr (!std::is_same_v<Law, PinkusSternlicht>) {  // has no pressure field
      for (const double nearest : {0.0, 1e-9}) {
        Places random(nearest);
        double worst = 0;
        for (int i = 0; i < 300; ++i) {
          const Vec e = random.eccentricity();
          const Vec force = ratio<Law>(e, random.direction_at());
          const Mobility<double> m = mobility<Law>(e, q_of(e), force);
          REQUIRE(m.velocity);
          for (const auto& u : {m.velocity, m.other}) {
            if (u) worst = std::max(worst, (by_quadrature(Law::name, Law::limit, e, *u) - force).norm() / force.norm());
          }
        }
        INFO(Law::name << ", nearest " << nearest << ": " << worst);
        CHECK(worst <= (nearest > 0 ? 1e-10 : 1e-12));  // promised of law and quadrature; rounding of u times 1/√q
      }
    }
  });
}

TEST_CASE("the mobility of a film is linear in the force's size from 1e-300 to 1e300, and 0 for no force") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    const Vec e(0.375, -0.25);
    const Vec force = ratio<Law>(e, Vec(0.75, -0.5));
    const Vec u = *mobility<Law>(e, q_of(e), force).velocity;
    for (const int power : {-990, -500, 500, 990}) {
      const Vec scaled(std::ldexp(force.x(), power), std::ldexp(force.y(), power));
      const Vec found = *mobility<Law>(e, q_of(e), scaled).velocity;
      CHECK(std::ldexp(found.x(), -power) == Approx(u.x()).epsilon(1e-14));  // rounding of |F|
      CHECK(std::ldexp(found.y(), -power) == Approx(u.y()).epsilon(1e-14));  // the same
    }
    const Mobility<double> none = mobility<Law>(e, q_of(e), Vec(0, 0));
    CHECK(none.status == MobilityStatus::found);
    CHECK(*none.velocity == Vec(0, 0));
  });
}

TEST_CASE("at the centre every law has one velocity for a force; short_dynamic -2F/π") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    const Vec e(0, 0);
    const Vec force(-3, 4);
    const Mobility<double> m = mobility<Law>(e, 1.0, force);
    REQUIRE(m.status == MobilityStatus::found);
    CHECK((ratio<Law>(e, *m.velocity) - force).norm() <= 1e-14 * 5);  // rounding
  });
  const Vec u = *mobility<ShortDynamic>(Vec(0, 0), 1.0, Vec(-3, 4)).velocity;
  CHECK((u - Vec(6, -8) / std::numbers::pi).norm() <= 1e-15 * 10);  // rounding
}

TEST_CASE("half films: of the directions of force at ε = 1/2 11.2 % have no velocity and 11.2 % two (short half)") {
  const auto share = []<class Law>() {
    std::array<double, 3> counts{};
    constexpr int directions = 20000;
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
      const Mobility<double> m = mobility<Law>(Vec(0.5, 0), 0.75, Vec(std::cos(angle), std::sin(angle)));
      counts[static_cast<std::size_t>(m.status)] += 100.0 / directions;
      CHECK(m.velocity.has_value() == (m.status != MobilityStatus::none));
      CHECK(m.other.has_value() == (m.status == MobilityStatus::two));
      if (m.other) CHECK(m.velocity->x() < 0);  // b < 0
    }
    return counts;
  };
  const auto counts = share.operator()<ShortHalf>();
  CHECK(counts[1] == Approx(11.2).margin(0.05));  // the digit printed
  CHECK(counts[2] == Approx(11.2).margin(0.05));  // the same
  for (const auto& other : {share.operator()<LongHalf>(), share.operator()<LongHalfEq5>()}) {
    CHECK(other[1] > 5);
    CHECK(other[2] == Approx(other[1]).margin(0.02));  // F(−b) mirrors the gap of forces into the doubled ones
  }
}

TEST_CASE(
    "half films without a velocity: the force lies inside the jump at a = 0, and both of two velocities carry it") {
  for (int i = 0; i < 720; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / 720;
    const Vec force(std::cos(angle), std::sin(angle));
    const Mobility<double> m = mobility<ShortHalf>(Vec(0.5, 0), 0.75, force);
    if (m.status == MobilityStatus::none) {
      // Slides along a = 0: F_r fixes b, and |F_t| is less than what either side gives there.
      const PolarForce<double> unit =
          ShortHalf::force_ratio(PolarFilmState<double>(0.5, 0, 1), HalfFilmSide::converging);
      CHECK(std::abs(force.y()) < std::abs(unit.tangential * force.x() / unit.radial));
      CHECK(force.x() < 0);  // b > 0
    }
    for (const auto& u : {m.velocity, m.other}) {
      if (u) CHECK((ratio<ShortHalf>(Vec(0.5, 0), *u) - force).norm() <= 1e-14);  // rounding
    }
  }
}

TEST_CASE("squeeze-only laws: many velocities carry a force along ê, none carries any other") {
  const Vec e(0.3, 0.4);
  const auto check = [&]<class Law>() {
    INFO(Law::name);
    const Mobility<double> m = mobility<Law>(e, q_of(e), Vec(-3, -4));
    REQUIRE(m.status == MobilityStatus::many);
    CHECK((ratio<Law>(e, *m.velocity) - Vec(-3, -4)).norm() <= 1e-14 * 5);  // rounding
    CHECK(std::abs(cross(*m.velocity, e)) <= 1e-15 * m.velocity->norm());   // the smallest of them lies along ê
    CHECK((ratio<Law>(e, Vec(*m.velocity + 7 * perpendicular(e))) - Vec(-3, -4)).norm() <=
          1e-13 * 5);  // so does another
    CHECK(mobility<Law>(e, q_of(e), Vec(-3, -4.000001)).status == MobilityStatus::none);
    CHECK(mobility<Law>(e, q_of(e), Vec(0, 0)).status == MobilityStatus::many);
    CHECK(mobility<Law>(Vec(0, 0), 1.0, Vec(1, 2)).status == MobilityStatus::found);
  };
  check.operator()<SqueezeLong>();
  check.operator()<SqueezeShortFull>();
}

TEST_CASE("Booker's closed form is exact at the centre and off by the published share elsewhere") {
  // M∥ = (1 − ξ)^{5/2}/π, M⊥ = −4η(1 − ξ)^{3/2}/π², u = |F|/2 M over S: velocity vector and angle, all directions.
  struct Row {
    double epsilon, velocity, degrees;
  };
  for (const Row& row : {Row{0.1, 0.5, 0.03}, Row{0.3, 1.5, 0.3}, Row{0.5, 2.6, 0.85}, Row{0.7, 4.3, 1.7},
                         Row{0.9, 7.5, 3.2}, Row{0.99, 10.3, 4.5}}) {
    double velocity = 0;
    double degrees = 0;
    for (int i = 0; i < 7200; ++i) {
      const double angle = 2 * std::numbers::pi * i / 7200;
      const Vec load(1, 0);
      const Vec e(row.epsilon * std::cos(angle), row.epsilon * std::sin(angle));
      const double room = 1 - e.x();
      const Vec booker = Vec(std::pow(room, 2.5) / std::numbers::pi,
                             -4 * e.y() * std::pow(room, 1.5) / (std::numbers::pi * std::numbers::pi));
      const Vec exact = *mobility<ShortDynamic>(e, q_of(e), Vec(-load)).velocity;
      const Vec unit = 2 * booker;  // F = S|u| … against 2μRL(R/c)²: at ê = 0 both are 2/π
      velocity = std::max(velocity, 100 * (unit - exact).norm() / exact.norm());
      degrees = std::max(degrees, 180 / std::numbers::pi * std::abs(std::atan2(cross(unit, exact), unit.dot(exact))));
    }
    INFO("ε " << row.epsilon << ": " << velocity << " %, " << degrees << "°");
    CHECK(velocity == Approx(row.velocity).epsilon(0.03).margin(0.05));  // the digits printed
    CHECK(degrees == Approx(row.degrees).epsilon(0.03).margin(0.05));    // the same
  }
}

TEST_CASE("mobility names what it can't answer") {
  CHECK_THROWS_WITH(mobility<ShortDynamic>(Vec(1, 0), 0.0, Vec(1, 0)),
                    Contains("no mobility at eccentricity (1, 0)") && Contains("[0, 1)"));
  CHECK_THROWS_AS(mobility<LongFull>(Vec(0, 0), 1.0, Vec(std::nan(""), 0)), FilmDomainError);
}

TEST_CASE("a bearing's mobility is that of the force over its scale") {
  const Vec e(0.25, -0.5);
  const Vec force(120, -35);
  const double scale = force_scale(BearingLimit::short_bearing, bearing, oil);
  const Vec u = *mobility<ShortDynamic>(bearing, oil, e, force).velocity;
  CHECK((film_force<ShortDynamic>(bearing, oil, FilmState<double>(e, u)) - force).norm() <=
        1e-12 * force.norm());  // M∘F
  CHECK(u == *mobility<ShortDynamic>(e, q_of(e), Vec(force / scale)).velocity);
}

}  // namespace mobility_test
