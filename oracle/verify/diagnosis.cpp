#include "oracle/verify/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lubjoint::verify {

namespace {

constexpr double single_roundoff = 0x1p-24;

using Set = std::vector<const Mistake*>;

std::vector<std::size_t> thinned(const std::vector<std::size_t>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

/// The states at which suspicions are tried: failing ones first.
struct Sample {
  std::vector<std::size_t> states;
  std::size_t failing;
};

Sample sample_of(const Judgement& judgement, std::size_t most_failing, std::size_t most_passing) {
  std::vector<std::size_t> passing;
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    if (judgement.comparisons[i].passes()) passing.push_back(i);
  }
  Sample sample{thinned(judgement.failing, most_failing), 0};
  sample.failing = sample.states.size();
  const auto some = thinned(passing, most_passing);
  sample.states.insert(sample.states.end(), some.begin(), some.end());
  return sample;
}

class Matcher {
 public:
  Matcher(const Judgement& judgement, const std::vector<State>& states, const Answers& answers)
      : judgement_(judgement),
        states_(states),
        answers_(answers),
        columns_(answer_columns(judgement.quantities).size()) {}

  /// True if a program with these mistakes would have answered so.
  bool predicts(const Set& mistakes, std::size_t i) const {
    const Solution wrong = solve_with(judgement_.quantities, judgement_.law, states_[i], mistakes);
    return std::ranges::all_of(range(columns_), [&](std::size_t k) { return near(wrong.answer[k], i, k); });
  }

  /// Bit i: predicted at sample.states[i].
  std::vector<bool> predictions(const Set& mistakes, const Sample& sample) const {
    std::vector<bool> hits;
    for (const std::size_t i : sample.states) hits.push_back(predicts(mistakes, i));
    return hits;
  }

 private:
  static std::vector<std::size_t> range(std::size_t n) {
    std::vector<std::size_t> list(n);
    for (std::size_t k = 0; k < n; ++k) list[k] = k;
    return list;
  }

  bool near(Real predicted, std::size_t i, std::size_t k) const {
    const double given = answers_.values[i][k];
    if (std::isnan(given) || !std::isfinite(predicted)) return std::isnan(given) && !std::isfinite(predicted);
    const Reference& reference = judgement_.references[i];
    const Precision& precision = judgement_.precision;
    // A mistake moves the conditioning with the answer: the state's relative tolerance, doubled, and ten bits more.
    const double rounding = precision.roundoff * reference.sensitivity[k];
    const double relative = reference.size[k] > 0 ? 2 * rounding / reference.size[k] : 0;
    const double value = static_cast<double>(std::abs(predicted));
    const double vector_size = std::hypot(answers_.values[i][k < 2 ? 0 : 2], answers_.values[i][k < 2 ? 1 : 3]);
    const double tolerance = rounding + (relative + 0x1p10 * precision.roundoff) * vector_size +
                             1.01 * precision.text.relative * value + 1.01 * precision.text.absolute;
    return static_cast<double>(std::abs(given - predicted)) <= tolerance;
  }

