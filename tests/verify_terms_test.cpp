// What verify says of wrong answers: by which factor, in which term, where, and to how many digits.
#include <catch2/catch.hpp>
#include <numbers>

#include "oracle/verify/terms/factor.hpp"
#include "support/verify_answers.hpp"

namespace verify_terms_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;
constexpr double pi_ = std::numbers::pi;

namespace {

const std::vector<State>& some_states() {
  static const std::vector<State> states = states_to_verify(Quantities::cartesian, 200, 17);
  return states;
}

/// Answers of a program that is right but for one change.
Verification with(std::string_view law, const Change& change) {
  const Answers answers = answers_of(Quantities::cartesian, some_states(), [&](const State& state) {
    return solve(Quantities::cartesian, law_of(law), state, std::span(&change, 1)).answer;
  });
  return verified(Quantities::cartesian, law, some_states(), answers);
}

const Term& term(const Verification& v, Component component, MotionKind kind) {
  return v.terms.at(4 * static_cast<std::size_t>(component) + static_cast<std::size_t>(kind));
}

}  // namespace

TEST_CASE("verify: a factor is recognised as what it is made of, and only as precisely as it is known") {
  CHECK(factor_words(1 / pi_, 1e-12) == "1/pi");
  CHECK(factor_words(-2, 1e-12) == "-2");
  CHECK(factor_words(0.75, 1e-12) == "3/4");
  CHECK(factor_words(pi_ * pi_ / 6, 1e-12) == "pi^2/6");
  CHECK(factor_words(4 / (3 * pi_), 1e-12) == "4/(3 pi)");
  CHECK(factor_words(10, 1e-12) == "10");
  CHECK(factor_words(1e-3, 1e-12) == "1e-03");
  CHECK(factor_words(30 / pi_, 1e-12) == "60/(2 pi)");
  CHECK(factor_words(0.3183, 1e-3) == "1/pi");
  CHECK(factor_words(0.3183, 1e-9).empty());
  CHECK(factor_words(1.2345, 1e-9).empty());
  CHECK(factor_words(0, 1e-9).empty());
  CHECK(factor_words(std::nan(""), 1e-9).empty());
}

TEST_CASE("verify: conditions are read as they are printed, and what can't be read is named") {
  const Conjunction read =
      read_conditions(Quantities::cartesian, " omega_sum>0 , one_minus_eccentricity_ratio < 1e-05");
  REQUIRE(read.size() == 2);
  CHECK(words(read) == "omega_sum > 0 and one_minus_eccentricity_ratio < 1e-05");
  State state;
  state.clearance = 1;
  state.ex = 1 - 1e-6;
  state.omega_journal = 1;
  CHECK(holds(read, state));
  state.omega_bearing = -1;
  CHECK_FALSE(holds(read, state));
  for (const char* wrong :
       {"omega > 0", "omega_sum", "omega_sum >", "omega_sum => 0", "omega_sum > 0x", "", "ex > nan"}) {
    INFO(wrong);
    CHECK_THROWS_WITH(read_conditions(Quantities::cartesian, wrong),
                      Catch::Contains(wrong) && Catch::Contains("eccentricity_ratio"));
  }
  CHECK_THROWS_WITH(read_conditions(Quantities::polar, "omega_sum > 0"), Catch::Contains("omega,"));
}

TEST_CASE("verify: a domain is found where there is one, and none is claimed where there is none") {
  const auto domain = [](const auto& selects) {
    std::vector<int> in_set;
    for (const State& state : some_states()) in_set.push_back(selects(state));
    return domain_of(Quantities::cartesian, some_states(), in_set);
  };
  CHECK(words(domain([](const State& s) { return s.omega_bearing + s.omega_journal > 0; })) == "omega_sum > 0");
  CHECK(words(domain([](const State& s) { return s.ex < 0 && s.omega_journal < 0; })) ==
        "omega_journal < 0 and ex < 0");
  CHECK(domain([](const State&) { return true; }).empty());
  CHECK(domain([](const State&) { return false; }).empty());
  CHECK(domain([](const State& s) { return std::fmod(1e9 * std::abs(s.vx), 2.0) < 1; }).empty());
}

