// Batch evaluation against the functions for one state: the same bits, the same errors.
#include <catch2/catch.hpp>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "support/force_rows.hpp"
#include "support/golden.hpp"

namespace film_batch_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const Bearing<double> bearing(0.04, 0.0098, 0.0002);
const Lubricant<double> oil(0.4);

/// States of all three kinds, the same in each row up to rounding.
struct Rows {
  std::vector<double> epsilon, a, b;
  std::vector<double> ex, ey, ux, uy;          // [-], [1/s]
  std::vector<double> mx, my, vx, vy, wb, wj;  // [m], [m/s], [rad/s]

  /// Leaves out states that rounding of their components puts on the wall.
  void add(double ratio, double slip, double squeeze, double attitude) {
    const Vector2<double> r(std::cos(attitude), std::sin(attitude));
    const Vector2<double> e = ratio * r;
    const Vector2<double> u = squeeze * r - slip / 2 * perpendicular(r);
    const double c = bearing.clearance();
    const JournalMotion<double> motion{c * e, Vector2<double>(c * u + c * 25 * perpendicular(e)), 0, 50};
    const Vector2<double> in_clearances = eccentricity_in_clearances(motion, c);
    if (!(one_minus_squared_norm(e.x(), e.y()) > 0)) return;
    if (!(one_minus_squared_norm(in_clearances.x(), in_clearances.y()) > 0)) return;
    const std::pair<std::vector<double>*, double> columns[] = {{&epsilon, ratio},
                                                               {&a, slip},
                                                               {&b, squeeze},
                                                               {&ex, e.x()},
                                                               {&ey, e.y()},
                                                               {&ux, u.x()},
                                                               {&uy, u.y()},
                                                               {&mx, c * e.x()},
                                                               {&my, c * e.y()},
                                                               {&vx, motion.velocity.x()},
                                                               {&vy, motion.velocity.y()},
                                                               {&wb, motion.bearing_spin},
                                                               {&wj, motion.journal_spin}};
    for (const auto& [column, value] : columns) column->push_back(value);
  }

  std::size_t size() const { return ex.size(); }
  FilmStateArrays states(std::size_t begin, std::size_t n) const {
    return {part(ex, begin, n), part(ey, begin, n), part(ux, begin, n), part(uy, begin, n)};
  }
  PolarStateArrays polar() const { return {epsilon, a, b}; }
  JournalMotionArrays motions() const { return {mx, my, vx, vy, wb, wj}; }

 private:
  static std::span<const double> part(const std::vector<double>& v, std::size_t begin, std::size_t n) {
    return std::span<const double>(v).subspan(begin, n);
  }
};

/// The states of the golden forces, at attitudes of all four quadrants and on the axes.
Rows golden_rows() {
  Rows rows;
  const GoldenTable table("film_force.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const PolarState s = table.polar(row);
    rows.add(s.eccentricity_ratio, s.slip_rate, s.squeeze_rate,
             0.25 * std::numbers::pi * static_cast<double>(row % 16));
  }
  return rows;
}

Rows random_rows(std::size_t count) {
  Rows rows;
  std::mt19937_64 random(20090331);
  const auto part = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  while (rows.size() < count) {
    const double ratio = part() < 0.5 ? part() : 1 - std::pow(10, -14 * part());
    const double size = std::pow(10, 8 * part() - 4);
    const double course = 6.3 * part();
    rows.add(ratio, size * std::cos(course), size * std::sin(course), 6.3 * part());
  }
  return rows;
}

std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

