#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "support/law_property.hpp"

namespace film_homogeneity_test {

using namespace lubjoint;

TEST_CASE("film force is homogeneous of degree one in u: a power of two scales it exactly") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F(e, 2^k u) = 2^k F(e, u), bit for bit"), [] {
      const double epsilon = *rc::gen::inRange(0, 1000) * 1e-3;
      const double a = *rc::gen::inRange(-1000, 1000) * 1e-2;
      const double b = *rc::gen::inRange(-1000, 1000) * 1e-2;
      const double power = std::ldexp(1.0, *rc::gen::inRange(-100, 100));
      const auto once = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, a, b));
      const auto scaled = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, power * a, power * b));
      RC_ASSERT(scaled.radial == power * once.radial);
      RC_ASSERT(scaled.tangential == power * once.tangential);
    });
  });
}

}  // namespace film_homogeneity_test