TEST_CASE("verify: the term that is wrong is named with its factor, the others are right") {
  const Verification v = with("short_half", {Step::terms, [](Solution& s) { s.radial_squeeze *= 0.7L; }});
  CHECK(v.verdict == Verdict::disagrees);
  for (const MotionKind kind : {MotionKind::closing, MotionKind::opening}) {
    const Term& wrong = term(v, Component::radial, kind);
    CHECK(wrong.verdict == TermVerdict::factor);
    CHECK(wrong.factor.value() == Approx(0.7).epsilon(1e-9));
    CHECK(term(v, Component::tangential, kind).verdict == TermVerdict::undecided);  // on the jump of the half film
  }
  CHECK(term(v, Component::radial, MotionKind::wedge).is_right());
  CHECK(term(v, Component::tangential, MotionKind::wedge).is_right());
  CHECK(term(v, Component::tangential, MotionKind::mixed).is_right());
  CHECK(v.suspicions.empty());
}

TEST_CASE("verify: a wrong power of 1 - e^2, or a length for another, is told by its exponents") {
  const Verification power =
      with("short_full", {Step::terms, [](Solution& s) { s.tangential_wedge *= std::pow(s.q(), 2.5L); }});
  const Term& wedge = term(power, Component::tangential, MotionKind::wedge);
  CHECK(wedge.verdict == TermVerdict::function);
  REQUIRE(wedge.exponents.count("q") == 1);
  CHECK(wedge.exponents.at("q") == 2.5);
  CHECK(term(power, Component::radial, MotionKind::closing).is_right());
  const Verification length = with("short_full", {Step::scale, [](Solution& s) { s.scale *= s.radius / s.length; }});
  const Term& scaled = term(length, Component::radial, MotionKind::closing);
  CHECK(scaled.verdict == TermVerdict::factor);
  CHECK(scaled.factor_text == "R/L");
}

TEST_CASE("verify: a function of the eccentricity that is no power is said to be one; an absent term is absent") {
  const Verification v =
      with("long_full", {Step::terms, [](Solution& s) { s.radial_squeeze *= 1 + std::sin(3 * s.ratio); }});
  CHECK(term(v, Component::radial, MotionKind::closing).verdict == TermVerdict::function);
  CHECK(term(v, Component::radial, MotionKind::closing).exponents.empty());
  const Verification none = with("long_full", {Step::terms, [](Solution& s) { s.tangential_wedge = 0; }});
  CHECK(term(none, Component::tangential, MotionKind::wedge).verdict == TermVerdict::absent);
  CHECK(term(none, Component::radial, MotionKind::opening).is_right());
}

TEST_CASE("verify: digits that fall off a cliff are not excused as those of a numerical program") {
  const auto noisy = [](Solution& s, Real size) {
    // A different error in each state, as a sum over angles makes.
    s.radial *= 1 + size * std::sin(1e5L * s.ratio + 7 * s.a);
    s.tangential *= 1 - size * std::cos(1e5L * s.ratio + 3 * s.b);
  };
  static const auto error = noisy;
  const Verification smooth = with("short_full", {Step::film, [](Solution& s) { error(s, 1e-6L / s.ratio_gap); }});
  CHECK(smooth.verdict == Verdict::agrees_to_digits);
  CHECK(smooth.digits.digits > 4.5);
  CHECK(smooth.digits.digits < 7);
  CHECK_FALSE(smooth.accepted());
  const Verification cliff =
      with("short_full", {Step::film, [](Solution& s) { error(s, s.ratio_gap < 1e-3L ? 0.5L : 1e-9L); }});
  CHECK(cliff.verdict == Verdict::disagrees);
  CHECK_FALSE(cliff.digits.steady);
}

TEST_CASE("verify: a wrong law beside all eight is said to be none of them") {
  const Answers answers = answers_of(Quantities::cartesian, some_states(), [](const State& state) {
    const Solution s = solve(Quantities::cartesian, "short_full"_law, state);
    return std::array<Real, most_answers>{s.force.x() * std::exp(3 * s.ratio) + 2 * s.force.y(),
                                          s.force.y() * (1 + s.ratio) - s.force.x()};
  });
  const Verification v = verified(Quantities::cartesian, "auto", some_states(), answers);
  CHECK(v.verdict == Verdict::disagrees);
  CHECK(v.law_is_doubtful);
  CHECK_THAT(next_step(v), Catch::Contains("none of these"));
}

}  // namespace verify_terms_test
