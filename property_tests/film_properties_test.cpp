#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"
#include "support/law_property.hpp"

namespace film_properties_test {

using namespace lubjoint;
using generate::Vec;

namespace {

constexpr double epsilon_of_double = 0x1p-52;

PolarFilmState<double> mirrored(const PolarFilmState<double>& s) {
  return {s.eccentricity_ratio, -s.slip_rate, s.squeeze_rate};
}

double size(const PolarForce<double>& f) { return std::hypot(f.radial, f.tangential); }

Vec ratio_at(const auto& law_of, const Vec& e, const Vec& u) { return law_of(FilmState<double>(e, u)); }

template <FilmLaw Law>
Vec vector_ratio(const FilmState<double>& film) {
  return force_ratio<Law>(film);
}

const Bearing<double> one_bearing(0.04, 0.0098, 0.0002);
const Lubricant<double> one_oil(0.4);

}  // namespace

TEST_CASE("full films are linear in u") {
  const auto linear = []<FilmLaw Law>() {
    rc::prop(of_law<Law>("F(e, u + w) = F(e, u) + F(e, w)"), [] {
      const Vec e(*generate::moderate_ratio(), 0);
      const Vec u = generate::direction_at(*generate::angle());
      const Vec w = generate::direction_at(*generate::angle());
      const Vec sum = ratio_at(vector_ratio<Law>, e, u) + ratio_at(vector_ratio<Law>, e, w);
      const double terms = ratio_at(vector_ratio<Law>, e, u).norm() + ratio_at(vector_ratio<Law>, e, w).norm();
      RC_ASSERT((ratio_at(vector_ratio<Law>, e, Vec(u + w)) - sum).norm() <=
                20 * epsilon_of_double * terms);  // rounding
    });
  };
  linear.operator()<ShortFull>();
  linear.operator()<LongFull>();
}

TEST_CASE("films that cavitate are not linear in u: counterexample, u and -u at ε = 0.5 do not cancel") {
  for_each_film_law([]<class Law>() {
    const Vec e(0.5, 0);
    const Vec u(0.5, -0.25);
    const Vec there_and_back = force_ratio<Law>(FilmState<double>(e, u)) + force_ratio<Law>(FilmState<double>(e, -u));
    const double defect = there_and_back.norm() / force_ratio<Law>(FilmState<double>(e, u)).norm();
    INFO(Law::name << ", |F(u) + F(-u)|/|F(u)| " << defect);
    if (Law::extent == FilmExtent::full) {
      CHECK(defect == 0);
    } else {
      CHECK(defect > 0.1);
    }
  });
}

TEST_CASE("the derivative of every law in u, applied to u, is its force: homogeneity of degree one") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("(∂F/∂u) u = F"), [] {
      using T = Dual<double, 2>;
      const FilmState<double> film = (*generate::moderate_film()).in_own_frame();
      const Vector2<T> e(T(film.eccentricity.x()), T(film.eccentricity.y()));
      const Vector2<T> u(T::variable(film.velocity.x(), 0), T::variable(film.velocity.y(), 1));
      const Vector2<T> ratio = force_ratio<Law>(FilmState<T>(e, u));
      const Vec slope(ratio.x().derivatives().dot(film.velocity), ratio.y().derivatives().dot(film.velocity));
      const Vec force(ratio.x().value(), ratio.y().value());
      const double terms = ratio.x().derivatives().norm() + ratio.y().derivatives().norm();  // |u| is 1
      RC_ASSERT((slope - force).norm() <= 1000 * epsilon_of_double * terms);  // rounding of the moments' derivatives
    });
  });
}

