#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>

#include "oracle/laws/published_forms.hpp"
#include "oracle/verify/states/single_precision.hpp"
#include "support/verify_answers.hpp"

namespace verify_precision_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using namespace lubjoint::test;

namespace {

using FiftyDigits =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class T>
Answers from_library(Quantities quantities, std::string_view law, const std::vector<State>& states) {
  return answers_of(quantities, states, [&](const State& state) { return library_answer<T>(quantities, law, state); });
}

/// The printed polar forms in double, angles and all: as a program written from a paper would do it.
std::array<double, most_answers> printed_forms(std::string_view law, const State& s) {
  const double distance = std::hypot(s.ex, s.ey);
  const bool centred = distance == 0;
  const double gamma = centred ? std::atan2(s.vy, s.vx) : std::atan2(s.ey, s.ex);
  const double epsilon = distance / s.clearance;
  const double b = (s.vx * std::cos(gamma) + s.vy * std::sin(gamma)) / s.clearance;
  const double across = s.vy * std::cos(gamma) - s.vx * std::sin(gamma);
  const double attitude_rate = centred ? 0 : across / distance;
  const double a = epsilon * (s.omega_journal + s.omega_bearing - 2 * attitude_rate);
  if (a == 0 && b == 0) return {};
  const auto terms = reports::published_terms<double>(law, epsilon, a, b);
  double radial = 0, tangential = 0;
  for (const double term : terms.radial) radial += term;
  for (const double term : terms.tangential) tangential += term;
  const bool is_short_law = law.starts_with("short");
  const double scale = is_short_law ? s.viscosity * s.radius * std::pow(s.length, 3) / std::pow(s.clearance, 2)
                                    : s.viscosity * s.length * std::pow(s.radius, 3) / std::pow(s.clearance, 2);
  radial *= scale;
  tangential *= scale;
  return {radial * std::cos(gamma) - tangential * std::sin(gamma),
          radial * std::sin(gamma) + tangential * std::cos(gamma), 0, 0};
}

/// Thinner than single precision can state well.
bool has_thin_film(Quantities quantities, const State& state) {
  return references(quantities, "short_full"_law, {state})[0].gap < 5.1e-5;
}

}  // namespace

TEST_CASE("verify: its own work from the printed formulas is the library's answer in 50 digits") {
  for (const Quantities quantities : all_quantities) {
    const std::vector<State> states = states_to_verify(quantities, 30, 3);
    const std::size_t columns = answer_columns(quantities).size();
    for (const std::string_view law : film_law_names) {
      for (const State& state : states) {
        const auto exact = library_answer<FiftyDigits>(quantities, law, state);
        const Reference reference = references(quantities, law_of(law), {state})[0];
        for (std::size_t k = 0; k < columns; ++k) {
          const double error = static_cast<double>(abs(exact[k] - FiftyDigits(reference.expected[k])));
          INFO(name_of(quantities) << " " << law << "\n" << state_row(quantities, state, 1));
          CHECK(error <= 0x1p-63 * reference.sensitivity[k]);  // rounding of long double
        }
      }
    }
  }
}

TEST_CASE("verify: a correct program passes in double, in single, and printed with seven digits") {
  for (const Quantities quantities : all_quantities) {
    const std::vector<State> states = states_to_verify(quantities, 700, 9);
    for (const std::string_view law : film_law_names) {
      INFO(name_of(quantities) << " " << law);
      const Answers in_double = from_library<double>(quantities, law, states);
      const Answers in_single = from_library<float>(quantities, law, states);
      const auto check = [&](const Answers& answers, const std::string& words) {
        const Verification v = verified(quantities, law, states, answers);
        INFO(words << "\n" << text_report(v));
        CHECK(v.verdict == Verdict::agrees);
        CHECK_THAT(v.judgement.precision.words(), Catch::StartsWith(words));
        return static_cast<double>(v.judgement.undecided) / static_cast<double>(v.judgement.judged());
      };
      CHECK(check(in_double, "double precision") <= 0.02);  // the wall's last decades
      CHECK(check(in_single, "single precision") <= 0.3);  // 1 - e/c below 1e-3 and cancelling terms: a quarter at most
      check(through_text(quantities, in_double, "{:.17g}"), "double precision");
      check(through_text(quantities, in_double, "{}"), "double precision");
      check(through_text(quantities, in_double, "{:.7g}"), "double precision, 7 digits");
      check(through_text(quantities, in_double, "{:.6e}"), "double precision, 7 digits");
      check(through_text(quantities, in_double, "{:.3f}"), "double precision, 3 decimals");
      check(through_text(quantities, in_single, "{:.9g}"), "single precision");
      check(through_text(quantities, in_single, "{:.17g}"), "single precision");
    }
  }
}

TEST_CASE("verify: the printed formulas, with angles and powers, pass in double for every law") {
  // Thinner than this, the sums of the dynamic laws' printed forms are differences of equal numbers, over which they
  // divide: no number at all.
  const std::vector<State> states =
      verify::states_to_verify(Quantities::cartesian, golden_folder(), 2000, 4,
                               read_conditions(Quantities::cartesian, "one_minus_eccentricity_ratio >= 1e-8"));
  for (const std::string_view law : film_law_names) {
    const Answers answers =
        answers_of(Quantities::cartesian, states, [&](const State& s) { return printed_forms(law, s); });
    const Verification v = verified(Quantities::cartesian, law, states, answers);
    INFO(text_report(v));
    CHECK(v.verdict == Verdict::agrees);
    // What the dynamic laws' printed forms lose where the film opens: a sixth of these states was measured.
    const double most = is_dynamic(law_of(law)) ? 0.2 : 0.02;
    CHECK(static_cast<double>(v.judgement.undecided) <= most * static_cast<double>(states.size()));
  }
}

TEST_CASE("verify: a program that computes in single and prints what double prints is told apart") {
  const std::vector<State> states = states_to_verify(Quantities::cartesian, 300, 4);
  const Answers answers = answers_of(Quantities::cartesian, states, [](const State& s) {
    auto answer = library_answer<float>(Quantities::cartesian, "long_half", s);
    std::array<double, most_answers> wide{};
    for (std::size_t k = 0; k < wide.size(); ++k) wide[k] = static_cast<double>(answer[k]) * (1 + 0x1p-40);
    return wide;
  });
  const Verification v = verified(Quantities::cartesian, "long_half", states, answers);
  CHECK(v.verdict == Verdict::agrees);
  CHECK(v.judgement.precision.words() == "single precision");
}

TEST_CASE("verify: states are the same for a seed and of every regime, those of its own exact in single precision") {
  for (const Quantities quantities : all_quantities) {
    const std::vector<State> states = states_to_verify(quantities, 500, 42);
    CHECK(states_csv(quantities, states) == states_csv(quantities, states_to_verify(quantities, 500, 42)));
    CHECK(states_csv(quantities, states) != states_csv(quantities, states_to_verify(quantities, 500, 43)));
    std::set<Regime> regimes;
    for (const State& state : states) {
      regimes.insert(regime_of(quantities, state));
      if (state.golden) continue;
      for (const StateColumn& column : state_columns(quantities)) {
        const bool holds_film = column.name == "ex" || column.name == "ey" || column.name == "x" ||
                                column.name == "y" || column.name == "eccentricity_ratio";
        if (!holds_film || !has_thin_film(quantities, state)) CHECK(is_single(state.*column.value));
      }
    }
    CHECK(regimes.size() == (quantities == Quantities::transition ? 6 : 5));
  }
}

}  // namespace verify_precision_test
