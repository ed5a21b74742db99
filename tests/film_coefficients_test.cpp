// Stiffness, damping and thresholds of stability, against published values, each other and the eigenvalues.
#include <boost/math/tools/roots.hpp>
#include <catch2/catch.hpp>

#include "lubjoint/film/coefficients.hpp"
#include "lubjoint/film/rotor_modes.hpp"
#include "lubjoint/film/steady_place.hpp"
#include "support/film_reference.hpp"

namespace film_coefficients_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// The steady film of a bearing of μ = ¼, L = R = ½, c = 2⁻¹⁰, ω = 8, in 50 digits.
template <FilmLaw Law>
SteadyFilm<FiftyDigits> dyadic(const FiftyDigits& ratio, double spin = 8) {
  const Bearing<FiftyDigits> bearing(FiftyDigits(0.5), FiftyDigits(0.5), FiftyDigits(0x1p-10));
  return steady_film<Law>(bearing, Lubricant<FiftyDigits>(FiftyDigits(0.25)), SteadyPlace<FiftyDigits>(ratio),
                          FiftyDigits(spin));
}

/// Dimensionless: cK/W, cωC/W, mcω²/W.
struct Dimensionless {
  Eigen::Matrix<FiftyDigits, 2, 2> k, c;
  FiftyDigits mass;

  explicit Dimensionless(const SteadyFilm<FiftyDigits>& film) {
    const FiftyDigits clearance(0x1p-10);
    const FiftyDigits spin = abs(film.spin);
    k = film.stiffness * FiftyDigits(clearance / film.load);
    c = film.damping * FiftyDigits(clearance * spin / film.load);
    mass = film.threshold.critical_mass * clearance * spin * spin / film.load;
  }
};

/// The value's digits are those given, to a unit of the last.
bool has_digits(const FiftyDigits& value, const char* digits) {
  std::string text = digits;
  const std::size_t point = text.find('.');
  const FiftyDigits unit = pow(FiftyDigits(10), -static_cast<int>(text.size() - point - 1));
  return abs(value - FiftyDigits(digits)) <= unit;
}

}  // namespace

TEST_CASE("coefficients: check values at ε = ½, all digits") {
  const Dimensionless half(dyadic<ShortHalf>(0.5));
  CHECK(has_digits(half.k(0, 0), "2.9232504981753439929"));
  CHECK(has_digits(half.k(0, 1), "3.9766424213158496574"));
  CHECK(has_digits(half.k(1, 0), "-0.85769951026357551193"));
  CHECK(has_digits(half.k(1, 1), "2.2099437483396459288"));
  CHECK(has_digits(half.c(0, 0), "6.6147597222359980632"));
  CHECK(has_digits(half.c(0, 1), "2.244955497755921797"));
  CHECK(has_digits(half.c(1, 0), "2.244955497755921797"));
  CHECK(has_digits(half.c(1, 1), "3.0539241409228522755"));
  CHECK(has_digits(half.mass, "6.4603957523295151749"));
  const Dimensionless dynamic(dyadic<LongDynamic>(0.5));
  CHECK(has_digits(dynamic.c(0, 0), "4.867516054556102346"));
  CHECK(has_digits(dynamic.c(0, 1), "1.6484245684560456171"));
  CHECK(has_digits(dynamic.c(1, 0), "1.4950967738267082111"));
  CHECK(has_digits(dynamic.c(1, 1), "4.0677083667532703285"));
  CHECK(has_digits(dynamic.mass, "5.232115959906921292"));
  CHECK(has_digits(Dimensionless(dyadic<LongHalf>(0.5)).mass, "1.4526541111752446407"));
}

TEST_CASE("coefficients: closed forms and exact derivatives agree to 1e-12 for every law and both spins") {
  for_each_film_law([&]<class Law>() {
    REQUIRE(HasClosedCoefficients<Law>);
    for (const double ratio : {1e-12, 1e-6, 0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.9999, 1 - 1e-9}) {
      for (const int sign : {1, -1}) {
        INFO(Law::name << ", eps " << ratio << ", spin " << sign);
        const SteadyPlace<double> place(ratio);
        const auto closed = coefficient_ratios<Law>(place, sign);
        const auto differentiated = differentiated_coefficients<Law>(place, sign);
        CHECK(coefficient_difference(closed, differentiated) < 1e-12);
        auto wrong = closed;
        wrong.damping(1, 0) += 1e-9 * wrong.damping.norm();
        CHECK(coefficient_difference(wrong, differentiated) > 1e-12);
      }
    }
  });
}

