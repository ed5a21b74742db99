// Programs for the film of the bearing's real length: right ones are accepted, wrong ones are told apart.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "oracle/verify/states/finite_film.hpp"
#include "support/run_program.hpp"

namespace verify_finite_test {

using namespace lubjoint;
using namespace lubjoint::test;
using namespace lubjoint::verify;
using Catch::Matchers::Contains;
using oracle::FilmOnset;
using oracle::FiniteFilm;
using Vec = Vector2<double>;

namespace {

/// Force in newtons of a Cartesian state, worked out here from the motion; by the solver that is not the judge's where
/// there are two.
Vec force_of(const FiniteClaim& claim, const State& s) {
  const JournalMotion<double> motion{Vec(s.ex, s.ey), Vec(s.vx, s.vy), s.omega_bearing, s.omega_journal};
  const double scale = s.viscosity * s.length * std::pow(s.radius, 3) / (s.clearance * s.clearance);
  const double tolerance = claim.film == FiniteFilm::finite_reynolds ? 1e-3 : 1e-7;
  const bool steady = s.vx == 0 && s.vy == 0;
  FilmState<double> film = film_state(motion, s.clearance);
  if (steady) {  // no squeeze at all, so that the onset may be pinned
    const Vec e = film.eccentricity;
    const double a = e.norm() * (s.omega_bearing + s.omega_journal);
    const Vec polar = oracle::finite_force(claim.film, s.length / (2 * s.radius),
                                           PolarFilmState<double>(e.norm(), a, 0).in_own_frame(),
                                           {tolerance, claim.onset, oracle::SmoothFilmMethod::circumferential_modes})
                          .ratio;
    const Vec r = e / e.norm();
    return scale * (polar.x() * r + polar.y() * perpendicular(r));
  }
  return scale * oracle::finite_force(claim.film, s.length / (2 * s.radius), film,
                                      {tolerance, claim.onset, oracle::SmoothFilmMethod::circumferential_modes})
                     .ratio;
}

Answers answers_of(const FiniteClaim& claim, const std::vector<State>& states) {
  Answers answers;
  for (const State& s : states) {
    const Vec force = force_of(claim, s);
    Answer answer{};
    answer[0] = force.x();
    answer[1] = force.y();
    answers.values.push_back(answer);
  }
  return answers;
}

/// Every so many of the states, for films that take long.
std::vector<State> some_states(std::size_t step) {
  const std::vector<State> all = finite_states(Quantities::cartesian);
  std::vector<State> some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

FiniteVerification judged(const FiniteClaim& claim, const std::vector<State>& states, const Answers& answers,
                          double tolerance = 0) {
  return verify_finite_film(claim, Quantities::cartesian, states, answers, tolerance, 2);
}

}  // namespace

TEST_CASE("verify, finite films: states cover every direction of motion, both spins and four shapes") {
  const std::vector<State> states = finite_states(Quantities::cartesian);
  CHECK(states.size() == 120);
  std::size_t wedge = 0, closing = 0, opening = 0, backwards = 0, bearing_turns = 0;
  for (const State& s : states) {
    const Vec e(s.ex, s.ey);
    const Vec v(s.vx, s.vy);
    CHECK(e.norm() < s.clearance);
    const double b = dot(v, e) / e.norm() / s.clearance;
    wedge += s.vx == 0 && s.vy == 0 ? 1 : 0;
    closing += b > 1e-9 ? 1 : 0;
    opening += b < -1e-9 ? 1 : 0;
    backwards += s.omega_journal < 0 ? 1 : 0;
    bearing_turns += s.omega_bearing != 0 ? 1 : 0;
  }
  CHECK(wedge == 40);
  CHECK(closing == 40);
  CHECK(opening == 40);
  CHECK(backwards == 40);
  CHECK(bearing_turns == 20);
  CHECK_THROWS_WITH(finite_states(Quantities::pressure), Contains("allowed are cartesian and polar"));
}

TEST_CASE("verify, finite films: right programs agree, by another solver than the judge's") {
  for (const FiniteFilm film : {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic}) {
    INFO(oracle::name_of(film));
    const std::vector<State> states = some_states(1);
    const FiniteVerification result = judged({film}, states, answers_of({film}, states));
    CHECK(result.verdict == Verdict::agrees);
    const std::size_t on_jump = film == FiniteFilm::finite_half ? 40 : 0;  // squeeze alone
    CHECK(result.count(Outcome::left_out) == on_jump);
    CHECK(result.count(Outcome::right) == states.size() - on_jump);
    CHECK(result.worst_error() < 1e-5);  // both solvers were asked for 1e-6
  }
  // Onset: free, and pinned where the motion is steady; each is wrong for the other claim.
  const std::vector<State> states = some_states(7);
  const FiniteClaim free{FiniteFilm::finite_reynolds};
  const FiniteClaim pinned{FiniteFilm::finite_reynolds, FilmOnset::maximum_film};
  CHECK(judged(free, states, answers_of(free, states)).verdict == Verdict::agrees);
  CHECK(judged(pinned, states, answers_of(pinned, states)).verdict == Verdict::agrees);
  const FiniteVerification mixed = judged(free, states, answers_of(pinned, states));
  CHECK(mixed.verdict == Verdict::disagrees);
  REQUIRE(mixed.others.size() == 1);
  CHECK(mixed.others.front().words() == "finite_reynolds, onset at the maximum film");
}

TEST_CASE("verify, finite films: polar states are the same motions") {
  const std::vector<State> states = finite_states(Quantities::polar);
  Answers answers;
  for (const State& s : states) {
    const double a = s.eccentricity_ratio * (s.omega - 2 * s.attitude_rate);
    const double scale = s.viscosity * s.length * std::pow(s.radius, 3) / (s.clearance * s.clearance);
    const Vec force =
        scale * oracle::finite_force(FiniteFilm::finite_half, s.length / (2 * s.radius),
                                     PolarFilmState<double>(s.eccentricity_ratio, a, s.squeeze_rate).in_own_frame(),
                                     {1e-7})
                    .ratio;
    Answer answer{};
    answer[0] = force.x();
    answer[1] = force.y();
    answers.values.push_back(answer);
  }
  const auto result = verify_finite_film({FiniteFilm::finite_half}, Quantities::polar, states, answers, 0, 2);
  CHECK(result.verdict == Verdict::agrees);
}

TEST_CASE(
    "verify, finite films: a factor, another film, an error, a state that is wrong and no number are told apart") {
  const std::vector<State> states = some_states(1);
  const FiniteClaim claim{FiniteFilm::finite_dynamic};
  const Answers right = answers_of(claim, states);
  const auto changed = [&](const auto& change) {
    Answers answers = right;
    for (std::size_t i = 0; i < answers.values.size(); ++i) change(i, answers.values[i]);
    return answers;
  };
  const auto doubled = judged(claim, states, changed([](std::size_t, Answer& f) {
                                f[0] *= -2;
                                f[1] *= -2;
                              }));
  CHECK(doubled.verdict == Verdict::disagrees);
  REQUIRE(doubled.factor);
  CHECK(*doubled.factor == Approx(-2).epsilon(1e-5));
  CHECK_THAT(text_report(doubled), Contains("All answers are -2 times the right ones."));

  const auto half = judged(claim, states, answers_of({FiniteFilm::finite_half}, states));
  CHECK(half.verdict == Verdict::disagrees);
  CHECK_FALSE(half.factor);
  REQUIRE(half.others.size() == 1);
  CHECK(half.others.front().film == FiniteFilm::finite_half);

  const Answers rough = changed([](std::size_t i, Answer& f) { f[0] *= 1 + 0.03 * std::sin(2.0 * double(i)); });
  const auto numerical = judged(claim, states, rough);
  CHECK(numerical.verdict == Verdict::agrees_to_digits);
  CHECK_FALSE(numerical.accepted());
  CHECK_THAT(text_report(numerical), Contains("say --tolerance 1e-01"));
  CHECK(judged(claim, states, rough, 0.05).verdict == Verdict::agrees);

  const Answers close = changed([](std::size_t i, Answer& f) { f[0] *= 1 + 3e-4 * std::sin(2.0 * double(i)); });
  CHECK(judged(claim, states, close).verdict == Verdict::agrees);
  CHECK_FALSE(judged(claim, states, close, 1e-5).accepted());  // a tolerance tighter than the default counts, too
  CHECK(judged(claim, states, right, 1e-5).accepted());

  const auto one = judged(claim, states, changed([](std::size_t i, Answer& f) {
                            if (i == 41) f[1] = -f[1];
                          }));
  CHECK(one.verdict == Verdict::disagrees);
  CHECK(one.count(Outcome::wrong) == 1);
  CHECK_THAT(text_report(one), Contains("\n42,"));  // the state to paste back

  const auto none = judged(claim, states, changed([](std::size_t i, Answer& f) {
                             if (i == 5) f[0] = NAN;
                           }));
  CHECK(none.verdict == Verdict::disagrees);
  CHECK(none.count(Outcome::not_a_number) == 1);
  CHECK(judged(claim, states, changed([](std::size_t, Answer& f) { f[0] = NAN; })).verdict == Verdict::undecided);
}

TEST_CASE("verify, finite films: where steady states alone are asked about, all films that fit them are named") {
  const std::vector<State> all = finite_states(Quantities::cartesian);
  const std::vector<State> steady = finite_states(Quantities::cartesian, steady_conditions(Quantities::cartesian));
  CHECK(steady.size() == 40);
  for (const State& s : steady) CHECK((s.vx == 0 && s.vy == 0 && s.omega_bearing == 0));
  CHECK_THROWS_WITH(finite_states(Quantities::cartesian, read_conditions(Quantities::cartesian, "speed > 1e9")),
                    Contains("no state") && Contains("speed > 1000000000"));
  // In a steady wedge the half film is the dynamic one.
  const FiniteVerification result =
      judged({FiniteFilm::finite_full}, steady, answers_of({FiniteFilm::finite_half}, steady));
  CHECK(result.verdict == Verdict::disagrees);
  REQUIRE(result.others.size() == 2);
  CHECK(result.others[0].film == FiniteFilm::finite_half);
  CHECK(result.others[1].film == FiniteFilm::finite_dynamic);
  CHECK_THAT(text_report(result), Contains("Next: The answers are those of finite_half and finite_dynamic."));
  const auto json = json_report(result);
  CHECK(json.at("other") == "finite_half");
  CHECK(json.at("other_films") == nlohmann::json{"finite_half", "finite_dynamic"});
  // The same of laws: short_half and short_dynamic don't differ there.
  Answers short_half;
  for (const State& s : steady) {
    const double epsilon = std::hypot(s.ex, s.ey) / s.clearance;
    const double q = (1 - epsilon) * (1 + epsilon);
    const double scale = s.viscosity * s.radius * std::pow(s.length, 3) / (s.clearance * s.clearance);
    const Vec r = Vec(s.ex, s.ey) / std::hypot(s.ex, s.ey);
    const double radial = -scale * epsilon * epsilon * std::abs(s.omega_journal) / (q * q);
    const double tangential = scale * 0.25 * std::acos(-1.0) * epsilon * s.omega_journal / std::pow(q, 1.5);
    Answer answer{};
    answer[0] = radial * r.x() - tangential * r.y();
    answer[1] = radial * r.y() + tangential * r.x();
    short_half.values.push_back(answer);
  }
  const FiniteVerification laws = judged({FiniteFilm::finite_half}, steady, short_half);
  CHECK(laws.laws == std::vector<std::string>{"short_half", "short_dynamic"});
  CHECK_THAT(text_report(laws), Contains("those of the laws short_half and short_dynamic, not of the film"));
  CHECK(json_report(laws).at("law_of_answers") == "short_half");
}

TEST_CASE("verify, finite films: where and which term is wrong is said, in words and as data") {
  const FiniteClaim claim{FiniteFilm::finite_dynamic};
  const std::vector<State> states = some_states(1);
  Answers answers = answers_of(claim, states);
  for (std::size_t i = 0; i < states.size(); ++i) {  // a tangential force that is a third too large
    const Vec r = Vec(states[i].ex, states[i].ey).normalized();
    const Vec force(answers.values[i][0], answers.values[i][1]);
    const Vec wrong = force + 1.0 / 3 * dot(force, perpendicular(r)) * perpendicular(r);
    answers.values[i][0] = wrong.x();
    answers.values[i][1] = wrong.y();
  }
  const FiniteVerification result = judged(claim, states, answers);
  CHECK(result.verdict != Verdict::agrees);
  CHECK(result.suspicions.empty());
  REQUIRE(result.terms.size() == 8);
  for (const Term& term : result.terms) {
    INFO(component_names[static_cast<std::size_t>(term.component)]
         << " " << motion_kind_names[static_cast<std::size_t>(term.states)] << ": " << term.words());
    const bool squeeze_alone = term.states == MotionKind::closing || term.states == MotionKind::opening;
    if (term.component == Component::radial || squeeze_alone) {  // which has no tangential force
      CHECK(term.verdict == TermVerdict::right);
    } else if (term.states == MotionKind::wedge) {
      CHECK(term.verdict == TermVerdict::factor);
      CHECK(term.factor.value_or(0) == Approx(4.0 / 3).epsilon(2e-3));  // the tolerance of the comparison, twice
    } else {  // where some tangential forces are hardly larger than the tolerance
      CHECK(term.verdict == TermVerdict::wrong);
    }
  }
  CHECK_THAT(text_report(result), Contains("tangential  wedge    4/3 times what it should be"));
  const auto json = json_report(result);
  CHECK(json.at("terms").size() == 8);
  CHECK(json.at("terms").at(0).at("verdict") == "right");
  CHECK(json.at("accepted") == false);
  // Right where there is no squeeze, said as a domain.
  Answers no_squeeze = answers_of(claim, states);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i].vx != 0 || states[i].vy != 0) no_squeeze.values[i][0] *= 1.5;
  }
  const FiniteVerification located = judged(claim, states, no_squeeze);
  CHECK(words(located.right_where) == "squeeze_rate == 0");
  CHECK(json_report(located).at("right_where") == nlohmann::json{{"squeeze_rate == 0"}});
}