void check_bits(const Rows& rows) {
  for_each_film_law([&]<class Law>() {
    for (const InstructionSet set : available_sets()) {
      INFO(Law::name << ", " << name_of(set));
      Forces forces(rows.size());
      film_forces(Law::name, bearing, oil, rows.states(0, rows.size()), forces, set);
      CHECK(
          differing_rows(forces, [&](std::size_t i) {
            return film_force<Law>(bearing, oil, FilmState<double>({rows.ex[i], rows.ey[i]}, {rows.ux[i], rows.uy[i]}));
          }) == 0);
      film_forces(Law::name, bearing, oil, rows.polar(), forces, set);
      CHECK(differing_rows(forces, [&](std::size_t i) {
              const PolarForce<double> f =
                  film_force<Law>(bearing, oil, PolarFilmState<double>(rows.epsilon[i], rows.a[i], rows.b[i]));
              return Vector2<double>(f.radial, f.tangential);
            }) == 0);
      film_forces(Law::name, bearing, oil, rows.motions(), forces, set);
      CHECK(differing_rows(forces, [&](std::size_t i) {
              const JournalMotion<double> motion{
                  {rows.mx[i], rows.my[i]}, {rows.vx[i], rows.vy[i]}, rows.wb[i], rows.wj[i]};
              return film_force<Law>(bearing, oil, film_state(motion, bearing.clearance()));
            }) == 0);
      film_force_ratios(Law::name, rows.states(0, rows.size()), forces, set);
      CHECK(differing_rows(forces, [&](std::size_t i) {
              return force_ratio<Law>(FilmState<double>({rows.ex[i], rows.ey[i]}, {rows.ux[i], rows.uy[i]}));
            }) == 0);
    }
  });
}

}  // namespace

TEST_CASE("batch: every law gives the golden states the bits of one state, with every instruction set") {
  const Rows rows = golden_rows();
  REQUIRE(rows.size() > 3000);
  check_bits(rows);
}

TEST_CASE("batch: every law gives random states the bits of one state, with every instruction set") {
  check_bits(random_rows(5000));
  if (!is_available(InstructionSet::avx2)) WARN("this machine has no AVX2: only the scalar loop was run");
}

TEST_CASE("batch: any number of rows at any place in memory gives the same bits, and nothing beside them is written") {
  const Rows rows = random_rows(800);
  std::vector<std::size_t> sizes{31, 32, 33, 63, 64, 65, 255, 257};
  for (std::size_t n = 0; n <= 17; ++n) sizes.push_back(n);
  for_each_film_law([&]<class Law>() {
    Forces all(rows.size());
    film_force_ratios(Law::name, rows.states(0, rows.size()), all, InstructionSet::scalar);
    for (const InstructionSet set : available_sets()) {
      for (const std::size_t n : sizes) {
        for (std::size_t offset = 0; offset < 8; ++offset) {  // two vectors of 32 bytes
          const std::size_t begin = 8 - offset;               // outputs and inputs at different alignments
          Forces some(n + 16);
          film_force_ratios(Law::name, rows.states(begin, n),
                            {std::span(some.first).subspan(offset, n), std::span(some.second).subspan(offset + 1, n)},
                            set);
          std::size_t wrong = 0;
          for (std::size_t i = 0; i < n + 16; ++i) {
            const bool in_first = i >= offset && i < offset + n;
            const bool in_second = i >= offset + 1 && i < offset + 1 + n;
            wrong += !same_bits(some.first[i], in_first ? all.first[begin + i - offset] : untouched);
            wrong += !same_bits(some.second[i], in_second ? all.second[begin + i - offset - 1] : untouched);
          }
          INFO(Law::name << ", " << name_of(set) << ", " << n << " rows, offset " << offset);
          CHECK(wrong == 0);
        }
      }
    }
  });
}

TEST_CASE("batch: forces may replace any two of the inputs, and other overlaps are refused by name") {
  const Rows rows = random_rows(700);
  for_each_film_law([&]<class Law>() {
    Forces apart(rows.size());
    film_force_ratios(Law::name, rows.states(0, rows.size()), apart);
    for (const InstructionSet set : available_sets()) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          if (i == j) continue;
          std::array<std::vector<double>, 4> in = {rows.ex, rows.ey, rows.ux, rows.uy};
          film_force_ratios(Law::name, {in[0], in[1], in[2], in[3]}, {in[i], in[j]}, set);
          INFO(Law::name << ", " << name_of(set) << ", forces in columns " << i << " and " << j);
          CHECK(in[i] == apart.first);
          CHECK(in[j] == apart.second);
        }
      }
    }
  });
  std::vector<double> one = rows.ux;
  std::vector<double> other(rows.size());
  const std::span<double> shifted = std::span(one).subspan(1, 500);
  const auto with = [&](std::span<double> first, std::span<double> second) {
    film_force_ratios("long_full",
                      {std::span(rows.ex).first(500), std::span(rows.ey).first(500), std::span(one).first(500),
                       std::span(rows.uy).first(500)},
                      {first, second});
  };
  CHECK_THROWS_WITH(with(shifted, std::span(other).first(500)), Contains("overlaps ux"));
  CHECK_THROWS_WITH(with(std::span(other).first(500), shifted), Contains("overlaps ux"));
  CHECK_THROWS_WITH(with(std::span(other).first(500), std::span(other).subspan(1, 500)), Contains("overlap"));
  CHECK(one == rows.ux);
}