TEST_CASE("coefficients: differences of the force itself in 50 digits give the same stiffness and damping") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const FiftyDigits ratio(0.375);
    const FiftyDigits step("1e-15");
    for (const int sign : {1, -1}) {
      const auto exact = coefficient_ratios<Law>(SteadyPlace<FiftyDigits>(ratio), sign);
      const auto force = [&](int variable, const FiftyDigits& by) {
        Vector2<FiftyDigits> e(ratio, FiftyDigits(0));
        Vector2<FiftyDigits> v(FiftyDigits(0), FiftyDigits(0));
        (variable < 2 ? e : v)(variable % 2) += by;
        const FiftyDigits half = FiftyDigits(sign) / 2;
        return force_ratio<Law>(
            FilmState<FiftyDigits>(e, Vector2<FiftyDigits>(v.x() + half * e.y(), v.y() - half * e.x())));
      };
      for (int variable = 0; variable < 4; ++variable) {
        const Vector2<FiftyDigits> more = force(variable, step);
        const Vector2<FiftyDigits> less = force(variable, -step);
        const auto& matrix = variable < 2 ? exact.stiffness : exact.damping;
        for (int i = 0; i < 2; ++i) {
          const FiftyDigits slope = (less(i) - more(i)) / (2 * step);
          // The difference is right to step²; Pinkus-Sternlicht is only once differentiable: to step.
          const FiftyDigits error = abs(slope - matrix(i, variable % 2)) / matrix.cwiseAbs().maxCoeff();
          CHECK(error < FiftyDigits("1e-13"));
        }
      }
    }
  });
}

TEST_CASE("coefficients: Friswell's short bearing, as published to all its digits") {
  const Bearing<double> bearing(0.03, 0.05, 1e-4);
  const Lubricant<double> oil(0.1);
  const double spin = 157.1;
  const double scale = force_scale(BearingLimit::short_bearing, bearing, oil);
  const auto place = steady_place<ShortHalf>(525 / (scale * spin));
  REQUIRE(place.has_value());
  const SteadyFilm<double> film = steady_film<ShortHalf>(bearing, oil, *place, spin);
  const auto published = [](double value, double digits) {
    return Approx(value).margin(0.5000001 * digits).epsilon(0);
  };
  CHECK(place->eccentricity_ratio == published(0.266272, 1e-6));
  CHECK(film.attitude * 180 / std::numbers::pi == published(70.622, 1e-3));
  CHECK(film.load == Approx(525).epsilon(1e-13));  // root of |F| = W, to rounding
  CHECK(film.stiffness(0, 0) == published(8.81487e6, 10));
  CHECK(film.stiffness(0, 1) == published(25.06177e6, 10));
  CHECK(film.stiffness(1, 0) == published(-16.39580e6, 10));
  CHECK(film.stiffness(1, 1) == published(12.80806e6, 10));
  CHECK(film.damping(0, 0) == published(294.893e3, 1));
  CHECK(film.damping(0, 1) == published(81.914e3, 1));
  CHECK(film.damping(1, 0) == published(81.914e3, 1));
  CHECK(film.damping(1, 1) == published(232.893e3, 1));
  CHECK(film.threshold.critical_mass == published(1472.87, 1e-2));
  REQUIRE(film.threshold.whirl_frequency.has_value());
  CHECK(*film.threshold.whirl_frequency / spin == published(0.5166, 1e-4));
  const RotorThreshold<double> other = eigenvalue_threshold<double>(film.stiffness, film.damping, 100.0, spin);
  CHECK(other.critical_mass == Approx(film.threshold.critical_mass).epsilon(1e-10));
}

