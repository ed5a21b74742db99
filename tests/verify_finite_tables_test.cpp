// Tables of films of the bearing's real length: coefficients, places of rest and losses, judged by the solvers.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "lubjoint/film/compiled_coefficients.hpp"
#include "lubjoint/film/losses.hpp"
#include "oracle/verify/states/films_by_solver.hpp"
#include "support/compiled_films.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/solved_films.hpp"

namespace verify_finite_tables_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;
using Catch::Contains;
using oracle::FiniteFilm;

namespace {

constexpr std::array films = {"finite_full"_law, "finite_half"_law, "finite_dynamic"_law, "finite_reynolds"_law};

}  // namespace

TEST_CASE("verify finite tables: places, stiffness and damping are those of the golden data, within both bounds") {
  const auto golden = read_csv((golden_folder() / "finite_length/finite_film_coefficients.csv").string());
  const auto solved = solved_films(oracle::FilmOnset::free, 2);
  for (const CsvRow& row : golden) {
    const auto number = [&](const std::string& column) { return test::number(row.at(column)); };
    const Law law = law_of(row.at("film"));
    const double shape = number("length_over_diameter"), ratio = number("eccentricity_ratio");
    INFO(name_of(law) << " at L/D " << shape << ", ratio " << ratio);
    const SteadySlopes s = solved->slopes(law, shape, ratio);
    const RestErrors errors = solved->errors_at_rest(law, shape, ratio);
    const bool on_grids = law == "finite_reynolds"_law;
    CHECK(errors.force <= (on_grids ? 6e-4 : 2e-9));      // as the header says
    CHECK(errors.stiffness <= (on_grids ? 4e-3 : 5e-7));  // likewise
    CHECK(errors.damping <= (on_grids ? 4e-3 : 5e-7));    // likewise
    CHECK(std::abs(static_cast<double>(s.size()) - number("load")) <=
          number("load_uncertainty") + errors.force * number("load"));
    CHECK(std::abs(static_cast<double>(std::atan2(s.tangential, -s.radial)) - number("attitude")) <=
          number("attitude_uncertainty") + errors.force);
    // x along the load, y counter-clockwise of it: ours with the load along −y, turned by a right angle.
    const Real sine = s.tangential / s.size(), cosine = -s.radial / s.size();
    const PolarCoefficients polar = polar_coefficients(s, ratio, 1);
    const auto compare = [&](const Entries& in_rt, const std::string& letter, double bound, double uncertainty) {
      const Entries m = in_inertial_axes(in_rt, sine, cosine);
      const std::array<Real, 4> turned = {m[3], -m[2], -m[1], m[0]};
      Real largest = 0;
      for (const Real x : m) largest = std::max(largest, std::abs(x));
      const std::array<std::string, 4> axes = {"xx", "xy", "yx", "yy"};
      for (std::size_t k = 0; k < axes.size(); ++k) {
        CHECK(std::abs(static_cast<double>(turned[k]) - number(letter + axes[k])) <=
              uncertainty + bound * static_cast<double>(largest));
      }
    };
    compare(polar.stiffness, "k", errors.stiffness, number("stiffness_uncertainty"));
    compare(polar.damping, "c", errors.damping, number("damping_uncertainty"));
  }
  CHECK(golden.size() == 100);
}

