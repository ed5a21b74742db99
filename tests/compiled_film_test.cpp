// Laws of finite length from their tables: against solvers that the tables were not made with, and what every law of
// a film must satisfy. The tables are those that ship.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/long_dynamic.hpp"
#include "lubjoint/film/long_full.hpp"
#include "lubjoint/film/long_half.hpp"
#include "lubjoint/film/short_dynamic.hpp"
#include "lubjoint/film/short_full.hpp"
#include "lubjoint/film/short_half.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/film_check.hpp"
#include "oracle/laws/film_compiler.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace compiled_film_test {

using namespace lubjoint;
namespace fs = std::filesystem;

namespace {

constexpr double radius = 0.01;
constexpr double clearance = 1e-5;
const Lubricant<double> oil(0.01);
constexpr std::array<const char*, 4> shipped_shapes{"0.25", "0.5", "1", "2.0408163265306123"};

std::string shipped_text(std::string_view film, const std::string& shape) {
  const fs::path file = fs::path(LUBJOINT_SOURCE_DIR) / "data" / "films" / (std::string(film) + "-" + shape + ".txt");
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  INFO(file);
  REQUIRE(stream.good());
  return text.str();
}

template <class Law>
Law shipped(const std::string& shape) {
  return Law(read_compiled_film(shipped_text(Law::name, shape)));
}

/// Calls check(law) for every shipped law of a bearing.
template <class Check>
void for_each_shipped(const std::string& shape, const Check& check) {
  for_each_film_law<CompiledLaws>([&]<class Law>() {
    INFO(Law::name << ", L/D " << shape);
    check(shipped<Law>(shape));
  });
}

struct RandomStates {
  std::mt19937 random{20240613};
  std::uniform_real_distribution<double> uniform{0, 1};

  Vector2<double> direction() {
    const double angle = 2 * std::numbers::pi * uniform(random);
    return {std::cos(angle), std::sin(angle)};
  }
  FilmState<double> next(double limit) { return {limit * uniform(random) * direction(), direction()}; }
  PolarFilmState<double> polar(double limit) {
    const Vector2<double> u = direction();
    return {limit * uniform(random), 2 * u.y(), u.x()};
  }
};

template <class Law>
PolarForce<double> solved_by_series(const Law& law, const PolarFilmState<double>& state, double tolerance) {
  const Bearing<double> bearing(2 * radius * law.shape(), radius, clearance);
  const auto force = oracle::finite_length_force(oracle::finite_film_of(Law::name), bearing, oil, state,
                                                 {tolerance, oracle::FilmOnset::free});
  return {force.radial, force.tangential};
}

template <class Law>
double difference(const Law& law, const PolarFilmState<double>& state, double tolerance) {
  const Bearing<double> bearing(2 * radius * law.shape(), radius, clearance);
  const PolarForce<double> compiled = film_force(law, bearing, oil, state);
  const PolarForce<double> solved = solved_by_series(law, state, tolerance);
  return std::hypot(compiled.radial - solved.radial, compiled.tangential - solved.tangential) /
         std::hypot(solved.radial, solved.tangential);
}

/// Motions of a journal at e = (½, 0) at which the films' limits are looked at: a steady wedge, closing and opening.
const std::array<Vector2<double>, 4> limit_motions{Vector2<double>(0, -1), Vector2<double>(0.3, 0.9),
                                                   Vector2<double>(0.8, -0.6), Vector2<double>(-0.6, 0.8)};

using D = Dual<double, 4>;

/// F/S with its derivatives in ê and u.
template <class Law>
Vector2<D> differentiated(const Law& law, const Vector2<double>& e, const Vector2<double>& u) {
  const Vector2<D> e_hat(D::variable(e.x(), 0), D::variable(e.y(), 1));
  const Vector2<D> velocity(D::variable(u.x(), 2), D::variable(u.y(), 3));
  return compiled_force_ratio(law, FilmState<D>(e_hat, velocity));
}

template <class Law>
Eigen::Matrix<double, 2, 4> jacobian(const Law& law, const Vector2<double>& e, const Vector2<double>& u) {
  const Vector2<D> force = differentiated(law, e, u);
  Eigen::Matrix<double, 2, 4> j;
  j << force.x().derivatives().transpose(), force.y().derivatives().transpose();
  return j;
}

template <class Law>
Vector2<double> ratio(const Law& law, const Vector2<double>& e, const Vector2<double>& u) {
  return compiled_force_ratio(law, FilmState<double>(e, u));
}

}  // namespace

