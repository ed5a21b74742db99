/// Comparison of answers with the truth, at the precision that they have.
#pragma once

#include <optional>

#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/states/golden_states.hpp"
#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/states.hpp"

namespace lubjoint::verify {

/// The right answer to a state, and how much rounding moves it.
struct Reference {
  std::array<Real, most_answers> expected;
  /// Error of an answer over the unit roundoff: eight roundings of every input, each with the derivative that carries
  /// it to the answer (input_conditioning), and 32 of the answer's own size. Measured: right programs in double stay
  /// below a sixth of this (verify_precision_test).
  std::array<double, most_answers> sensitivity;
  /// What a published form may lose beyond that: 16 roundings of every term that it is the sum of.
  std::array<double, most_answers> published;
  std::array<double, most_answers> error{};  ///< of `expected` itself, where it is a sum in finite precision
  std::array<double, most_answers> size;     ///< |F|, or |F| times the arm: what agreement in digits is relative to
  Regime regime;
  const GoldenAnswers::Row* golden = nullptr;  ///< where `expected` is certified; kept by the state
  double smallest = 1, largest = 1;            ///< magnitudes of inputs and answers other than zero
  /// |a| over the terms that it is the sum of, where the answer jumps at a = 0. No roundoff hides its sign where large.
  double jump_margin = 1;
  double gap = 1;    ///< 1 − ε of the film, where it matters
  double ratio = 0;  ///< ε of the film
};

std::vector<Reference> references(Quantities quantities, Law law, const std::vector<State>& states);

/// Precision at which answers are judged.
struct Precision {
  double roundoff;     ///< of the arithmetic: 2^-53 or 2^-24
  TextPrecision text;  ///< of the numbers printed
  std::string words() const;
  /// Largest error of number k that rounding explains.
  double tolerance(const Reference& reference, std::size_t k) const;
  /// False for a state whose inputs this arithmetic can't hold: the film's thickness is lost in their rounding, a jump
  /// of the law is nearer than that, or products of the numbers leave the range.
  bool decides(const Reference& reference) const;
};

/// The precision in which the program works, from its answers: single where every number is one of single precision,
/// or where at most nine digits are printed and single explains the errors, or where three answers in five have
/// errors, all of single precision's size and no two alike. Otherwise double.
Precision measured_precision(Quantities quantities, const std::vector<Reference>& references,
                             const std::vector<State>& states, const Answers& answers,
                             const std::vector<std::size_t>& columns);

/// What can be said of one answer.
enum class Outcome {
  right,  ///< within its tolerance, and that tolerance leaves at least two digits of the answer to be right
  /// Rounding of the inputs leaves less than that; or the error is one that a published form makes in this precision
  /// (terms that cancel): neither right nor wrong.
  undecided,
  wrong,
  not_a_number,
  left_out  ///< this precision can't state the inputs
};

/// How one state came out.
struct Comparison {
  Outcome outcome;
  double excess;  ///< largest error over its tolerance; infinite for NaN
  double digits;  ///< of agreement, of the worst number; at most 17

  bool right() const { return outcome == Outcome::right; }
  bool fails() const { return outcome == Outcome::wrong || outcome == Outcome::not_a_number; }
  bool left_out() const { return outcome == Outcome::left_out; }
};

/// The largest tolerance over |F| at which an answer may count as right: half of the one percent by which an answer of
/// 1.01 times the force is off.
inline constexpr double coarsest_tolerance = 0.005;

/// The largest share of undecided states at which a program can be said to agree. Right programs in double leave less
/// than a fiftieth open, in single precision, which the thin films need most, less than a third
/// (verify_precision_test).
inline constexpr double largest_undecided_share = 0.4;

/// @param columns   of the answers that are compared
/// @param accepted  error over |F| that is right by the user's word
std::vector<Comparison> compare(const std::vector<Reference>& references, const Answers& answers,
                                const std::vector<std::size_t>& columns, const Precision& precision,
                                double accepted = 0);

/// One number's outcome, by its error against what rounding explains.
Outcome number_outcome(const Reference& reference, std::size_t column, double given, const Precision& precision,
                       double accepted);

/// What became of a regime's states.
struct RegimeResult {
  Regime regime;
  std::size_t states = 0;
  std::size_t failing = 0;
  std::size_t undecided = 0;
  double worst_digits = 17;  ///< of the decided states, as the median
  double median_digits = 17;
};

/// Answers compared with one law.
struct Judgement {
  Quantities quantities;
  Law law;
  std::vector<std::size_t> columns;  ///< of the answers, those that are judged
  Precision precision;
  std::vector<Reference> references;
  std::vector<Comparison> comparisons;
  std::vector<RegimeResult> regimes;  ///< those that have states
  std::vector<std::size_t> failing;
  std::size_t left_out = 0;   ///< states that this precision can't state
  std::size_t undecided = 0;  ///< of those judged
  std::size_t not_numbers = 0;
  std::optional<std::size_t> worst;  ///< of the failing ones, the one that shows most
  double accepted = 0;               ///< error over |F| that is right by the user's word

  std::size_t first_column() const { return columns.front(); }
  std::size_t judged() const { return comparisons.size() - left_out; }
  /// No answer fails, and enough of them were decided.
  bool agrees() const { return failing.empty() && enough_decided(); }
  bool enough_decided() const {
    return static_cast<double>(undecided) <= largest_undecided_share * static_cast<double>(judged());
  }
};

/// Columns that were given and that the law has: a long bearing has no side flow.
/// @throws UnjudgedError if there are none
std::vector<std::size_t> judged_columns(Quantities quantities, Law law, const Answers& answers);

/// @param accepted  error over |F| that is right by the user's word
Judgement judge(Quantities quantities, Law law, const std::vector<State>& states, const Answers& answers,
                double accepted = 0);

/// The same answers at another precision.
void judge_at(Judgement& judgement, const Answers& answers, const Precision& precision);

/// The largest error of number k of state i that is right: what rounding explains, or what the user accepts.
double tolerance_of(const Judgement& judgement, std::size_t i, std::size_t k);

/// Counts, regimes and the worst state anew after a change of outcomes.
void summarise(Judgement& judgement);

}  // namespace lubjoint::verify
