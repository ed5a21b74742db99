#include "oracle/verify/terms/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/verify/terms/factor.hpp"

namespace lubjoint::verify {

namespace {

double expected(const Judgement& judgement, std::size_t i, std::size_t k) {
  return static_cast<double>(judgement.references[i].expected[k]);
}

/// The states that say something of a column: a number is there, and rounding leaves it its digits.
std::vector<std::size_t> telling_states(const Judgement& judgement, const Answers& answers, std::size_t k) {
  std::vector<std::size_t> states;
  for (std::size_t i = 0; i < judgement.references.size(); ++i) {
    const Reference& r = judgement.references[i];
    if (judgement.comparisons[i].left_out() || std::isnan(answers.values[i][k]) || !(r.size[k] > 0)) continue;
    if (judgement.precision.tolerance(r, k) <= coarsest_tolerance * r.size[k]) states.push_back(i);
  }
  return states;
}

/// The one number that the answers are of what they should be, within a millionth; none if there is none. Numbers that
/// are small beside their matrix are left out.
std::optional<double> common_factor(const Judgement& judgement, const Answers& answers, std::size_t k,
                                    std::size_t of_column, const std::vector<std::size_t>& states) {
  std::vector<double> ratios;
  for (const std::size_t i : states) {
    const double right = expected(judgement, i, of_column);
    if (std::abs(right) > 0.01 * judgement.references[i].size[of_column])
      ratios.push_back(answers.values[i][k] / right);
  }
  if (ratios.size() < 5) return {};
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  const double factor = *middle;
  const bool all =
      std::ranges::all_of(ratios, [=](double x) { return std::abs(x - factor) <= 1e-6 * std::abs(factor); });
  return all ? std::optional(factor) : std::nullopt;
}

void judge_column(const Judgement& judgement, const Answers& answers, std::size_t k, ColumnResult& result) {
  const std::vector<std::size_t> states = telling_states(judgement, answers, k);
  result.states = states.size();
  if (states.empty()) return;
  std::vector<double> digits;
  bool zero = true;
  for (const std::size_t i : states) {
    const Reference& r = judgement.references[i];
    const double given = answers.values[i][k], error = std::abs(given - expected(judgement, i, k));
    digits.push_back(error > r.error[k] ? std::clamp(-std::log10(error / r.size[k]), 0.0, 17.0) + 0.0 : 17);
    if (number_outcome(r, k, given, judgement.precision, judgement.accepted) == Outcome::wrong) ++result.failing;
    zero = zero && given == 0;
  }
  const auto low = digits.begin() + static_cast<std::ptrdiff_t>(digits.size() / 20);
  std::ranges::nth_element(digits, low);
  result.digits = *low;
  result.verdict = ColumnVerdict::right;
  if (result.failing == 0) return;
  result.verdict = ColumnVerdict::wrong;
  if (zero) {
    result.verdict = ColumnVerdict::absent;
  } else if (const auto factor = common_factor(judgement, answers, k, k, states);
             factor && std::abs(*factor - 1) > 1e-5) {
    result.verdict = ColumnVerdict::factor;
    result.factor = factor;
    result.factor_text = factor_words(*factor, 1e-6);
  } else {
    constexpr double plainly_wrong = 2;  // digits: a symmetric matrix has the same number twice
    for (const std::size_t other : all_columns(judgement.quantities)) {
      if (result.digits > plainly_wrong) break;
      const auto same = other == k ? std::nullopt : common_factor(judgement, answers, k, other, states);
      if (!same || std::abs(std::abs(*same) - 1) > 1e-6) continue;
      result.verdict = ColumnVerdict::other;
      result.factor = *same < 0 ? -1 : 1;
      result.other = answer_columns(judgement.quantities)[other];
      break;
    }
  }
}

}  // namespace

std::string ColumnResult::words() const {
  switch (verdict) {
    case ColumnVerdict::right:
      return "right";
    case ColumnVerdict::absent:
      return "zero";
    case ColumnVerdict::factor:
      return factor_text.empty() ? fmt::format("{:.10g} times what it should be", *factor)
                                 : fmt::format("{} times what it should be ({:.10g})", factor_text, *factor);
    case ColumnVerdict::other:
      return fmt::format("{}what {} should be", *factor < 0 ? "minus " : "", other);
    case ColumnVerdict::undecided:
      return "-";
    case ColumnVerdict::wrong:
      break;
  }
  return fmt::format("wrong at {} of {} states", failing, states);
}

std::vector<ColumnResult> columns_of(const Judgement& judgement, const Answers& answers) {
  std::vector<ColumnResult> results;
  if (!is_table(judgement.quantities)) return results;
  for (const std::size_t k : judgement.columns) {
    ColumnResult result;
    result.name = answer_columns(judgement.quantities)[k];
    judge_column(judgement, answers, k, result);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace lubjoint::verify
