#include "oracle/verify/states/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace lubjoint::verify {

namespace {

double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

/// Is there an answer other than zero?
bool is_moving(const Judgement& judgement, std::size_t i) {
  return judgement.references[i].size[judgement.first_column()] > 0;
}

/// Decided for the purpose of counting digits: what a published form loses counts, what the inputs lose does not.
bool counts(const Judgement& judgement, std::size_t i) {
  const Comparison& c = judgement.comparisons[i];
  const Reference& r = judgement.references[i];
  if (c.left_out() || c.outcome == Outcome::not_a_number || !is_moving(judgement, i)) return false;
  const std::size_t first = judgement.first_column();
  return judgement.precision.tolerance(r, first) <= coarsest_tolerance * r.size[first];
}

DigitDecade decade(const Judgement& judgement, const std::string& where, const auto& selects,
                   std::vector<double>& digits) {
  DigitDecade result{where};
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.left_out() || !is_moving(judgement, i) || !selects(judgement.references[i])) continue;
    ++result.states;
    if (c.outcome == Outcome::undecided) ++result.undecided;
    if (c.fails()) ++result.failing;
    if (counts(judgement, i)) digits.push_back(c.digits);
  }
  if (!digits.empty()) {
    result.least = quantile(digits, 0.01);
    result.median = quantile(digits, 0.5);
  }
  return result;
}

/// Fewer digits from one bin to the next, and not by a cliff: where a method loses many of them in half a decade, as
/// spectral ones do, some states have a number in between.
bool loses_steadily(double from, double to, const std::vector<double>& digits_of_both) {
  if (to > from + 1.5) return false;
  if (to >= from - 4.5) return true;
  return std::ranges::count_if(digits_of_both, [=](double x) { return x > to + 1.5 && x < from - 1.5; }) >= 3;
}

/// Over bins of a distance, from the first to the last; bins of fewer than five states say nothing.
bool loses_steadily(const Judgement& judgement, const std::vector<double>& edges, double Reference::*distance) {
  std::optional<double> last;
  std::vector<double> last_digits;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    std::vector<double> digits;
    for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
      const double here = judgement.references[i].*distance;
      if (here < edges[k] && here >= edges[k + 1] && counts(judgement, i))
        digits.push_back(judgement.comparisons[i].digits);
    }
    if (digits.size() < 5) continue;
    const double median = quantile(digits, 0.5);
    last_digits.insert(last_digits.end(), digits.begin(), digits.end());
    if (last && !loses_steadily(*last, median, last_digits)) return false;
    last = median;
    last_digits = digits;
  }
  return true;
}

/// 1, 10^-1/2, 10^-1 … 1e-10, 0
std::vector<double> half_decades() {
  std::vector<double> edges;
  for (int k = 0; k <= 20; ++k) edges.push_back(std::pow(10.0, -0.5 * k));
  edges.push_back(0);
  return edges;
}

}  // namespace

DigitProfile digit_profile(const Judgement& judgement) {
  DigitProfile profile;
  std::vector<double> moderate, central;
  const auto add = [&](const std::string& where, const auto& selects, std::vector<double>& digits) {
    DigitDecade made = decade(judgement, where, selects, digits);
    if (made.states > 0) profile.decades.push_back(std::move(made));
  };
  add(
      "1 - e/c >= 0.1", [](const Reference& r) { return r.gap >= 0.1 && r.ratio >= 0.05; }, moderate);
  for (int k = 1; k <= 12; ++k) {
    const double upper = std::pow(10.0, -k), lower = std::pow(10.0, -k - 1);
    std::vector<double> digits;
    add(
        fmt::format("{:g} <= 1 - e/c < {:g}", lower, upper),
        [=](const Reference& r) { return r.gap >= lower && r.gap < upper; }, digits);
  }
  const std::vector<double> central_edges = {0.05, 5e-3, 1e-4, 0};
  for (std::size_t k = 0; k + 1 < central_edges.size(); ++k) {
    const double upper = central_edges[k], lower = central_edges[k + 1];
    add(
        fmt::format("{:g} <= e/c < {:g}", lower, upper),
        [=](const Reference& r) { return r.ratio >= lower && r.ratio < upper; }, central);
  }
  profile.steady = loses_steadily(judgement, half_decades(), &Reference::gap);
  const bool steady_at_centre = loses_steadily(judgement, {0.5, 0.05, 5e-3, 1e-4, 0}, &Reference::ratio);
  if (!steady_at_centre || moderate.empty()) moderate.insert(moderate.end(), central.begin(), central.end());
  profile.digits = moderate.empty() ? 0 : quantile(moderate, 0.01);
  if (!is_solved_film(judgement.law)) return profile;
  profile.digits = 17;
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    if (counts(judgement, i)) profile.digits = std::min(profile.digits, judgement.comparisons[i].digits);
  }
  return profile;
}

std::optional<FactorGroup> factor_group(const Judgement& judgement, const std::vector<State>& states,
                                        const Answers& answers, double digits) {
  if (is_table(judgement.quantities)) return {};  // column by column: columns_of
  // Where a program has two digits only, a positive factor may be chance.
  const bool few_digits = digits < 2.5;
  const double tolerance = std::clamp(3 * std::pow(10.0, -digits), 3e-3, 0.03);  // fewer digits where films are thin
  struct Off {
    std::size_t state;
    std::complex<double> ratio;
  };
  std::vector<Off> off;
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.excess <= 1 || c.left_out() || c.outcome == Outcome::not_a_number || !is_moving(judgement, i)) continue;
    const auto& expected = judgement.references[i].expected;
    const std::complex<double> right(static_cast<double>(expected[0]), static_cast<double>(expected[1]));
    off.push_back({i, std::complex<double>(answers.values[i][0], answers.values[i][1]) / right});
  }
  std::optional<FactorGroup> best;
  for (const double factor :
       {-1.0, 2.0, 0.5, -2.0, -0.5, 3.0, 4.0, 8.0, 0.25, 0.125, 10.0, 0.1, 100.0, 0.01, 1000.0, 1e-3, 0.0}) {
    if (few_digits && factor > 0) continue;
    FactorGroup group{factor, {}, {}};
    for (const Off& each : off) {
      if (std::abs(each.ratio - factor) <= tolerance * std::abs(factor)) group.members.push_back(each.state);
    }
    if (group.members.size() < 3 || (best && group.members.size() <= best->members.size())) continue;
    best = std::move(group);
  }
  if (!best) return {};
  std::vector<int> in_group(states.size(), -1);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    // Where answers are off by less regular amounts, too, the place is told from those that are right.
    if (!c.left_out() && is_moving(judgement, i) && (c.right() || c.digits >= 2)) in_group[i] = 0;
  }
  for (const std::size_t i : best->members) in_group[i] = 1;
  best->where = domain_of(judgement.quantities, states, in_group);
  // The place is theirs only if most of what is wrong there is off by this factor.
  std::size_t wrong_there = 0;
  for (const Off& each : off) {
    if (std::ranges::any_of(best->where, [&](const Conjunction& c) { return holds(c, states[each.state]); }))
      ++wrong_there;
  }
  if (5 * best->members.size() < 3 * wrong_there) best->where.clear();
  return best;
}

}  // namespace lubjoint::verify