TEST_CASE("compiled films: off their nodes they agree with another solver to the error that they state") {
  for (const char* shape : shipped_shapes) {
    for_each_shipped(shape, [&]<class Law>(const Law& law) {
      const CompiledFilm table = read_compiled_film(shipped_text(Law::name, shape));
      constexpr bool cavitated = std::is_same_v<Law, FiniteReynolds>;
      RandomStates states;
      double worst = 0;
      PolarFilmState<double> place(0, 0, 0);
      for (int n = 0; n < (cavitated ? 25 : 150); ++n) {
        const auto state = states.polar(table.ratio_limit);
        const double found = difference(law, state, cavitated ? 5e-5 : 1e-9);
        if (found > worst) place = state;
        worst = std::max(worst, found);
      }
      INFO("worst " << worst << " at eccentricity ratio " << place.eccentricity_ratio << ", a " << place.slip_rate
                    << ", b " << place.squeeze_rate);
      CHECK(worst <= table.error + (cavitated ? 5e-5 : 1e-9));  // the table's statement and the solver's estimate
      CHECK(table.ratio_limit >= (cavitated ? 0.95 : 0.99));
      // What the laws are meant to reach: a thousandth where the film has a free boundary, else 1e-5, a full film 1e-6.
      CHECK(table.error <= (cavitated ? 1e-3 : std::is_same_v<Law, FiniteFull> ? 1e-6 : 1e-5));
    });
  }
}

TEST_CASE("compiled films: a table of another bearing is found out") {
  // The statement of the error must be able to fail: the table of one L/D, said to be of another, is far off.
  CompiledFilm table = read_compiled_film(shipped_text("finite_dynamic", "1"));
  table.shape = 1.001;
  CHECK(difference(FiniteDynamic(table), {0.5, 1, 1}, 1e-9) > 10 * table.error);
  const Bearing<double> other(2 * radius, radius, clearance);
  CHECK_THROWS_WITH(film_force(FiniteDynamic(table), other, oil, PolarFilmState<double>(0.5, 1, 0)),
                    Catch::Contains("compiled for length over diameter 1.001, the bearing has 1"));
}

TEST_CASE("compiled films: derivatives are those of the force") {
  RandomStates states;
  for_each_shipped("0.5", [&](const auto& law) {
    for (int n = 0; n < 60; ++n) {
      const FilmState<double> state = states.next(0.97);
      const Eigen::Matrix<double, 2, 4> exact = jacobian(law, state.eccentricity, state.velocity);
      Eigen::Matrix<double, 2, 4> differences;
      const double step = 1e-6;
      for (int i = 0; i < 2; ++i) {
        const Vector2<double> d = step * Vector2<double>::Unit(i);
        differences.col(i) =
            (ratio(law, state.eccentricity + d, state.velocity) - ratio(law, state.eccentricity - d, state.velocity)) /
            (2 * step);
        differences.col(2 + i) =
            (ratio(law, state.eccentricity, state.velocity + d) - ratio(law, state.eccentricity, state.velocity - d)) /
            (2 * step);
      }
      INFO("e (" << state.eccentricity.transpose() << "), u (" << state.velocity.transpose() << ")");
      // Central differences: (step/(1−ε))² of the derivative, and rounding over the step.
      CHECK((exact - differences).norm() < 1e-6 * exact.norm());
    }
  });
}

