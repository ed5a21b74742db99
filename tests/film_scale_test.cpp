#include <catch2/catch.hpp>

#include "lubjoint/film/bearing.hpp"

namespace film_scale_test {

using namespace lubjoint;

TEST_CASE("bearing: a clearance that is not below the journal radius is refused by name") {
  CHECK_THROWS_WITH(Bearing<double>(0.04, 0.01, 0.01), Catch::Contains("clearance") && Catch::Contains("0.01"));
  CHECK_THROWS_WITH(Bearing<double>(-0.04, 0.01, 0.001), Catch::Contains("length") && Catch::Contains("-0.04"));
  CHECK_THROWS_WITH(Bearing<double>(0.04, std::nan(""), 0.001), Catch::Contains("radius") && Catch::Contains("nan"));
  CHECK_THROWS_WITH(Lubricant<double>(0.0), Catch::Contains("viscosity") && Catch::Contains("above 0"));
}

}  // namespace film_scale_test