TEST_CASE("coefficients: the short half film's published closed form in load axes is the same matrix") {
  const FiftyDigits pi2 = pi<FiftyDigits>() * pi<FiftyDigits>();
  for (const double given : {0.05, 0.266272, 0.5, 0.8, 0.95}) {
    INFO(given);
    const FiftyDigits e(given);
    const Dimensionless film(dyadic<ShortHalf>(e));
    const FiftyDigits q = 1 - e * e;
    const FiftyDigits h0 = pow(FiftyDigits(pi2 * q + 16 * e * e), FiftyDigits(-1.5));
    const FiftyDigits root = sqrt(q);
    // Friswell, Penny, Garvey, Lees: u along the load turned by 90°, v against it.
    const FiftyDigits auu = h0 * 4 * (pi2 * (2 - e * e) + 16 * e * e);
    const FiftyDigits auv = h0 * pi<FiftyDigits>() * (pi2 * q * q - 16 * pow(e, 4)) / (e * root);
    const FiftyDigits avu =
        -h0 * pi<FiftyDigits>() * (pi2 * q * (1 + 2 * e * e) + 32 * e * e * (1 + e * e)) / (e * root);
    const FiftyDigits avv = h0 * 4 * (pi2 * (1 + 2 * e * e) + 32 * e * e * (1 + e * e) / q);
    const FiftyDigits buu = h0 * 2 * pi<FiftyDigits>() * root * (pi2 * (1 + 2 * e * e) - 16 * e * e) / e;
    const FiftyDigits buv = -h0 * 8 * (pi2 * (1 + 2 * e * e) - 16 * e * e);
    const FiftyDigits bvv = h0 * 2 * pi<FiftyDigits>() * (pi2 * q * q + 48 * e * e) / (e * root);
    const auto same = [](const FiftyDigits& x, const FiftyDigits& y) {
      return abs(x - y) < FiftyDigits("1e-40") * abs(y);
    };
    CHECK(same(film.k(0, 0), avv));
    CHECK(same(film.k(0, 1), -avu));
    CHECK(same(film.k(1, 0), -auv));
    CHECK(same(film.k(1, 1), auu));
    CHECK(same(film.c(0, 0), bvv));
    CHECK(same(film.c(0, 1), -buv));
    CHECK(same(film.c(1, 1), buu));
  }
}

TEST_CASE("thresholds: the limits ε → 0 and the eccentricity beyond which every mass is stable, all digits") {
  const FiftyDigits small("1e-16");  // the next term is of order ε²
  const FiftyDigits p = pi<FiftyDigits>();
  const auto limit = [&]<FilmLaw Law>(const FiftyDigits& mass, const FiftyDigits& whirl) {
    INFO(Law::name);
    const SteadyFilm<FiftyDigits> film = dyadic<Law>(small);
    const FiftyDigits tolerance("1e-30");
    CHECK(abs(Dimensionless(film).mass - mass) < tolerance * mass);
    CHECK(abs(*film.threshold.whirl_frequency / 8 - whirl) < tolerance);
  };
  limit.operator()<ShortHalf>(24 / p, FiftyDigits(0.5));
  limit.operator()<LongDynamic>(12 / p, FiftyDigits(0.5));
  const FiftyDigits nu2 = p * p / (4 * (p * p - 8));
  limit.operator()<LongHalf>((3 * p * p - 8) / (p * (p * p - 4)) / nu2, sqrt(nu2));
  CHECK(has_digits(nu2, "1.31974502137172"));
  CHECK(has_digits((3 * p * p - 8) / (p * (p * p - 4)), "1.17185050325069"));

  const auto always = [&]<FilmLaw Law>(const char* digits) {
    INFO(Law::name);
    const auto whirl = [](const FiftyDigits& e) {
      const auto ratios = coefficient_ratios<Law>(SteadyPlace<FiftyDigits>(e), 1);
      const auto& k = ratios.stiffness;
      const auto& c = ratios.damping;
      const FiftyDigits kappa =
          (k(0, 0) * c(1, 1) + k(1, 1) * c(0, 0) - k(0, 1) * c(1, 0) - k(1, 0) * c(0, 1)) / (c(0, 0) + c(1, 1));
      return FiftyDigits((k(0, 0) - kappa) * (k(1, 1) - kappa) - k(0, 1) * k(1, 0));
    };
    std::uintmax_t iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        whirl, FiftyDigits(0.5), FiftyDigits(0.95), boost::math::tools::eps_tolerance<FiftyDigits>(150), iterations);
    CHECK(has_digits(bracket.first, digits));
    const FiftyDigits below = bracket.first - FiftyDigits("1e-9");
    const FiftyDigits above = bracket.first + FiftyDigits("1e-9");
    CHECK_FALSE(dyadic<Law>(below).threshold.always_stable());
    CHECK(dyadic<Law>(above).threshold.always_stable());
    CHECK_FALSE(dyadic<Law>(above).threshold.whirl_frequency.has_value());
  };
  always.operator()<ShortHalf>("0.75603038647101240583");
  always.operator()<LongDynamic>("0.8268040183068110095");
  always.operator()<LongHalf>("0.79490685746691899118");
}