TEST_CASE("compiled films: homogeneous in u, mirrored with their state, turned with it") {
  RandomStates states;
  for_each_shipped("2.0408163265306123", [&](const auto& law) {
    for (int n = 0; n < 60; ++n) {
      const FilmState<double> state = states.next(0.98);
      const Vector2<double> e = state.eccentricity;
      const Vector2<double> u = state.velocity;
      const Vector2<double> force = ratio(law, e, u);
      const double rounding = 1e-12 * force.norm();  // that of ê and q, times how steeply the force grows at 0.98
      CHECK((ratio(law, e, Vector2<double>(1024 * u)) - 1024 * force).norm() <= 1024 * rounding);
      CHECK((ratio(law, e, Vector2<double>(1e-200 * u)) / 1e-200 - force).norm() <= rounding);
      const auto mirrored = [](const Vector2<double>& v) { return Vector2<double>(v.x(), -v.y()); };
      CHECK((ratio(law, mirrored(e), mirrored(u)) - mirrored(force)).norm() <= rounding);
      const Eigen::Matrix2d turn = (Eigen::Matrix2d() << 0.6, -0.8, 0.8, 0.6).finished();
      CHECK((ratio(law, Vector2<double>(turn * e), Vector2<double>(turn * u)) - turn * force).norm() <= rounding);
      CHECK(dot(force, u) < 0);  // passive
    }
  });
}

TEST_CASE("compiled films: full and cavitating forces are gradients in u, to rounding") {
  RandomStates states;
  const auto asymmetry = [](const auto& law, const FilmState<double>& state) {
    const Eigen::Matrix2d j = jacobian(law, state.eccentricity, state.velocity).template rightCols<2>();
    return std::abs(j(0, 1) - j(1, 0)) / j.norm();
  };
  for (const char* shape : shipped_shapes) {
    INFO("L/D " << shape);
    const auto full = shipped<FiniteFull>(shape);
    const auto reynolds = shipped<FiniteReynolds>(shape);
    const auto not_a_gradient = shipped<FiniteDynamic>(shape);
    double dynamic = 0;
    for (int n = 0; n < 200; ++n) {
      const FilmState<double> state = states.next(0.98);
      CHECK(asymmetry(full, state) < 1e-13);      // rounding
      CHECK(asymmetry(reynolds, state) < 1e-12);  // rounding, of second derivatives of the series
      dynamic = std::max(dynamic, asymmetry(not_a_gradient, state));
    }
    CHECK(dynamic > 0.01);  // the dynamic film's is none: the test can fail
  }
}

TEST_CASE("compiled films: smooth through the centre; the value at rest is zero, its derivatives are finite") {
  for_each_shipped("0.25", [&]<class Law>(const Law& law) {
    const Vector2<double> u(0.6, -0.8);
    if constexpr (!std::is_same_v<Law, FiniteHalf>) {  // which depends on e's direction there, as all its kind
      const auto centre = jacobian(law, Vector2<double>(0, 0), u);
      for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
        const Vector2<double> near = 1e-7 * Vector2<double>(std::cos(angle), std::sin(angle));
        CHECK((jacobian(law, near, u) - centre).norm() < 1e-5 * centre.norm());  // 1e-7 away, second derivatives of 10
      }
      // Isotropic at the centre.
      CHECK(std::abs(cross(ratio(law, Vector2<double>(0, 0), u), u)) < 1e-13 * centre.norm());
    }
    for (const Vector2<double>& e : {Vector2<double>(0, 0), Vector2<double>(0.3, 0.4)}) {
      const Vector2<D> rest = differentiated(law, e, Vector2<double>(0, 0));
      CHECK(rest.x().value() == 0);
      CHECK(rest.y().value() == 0);
      CHECK(jacobian(law, e, Vector2<double>(0, 0)).allFinite());
      CHECK(jacobian(law, e, Vector2<double>(0, 0)).template rightCols<2>().norm() > 0);
    }
  });
}

