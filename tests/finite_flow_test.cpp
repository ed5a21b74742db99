// Side flow of films of finite length: by two solvers each, against the short bearing, and against what they displace.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/cavitated_film.hpp"
#include "oracle/reynolds/circumferential_modes.hpp"
#include "oracle/reynolds/film_losses.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "oracle/reynolds/smooth_film.hpp"

namespace finite_flow_test {

using namespace lubjoint;
using namespace lubjoint::oracle;
using Vec = Vector2<double>;

namespace {

constexpr std::array leaking = {FiniteFilm::finite_half, FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds};
constexpr std::array<std::array<double, 2>, 5> motions = {{{1, 0}, {0, 1}, {0, -1}, {1, 0.5}, {1, -0.5}}};  // a, b

ScaledFilm film_at(double epsilon, double a, double b, double shape) { return {epsilon, 1 - epsilon, a, b, shape}; }

FiniteFlow flow_at(FiniteFilm film, double shape, const PolarFilmState<double>& state,
                   const FiniteLengthOptions& options = {1e-6}) {
  return finite_side_flow(film, shape, state.in_own_frame(), options);
}

}  // namespace

TEST_CASE("side flow: two solvers of half and dynamic films that share no step agree within their estimates") {
  double worst = 0;
  for (const FilmExtent extent : {FilmExtent::half, FilmExtent::dynamic}) {
    for (const double shape : {0.25, 1.0, 4.0}) {
      for (const double epsilon : {0.0, 0.1, 0.5, 0.9}) {
        for (const auto& [a, b] : motions) {
          const ScaledFilm film = film_at(epsilon, a, b, shape);
          const ScaledFlow series = smooth_film_flow(extent, film, 1e-9);
          const ScaledFlow modes = circumferential_film_flow(extent, film, 1e-9);
          INFO("L/D " << shape << ", e " << epsilon << ", a " << a << ", b " << b);
          const double apart = std::abs(series.value[0] - modes.value[0]);
          CHECK(apart <= series.error[0] + modes.error[0]);
          CHECK(series.error[0] <= 1e-9 * film.displacement());  // as asked for
          worst = std::max(worst, modes.error[0] / film.displacement());
          if (a == 0) continue;  // the net flow of a half film in squeeze is nearly none, and hardly depends on L/D
          const ScaledFlow longer = smooth_film_flow(extent, film_at(epsilon, a, b, 1.001 * shape), 1e-9);
          CHECK(std::abs(longer.value[0] - modes.value[0]) > longer.error[0] + modes.error[0]);
        }
      }
    }
  }
  CHECK(worst < 3e-7);  // as circumferential_modes.hpp says, of a half film in squeeze at ε = 0.9
}

TEST_CASE("side flow: a film that ruptures has the same by finite volumes and by finite elements, within both bounds") {
  for (const double shape : {0.25, 1.0}) {
    for (const double epsilon : {0.1, 0.5, 0.9}) {
      for (const auto& [a, b] : motions) {
        const ScaledFilm film = film_at(epsilon, a, b, shape);
        const ScaledFlow volumes = cavitated_film_flow(film, false, 1e-4);
        const ScaledFlow elements = cavitated_flow_by_elements(film, 32);
        INFO("L/D " << shape << ", e " << epsilon << ", a " << a << ", b " << b);
        CHECK(std::abs(volumes.value[0] - elements.value[0]) <= volumes.error[0] + elements.error[0]);
        CHECK(volumes.error[0] <= 1e-4 * film.displacement());   // as asked for
        CHECK(elements.error[0] <= 2e-2 * film.displacement());  // else its bound would say nothing
        if (epsilon < 0.5) continue;
        // The film between the cuts of the dynamic one is another, and loses oil through them.
        const ScaledFlow dynamic = circumferential_film_flow(FilmExtent::dynamic, film, 1e-6);
        CHECK(volumes.value[0] - dynamic.value[0] > volumes.error[0] + dynamic.error[0]);
      }
    }
  }
  CHECK_THROWS_WITH(cavitated_flow_by_elements(film_at(0.5, 0, 1, 1), 4), Catch::Contains("allowed are 8 or more"));
}

TEST_CASE("side flow: as L/D vanishes it becomes the short bearing's, by the square of L/D") {
  const std::array pairs = {std::pair{FiniteFilm::finite_half, OneDimensionalFilm::short_half},
                            std::pair{FiniteFilm::finite_dynamic, OneDimensionalFilm::short_dynamic},
                            std::pair{FiniteFilm::finite_reynolds, OneDimensionalFilm::short_dynamic}};
  for (const auto& [film, limit] : pairs) {
    for (const auto& [a, b] : {std::array{1.0, 0.0}, std::array{1.0, 0.5}, std::array{1.0, -0.5}}) {
      const PolarFilmState<double> state(0.5, a, b);
      // With c, R and L such that cRL is one.
      const double short_flow =
          film_losses_by_quadrature(limit, Bearing<double>(2, 1, 0.5), Lubricant<double>(1), state, 0).side_flow->value;
      const FiniteFlow narrow = flow_at(film, 0.02, state);
      const FiniteFlow twice = flow_at(film, 0.04, state);
      INFO(name_of(film) << ", b " << b);
      CHECK(std::abs(narrow.ratio - short_flow) < 1e-3 * short_flow);
      const double off = std::abs(narrow.ratio - short_flow);
      if (film == FiniteFilm::finite_reynolds) {
        // What grids resolve of a difference that small.
        CHECK(off <= 2e-4 * short_flow + narrow.error);
      } else {
        CHECK(off > 10 * narrow.error);
        CHECK(std::abs(twice.ratio - short_flow) / off == Approx(4).epsilon(0.05));  // (L/D)², and (L/D)³ after it
      }
    }
  }
}

TEST_CASE("side flow: a film that ruptures loses by its sides what the motion displaces over it, others do not") {
  const Bearing<double> bearing(2, 1, 0.5);  // L/D = 1
  for (const auto& [a, b] : motions) {
    const PolarFilmState<double> state(0.6, a, b);
    const auto displaced = [&](FiniteFilm film) {
      const PressureField field = finite_length_pressure(film, bearing, Lubricant<double>(1), state, 1441, 129);
      double sum = 0;
      for (std::size_t i = 0; i + 1 < field.theta.size(); ++i) {
        const double source = state.slip_rate * std::sin(field.theta[i]) - 2 * b * std::cos(field.theta[i]);
        for (std::size_t j = 0; j < field.z.size(); ++j) {
          if (field.pressure[i * field.z.size() + j] > 0) sum += source;
        }
      }
      const double cell = 2 * std::numbers::pi / 1440 * bearing.length() / 128;  // R = 1
      return sum * cell * bearing.clearance() * bearing.radius() / 2;  // the film's thickness grows by cs/2, downwards
    };
    const double flow = finite_length_flow(FiniteFilm::finite_reynolds, bearing, state, {1e-4}).side_flow;
    INFO("a " << a << ", b " << b);
    // A wet point more or less at each station and on each side of a field of 1440 points.
    CHECK(flow == Approx(displaced(FiniteFilm::finite_reynolds)).epsilon(0.02));
    const double dynamic = finite_length_flow(FiniteFilm::finite_dynamic, bearing, state, {1e-6}).side_flow;
    CHECK(dynamic < 0.97 * displaced(FiniteFilm::finite_dynamic));  // the rest leaves through its cut ends
  }
}

TEST_CASE(
    "side flow: of a full film there is none, as its pressure's mean over the circle, weighted with h³, is none") {
  const PolarFilmState<double> state(0.6, 1, 0.7);
  const Bearing<double> bearing(2, 1, 0.5);
  CHECK(finite_length_flow(FiniteFilm::finite_full, bearing, state).side_flow == 0);
  const PressureField field =
      finite_length_pressure(FiniteFilm::finite_full, bearing, Lubricant<double>(1), state, 181, 9);
  for (std::size_t j = 1; j + 1 < field.z.size(); ++j) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i + 1 < field.theta.size(); ++i) {
      const double h = 1 + state.eccentricity_ratio * std::cos(field.theta[i]);
      const double term = h * h * h * field.pressure[i * field.z.size() + j];
      sum += term;
      size += std::abs(term);
    }
    CHECK(std::abs(sum) < 1e-6 * size);  // what finite_length_pressure has of its largest pressure
  }
}

