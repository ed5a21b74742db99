// Films of the bearing's real length in joints, and inside of them: wrenches, the transition to contact, where the film
// lies and its pressure, judged by the solvers.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "lubjoint/joint/touching_journal.hpp"
#include "lubjoint/joint/wrench.hpp"
#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "support/solved_films.hpp"

namespace verify_finite_joint_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;
using oracle::FiniteFilm;

namespace {

using Numbers = std::array<double, most_answers>;

constexpr std::array smooth = {"finite_full"_law, "finite_half"_law, "finite_dynamic"_law};

/// F/S of the film that ruptures, by finite elements.
Vector2<double> ratio_by_elements(double shape, const FilmState<double>& film) {
  const PolarView<double> view = polar_view(film);
  const double a = std::abs(view.state.slip_rate), b = view.state.squeeze_rate, rate = std::max(a, std::abs(b));
  const double epsilon = view.state.eccentricity_ratio;
  const oracle::ScaledForce force =
      oracle::cavitated_force_by_elements({epsilon, 1 - epsilon, a / rate, b / rate, shape}, 32);
  const double radial = 3 / shape * rate * force.value[0];  // p = 6 mu (R/c)^2 P and S = mu L R^3/c^2
  const double tangential = (view.state.slip_rate < 0 ? -3 : 3) / shape * rate * force.value[1];
  return Vector2<double>(radial * view.radial + tangential * perpendicular(view.radial));
}

/// The film's force by a solver that the judge does not use.
Vector2<double> film_force_of(Law law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                              const FilmState<double>& film) {
  const double shape = bearing.length() / (2 * bearing.radius());
  const Vector2<double> ratio =
      law == "finite_reynolds"_law
          ? ratio_by_elements(shape, film)
          : oracle::finite_force(oracle::finite_film_of(name_of(law)), shape, film, {1e-6}).ratio;
  return Vector2<double>(force_scale(BearingLimit::long_bearing, bearing, oil) * ratio);
}

JournalMotion<double> motion_of(const State& s) {
  return {{s.ex, s.ey}, {s.vx, s.vy}, s.omega_bearing, s.omega_journal};
}

Numbers wrench_of(Law law, const State& s) {
  const Bearing<double> bearing(s.length, s.radius, s.clearance);
  const JointKinematics<double> joint{{s.sx_i, s.sy_i}, {s.sx_j, s.sy_j}, motion_of(s)};
  const Vector2<double> f =
      film_force_of(law, bearing, Lubricant<double>(s.viscosity), film_state(joint.motion, bearing.clearance()));
  const JointWrenches<double> wrenches = joint_wrenches(joint, f);
  return {f.x(), f.y(), wrenches.bearing.moment, wrenches.journal.moment};
}

Numbers transition_of(Law law, const State& s) {
  const Bearing<double> bearing(s.length, s.radius, s.clearance);
  const Vector2<double> f = touching_journal_force_of<double>(
      bearing, TransitionTolerances<double>(s.e0, s.e1), ContactSurface<double>{s.contact_stiffness, s.restitution},
      motion_of(s), s.impact_speed, [&](const Bearing<double>& wide, const FilmState<double>& film) {
        return film_force_of(law, wide, Lubricant<double>(s.viscosity), film);
      });
  return {f.x(), f.y()};
}

/// P of a smooth film at (θ, ζ) by differences around it and harmonics along the axis, where u·m is its source: a
/// solver of this test's own. @param cut  P = 0 at its ends, which are start and start + π; else it goes all around
double harmonic_pressure(double shape, double ratio, double a, double b, bool cut, double start, double theta,
                         double zeta) {
  const int n = 1200;  // second order: 1e-4 of the largest at ε = 0.9
  const double turn = 2 * pi<double>(), span = cut ? pi<double>() : turn, step = span / n;
  double past = std::fmod(theta - start, turn);
  if (past < 0) past += turn;
  if (past >= span || std::abs(zeta) >= shape) return 0;
  const auto h3 = [&](double t) { return std::pow(1 + ratio * std::cos(t), 3); };
  const int here = static_cast<int>(past / step);
  const double part = past / step - here;
  double sum = 0;
  for (int harmonic = 1; harmonic < 60; harmonic += 2) {  // whose rest falls like the square of their number
    const double k = harmonic * pi<double>() / (2 * shape);
    const double weight = 2 * std::sin(harmonic * pi<double>() / 2) / (k * shape);
    const int first = cut ? 1 : 0, count = n - first;
    Eigen::SparseMatrix<double> matrix(count, count);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(count);
    for (int i = first; i < n; ++i) {
      const double t = start + i * step, before = h3(t - step / 2) / (step * step),
                   after = h3(t + step / 2) / (step * step);
      const int row = i - first;
      entries.emplace_back(row, row, before + after + k * k * h3(t));
      if (!cut || i > first) entries.emplace_back(row, (row + count - 1) % count, -before);
      if (!cut || i + 1 < n) entries.emplace_back(row, (row + 1) % count, -after);
      right[row] = weight * (a * std::sin(t) - 2 * b * std::cos(t));
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    const Eigen::VectorXd p = factors.solve(right);
    const auto at = [&](int i) { return cut ? (i <= 0 || i >= n ? 0.0 : p[i - 1]) : p[i % n]; };
    sum += std::cos(k * zeta) * ((1 - part) * at(here) + part * at(here + 1));
  }
  return sum;
}

Numbers pressure_of(Law law, const State& s) {
  const double a = s.eccentricity_ratio * (s.omega - 2 * s.attitude_rate), b = s.squeeze_rate;
  const double start = is_full(law) ? 0 : is_half(law) ? (a < 0 ? pi<double>() : 0) : std::atan2(2 * b, a);
  const double p = harmonic_pressure(s.length / (2 * s.radius), s.eccentricity_ratio, a, b, !is_full(law), start,
                                     s.theta, s.z / s.radius);
  return {6 * s.viscosity * std::pow(s.radius / s.clearance, 2) * p};
}

void agrees_and_says_no(Law law, Quantities quantities, const std::vector<State>& states,
                        const std::function<Numbers(Law, const State&)>& program) {
  const Answers answers = answers_of(quantities, states, [&](const State& s) { return program(law, s); });
  const Verification right = judged(law, quantities, states, answers);
  INFO(text_report(right));
  CHECK(right.verdict == Verdict::agrees);
  CHECK(10 * right.judgement.undecided <= states.size());
  for (const std::size_t column : right.judgement.columns) {  // each of them alone
    Answers off = answers;
    for (Answer& each : off.values) each[column] *= 1.01;
    const Verification wrong = judged(law, quantities, states, off);
    INFO("column " << column << ": " << text_report(wrong));
    CHECK(wrong.verdict != Verdict::agrees);
  }
}

}  // namespace

TEST_CASE("verify finite joint: wrenches by the other solver agree, and are refused a percent beside it") {
  for (const Law law : smooth) {
    agrees_and_says_no(law, Quantities::wrench, some_states(law, Quantities::wrench, 7), wrench_of);
  }
  const Law ruptures = "finite_reynolds"_law;
  agrees_and_says_no(ruptures, Quantities::wrench, some_states(ruptures, Quantities::wrench, 17), wrench_of);
}

TEST_CASE("verify finite joint: an onset at the maximum film is another film in steady rotation, and judged as it") {
  const oracle::FilmOnset pinned = oracle::FilmOnset::maximum_film;
  for (const Quantities quantities : {Quantities::wrench, Quantities::pressure}) {
    const std::string motion =
        quantities == Quantities::wrench ? "omega_bearing == 0, speed == 0" : "squeeze_rate == 0, attitude_rate == 0";
    std::vector<State> states;
    for (const State& s : solved_film_states({FiniteFilm::finite_reynolds, pinned}, quantities,
                                             read_conditions(quantities, motion), ShearExtent::film, 2)) {
      if (s.length == s.radius) states.push_back(s);
    }
    REQUIRE(states.size() == 10);
    const auto program = [&](oracle::FilmOnset onset) {
      return answers_of(quantities, states, [&](const State& s) -> Numbers {
        if (quantities == Quantities::pressure) {
          const PolarFilmState<double> state(s.eccentricity_ratio, s.eccentricity_ratio * s.omega, 0);
          return {
              s.viscosity * std::pow(s.radius / s.clearance, 2) *
              oracle::finite_pressure(FiniteFilm::finite_reynolds, 0.5, state, s.theta, s.z / s.radius, onset).ratio};
        }
        const Bearing<double> bearing(s.length, s.radius, s.clearance);
        const JointKinematics<double> joint{{s.sx_i, s.sy_i}, {s.sx_j, s.sy_j}, motion_of(s)};
        // Not by way of u, whose rounding along e would be squeeze, in which nothing is pinned.
        const Vector2<double> r = direction(joint.motion.eccentricity);
        const double ratio = norm(joint.motion.eccentricity) / s.clearance;
        const PolarFilmState<double> state(ratio, ratio * s.omega_journal, 0);
        const Vector2<double> along =
            force_scale(BearingLimit::long_bearing, bearing, Lubricant<double>(s.viscosity)) *
            oracle::finite_force(FiniteFilm::finite_reynolds, 0.5, state.in_own_frame(), {1e-4, onset}).ratio;
        const Vector2<double> f = along.x() * r + along.y() * perpendicular(r);
        const JointWrenches<double> wrenches = joint_wrenches(joint, f);
        return {f.x(), f.y(), wrenches.bearing.moment, wrenches.journal.moment};
      });
    };
    INFO(name_of(quantities));
    CHECK(judged("finite_reynolds"_law, quantities, states, program(pinned)).verdict == Verdict::agrees);
    const Verification other = judged("finite_reynolds"_law, quantities, states, program(oracle::FilmOnset::free));
    INFO(text_report(other));
    CHECK(!other.accepted());
    if (quantities == Quantities::pressure) continue;  // one place of ten shows it
    REQUIRE(!other.suspicions.empty());
    CHECK(other.suspicions[0].names({&mistake_of("other_onset")}));
  }
}

TEST_CASE("verify finite joint: transitions by the other solver agree, and are refused a percent beside it") {
  for (const Law law : smooth) {
    agrees_and_says_no(law, Quantities::transition, some_states(law, Quantities::transition, 7), transition_of);
  }
  const Law ruptures = "finite_reynolds"_law;
  agrees_and_says_no(ruptures, Quantities::transition, some_states(ruptures, Quantities::transition, 17),
                     transition_of);
  // Inside of the clearance, in the blend and beyond it.
  std::array<int, 3> phases{};
  for (const State& s : states_of("finite_full"_law, Quantities::transition)) {
    const double depth = std::hypot(s.ex, s.ey) - s.clearance;
    ++phases[depth <= 0 ? 0 : depth < s.e0 ? 1 : 2];
    CHECK(std::hypot(s.ex, s.ey) < 0.9 * (s.clearance + s.e1));
  }
  CHECK(phases == std::array{48, 48, 24});
}

TEST_CASE("verify finite joint: pressures by an own solver agree, and are refused a percent beside it") {
  for (const Law law : smooth) {
    agrees_and_says_no(law, Quantities::pressure, some_states(law, Quantities::pressure, 7), pressure_of);
  }
}

TEST_CASE(
    "verify finite joint: a film with a free boundary has its pressure to the bound, as a grid twice as fine says") {
  // At places of the film and beside it; the finer one's own error is a quarter as large.
  const auto shapes = {std::pair(0.25, 0.9), std::pair(1.0, 0.5), std::pair(2.0, 0.9)};
  for (const auto& [shape, ratio] : shapes) {
    const PolarFilmState<double> state(ratio, ratio, 0.25);
    const Bearing<double> bearing(2 * shape, 1, 0.5);
    const auto field =
        oracle::finite_length_pressure(FiniteFilm::finite_reynolds, bearing, Lubricant<double>(0.25), state, 1441, 193);
    for (std::size_t i = 5; i < 1440; i += 97) {
      const std::size_t j = 5 + i % 91;
      const oracle::FinitePressure p =
          oracle::finite_pressure(FiniteFilm::finite_reynolds, shape, state, field.theta[i], field.z[j]);
      INFO("L/D " << shape << ", ratio " << ratio << ", theta " << field.theta[i] << ", z " << field.z[j]);
      const double off = std::abs(p.ratio - field.pressure[i * field.z.size() + j]);
      CHECK(off <= p.error);
      CHECK(off <= 6e-4 * p.largest);        // as the header says
      CHECK(p.error <= 1.5e-3 * p.largest);  // half of the change from half as many steps: three times the above
    }
  }
}

TEST_CASE("verify finite joint: where a film lies agrees with the formula, and a turned end does not") {
  for (const Law law : smooth) {
    const std::vector<State> states = states_of(law, Quantities::extent);
    const auto ends = [&](const State& s) -> Numbers {
      const double a = s.eccentricity_ratio * (s.omega - 2 * s.attitude_rate);
      if (is_full(law)) return {0, 2 * pi<double>()};
      const double start = is_half(law) ? (a < 0 ? pi<double>() : 0) : std::atan2(2 * s.squeeze_rate, a);
      return {start, start + pi<double>()};
    };
    const Answers answers = answers_of(Quantities::extent, states, ends);
    const Verification right = judged(law, Quantities::extent, states, answers);
    INFO(text_report(right));
    CHECK(right.verdict == Verdict::agrees);
    Answers off = answers;
    for (Answer& each : off.values) each[1] -= 0.02;
    CHECK(judged(law, Quantities::extent, states, off).verdict != Verdict::agrees);
  }
}

TEST_CASE("verify finite joint: what is wrong in thin films alone, or in one state, is never accepted") {
  const Law law = "finite_half"_law;
  for (const Quantities quantities : {Quantities::wrench, Quantities::pressure, Quantities::coefficients}) {
    const std::vector<State> states = some_states(law, quantities, 3);
    const auto right = [&](const State& s) { return solve(quantities, law, s).answer; };
    const auto judged_with = [&](const auto& is_off, double factor) {
      return judged(law, quantities, states, answers_of(quantities, states, [&](const State& s) {
                      auto answer = right(s);
                      for (Real& each : answer) each *= is_off(s) ? factor : 1;
                      return answer;
                    }));
    };
    INFO(name_of(quantities));
    CHECK(judged_with([](const State&) { return false; }, 1).verdict == Verdict::agrees);
    const auto is_thin = [&](const State& s) { return solve(quantities, law, s).ratio > 0.85L; };
    CHECK(!judged_with(is_thin, 1.37).accepted());
    CHECK(!judged_with([&](const State& s) { return &s == &states[4]; }, 1.05).accepted());
  }
}

TEST_CASE("verify finite joint: every mistake is named first") {
  check_every_mistake("finite_full"_law, Quantities::wrench, 1, 50);
  check_every_mistake("finite_half"_law, Quantities::wrench, 1, 50);
  check_every_mistake("finite_dynamic"_law, Quantities::transition, 1, 50);
  check_every_mistake("finite_half"_law, Quantities::extent, 1, 6);
  check_every_mistake("finite_dynamic"_law, Quantities::extent, 1, 6);
  check_every_mistake("finite_full"_law, Quantities::pressure, 1, 30);
  check_every_mistake("finite_dynamic"_law, Quantities::pressure, 1, 30);
  check_every_mistake("finite_reynolds"_law, Quantities::wrench, 17, 40);
  check_every_mistake("finite_reynolds"_law, Quantities::pressure, 7, 20);
}

}  // namespace verify_finite_joint_test