TEST_CASE("compiled films: at the centre and near it, force and slopes in e are those of the solver") {
  struct Place {
    Vector2<double> e, u;
  };
  // The centre, a closing and an opening film beside it; neither of them is steady, with u at a right angle to e.
  const std::array<Place, 3> places{Place{{0, 0}, {1, 0}}, Place{{6e-4, 8e-4}, {0.96, 0.28}},
                                    Place{{-0.03, 0.04}, {0.96, 0.28}}};
  for (const char* shape : shipped_shapes) {
    for (const Place& place : places) {
      INFO("L/D " << shape << ", e (" << place.e.transpose() << ")");
      const auto solved = [&](const auto& law, const Vector2<double>& e, double tolerance) {
        return oracle::finite_force(oracle::finite_film_of(law.name), law.shape(), {e, place.u}, {tolerance}).ratio;
      };
      /// Largest difference of slopes over a force, with central differences of fourth order.
      const auto slopes_off = [&](const auto& law, double step, double tolerance, double scale) {
        Eigen::Matrix2d slopes;
        for (int i = 0; i < 2; ++i) {
          const Vector2<double> d = step * Vector2<double>::Unit(i);
          const auto change = [&](const Vector2<double>& by) {
            return Vector2<double>(solved(law, place.e + by, tolerance) - solved(law, place.e - by, tolerance));
          };
          slopes.col(i) = (8 * change(d) - change(2 * d)) / (12 * step);
        }
        return (jacobian(law, place.e, place.u).template leftCols<2>() - slopes).norm() / scale;
      };
      const auto slope = [&](const auto& law) { return jacobian(law, place.e, place.u).template leftCols<2>().norm(); };
      const auto force_off = [&](const auto& law, double tolerance) {
        const Vector2<double> expected = solved(law, place.e, tolerance);
        return (ratio(law, place.e, place.u) - expected).norm() / expected.norm();
      };
      const auto statement = [&](const auto& law) { return read_compiled_film(shipped_text(law.name, shape)).error; };

      const auto dynamic = shipped<FiniteDynamic>(shape);
      // step⁴/30 = 5e-9 of fifth derivatives, some hundred times the first; the solver's 1e-10 over the step.
      CHECK(slopes_off(dynamic, 0.02, 1e-10, slope(dynamic)) < 1e-5);
      CHECK(force_off(dynamic, 1e-10) <= statement(dynamic) + 1e-10);  // the solver's tolerance

      const auto reynolds = shipped<FiniteReynolds>(shape);
      // The solver's 2e-5 of the force over the step, 3e-4; step⁴/30 = 4e-7 of fifth derivatives.
      CHECK(slopes_off(reynolds, 0.06, 2e-5, slope(reynolds)) < 5e-4);
      CHECK(force_off(reynolds, 2e-5) <= statement(reynolds) + 2e-5);  // the solver's tolerance

      const auto full = shipped<FiniteFull>(shape);
      // As of the dynamic film, over the force: the slopes themselves vanish with e.
      CHECK(slopes_off(full, 0.02, 1e-10, ratio(full, place.e, place.u).norm()) < 1e-5);
      CHECK(force_off(full, 1e-10) <= statement(full) + 1e-10);  // the solver's tolerance
      CHECK((slope(full) == 0) == (place.e.norm() == 0));        // even in e
    }
  }
}

TEST_CASE("compiled films: beyond the table they go on without a jump, and stay finite up to the wall") {
  for_each_shipped("1", [&](const auto& law) {
    for (const Vector2<double>& u : {Vector2<double>(1, 0), Vector2<double>(0, 1), Vector2<double>(-0.8, 0.6)}) {
      double last = 0;
      for (double gap = 0.02; gap > 1e-14; gap /= 1.02) {
        const FilmState<double> state(Vector2<double>(1 - gap, 0), u, gap * (2 - gap));
        const Vector2<double> force = compiled_force_ratio(law, state);
        INFO("1 - e " << gap << ", u (" << u.transpose() << ")");
        REQUIRE(force.allFinite());
        CHECK(dot(force, u) < 0);
        // The force grows at most like gap^(-5/2): a step of 2 % is 5 %. A jump would be more than a step's change.
        if (last > 0) CHECK(std::abs(force.norm() / last - 1) < 0.06);
        last = force.norm();
      }
    }
  });
}