TEST_CASE("verify finite tables: a pressure field's shear and dissipation are what torques and power are made of") {
  // Of a dynamic film: −½ e × F is the moment of the pressure's shear −(h/2R) ∂p/∂θ, −c F·u its dissipation.
  const State s = states_of("finite_dynamic"_law, Quantities::losses)[16];  // L/D ¼, ε 0.5, whirl and squeeze
  const Solution right = solve(Quantities::losses, "finite_dynamic"_law, s);
  const Bearing<double> bearing(s.length, s.radius, s.clearance);
  const PolarFilmState<double> state(static_cast<double>(right.ratio), static_cast<double>(right.a),
                                     static_cast<double>(right.b));
  const auto field = oracle::finite_length_pressure(FiniteFilm::finite_dynamic, bearing, Lubricant<double>(s.viscosity),
                                                    state, 2001, 201);
  const std::size_t stations = field.z.size();
  const auto p = [&](std::size_t i, std::size_t j) { return field.pressure[i * stations + j]; };
  const double along = field.z[1] - field.z[0], around = field.theta[1] - field.theta[0];
  double moment = 0, dissipated = 0;
  for (std::size_t i = 0; i + 1 < field.theta.size(); ++i) {
    const double h = s.clearance * (1 + state.eccentricity_ratio * std::cos(field.theta[i] + around / 2));
    for (std::size_t j = 0; j + 1 < stations; ++j) {  // at the middle of a cell
      const double by_theta = (p(i + 1, j) + p(i + 1, j + 1) - p(i, j) - p(i, j + 1)) / (2 * around);
      const double by_z = (p(i, j + 1) + p(i + 1, j + 1) - p(i, j) - p(i + 1, j)) / (2 * along);
      moment -= h / 2 * by_theta * s.radius * around * along;
      dissipated += h * h * h / (12 * s.viscosity) * (by_theta * by_theta / (s.radius * s.radius) + by_z * by_z) *
                    s.radius * around * along;
    }
  }
  const auto mean = static_cast<double>((right.costs.torque_journal + right.costs.torque_bearing) / 2);
  CHECK(moment == Approx(mean).epsilon(2e-3));  // differences across the film's ends, where dp/dθ jumps
  CHECK(dissipated == Approx(static_cast<double>(right.costs.squeeze_power)).epsilon(2e-3));  // likewise
}

TEST_CASE("verify finite tables: coefficients of the compiled laws agree, and are refused a percent beside them") {
  for (const Law law : films) {
    const bool on_grids = law == "finite_reynolds"_law;
    with_film_law<CompiledLaws>(name_of(law), [&]<class Compiled>() {
      std::vector<State> states;
      for (const State& state : states_of(law, Quantities::coefficients)) {
        // No table of L/D 2 ships, and a film with a free boundary takes a second a bearing.
        const bool is_asked = on_grids ? state.length == state.radius : state.length < 3 * state.radius;
        if (is_asked) states.push_back(state);
      }
      std::map<double, Compiled> laws;
      for (const auto& [shape, name] : {std::pair(0.25, "0.25"), std::pair(0.5, "0.5"), std::pair(1.0, "1")}) {
        laws.emplace(shape, Compiled(*shipped_film(name_of(law), name)));
      }
      const auto answer = [&](const State& s) {
        const Compiled& compiled =
            laws.at(std::ldexp(1.0, static_cast<int>(std::lround(std::log2(s.length / s.radius / 2)))));
        const auto ratio = static_cast<double>(solve(Quantities::equilibrium, law, s).ratio);
        const Bearing<double> bearing(s.length, s.radius, s.clearance);
        const SteadyPlace<double> place(ratio);
        const SteadyFilm<double> rest = steady_film_of<double>(
            bearing, force_scale(Compiled::limit, bearing, Lubricant<double>(s.viscosity)),
            [&](const auto& film) { return compiled_polar_force_ratio(compiled, film); }, place, s.omega,
            coefficient_ratios(compiled, place, s.omega < 0 ? -1 : 1));
        const auto &k = rest.stiffness, &c = rest.damping;
        return std::array<double, most_answers>{ratio,   rest.attitude, k(1, 1),  -k(1, 0), -k(0, 1),
                                                k(0, 0), c(1, 1),       -c(1, 0), -c(0, 1), c(0, 0)};
      };
      const Answers answers = answers_of(Quantities::coefficients, states, answer);
      const Verification right = judged(law, Quantities::coefficients, states, answers);
      INFO(text_report(right));
      CHECK(right.verdict == Verdict::agrees);
      CHECK(right.judgement.undecided == 0);
      if (on_grids) return;  // whose search takes 31 bearings of its own
      Answers off = answers;
      for (Answer& each : off.values) each[3] *= 1.02;  // kxy, which no film has zero
      CHECK(judged(law, Quantities::coefficients, states, off).verdict != Verdict::agrees);
    });
  }
}