TEST_CASE("verify command, finite films: states go out, answers come in, and the exit status is the verdict") {
  const TemporaryFolder folder;
  const std::string states_file = (folder.path() / "states.csv").string();
  REQUIRE(lubjoint_program({"verify", "--law", "finite_half", "--states-out", states_file}).status == 0);
  const std::vector<State> states = finite_states(Quantities::cartesian);
  CHECK(read_text(states_file) == states_csv(Quantities::cartesian, states));
  const auto answer = [&](const FiniteClaim& claim, double factor) {
    std::string csv = "id,fx,fy\n";
    const Answers answers = answers_of(claim, states);
    for (std::size_t i = 0; i < states.size(); ++i) {
      std::ostringstream row;
      row.precision(17);
      row << i + 1 << ',' << factor * answers.values[i][0] << ',' << factor * answers.values[i][1] << '\n';
      csv += row.str();
    }
    const std::string file = (folder.path() / "answers.csv").string();
    std::ofstream(file) << csv;
    return file;
  };
  const auto verify_half = [&](const std::string& file) {
    return lubjoint_program({"verify", "--law", "finite_half", "--answers", file, "--json"});
  };
  const ProgramResult right = verify_half(answer({FiniteFilm::finite_half}, 1));
  CHECK(right.status == 0);
  CHECK(nlohmann::json::parse(right.out).at("verdict") == "agrees");
  const ProgramResult wrong = verify_half(answer({FiniteFilm::finite_half}, 0.5));
  CHECK(wrong.status == 1);
  CHECK(nlohmann::json::parse(wrong.out).at("factor").get<double>() == Approx(0.5).epsilon(1e-5));
  CHECK(lubjoint_program({"verify", "--law", "finite_half", "--answers", "/dev/null"}).status == 2);
  const ProgramResult unused =
      lubjoint_program({"verify", "--law", "finite_half", "--onset", "free", "--answers", states_file});
  CHECK(unused.status == 2);
  CHECK_THAT(unused.err, Contains("--onset has no effect on finite_half"));
  CHECK_THAT(lubjoint_program({"verify", "--law", "finite_half", "--seed", "2", "--answers", states_file}).err,
             Contains("--seed does nothing with --law finite_half"));
}

}  // namespace verify_finite_test
