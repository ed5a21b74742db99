// The cavitated film by finite elements: a second solver beside the finite volumes, of second order.
#include "oracle/reynolds/cavitated_elements.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/reynolds/cavitated_film.hpp"
#include "oracle/reynolds/circumferential_modes.hpp"

namespace cavitated_elements_test {

using namespace lubjoint;
using namespace lubjoint::oracle;

namespace {

ScaledFilm film_at(double epsilon, double a, double b, double shape) { return {epsilon, 1 - epsilon, a, b, shape}; }

}  // namespace

TEST_CASE("cavitated film by elements: it agrees with the finite volumes, within both bounds") {
  for (const double shape : {0.25, 1.0}) {
    for (const double epsilon : {0.1, 0.5, 0.9}) {
      for (const auto& [a, b] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{0.0, -1.0}, std::pair{1.0, 0.5}}) {
        const ScaledFilm film = film_at(epsilon, a, b, shape);
        const ScaledForce elements = cavitated_force_by_elements(film, 32);
        const ScaledForce volumes = cavitated_film_force(film, false, 1e-4);
        INFO("L/D " << shape << ", e " << epsilon << ", a " << a << ", b " << b << ", apart "
                    << (elements.value - volumes.value).norm() / volumes.value.norm());
        CHECK((elements.value - volumes.value).norm() <= elements.error.norm() + volumes.error.norm());
        CHECK(elements.error.norm() < 5e-3 * elements.value.norm());
      }
    }
  }
}

TEST_CASE("cavitated film by elements: second order, and another film is told apart") {
  // A film that closes is carried at all nodes but those behind it: no rounding of the boundary hides the order.
  const ScaledForce closing = cavitated_force_by_elements(film_at(0.5, 0, 1, 0.5), 32);
  CHECK(closing.observed_order == Approx(2).margin(0.1));
  const ScaledForce dynamic = circumferential_film_force(FilmExtent::dynamic, film_at(0.5, 0, 1, 0.5), 1e-8);
  CHECK((closing.value - dynamic.value).norm() > 100 * closing.error.norm());
  const ScaledForce longer = cavitated_force_by_elements(film_at(0.5, 0, 1, 0.51), 32);
  CHECK((longer.value - closing.value).norm() > longer.error.norm() + closing.error.norm());
  CHECK_THROWS_WITH(cavitated_force_by_elements(film_at(0.5, 0, 1, 1), 4), Catch::Contains("allowed are 8 or more"));
}

}  // namespace cavitated_elements_test
