#include "oracle/verify/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lubjoint::verify {

namespace {

constexpr double double_roundoff = 0x1p-53;
constexpr double single_roundoff = 0x1p-24;
constexpr double largest_in_single = 1e18;  // its square is still a number of single precision

/// Σ |∂answer/∂x · x| over the inputs, by forward differences: the step is far below the distance to any seam, and
/// two digits of a tolerance are enough.
std::array<double, most_answers> input_sensitivity(Quantities quantities, Law law, const State& state,
                                                   const std::array<Real, most_answers>& expected,
                                                   std::size_t columns) {
  constexpr double step = 0x1p-24;
  std::array<double, most_answers> sum{};
  for (const StateColumn& column : state_columns(quantities)) {
    const double given = state.*column.value;
    if (given == 0) continue;
    State moved = state;
    moved.*column.value = given * (1 - step);
    std::array<Real, most_answers> answer = solve(quantities, law, moved).answer;
    if (std::isnan(answer[0])) {
      moved.*column.value = given * (1 + step);
      answer = solve(quantities, law, moved).answer;
    }
    const double plane = static_cast<double>(std::hypot(answer[0] - expected[0], answer[1] - expected[1]) / step);
    sum[0] += plane;  // both components: programs work in other frames than ours
    sum[1] += plane;
    for (std::size_t k = 2; k < columns; ++k) sum[k] += static_cast<double>(std::abs(answer[k] - expected[k]) / step);
  }
  return sum;
}

/// Σ|terms| of the slip rate a [1/s]: what its rounding is proportional to.
Real slip_terms(const Solution& s) {
  if (is_polar(s.quantities)) return std::abs(s.spin_part) + std::abs(s.attitude_part);
  const Real across = std::abs(s.v.x() * s.r.y()) + std::abs(s.v.y() * s.r.x());
  return s.ratio * (std::abs(s.omega_bearing) + std::abs(s.omega_journal)) + 2 * across / s.film_clearance;
}

/// Sizes of a golden state's numbers, and how far it is from a jump of the law.
void note_limits(Quantities quantities, const Solution& solution, const State& state, Reference& reference) {
  const auto see = [&](double number) {
    if (number == 0) return;
    reference.smallest = std::min(reference.smallest, std::abs(number));
    reference.largest = std::max(reference.largest, std::abs(number));
  };
  for (const StateColumn& column : state_columns(quantities)) see(state.*column.value);
  for (std::size_t k = 0; k < answer_columns(quantities).size(); ++k) see(static_cast<double>(reference.expected[k]));
  if (solution.of_dry < 1) reference.gap = static_cast<double>(solution.ratio_gap);
  // A half film jumps to the other side; its force only where there is squeeze.
  const bool jumps = is_half(solution.law) && (quantities == Quantities::extent || solution.b != 0);
  const Real terms = slip_terms(solution);
  if (jumps && terms > 0) reference.jump_margin = static_cast<double>(std::abs(solution.a) / terms);
}

Reference reference(Quantities quantities, Law law, const State& state) {
  const std::size_t columns = answer_columns(quantities).size();
  const Solution solution = solve(quantities, law, state);
  Reference result{solution.answer, {}, {}, regime_of(quantities, state)};
  if (state.golden) {
    const auto& row = state.golden->row[static_cast<std::size_t>(law)];
    if (row) {
      result.golden = &*row;
      result.expected = row->answer;
    }
    note_limits(quantities, solution, state, result);
  }
  const auto inputs = input_sensitivity(quantities, law, state, solution.answer, columns);
  const double terms = 16 * static_cast<double>(size_of_terms(solution));
  const double force = std::hypot(static_cast<double>(solution.answer[0]), static_cast<double>(solution.answer[1]));
  for (std::size_t k = 0; k < columns; ++k) {
    result.sensitivity[k] = 4 * inputs[k] + terms;
    result.size[k] = quantities == Quantities::pressure ? terms / 16 : force;
    if (k < 2) continue;
    const double arm = k == 2 ? std::hypot(state.sx_i, state.sy_i) + std::hypot(state.ex, state.ey)
                              : std::hypot(state.sx_j, state.sy_j);
    result.sensitivity[k] = 4 * inputs[k] + arm * (4 * inputs[0] + terms);
    result.size[k] = arm * force;
  }
  return result;
}

bool all_agree(const std::vector<Comparison>& comparisons) {
  return std::ranges::all_of(comparisons, [](const Comparison& c) { return c.not_a_number || c.excess <= 1; });
}

}  // namespace

std::vector<Reference> references(Quantities quantities, Law law, const std::vector<State>& states) {
  std::vector<Reference> list;
  list.reserve(states.size());
  for (const State& state : states) list.push_back(reference(quantities, law, state));
  return list;
}

std::string Precision::words() const {
  std::string words = roundoff == single_roundoff ? "single precision" : "double precision";
  if (text.decimals >= 0) {
    words += fmt::format(", {} decimals printed", text.decimals);
  } else if (text.relative > 0) {
    words += fmt::format(", {} digits printed", text.digits);
  }
  return words;
}