TEST_CASE("batch: a row without a film is named, those before it are answered, the others stay as they were") {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  const std::array<std::array<double, 4>, 8> bad = {{{1, 0, 1, 1},
                                                     {0.6, 0.8, 1, 1},
                                                     {-3, 0.1, 1, 1},
                                                     {nan, 0, 1, 1},
                                                     {0.1, infinity, 1, 1},
                                                     {0.1, 0, nan, 0},
                                                     {0, 0, 1, nan},
                                                     {0.5, 0, -infinity, 1}}};
  const Rows rows = random_rows(600);
  for_each_film_law([&]<class Law>() {
    Forces good(rows.size());
    film_force_ratios(Law::name, rows.states(0, rows.size()), good);
    for (const InstructionSet set : available_sets()) {
      for (const auto& state : bad) {
        for (const std::size_t place : {0UL, 3UL, 4UL, 31UL, 32UL, 33UL, 575UL, 576UL, 598UL, 599UL}) {
          Rows spoilt = rows;
          spoilt.ex[place] = state[0];
          spoilt.ey[place] = state[1];
          spoilt.ux[place] = state[2];
          spoilt.uy[place] = state[3];
          spoilt.ex[599] = 2;  // a later one does not matter
          Forces forces(rows.size());
          INFO(Law::name << ", " << name_of(set) << ", row " << place << ": " << state[0] << " " << state[1] << " "
                         << state[2] << " " << state[3]);
          std::size_t named = rows.size();
          std::string message;
          try {
            film_force_ratios(Law::name, spoilt.states(0, rows.size()), forces, set);
          } catch (const FilmRowError& error) {
            named = error.row();
            message = error.what();
          }
          CHECK(named == place);
          CHECK_THAT(message, Contains("row " + std::to_string(place) + ": no film at eccentricity") &&
                                  Contains("allowed are eccentricity ratios in [0, 1)"));
          std::size_t wrong = 0;
          for (std::size_t i = 0; i < rows.size(); ++i) {
            wrong += !same_bits(forces.first[i], i < place ? good.first[i] : untouched);
            wrong += !same_bits(forces.second[i], i < place ? good.second[i] : untouched);
          }
          CHECK(wrong == 0);
        }
      }
    }
  });
}

TEST_CASE("batch: polar states and motions without a film are named too") {
  const Rows rows = random_rows(300);
  for_each_film_law([&]<class Law>() {
    for (const InstructionSet set : available_sets()) {
      INFO(Law::name << ", " << name_of(set));
      Forces forces(rows.size());
      for (const double ratio : {-0.1, 1.0, 1e300, std::nan("")}) {
        Rows spoilt = rows;
        spoilt.epsilon[270] = ratio;
        CHECK_THROWS_WITH(film_forces(Law::name, bearing, oil, spoilt.polar(), forces, set),
                          Contains("row 270: no film at eccentricity_ratio"));
      }
      for (std::vector<double> Rows::*column : {&Rows::a, &Rows::b}) {
        Rows spoilt = rows;
        (spoilt.*column)[13] = std::nan("");
        CHECK_THROWS_WITH(film_forces(Law::name, bearing, oil, spoilt.polar(), forces, set), Contains("row 13: "));
      }
      for (std::vector<double> Rows::*column : {&Rows::mx, &Rows::my, &Rows::vx, &Rows::vy, &Rows::wb, &Rows::wj}) {
        Rows spoilt = rows;
        (spoilt.*column)[131] = std::numeric_limits<double>::infinity();
        CHECK_THROWS_WITH(film_forces(Law::name, bearing, oil, spoilt.motions(), forces, set), Contains("row 131: "));
      }
    }
  });
}