TEST_CASE("every film force is linear in the viscosity, and scales with L, R and c as its S") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("2^k in μ, L, R and c scales the force exactly"), [] {
      const Bearing<double> b = *generate::bearing();
      const Lubricant<double> oil = *generate::oil();
      const PolarFilmState<double> film = *generate::film();
      const int k = *rc::gen::inRange(0, 20);
      const double power = std::ldexp(1.0, k);
      const PolarForce<double> once = film_force<Law>(b, oil, film);
      const auto is_scaled = [&](const PolarForce<double>& f, double factor) {
        return f.radial == factor * once.radial && f.tangential == factor * once.tangential;
      };
      constexpr bool is_short = Law::limit == BearingLimit::short_bearing;
      const double cube = power * power * power;
      RC_ASSERT(is_scaled(film_force<Law>(b, Lubricant<double>(power * oil.viscosity()), film), power));
      const Bearing<double> longer(power * b.length(), b.radius(), b.clearance());
      RC_ASSERT(is_scaled(film_force<Law>(longer, oil, film), is_short ? cube : power));
      const Bearing<double> wider(b.length(), power * b.radius(), b.clearance());
      RC_ASSERT(is_scaled(film_force<Law>(wider, oil, film), is_short ? power : cube));
      const Bearing<double> tighter(b.length(), b.radius(), b.clearance() / power);
      RC_ASSERT(is_scaled(film_force<Law>(tighter, oil, film), power * power));
    });
    rc::prop(of_law<Law>("any factor in μ scales the force to rounding"), [] {
      const double viscosity = (*generate::oil()).viscosity();
      const double factor = *generate::log_uniform(-3, 3);
      const PolarFilmState<double> film = *generate::film();
      const PolarForce<double> once = film_force<Law>(one_bearing, Lubricant<double>(viscosity), film);
      const PolarForce<double> more = film_force<Law>(one_bearing, Lubricant<double>(factor * viscosity), film);
      // Rounding: the factor's product, S, and S times the ratio, on both sides.
      RC_ASSERT(std::abs(more.radial - factor * once.radial) <= 4 * epsilon_of_double * size(more));
      RC_ASSERT(std::abs(more.tangential - factor * once.tangential) <= 4 * epsilon_of_double * size(more));
    });
  });
}

TEST_CASE("the mirror image of a motion has the mirror image of its force, wherever a ≠ 0 or the law has no jump") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F_r(ε, -a, b) = F_r(ε, a, b) and F_t(ε, -a, b) = -F_t(ε, a, b), bit for bit"), [] {
      const PolarFilmState<double> film = *generate::film();
      if (Law::extent == FilmExtent::half) RC_PRE(film.slip_rate != 0);
      const PolarForce<double> here = polar_force_ratio<Law>(film);
      const PolarForce<double> there = polar_force_ratio<Law>(mirrored(film));
      RC_ASSERT(there.radial == here.radial);
      RC_ASSERT(there.tangential == -here.tangential);
    });
  });
}

TEST_CASE("sgn(0) = +1 breaks the mirror of half films at a = 0: counterexample, a tangential force without slip") {
  for_each_film_law([]<class Law>() {
    if constexpr (Law::extent == FilmExtent::half) {
      INFO(Law::name);
      const PolarForce<double> on_the_jump = polar_force_ratio<Law>(PolarFilmState<double>(0.5, 0.0, 1));
      CHECK(on_the_jump.tangential > 1);  // its own mirror image would need it to be zero
      const PolarForce<double> below = polar_force_ratio<Law>(PolarFilmState<double>(0.5, -1e-300, 1));
      CHECK(below.tangential == -on_the_jump.tangential);
      CHECK(below.radial == on_the_jump.radial);
    }
  });
}

TEST_CASE("a film force turns with e and u when both are turned") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F(Qe, Qu) = Q F(e, u)"), [] {
      const PolarFilmState<double> polar = *generate::moderate_film();
      if (Law::extent == FilmExtent::half) RC_PRE(std::abs(polar.slip_rate) > 1e-9);  // not on the jump
      const FilmState<double> film = polar.in_own_frame();
      const double turn = *generate::angle();
      const Vec force = force_ratio<Law>(film);
      const FilmState<double> seen(generate::turned(film.eccentricity, turn), generate::turned(film.velocity, turn));
      // Rounding of Qe and Qu, by the law's condition: ε/(1 − ε) to a power, and 1/q for a film that opens.
      RC_ASSERT((force_ratio<Law>(seen) - generate::turned(force, turn)).norm() <= 1e-12 * force.norm());
    });
  });
}

TEST_CASE("polar and vector evaluation of every law are one") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F = F_r r + F_t t"), [] {
      const PolarFilmState<double> polar = *generate::film();
      RC_PRE(polar.eccentricity_ratio > 0);  // at e = 0 a vector has no r of its own: half films take it along u
      const Vec in_plane = force_ratio<Law>(polar.in_own_frame());
      const PolarForce<double> ratio = polar_force_ratio<Law>(polar);
      RC_ASSERT(std::abs(in_plane.x() - ratio.radial) <= 4 * epsilon_of_double * size(ratio));      // rounding
      RC_ASSERT(std::abs(in_plane.y() - ratio.tangential) <= 4 * epsilon_of_double * size(ratio));  // the same
    });
  });
}

}  // namespace film_properties_test