TEST_CASE("thresholds: Routh's condition and the eigenvalues agree for every law, and a mass beside it changes sign") {
  for_each_film_law([&]<class Law>() {
    for (const double ratio : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9}) {
      INFO(Law::name << ", eps " << ratio);
      using Wide = long double;
      const SteadyPlace<Wide> place{Wide(ratio)};
      const auto ratios = coefficient_ratios<Law>(place, 1);
      const RotorThreshold<Wide> routh = routh_threshold<Wide>(ratios.stiffness, ratios.damping);
      const PolarForce<Wide> f = polar_force_ratio<Law>(place.film(1));
      const Wide unit = std::hypot(f.radial, f.tangential);  // W c⁻¹ω⁻² in these units
      const RotorThreshold<Wide> other = eigenvalue_threshold<Wide>(ratios.stiffness, ratios.damping, unit, 1);
      CHECK(other.always_stable() == routh.always_stable());
      if (routh.always_stable()) continue;
      if (routh.critical_mass == 0) {
        CHECK(other.critical_mass == 0);
        CHECK(Law::extent == FilmExtent::full);  // a full film has no stiffness against the load's direction
        continue;
      }
      // Bracketing to the last digit; the eigenvalue's own rounding over its slope in the mass.
      CHECK(static_cast<double>(other.critical_mass / routh.critical_mass) == Approx(1).epsilon(1e-13));
      CHECK(static_cast<double>(*other.whirl_frequency / *routh.whirl_frequency) == Approx(1).epsilon(1e-13));
      const auto growth = [&](Wide mass) {
        return leading_mode<Wide>(ratios.stiffness, ratios.damping, mass, 1).growth;
      };
      CHECK(growth(routh.critical_mass * Wide(1.001)) > 0);
      CHECK(growth(routh.critical_mass * Wide(0.999)) < 0);
    }
  });
}

TEST_CASE("coefficients: turning the other way mirrors them and changes no threshold") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const SteadyFilm<FiftyDigits> forward = dyadic<Law>(0.4, 8);
    const SteadyFilm<FiftyDigits> backward = dyadic<Law>(0.4, -8);
    CHECK(forward.attitude == backward.attitude);
    CHECK(forward.load == backward.load);
    CHECK(forward.threshold.critical_mass == backward.threshold.critical_mass);
    CHECK(forward.stiffness(0, 0) == backward.stiffness(0, 0));
    CHECK(forward.stiffness(0, 1) == -backward.stiffness(0, 1));
    CHECK(forward.damping(1, 0) == -backward.damping(1, 0));
    CHECK(forward.damping(1, 1) == backward.damping(1, 1));
  });
}

TEST_CASE("coefficients: full films rest at 90° and carry no rotor of any mass") {
  const SteadyFilm<FiftyDigits> film = dyadic<ShortFull>(0.4);
  CHECK(abs(film.attitude - pi<FiftyDigits>() / 2) < FiftyDigits("1e-45"));
  CHECK(film.threshold.critical_mass == 0);
  CHECK(abs(*film.threshold.whirl_frequency - 4) < FiftyDigits("1e-45"));
}

TEST_CASE("coefficients: no place at ε = 0 or 1, none without spin, none under a load out of reach") {
  CHECK_THROWS_WITH(SteadyPlace<double>(0.0), Contains("ratio 0;") && Contains("above 0 and below 1"));
  CHECK_THROWS_WITH(SteadyPlace<double>(1.0), Contains("ratio 1;"));
  const Bearing<double> bearing(0.03, 0.05, 1e-4);
  CHECK_THROWS_WITH(steady_film<ShortHalf>(bearing, Lubricant<double>(0.1), SteadyPlace<double>(0.5), 0.0),
                    Contains("spin 0 rad/s"));
  CHECK_FALSE(steady_place<ShortHalf>(1e40).has_value());
  CHECK_FALSE(steady_place<ShortHalf>(0.0).has_value());
}

}  // namespace film_coefficients_test