TEST_CASE("batch: rows at rest, in the centre and at rates beyond the vector loop's have the bits of one state") {
  Rows rows = random_rows(520);
  std::size_t row = 0;
  for (const Vector2<double>& e : {Vector2<double>(0, 0), {-0.0, 0}, {1e-300, 0}, {0.3, -1e-200}, {0.6, 0.5}}) {
    for (const double rate : {0.0, -0.0, 5e-324, 1e-300, 1e-100, 1e-59, 1e59, 1e61, 1e200, 1e300}) {
      for (const double course : {0.0, 0.7, 2.0, -1.5}) {
        rows.ex[row] = e.x();
        rows.ey[row] = e.y();
        rows.ux[row] = rate * std::cos(course);
        rows.uy[row] = rate * std::sin(course);
        rows.epsilon[row] = std::abs(e.x());
        rows.a[row] = -2 * rows.uy[row];
        rows.b[row] = rows.ux[row];
        row += 2;  // ordinary ones between them
      }
    }
  }
  REQUIRE(row == 400);
  check_bits(rows);
}

TEST_CASE("batch: a force beyond the range of double precision is an error that names the row") {
  Rows rows = random_rows(300);
  rows.ux[200] = 1e308;
  rows.b[200] = 1e308;
  const Lubricant<double> tar(1e140);
  for_each_film_law([&]<class Law>() {
    for (const InstructionSet set : available_sets()) {
      INFO(Law::name << ", " << name_of(set));
      Forces forces(rows.size());
      CHECK_THROWS_AS(film_forces(Law::name, bearing, oil, rows.states(0, 300), forces, set), ForceRowError);
      CHECK_THROWS_WITH(film_forces(Law::name, bearing, oil, rows.states(0, 300), forces, set),
                        "row 200: the force is beyond the range of double precision; allowed are smaller rates");
      CHECK(forces.first[199] != untouched);
      CHECK(forces.first[200] == untouched);
      CHECK_THROWS_WITH(film_forces(Law::name, bearing, oil, rows.polar(), forces, set),
                        Contains("row 200: the force"));
      film_forces(Law::name, bearing, tar, rows.states(0, 200),
                  {std::span(forces.first).first(200), std::span(forces.second).first(200)}, set);
      for (std::size_t i = 0; i < 200; ++i) REQUIRE(std::isfinite(forces.first[i]));
      CHECK_THROWS_WITH(film_forces(Law::name, bearing, Lubricant<double>(1e306), rows.states(0, 200),
                                    {std::span(forces.first).first(200), std::span(forces.second).first(200)}, set),
                        Contains("the force is beyond"));
    }
  });
}

TEST_CASE("batch: laws, lengths and instruction sets that are none are refused by name") {
  const Rows rows = random_rows(10);
  Forces forces(10);
  CHECK_THROWS_WITH(film_force_ratios("short", rows.states(0, 10), forces),
                    Contains("\"short\"") && Contains("short_half"));
  CHECK_THROWS_WITH(film_force_ratios("short_half", rows.states(0, 9), forces),
                    Contains("ex has 9 rows") && Contains("10"));
  Forces longer(11);
  CHECK_THROWS_WITH(film_force_ratios("short_half", rows.states(0, 10), {forces.first, longer.second}),
                    Contains("second array of forces has 11 rows"));
  PolarStateArrays polar = rows.polar();
  polar.slip_rate = polar.slip_rate.first(3);
  CHECK_THROWS_WITH(film_forces("short_half", bearing, oil, polar, forces), Contains("slip_rate has 3 rows"));
  JournalMotionArrays motions = rows.motions();
  motions.journal_spin = {};
  CHECK_THROWS_WITH(film_forces("short_half", bearing, oil, motions, forces), Contains("journal_spin has 0 rows"));
  CHECK(is_available(InstructionSet::scalar));
  CHECK(is_available(fastest_instruction_set()));
  if (is_available(InstructionSet::avx2)) CHECK(fastest_instruction_set() != InstructionSet::scalar);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (is_available(set)) continue;
    CHECK_THROWS_WITH(film_force_ratios("short_half", rows.states(0, 10), forces, set),
                      Contains(std::string(name_of(set))));
  }
}

}  // namespace film_batch_test
