// Films that are tables, over arrays: the bits of one state, and the errors of the other laws' batches.
#include <catch2/catch.hpp>
#include <random>

#include "support/compiled_films.hpp"
#include "support/force_rows.hpp"

namespace compiled_film_batch_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const Bearing<double> bearing(0.01, 0.01, 1e-4);  // L/D = ½, which ships
const Lubricant<double> oil(0.1);

template <class Law>
Law shipped() {
  return Law(*shipped_film(Law::name, "0.5"));
}

/// Random states, those beyond the tables among them, and those that need care: at rest, in the centre, at far rates.
struct Rows {
  std::vector<double> epsilon, a, b;
  std::vector<double> ex, ey, ux, uy;
  std::vector<double> mx, my, vx, vy, wb, wj;

  explicit Rows(std::size_t count) {
    std::mt19937_64 random(20090331);
    const auto part = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
    while (ex.size() < count) {
      const double ratio = part() < 0.5 ? part() : 1 - std::pow(10, -8 * part());
      const double size = std::pow(10, 8 * part() - 4);
      add(ratio, 6.3 * part(), size, 6.3 * part());
    }
    for (const double ratio : {0.0, 1e-300, 0.3, 0.6}) {
      for (const double rate : {0.0, -0.0, 5e-324, 1e-100, 1e-59, 1e61, 1e200}) {
        for (const double course : {0.0, 0.7, 2.0, -1.5}) add(ratio, 0.25, rate, course);
      }
    }
  }

  void add(double ratio, double attitude, double rate, double course) {
    const Vector2<double> e(ratio * std::cos(attitude), ratio * std::sin(attitude));
    const Vector2<double> u(rate * std::cos(course), rate * std::sin(course));
    const double c = bearing.clearance();
    const std::pair<std::vector<double>*, double> columns[] = {
        {&epsilon, ratio}, {&a, -2 * u.y()}, {&b, u.x()},      {&ex, e.x()},     {&ey, e.y()},
        {&ux, u.x()},      {&uy, u.y()},     {&mx, c * e.x()}, {&my, c * e.y()}, {&vx, c * u.x()},
        {&vy, c * u.y()},  {&wb, 3},         {&wj, 50}};
    for (const auto& [column, value] : columns) column->push_back(value);
  }

  std::size_t size() const { return ex.size(); }
  FilmStateArrays states() const { return {ex, ey, ux, uy}; }
  PolarStateArrays polar() const { return {epsilon, a, b}; }
  JournalMotionArrays motions() const { return {mx, my, vx, vy, wb, wj}; }
};

}  // namespace

TEST_CASE("batch: films that are tables give every row the bits of one state") {
  const Rows rows(4000);
  for_each_film_law<CompiledLaws>([&]<class Law>() {
    INFO(Law::name);
    const Law law = shipped<Law>();
    Forces forces(rows.size());
    const auto film = [&](std::size_t i) {
      return FilmState<double>({rows.ex[i], rows.ey[i]}, {rows.ux[i], rows.uy[i]});
    };
    film_force_ratios(law, rows.states(), forces);
    CHECK(differing_rows(forces, [&](std::size_t i) { return compiled_force_ratio(law, film(i)); }) == 0);
    film_forces(law, bearing, oil, rows.states(), forces);
    CHECK(differing_rows(forces, [&](std::size_t i) { return film_force(law, bearing, oil, film(i)); }) == 0);
    film_forces(law, bearing, oil, rows.polar(), forces);
    CHECK(differing_rows(forces, [&](std::size_t i) {
            const PolarForce<double> f =
                film_force(law, bearing, oil, PolarFilmState<double>(rows.epsilon[i], rows.a[i], rows.b[i]));
            return Vector2<double>(f.radial, f.tangential);
          }) == 0);
    film_forces(law, bearing, oil, rows.motions(), forces);
    CHECK(differing_rows(forces, [&](std::size_t i) {
            const JournalMotion<double> motion{
                {rows.mx[i], rows.my[i]}, {rows.vx[i], rows.vy[i]}, rows.wb[i], rows.wj[i]};
            return film_force(law, bearing, oil, film_state(motion, bearing.clearance()));
          }) == 0);
    // The count can differ from 0: in another row's place, nearly all do.
    CHECK(differing_rows(forces, [&](std::size_t i) {
            return film_force(law, bearing, oil, film((i + 1) % rows.size()));
          }) > rows.size() * 9 / 10);
  });
}

TEST_CASE("batch: films that are tables write in the place of their inputs, and stop at the row that has no film") {
  const Rows rows(300);
  for_each_film_law<CompiledLaws>([&]<class Law>() {
    INFO(Law::name);
    const AnyCompiledLaw law = shipped<Law>();
    Forces apart(rows.size());
    film_forces(law, bearing, oil, rows.states(), apart);
    Rows spoilt = rows;
    film_forces(law, bearing, oil, spoilt.states(), {spoilt.ux, spoilt.ex});
    CHECK(spoilt.ux == apart.first);
    CHECK(spoilt.ex == apart.second);

    spoilt = rows;
    spoilt.ex[270] = 1;
    spoilt.epsilon[270] = 1;
    spoilt.mx[270] = bearing.clearance();
    Forces forces(rows.size());
    CHECK_THROWS_WITH(film_forces(law, bearing, oil, spoilt.polar(), forces),
                      Contains("row 270: no film at eccentricity_ratio"));
    CHECK_THROWS_WITH(film_forces(law, bearing, oil, spoilt.motions(), forces), Contains("row 270: "));
    CHECK_THROWS_WITH(film_force_ratios(law, spoilt.states(), forces), Contains("row 270: "));
    CHECK(forces.first[269] != untouched);
    CHECK(forces.first[270] == untouched);
    spoilt = rows;
    spoilt.ux[4] = 1e308;
    CHECK_THROWS_WITH(film_forces(law, bearing, Lubricant<double>(1e20), spoilt.states(), forces),
                      Contains("row 4: the force is beyond the range"));
  });
}

TEST_CASE("batch: films that are tables are refused by name alone, for another L/D and with arrays of other lengths") {
  const Rows rows(10);
  const auto law = shipped<FiniteReynolds>();
  Forces forces(rows.size());
  CHECK_THROWS_WITH(film_forces("finite_reynolds", bearing, oil, rows.states(), forces),
                    Contains("finite_reynolds is a table") && Contains("allowed is the law with its table"));
  CHECK_THROWS_WITH(film_force_ratios("finite_full", rows.states(), forces), Contains("finite_full is a table"));
  CHECK_THROWS_WITH(film_forces(law, Bearing<double>(0.02, 0.01, 1e-4), oil, rows.states(), forces),
                    Contains("compiled for length over diameter 0.5, the bearing has 1"));
  Forces longer(rows.size() + 1);
  CHECK_THROWS_WITH(film_forces(law, bearing, oil, rows.states(), longer), Contains("ex has"));
  CHECK_THROWS_WITH(film_forces(law, bearing, oil, rows.states(), {forces.first, forces.first}), Contains("overlap"));
}

}  // namespace compiled_film_batch_test