TEST_CASE("compiled films: as L/D goes to infinity they are the long films, less what is lost at the ends") {
  const auto check = []<class Law, class Long>() {
    const Law ten(reports::compile_film(Law::name, 10, {2, {}}));
    const Law five(reports::compile_film(Law::name, 5, {2, {}}));
    for (const Vector2<double>& u : limit_motions) {
      const FilmState<double> state(Vector2<double>(0.5, 0), u);
      const Vector2<double> at_ten = ratio(ten, state.eccentricity, u);
      const Vector2<double> at_five = ratio(five, state.eccentricity, u);
      const Vector2<double> endless = force_ratio<Long>(state);
      INFO(Law::name << ", u (" << u.transpose() << ")");
      // F = F_long (1 − k D/L) + O(e^(−L/R)): two bearings give the limit.
      CHECK((2 * at_ten - at_five - endless).norm() < 1e-4 * endless.norm());  // e^(−10), of k D/L up to 0.2
      CHECK((at_ten - endless).norm() > 0.05 * endless.norm());
    }
  };
  check.operator()<FiniteFull, LongFull>();
  check.operator()<FiniteHalf, LongHalf>();
  check.operator()<FiniteDynamic, LongDynamic>();
}

TEST_CASE("compiled films: as L/D goes to 0 they are the short films, at the order that the film's cut ends allow") {
  const auto check = []<class Law, class Short>() {
    const Law wide(reports::compile_film(Law::name, 0.1, {2, {}}));
    const Law narrow(reports::compile_film(Law::name, 0.05, {2, {}}));
    for (const Vector2<double>& u : limit_motions) {
      const FilmState<double> state(Vector2<double>(0.5, 0), u);
      const Vector2<double> limit = force_ratio<Short>(state);
      // Over the scale of the short film, μRL³/c², where the compiled law's is μLR³/c².
      const auto apart = [&](const Law& law) {
        const Vector2<double> force = ratio(law, state.eccentricity, u) / (4 * law.shape() * law.shape());
        return Vector2<double>((force - limit) / limit.norm());
      };
      const double order = std::log2(apart(wide).norm() / apart(narrow).norm());
      INFO(Law::name << ", u (" << u.transpose() << ")");
      // The short pressure vanishes at the ends of a film that lies in front of the motion, and nothing but its
      // curvature around the film is missing: (L/D)². A half film in squeeze is cut where the short pressure is not
      // zero, and loses a layer there that is as wide as the bearing is long: L/D.
      const bool cut = std::is_same_v<Law, FiniteHalf> && u.x() != 0;
      // Second term of the order, 0.05 of it; of a cut film up to (L/D)² of the other kind beside 0.02 of the layer.
      CHECK(std::abs(order - (cut ? 1 : 2)) < (cut ? 0.2 : 0.1));
      // What two bearings leave when that term is taken out: the next one.
      const double factor = cut ? 2 : 4;
      const double left = (factor * apart(narrow) - apart(wide)).norm() / (factor - 1);
      CHECK(left < (cut ? 0.01 : 5e-4));  // (L/D)² and (L/D)³ of the wider bearing, times half of one
    }
  };
  check.operator()<FiniteFull, ShortFull>();
  check.operator()<FiniteHalf, ShortHalf>();
  check.operator()<FiniteDynamic, ShortDynamic>();
}

TEST_CASE("compiled films: files read back to the bit, and nothing damaged or foreign is read") {
  const std::string text = shipped_text("finite_half", "0.5");
  const CompiledFilm film = read_compiled_film(text);
  CHECK(compiled_film_text(film) == text);
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string damaged = text;
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    if (damaged != text) CHECK_THROWS_AS(read_compiled_film(damaged), CompiledFilmError);
    CHECK_THROWS_AS(read_compiled_film(text.substr(0, at)), CompiledFilmError);
  }
  CHECK_THROWS_WITH(read_compiled_film(text + "x\n"), Catch::Contains("should be the last"));
  CHECK_THROWS_WITH(read_compiled_film("id,fx,fy\n1,2,3\n"), Catch::Contains("line 1 should be"));
  CHECK_THROWS_WITH(FiniteFull(film), Catch::Contains("is one of \"finite_half\""));
  CompiledFilm cut = film;
  cut.coefficients.pop_back();
  CHECK_THROWS_WITH(FiniteHalf(cut), Catch::Contains("83 coefficients; allowed are 84"));
  CompiledFilm infinite = film;
  infinite.coefficients[3] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(FiniteHalf(infinite), Catch::Contains("not finite"));
  CompiledFilm unmeasured = film;
  unmeasured.ratio_limit = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(FiniteHalf(unmeasured), Catch::Contains("eccentricity ratio nan"));
  unmeasured = film;
  unmeasured.error = -1e-9;
  CHECK_THROWS_WITH(FiniteHalf(unmeasured), Catch::Contains("the error -1e-09"));
  CHECK_THROWS_WITH(reports::compile_film("finite_full", 11), Catch::Contains("0.05"));
  CHECK_THROWS_WITH(reports::compile_film("finite", 1), Catch::Contains("finite_full, finite_half"));
}