TEST_CASE("verify finite tables: losses of the compiled laws, and the other solver's side flow, agree") {
  for (const Law law : {"finite_full"_law, "finite_half"_law, "finite_dynamic"_law}) {
    with_film_law<CompiledLaws>(name_of(law), [&]<class Compiled>() {
      const Compiled compiled(*shipped_film(name_of(law), "0.5"));
      std::vector<State> states;
      for (const State& state : states_of(law, Quantities::losses)) {
        if (state.length == state.radius) states.push_back(state);
      }
      const auto answer = [&](const State& s) {
        const Bearing<double> bearing(s.length, s.radius, s.clearance);
        const JournalMotion<double> motion{{s.ex, s.ey}, {s.vx, s.vy}, s.omega_bearing, s.omega_journal};
        const FilmState<double> film = film_state(motion, bearing.clearance());
        const Lubricant<double> oil(s.viscosity);
        const double scale = force_scale(Compiled::limit, bearing, oil);
        const Vector2<double> force = scale * compiled_force_ratio(compiled, film);
        const double rate = couette_scale(bearing, oil) * couette_integral<Compiled>(film, ShearExtent::film);
        const FilmLosses<double> losses =
            losses_of(force, film, bearing.clearance(), rate, s.omega_journal - s.omega_bearing);
        const oracle::FiniteFlow flow =
            oracle::finite_side_flow(oracle::finite_film_of(name_of(law)), 0.5, film, {1e-6});  // the axial series
        return std::array<double, most_answers>{losses.torque_journal, losses.torque_bearing, losses.power(),
                                                s.clearance * s.radius * s.length * flow.ratio};
      };
      const Verification v = judged(law, Quantities::losses, states, answers_of(Quantities::losses, states, answer));
      INFO(text_report(v));
      CHECK(states.size() == 30);
      CHECK(v.verdict == Verdict::agrees);
    });
  }
}

TEST_CASE("verify finite tables: what is not judged of these films is refused with what is") {
  const auto asked = [](const std::string& law, std::vector<std::string> more) {
    std::vector<std::string> words = {"verify", "--states-out", "-", "--law", law, "--quantities"};
    words.insert(words.end(), more.begin(), more.end());
    return lubjoint_program(words);
  };
  const auto refused = [&](const std::string& law, const std::vector<std::string>& more) {
    const ProgramResult result = asked(law, more);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    return result.err;
  };
  CHECK_THAT(
      refused("finite_half", {"dimensionless"}),
      Contains("--quantities dimensionless") &&
          Contains("cartesian, polar, wrench, transition, extent, pressure, coefficients, equilibrium and losses"));
  CHECK_THAT(refused("finite_reynolds", {"extent"}), Contains("another angle") && Contains("allowed is pressure"));
  CHECK_THAT(refused("finite_reynolds", {"coefficients", "--onset", "maximum_film"}),
             Contains("maximum film") && Contains("cartesian, polar, wrench, transition, pressure and equilibrium"));
  CHECK_THAT(refused("finite_half", {"coefficients", "--shear", "flooded"}), Contains("--shear does nothing"));
  CHECK_THAT(refused("finite_full", {"losses", "--shear", "striated"}), Contains("finite_half"));
  CHECK_THAT(refused("finite_half", {"losses", "--states", "5"}),
             Contains("--states does nothing with --law finite_half"));
  CHECK_THAT(refused("finite_half", {"equilibrium", "--only", "omega == 5"}),
             Contains("no state") && Contains("omega == 5"));
  const std::vector<State> bare(3);  // that no solver stands behind
  CHECK_THROWS_WITH(judged("finite_half"_law, Quantities::equilibrium, bare, Answers{std::vector<Answer>(3), {}, {0}}),
                    Contains("no solver stands behind"));
  CHECK(parse_csv(asked("finite_half", {"equilibrium"}).out).size() == 56);
  CHECK(parse_csv(asked("finite_reynolds", {"equilibrium", "--onset", "maximum_film"}).out).size() == 56);
  CHECK(parse_csv(asked("finite_dynamic", {"losses", "--shear", "flooded"}).out).size() == 120);
}

TEST_CASE("verify finite tables: every mistake is named first") {
  check_every_mistake("finite_full"_law, Quantities::coefficients, 3, 45);
  check_every_mistake("finite_half"_law, Quantities::coefficients, 3, 45);
  check_every_mistake("finite_dynamic"_law, Quantities::equilibrium, 3, 25);
  check_every_mistake("finite_dynamic"_law, Quantities::losses, 7, 30);
  check_every_mistake("finite_reynolds"_law, Quantities::equilibrium, 9, 25);
  check_every_mistake("finite_reynolds"_law, Quantities::losses, 17, 30);
}

}  // namespace verify_finite_tables_test