  const Judgement& judgement_;
  const std::vector<State>& states_;
  const Answers& answers_;
  std::size_t columns_;
};

struct Candidate {
  Set mistakes;
  std::vector<bool> hits;
  double share;
  double contradicted;
  double score() const { return share - contradicted; }
};

Candidate candidate(const Matcher& matcher, const Set& mistakes, const Sample& sample) {
  Candidate c{mistakes, matcher.predictions(mistakes, sample), 0, 0};
  const auto failing = static_cast<double>(sample.failing);
  for (std::size_t i = 0; i < c.hits.size(); ++i) {
    if (i < sample.failing && c.hits[i]) c.share += 1 / failing;
    if (i >= sample.failing && !c.hits[i]) c.contradicted += 1 / failing;
  }
  return c;
}

/// Best first; those with the same predictions become one suspicion.
std::vector<Suspicion> grouped(std::vector<Candidate> candidates, std::size_t most) {
  std::ranges::stable_sort(candidates, [](const Candidate& x, const Candidate& y) {
    if (std::abs(x.score() - y.score()) > 1e-9) return x.score() > y.score();
    return x.mistakes.size() < y.mistakes.size();
  });
  std::vector<Suspicion> suspicions;
  std::vector<const Candidate*> heads;
  for (const Candidate& c : candidates) {
    const auto same = std::ranges::find_if(heads, [&](const Candidate* head) { return head->hits == c.hits; });
    if (same != heads.end()) {
      Suspicion& suspicion = suspicions[static_cast<std::size_t>(same - heads.begin())];
      // A pair that does what one mistake does says nothing new.
      if (c.mistakes.size() == suspicion.mistakes.size()) suspicion.others.push_back(c.mistakes);
      continue;
    }
    if (suspicions.size() == most) break;
    suspicions.push_back({c.mistakes, {}, c.share, c.contradicted});
    heads.push_back(&c);
  }
  return suspicions;
}

/// Suspicions at the judgement's precision.
std::vector<Suspicion> suspects(const Judgement& judgement, const std::vector<State>& states, const Answers& answers) {
  const Matcher matcher(judgement, states, answers);
  const Sample sample = sample_of(judgement, 400, 200);
  const Set known = mistakes_for(judgement.quantities, judgement.law);
  std::vector<Candidate> candidates;
  for (const Mistake* mistake : known) {
    Candidate c = candidate(matcher, {mistake}, sample);
    if (c.share >= 0.02) candidates.push_back(std::move(c));
  }
  std::vector<Suspicion> alone = grouped(candidates, 5);
  if (!alone.empty() && alone[0].explains_all()) return {alone[0]};

  // Pairs must explain a third of what the best one leaves open. A few states first, half of them of those that it
  // leaves open; all of the sample for the pairs that survive.
  const double best = candidates.empty() ? 0 : alone[0].share - alone[0].contradicted;
  const double to_beat = best + 0.33 * (1 - best);
  Sample few = sample_of(judgement, 16, 8);
  const Set head = alone.empty() ? Set{} : alone[0].mistakes;
  std::vector<std::size_t> left_open;
  for (const std::size_t state : sample.states) {
    if (alone.empty() || !matcher.predicts(head, state)) left_open.push_back(state);
  }
  const auto some = thinned(left_open, 16);
  few.states.insert(few.states.end(), some.begin(), some.end());
  const auto allowed = static_cast<std::size_t>((1 - to_beat) * static_cast<double>(few.states.size())) + 4;
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (std::size_t j = i + 1; j < known.size(); ++j) {
      const Set pair = {known[i], known[j]};
      std::size_t misses = 0;
      for (const std::size_t state : few.states) {
        if (!matcher.predicts(pair, state) && ++misses > allowed) break;
      }
      if (misses > allowed) continue;
      Candidate c = candidate(matcher, pair, sample);
      if (c.score() >= to_beat) candidates.push_back(std::move(c));
    }
  }
  std::vector<Suspicion> all = grouped(std::move(candidates), 5);
  if (!all.empty() && all[0].explains_all()) all.erase(all.begin() + 1, all.end());
  return all;
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// Facts about the failing states that point at a branch or a term.
Pattern pattern_of(const Judgement& judgement, const std::vector<State>& states, const Answers& answers) {
  Pattern pattern;
  const std::size_t columns = answer_columns(judgement.quantities).size();
  const auto& names = answer_columns(judgement.quantities);
  const auto failing_share = [&](const auto& selects) {
    double failing = 0, passing = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Solution s = solve(judgement.quantities, judgement.law, states[i]);
      const Comparison& c = judgement.comparisons[i];
      if (c.left_out || (s.answer[0] == 0 && s.answer[1] == 0) || !selects(s)) continue;
      (c.fails() ? failing : passing) += 1;
    }
    return std::array<double, 2>{failing, passing};
  };
  const auto only = [&](const char* words, const auto& selects) {
    const auto inside = failing_share(selects);
    const auto outside = failing_share([&](const Solution& s) { return !selects(s); });
    if (inside[0] > 0 && outside[0] == 0 && outside[1] > 0) pattern.facts.push_back(fmt::format("only {}", words));
  };
  only("where the film closes (squeeze rate b > 0)", [](const Solution& s) { return s.b > 0; });
  only("where the film opens (squeeze rate b < 0)", [](const Solution& s) { return s.b < 0; });
  only("where the slip rate a > 0", [](const Solution& s) { return s.a > 0; });
  only("where the slip rate a < 0", [](const Solution& s) { return s.a < 0; });
  only("where ex < 0", [](const Solution& s) { return s.e.x() < 0; });
  if (judgement.quantities == Quantities::transition) {
    only("beyond the clearance, |e| > c", [](const Solution& s) { return s.penetration > 0; });
  }
  // One factor for all failing states?
  for (std::size_t k = 0; k < columns; ++k) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool wrong = false;
    for (const std::size_t i : judgement.failing) {
      const auto expected = static_cast<double>(judgement.references[i].expected[k]);
      const double given = answers.values[i][k];
      if (std::isnan(given)) continue;
      if (std::abs(given - expected) > judgement.precision.tolerance(judgement.references[i], k)) wrong = true;
      if (std::abs(expected) < 1e-3 * judgement.references[i].size[k] || expected == 0) continue;
      low = std::min(low, given / expected);
      high = std::max(high, given / expected);
    }
    if (!wrong) {
      pattern.facts.push_back(fmt::format("{} is right everywhere", names[k]));
    } else if (high - low <= 1e-6 * std::abs(high)) {
      pattern.facts.push_back(fmt::format("{} is {:.8g} times what it should be", names[k], high));
    }
  }
  pattern.facts.push_back(
      percent(static_cast<double>(judgement.failing.size()) / static_cast<double>(judgement.judged())) +
      " of the states fail");
  return pattern;
}

/// Zeros are within single precision's rounding of every answer that is a million times too small.
bool mostly_zero(const Answers& answers) {
  const auto zeros = std::ranges::count_if(answers.values, [](const Answer& a) { return a[0] == 0 && a[1] == 0; });
  return 2 * static_cast<std::size_t>(zeros) > answers.values.size();
}

}  // namespace

bool Suspicion::names(const std::vector<const Mistake*>& wanted) const {
  const std::set<const Mistake*> looked_for(wanted.begin(), wanted.end());
  const auto same = [&](const Set& set) { return std::set<const Mistake*>(set.begin(), set.end()) == looked_for; };
  return same(mistakes) || std::ranges::any_of(others, same);
}

Diagnosis diagnose(Judgement& judgement, const std::vector<State>& states, const Answers& answers) {
  Diagnosis diagnosis{suspects(judgement, states, answers), {}};
  const bool explained = !diagnosis.suspicions.empty() && diagnosis.suspicions[0].share > 0.5;
  if (!explained && judgement.precision.roundoff < single_roundoff && !mostly_zero(answers)) {
    // A program that is wrong, and works in single precision on top of it.
    Judgement in_single = judgement;
    judge_at(in_single, answers, {single_roundoff, answers.text});
    if (!in_single.failing.empty()) {
      auto found = suspects(in_single, states, answers);
      if (!found.empty() && found[0].share > 0.5) {
        judgement = std::move(in_single);
        diagnosis.suspicions = std::move(found);
      }
    }
  }
  diagnosis.pattern = pattern_of(judgement, states, answers);
  return diagnosis;
}

}  // namespace lubjoint::verify