TEST_CASE("compiled films: what is compiled now is what ships") {
  const CompiledFilm shipped = read_compiled_film(shipped_text("finite_dynamic", "0.25"));
  const CompiledFilm made = reports::compile_film("finite_dynamic", 0.25, {2, {}});
  REQUIRE(made.coefficients.size() == shipped.coefficients.size());
  double off = 0;
  for (std::size_t i = 0; i < made.coefficients.size(); ++i) {
    off = std::max(off, std::abs(made.coefficients[i] - shipped.coefficients[i]));
  }
  // Rounding of the solver: at the table's last place, where 1 - e/c is 2e-6, it leaves 1e-4 of the force, and a
  // coefficient has a hundredth of that.
  CHECK(off < 1e-6);
  const FiniteDynamic old_law(shipped);
  const FiniteDynamic new_law(made);
  for (const double epsilon : {0.1, 0.5, 0.9, shipped.ratio_limit}) {
    for (const double slip : {-1.0, 0.2, 1.0}) {
      for (const double squeeze : {-1.0, 0.3, 1.0}) {
        const PolarFilmState<double> state(epsilon, slip, squeeze);
        const PolarForce<double> one = compiled_polar_force_ratio(old_law, state);
        const PolarForce<double> other = compiled_polar_force_ratio(new_law, state);
        // A tenth of the error that is stated: what that place does to the others.
        CHECK(std::hypot(one.radial - other.radial, one.tangential - other.tangential) <=
              0.1 * shipped.error * std::hypot(one.radial, one.tangential));
      }
    }
  }
}

TEST_CASE("compiled films: ten thousand states each are stored, the worst is what it is, and a wrong table is found") {
  const std::string file = LUBJOINT_SOURCE_DIR "/data/measured/compiled-films.csv";
  const reports::CsvTable table(reports::read_input(file), file);
  CHECK(table.header() == reports::film_check_header);
  CHECK(table.rows() == 20);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    INFO(table.line(row));
    const auto value = [&](const char* column) { return table.number(row, table.column(column)); };
    const std::string name = table.line(row).substr(0, table.line(row).find(','));
    const bool ships = row < 4 * shipped_shapes.size();
    const std::string shape = ships ? shipped_shapes.at(row / 4) : "4";
    CHECK(name == names_of_laws<CompiledLaws>.at(row % 4));
    CHECK(value("length_over_diameter") == std::stod(shape));
    CHECK(value("states") == 10000);
    CHECK(value("beyond") == 0);
    // What the laws are meant to reach.
    CHECK(value("worst") <= (name == "finite_full" ? 1e-6 : name == "finite_reynolds" ? 1e-3 : 1e-5));
    CHECK(value("worst") <= value("stated_error") + value("solver_bound"));
    if (!ships) continue;  // no table of L/D 4 ships that could be held against its row; making one takes a minute
    CompiledFilm film = read_compiled_film(shipped_text(name, shape));
    CHECK(value("stated_error") == Approx(film.error).epsilon(0.005));  // three digits
    const auto [off, bound] = reports::difference_from_solver(film, value("eccentricity_ratio"), value("direction"));
    // The solver's own error where other processors round otherwise, and three digits.
    CHECK(std::abs(off - value("worst")) <= bound + 0.005 * off);
    const reports::FilmCheck few = reports::check_film(film, 20, {2, {}});
    CHECK(few.worst <= value("worst") + bound);  // the first of the same states
    CHECK(few.worst > 0);
    CHECK(few.beyond == 0);
    film.error = few.worst / 1e3;
    film.coefficients.front() += name == "finite_reynolds" ? 3e-3 : 1e-5;
    CHECK(reports::check_film(film, 20, {2, {}}).beyond > 0);
  }
}

}  // namespace compiled_film_test
