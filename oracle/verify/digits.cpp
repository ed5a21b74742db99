#include "oracle/verify/digits.hpp"

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

bool is_moving(const Reference& r) { return r.size[0] > 0; }

/// Decided for the purpose of counting digits: what a published form loses counts, what the inputs lose does not.
bool counts(const Judgement& judgement, std::size_t i) {
  const Comparison& c = judgement.comparisons[i];
  const Reference& r = judgement.references[i];
  if (c.left_out() || c.outcome == Outcome::not_a_number || !is_moving(r)) return false;
  return judgement.precision.tolerance(r, 0) <= coarsest_tolerance * r.size[0];
}

DigitDecade decade(const Judgement& judgement, const std::string& where, const auto& selects,
                   std::vector<double>& digits) {
  DigitDecade result{where};
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.left_out() || !is_moving(judgement.references[i]) || !selects(judgement.references[i])) continue;
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

/// Fewer digits from one to the next, and not by a cliff: a numerical method loses a few digits a decade.
bool loses_steadily(const DigitDecade& from, const DigitDecade& to) {
  return to.median <= from.median + 1.5 && to.median >= from.median - 4.5;
}

}  // namespace

DigitProfile digit_profile(const Judgement& judgement) {
  DigitProfile profile;
  std::vector<double> moderate, central;
  const auto add = [&](const std::string& where, const auto& selects, std::vector<double>& digits) {
    DigitDecade made = decade(judgement, where, selects, digits);
    if (made.states > 0) profile.decades.push_back(std::move(made));
    return !profile.decades.empty() && !digits.empty();
  };
  const bool there = add(
      "1 - e/c >= 0.1", [](const Reference& r) { return r.gap >= 0.1 && r.ratio >= 0.05; }, moderate);
  std::optional<DigitDecade> last;
  if (there) last = profile.decades.back();
  for (int k = 1; k <= 12; ++k) {
    const double upper = std::pow(10.0, -k), lower = std::pow(10.0, -k - 1);
    std::vector<double> digits;
    if (!add(
            fmt::format("{:g} <= 1 - e/c < {:g}", lower, upper),
            [=](const Reference& r) { return r.gap >= lower && r.gap < upper; }, digits)) {
      continue;
    }
    if (last && digits.size() >= 5) profile.steady = profile.steady && loses_steadily(*last, profile.decades.back());
    if (digits.size() >= 5) last = profile.decades.back();
  }
  bool steady_at_centre = there;
  if (there) last = profile.decades.front();
  for (const auto& [lower, upper] : {std::pair{5e-3, 0.05}, std::pair{1e-4, 5e-3}, std::pair{0.0, 1e-4}}) {
    std::vector<double> digits;
    if (!add(
            fmt::format("{:g} <= e/c < {:g}", lower, upper),
            [=](const Reference& r) { return r.ratio >= lower && r.ratio < upper; }, digits)) {
      continue;
    }
    central.insert(central.end(), digits.begin(), digits.end());
    if (last && digits.size() >= 5)
      steady_at_centre = steady_at_centre && loses_steadily(*last, profile.decades.back());
    if (digits.size() >= 5) last = profile.decades.back();
  }
  if (!steady_at_centre || moderate.empty()) moderate.insert(moderate.end(), central.begin(), central.end());
  profile.digits = moderate.empty() ? 0 : quantile(moderate, 0.01);
  return profile;
}

std::optional<FactorGroup> factor_group(const Judgement& judgement, const std::vector<State>& states,
                                        const Answers& answers, double digits) {
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
    if (c.excess <= 1 || c.left_out() || c.outcome == Outcome::not_a_number || !is_moving(judgement.references[i]))
      continue;
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
    if (!c.left_out() && is_moving(judgement.references[i]) && (c.right() || c.digits >= 2)) in_group[i] = 0;
  }
  for (const std::size_t i : best->members) in_group[i] = 1;
  best->where = domain_of(judgement.quantities, states, in_group);
  return best;
}

}  // namespace lubjoint::verify
