// The judge never takes a wrong answer for a right one, whatever the law and the state.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "oracle/verify/states/conditioning.hpp"
#include "oracle/verify/verification.hpp"
#include "support/golden.hpp"

namespace verify_judge_test {

using namespace lubjoint;
using namespace lubjoint::verify;

namespace {

constexpr std::size_t random_states = 100'000;

/// All golden and designed states and 100,000 random ones.
const std::vector<State>& all_states() {
  static const std::vector<State> states =
      states_to_verify(Quantities::cartesian, test::golden_folder(), random_states, 20261128);
  return states;
}

/// The truth times a factor, rounded to double.
Answers multiples_of_truth(const std::vector<Reference>& references, double factor) {
  std::vector<Answer> values;
  values.reserve(references.size());
  for (const Reference& r : references) {
    values.push_back({static_cast<double>(factor * r.expected[0]), static_cast<double>(factor * r.expected[1]), 0, 0});
  }
  return answers_from_numbers(Quantities::cartesian, std::move(values));
}

}  // namespace

TEST_CASE("verify: an answer of the wrong sign, or 2, 1/2 or 1.01 times the force, is right at no state of any law") {
  const std::vector<State>& states = all_states();
  for (std::size_t law = 0; law < law_count; ++law) {
    INFO(name_of(Law{law}));
    Judgement judgement;
    judgement.law = Law{law};
    judgement.columns = all_columns(Quantities::cartesian);
    judgement.references = references(Quantities::cartesian, judgement.law, states);
    for (const double factor : {-1.0, 2.0, 0.5, 1.01}) {
      INFO(factor << " times");
      const Answers answers = multiples_of_truth(judgement.references, factor);
      judge_at(judgement, answers, {0x1p-53, answers.text});
      std::size_t right = 0;
      for (std::size_t i = 0; i < states.size(); ++i) {
        const bool moves = judgement.references[i].size[0] > 0;
        if (moves && judgement.comparisons[i].right()) ++right;
      }
      CHECK(right == 0);
      CHECK_FALSE(judgement.agrees());
      // What is left open is bounded: the wall's last decades, and opening films of the dynamic laws (3.5 % measured).
      CHECK(judgement.undecided <= states.size() / 20);
    }
    const Answers truth = multiples_of_truth(judgement.references, 1);
    judge_at(judgement, truth, {0x1p-53, truth.text});
    CHECK(judgement.agrees());
    CHECK(judgement.undecided <= states.size() / 200);
  }
}

TEST_CASE("verify: only the thinnest opening films wrong, and it still never agrees") {
  const std::vector<State> states = states_to_verify(Quantities::cartesian, test::golden_folder(), 1000, 7);
  for (const std::string_view name : {"short_dynamic", "long_dynamic"}) {
    const Law law = law_of(name);
    const std::vector<Reference> truth = references(Quantities::cartesian, law, states);
    for (const double thinner_than : {1e-4, 1e-5, 1e-6}) {
      for (const double factor : {-1.0, 2.0, 0.5}) {
        std::vector<Answer> values;
        for (std::size_t i = 0; i < states.size(); ++i) {
          const Solution s = solve(Quantities::cartesian, law, states[i]);
          const double times = s.ratio_gap < thinner_than && s.b < 0 ? factor : 1;
          values.push_back({static_cast<double>(times * truth[i].expected[0]),
                            static_cast<double>(times * truth[i].expected[1]), 0, 0});
        }
        const Verification v = verify_answers(Quantities::cartesian, std::string(name), states,
                                              answers_from_numbers(Quantities::cartesian, std::move(values)));
        INFO(name << ", " << factor << " times below " << thinner_than);
        CHECK(v.verdict == Verdict::disagrees);
        CHECK_FALSE(v.accepted());
        REQUIRE(v.wrong_where.size() == 1);
        CHECK(v.wrong_where[0].size() == 2);
      }
    }
  }
}

TEST_CASE("verify: the conditioning of a state is what its exact derivatives by differences in longer steps say") {
  const std::vector<State> states = states_to_verify(Quantities::cartesian, test::golden_folder(), 300, 3);
  for (std::size_t law = 0; law < law_count; ++law) {
    for (const State& state : states) {
      const Solution s = solve(Quantities::cartesian, Law{law}, state);
      // Differences of 1e-7 in the inputs: far from the wall, from the centre and from the jump of half films.
      if (s.ratio_gap < 0.01L || s.ratio < 0.01L || std::abs(s.a) < 1e-2L * std::abs(s.b)) continue;
      // At u = 0 a film has a derivative in each direction, not one.
      if (std::abs(s.a) + std::abs(s.b) < 1e-3L * (std::abs(s.spin_part) + std::abs(s.attitude_part))) continue;
      Real sum = 0;
      for (const StateColumn& column : state_columns(Quantities::cartesian)) {
        State less = state, more = state;
        less.*column.value *= 1 - 1e-7;
        more.*column.value *= 1 + 1e-7;
        const Plane difference =
            solve(Quantities::cartesian, s.law, more).force - solve(Quantities::cartesian, s.law, less).force;
        sum += std::hypot(difference.x(), difference.y()) / 2e-7L;
      }
      INFO(name_of(s.law) << "\n" << state_row(Quantities::cartesian, state, 1));
      // Second differences of 1e-7 over (1 - e/c)², and Pinkus and Sternlicht's kink within the step.
      CHECK(input_conditioning(state, s)[0] == Approx(static_cast<double>(sum)).epsilon(2e-3));
    }
  }
}

}  // namespace verify_judge_test