TEST_CASE("side flow: the same turned and mirrored, in proportion to the speed and to cRL, none at rest") {
  const Bearing<double> bearing(0.03, 0.02, 1e-4);  // L/D = 3/4
  for (const FiniteFilm film : leaking) {
    INFO(name_of(film));
    const PolarFilmState<double> state(0.6, 2, 1);
    const FiniteFlow flow = flow_at(film, 0.75, state, {1e-3});
    const double rounding = (film == FiniteFilm::finite_reynolds ? 1e-6 : 1e-11) * flow.ratio;  // as of forces
    CHECK(flow.ratio > 0);
    CHECK(flow.tolerance_met);
    const Vec turned_e(0.36, 0.48), turned_u = Vec(state.squeeze_rate * Vec(0.6, 0.8) - Vec(-0.8, 0.6));
    CHECK(std::abs(finite_side_flow(film, 0.75, FilmState<double>(turned_e, turned_u)).ratio - flow.ratio) < rounding);
    CHECK(std::abs(flow_at(film, 0.75, {0.6, -2, 1}, {1e-3}).ratio - flow.ratio) < rounding);
    CHECK(std::abs(flow_at(film, 0.75, {0.6, 64, 32}, {1e-3}).ratio - 32 * flow.ratio) < 32 * rounding);
    const FiniteLengthFlow whole = finite_length_flow(film, bearing, state);
    CHECK(whole.side_flow == Approx(flow.ratio * 0.03 * 0.02 * 1e-4).epsilon(1e-12));  // rounding of the dimensions
    CHECK(finite_side_flow(film, 0.75, FilmState<double>(turned_e, Vec(0, 0))).ratio == 0);
    CHECK(finite_length_flow(film, bearing, {0.6, 0, 0}).side_flow == 0);
    CHECK_THROWS_WITH(flow_at(film, 0, state), Catch::Contains("length over diameter is 0"));
    CHECK_THROWS_WITH(flow_at(film, 1, state, {0.5}), Catch::Contains("relative_tolerance is 0.5"));
  }
}

TEST_CASE("side flow: a coarse estimate contains the fine flow") {
  for (const FiniteFilm film : leaking) {
    for (const auto& [a, b] : motions) {
      const PolarFilmState<double> state(0.8, a, b);
      const bool free = film == FiniteFilm::finite_reynolds;
      const FiniteFlow coarse = flow_at(film, 0.5, state, {1e-2});
      const FiniteFlow fine = flow_at(film, 0.5, state, {free ? 5e-5 : 1e-9});
      INFO(name_of(film) << ", a " << a << ", b " << b);
      CHECK(std::abs(coarse.ratio - fine.ratio) <= coarse.error + fine.error);
      CHECK(fine.error <= coarse.error);
    }
  }
}

}  // namespace finite_flow_test
