/// Comparison of answers with the truth, at the precision that they have.
#pragma once

#include <optional>

#include "oracle/verify/answers.hpp"
#include "oracle/verify/golden_states.hpp"
#include "oracle/verify/solution.hpp"
#include "oracle/verify/states.hpp"

namespace lubjoint::verify {

/// The right answer to a state, and how much rounding moves it.
struct Reference {
  std::array<Real, most_answers> expected;
  /// Error of an answer over the unit roundoff: 16 roundings of every term that the force is the sum of, and four of
  /// every input, each with the derivative that carries it to the answer.
  std::array<double, most_answers> sensitivity;
  std::array<double, most_answers> size;  ///< |F|, or |F| times the arm: what agreement in digits is relative to
  Regime regime;
  const GoldenAnswers::Row* golden = nullptr;  ///< where `expected` is certified; kept by the state
  double smallest = 1, largest = 1;            ///< magnitudes of inputs and answers other than zero
  /// |a| over the terms that it is the sum of, where the answer jumps at a = 0. No roundoff hides its sign where large.
  double jump_margin = 1;
  double gap = 1;  ///< 1 − ε of the film, where it matters
};

std::vector<Reference> references(Quantities quantities, Law law, const std::vector<State>& states);

/// Precision at which answers are judged.
struct Precision {
  double roundoff;     ///< of the arithmetic: 2^-53 or 2^-24
  TextPrecision text;  ///< of the numbers printed
  std::string words() const;
  /// Largest error of number k that rounding explains.
  double tolerance(const Reference& reference, std::size_t k) const;
  /// False for a golden state at which the rounding of the inputs leaves nothing to judge, or whose numbers are beyond
  /// what can be multiplied in this arithmetic. The other states are made so that there is always something.
  bool decides(const Reference& reference) const;
};

/// The precision in which the program works, from its answers: single where every number is one of single precision,
/// or where at most nine digits are printed and single explains the errors, or where three answers in five have
/// errors, all of single precision's size. Otherwise double.
Precision measured_precision(const std::vector<Reference>& references, const Answers& answers, std::size_t columns);

/// How one state came out.
struct Comparison {
  double excess;  ///< largest error over its tolerance; above 1 fails, infinite for NaN
  double digits;  ///< of agreement, of the worst number; at most 17
  bool not_a_number;
  bool left_out = false;  ///< this precision does not decide the state

  bool passes() const { return !left_out && excess <= 1; }
  bool fails() const { return !left_out && !(excess <= 1); }
};

std::vector<Comparison> compare(const std::vector<Reference>& references, const Answers& answers, std::size_t columns,
                                const Precision& precision);

/// What became of a regime's states.
struct RegimeResult {
  Regime regime;
  std::size_t states = 0;
  std::size_t failing = 0;
  double worst_digits = 17;
  double median_digits = 17;
};

/// Answers compared with one law.
struct Judgement {
  Quantities quantities;
  Law law;
  Precision precision;
  std::vector<Reference> references;
  std::vector<Comparison> comparisons;
  std::vector<RegimeResult> regimes;  ///< those that have states
  std::vector<std::size_t> failing;
  std::size_t left_out = 0;  ///< states that this precision does not decide
  std::size_t not_numbers = 0;
  std::optional<std::size_t> worst;  ///< of the failing ones, by error over tolerance; numbers before NaN

  std::size_t judged() const { return comparisons.size() - left_out; }
  bool agrees() const { return failing.empty(); }
  /// Some answers are no numbers, and those that are agree.
  bool unjudged() const { return not_numbers > 0 && not_numbers == failing.size(); }
};

Judgement judge(Quantities quantities, Law law, const std::vector<State>& states, const Answers& answers);

/// The same answers at another precision.
void judge_at(Judgement& judgement, const Answers& answers, const Precision& precision);

}  // namespace lubjoint::verify