double Precision::tolerance(const Reference& reference, std::size_t k) const {
  const double value = static_cast<double>(std::abs(reference.expected[k]));
  // The printed digits are rounded after the arithmetic: a hair more than half a unit.
  return roundoff * reference.sensitivity[k] + 1.01 * text.relative * value + 1.01 * text.absolute;
}

bool Precision::decides(const Reference& reference) const {
  const double largest = roundoff == single_roundoff ? largest_in_single : largest_in_double;
  // Answers are products of inputs: they may be larger.
  if (reference.smallest < 1 / largest || reference.largest > largest * largest) return false;
  if (reference.jump_margin <= 16 * roundoff) return false;  // roundings of a few operations
  return reference.gap > 64 * roundoff;  // 1/64 of 1 − ε, and more of the force, is lost in the input's rounding
}

std::vector<Comparison> compare(const std::vector<Reference>& references, const Answers& answers, std::size_t columns,
                                const Precision& precision) {
  std::vector<Comparison> list;
  list.reserve(references.size());
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (!precision.decides(references[i])) {
      list.push_back({0, 17, false, true});
      continue;
    }
    Comparison c{0, 17, false};
    for (std::size_t k = 0; k < columns; ++k) {
      const double given = answers.values[i][k];
      if (std::isnan(given)) {
        c = {std::numeric_limits<double>::infinity(), 0, true};
        break;
      }
      const double error = static_cast<double>(std::abs(given - references[i].expected[k]));
      if (error == 0) continue;
      const double tolerance = precision.tolerance(references[i], k);
      const double excess = tolerance > 0 ? error / tolerance : std::numeric_limits<double>::max();
      c.excess = std::max(c.excess, excess);
      if (references[i].size[k] > 0) c.digits = std::min(c.digits, -std::log10(error / references[i].size[k]));
      if (references[i].size[k] == 0) c.digits = 0;
    }
    c.digits = std::max(c.digits, 0.0);
    list.push_back(c);
  }
  return list;
}

Precision measured_precision(const std::vector<Reference>& references, const Answers& answers, std::size_t columns) {
  const Precision in_double{double_roundoff, answers.text};
  const Precision in_single{single_roundoff, answers.text};
  if (answers.text.all_single) return in_single;
  const auto at_double = compare(references, answers, columns, in_double);
  if (all_agree(at_double) || !all_agree(compare(references, answers, columns, in_single))) return in_double;
  if (answers.text.digits <= 9) return in_single;
  std::size_t moving = 0;
  std::size_t failing = 0;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (references[i].size[0] == 0) continue;
    ++moving;
    if (at_double[i].excess > 1) ++failing;
  }
  return 5 * failing >= 3 * moving ? in_single : in_double;
}

void judge_at(Judgement& judgement, const Answers& answers, const Precision& precision) {
  const std::size_t columns = answer_columns(judgement.quantities).size();
  judgement.precision = precision;
  judgement.comparisons = compare(judgement.references, answers, columns, precision);
  judgement.failing.clear();
  judgement.left_out = 0;
  judgement.not_numbers = 0;
  judgement.worst.reset();
  std::array<std::vector<double>, regime_names.size()> digits;
  std::array<RegimeResult, regime_names.size()> results{};
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.left_out) {
      ++judgement.left_out;
      continue;
    }
    const auto regime = static_cast<std::size_t>(judgement.references[i].regime);
    RegimeResult& result = results[regime];
    result.regime = judgement.references[i].regime;
    ++result.states;
    result.worst_digits = std::min(result.worst_digits, c.digits);
    digits[regime].push_back(c.digits);
    if (c.excess <= 1) continue;
    ++result.failing;
    judgement.failing.push_back(i);
    if (c.not_a_number) ++judgement.not_numbers;
    const auto badness = [&](std::size_t j) {
      return judgement.comparisons[j].not_a_number ? 0 : judgement.comparisons[j].excess;
    };
    if (!judgement.worst || badness(i) > badness(*judgement.worst)) judgement.worst = i;
  }
  judgement.regimes.clear();
  for (std::size_t r = 0; r < results.size(); ++r) {
    if (results[r].states == 0) continue;
    const auto middle = digits[r].begin() + static_cast<std::ptrdiff_t>(digits[r].size() / 2);
    std::ranges::nth_element(digits[r], middle);
    results[r].median_digits = *middle;
    judgement.regimes.push_back(results[r]);
  }
}

Judgement judge(Quantities quantities, Law law, const std::vector<State>& states, const Answers& answers) {
  Judgement judgement{quantities, law, {}, references(quantities, law, states), {}, {}, {}, 0, 0, {}};
  judge_at(judgement, answers, measured_precision(judgement.references, answers, answer_columns(quantities).size()));
  return judgement;
}

}  // namespace lubjoint::verify
