#include "oracle/verify/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lubjoint::verify {

namespace {

using Set = std::vector<const Mistake*>;

std::vector<std::size_t> thinned(const std::vector<std::size_t>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

/// A program's answers at one precision: what a set of mistakes is held against.
class Matcher {
 public:
  Matcher(const Judgement& judgement, const std::vector<State>& states, const Answers& answers, double precision)
      : judgement_(judgement), states_(states), answers_(answers), precision_(std::max(precision, judgement.accepted)) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Comparison& c = judgement.comparisons[i];
      if (c.left_out()) continue;
      const bool near_enough = c.outcome != Outcome::not_a_number && precision > 0 && is_right(i);
      if (c.right() || near_enough) {
        passing_.push_back(i);
      } else if (c.fails()) {
        failing_.push_back(i);
      }
    }
  }

  const std::vector<std::size_t>& columns() const { return judgement_.columns; }
  const std::vector<std::size_t>& failing() const { return failing_; }
  const std::vector<std::size_t>& passing() const { return passing_; }

  Solution predicted(const std::vector<Change>& changes, std::size_t i) const {
    return solve(judgement_.quantities, judgement_.law, states_[i], changes);
  }
  /// True if a program with these mistakes would have answered so.
  bool predicts(const std::vector<Change>& changes, std::size_t i) const { return gives(predicted(changes, i), i); }
  enum class Match { miss, hit, blurred };
  /// The same of a failing state: blurred where the right answer is as good a prediction.
  Match match(const std::vector<Change>& changes, std::size_t i) const {
    const Solution wrong = predicted(changes, i);
    if (!gives(wrong, i)) return Match::miss;
    for (const std::size_t k : judgement_.columns) {
      const Real right = judgement_.references[i].expected[k];
      if (!std::isfinite(wrong.answer[k])) return Match::hit;
      if (static_cast<double>(std::abs(wrong.answer[k] - right)) > 2 * tolerance(wrong.answer[k], i, k))
        return Match::hit;
    }
    return Match::blurred;
  }

 private:
  bool is_right(std::size_t i) const {
    const Reference& r = judgement_.references[i];
    for (const std::size_t k : judgement_.columns) {
      const double error = static_cast<double>(std::abs(answers_.values[i][k] - r.expected[k]));
      if (error > judgement_.precision.tolerance(r, k) + precision_ * r.size[k]) return false;
    }
    return true;
  }

  bool gives(const Solution& wrong, std::size_t i) const {
    for (const std::size_t k : judgement_.columns) {
      if (!near(wrong.answer[k], i, k)) return false;
    }
    return true;
  }

  bool near(Real predicted, std::size_t i, std::size_t k) const {
    const double given = answers_.values[i][k];
    if (std::isnan(given) || !std::isfinite(predicted)) return std::isnan(given) && !std::isfinite(predicted);
    return static_cast<double>(std::abs(given - predicted)) <= tolerance(predicted, i, k);
  }

  /// Size of the answers that are one vector or matrix with this one, as far as they were given.
  double given_size(std::size_t i, std::size_t k) const {
    const Answer& answer = answers_.values[i];
    if (judgement_.quantities == Quantities::wrench && k >= 2) return std::hypot(answer[2], answer[3]);
    const ColumnGroup group = group_of(judgement_.quantities, k);
    double square = 0;
    for (const std::size_t n : judgement_.columns) {
      if (n >= group.begin && n < group.end) square += answer[n] * answer[n];
    }
    // Of torques and powers, which are sums of terms that may cancel, it is that of the terms; of a solver's pressure,
    // the film's largest.
    const bool is_of_terms = judgement_.quantities == Quantities::losses ||
                             (judgement_.quantities == Quantities::pressure && is_solved_film(judgement_.law));
    const double least = is_of_terms ? judgement_.references[i].size[k] : 0;
    return std::max(std::sqrt(square), least);
  }

  /// How near an answer must be to a prediction.
  double tolerance(Real predicted, std::size_t i, std::size_t k) const {
    const Reference& reference = judgement_.references[i];
    const Precision& precision = judgement_.precision;
    // A mistake moves the conditioning with the answer: the state's relative tolerance, doubled, and ten bits more.
    const double rounding = precision.roundoff * reference.sensitivity[k];
    const double relative = reference.size[k] > 0 ? 2 * rounding / reference.size[k] : 0;
    const double value = static_cast<double>(std::abs(predicted));
    const double vector_size = given_size(i, k);
    return rounding + reference.error[k] + (relative + 0x1p10 * precision.roundoff + precision_) * vector_size +
           1.01 * precision.text.relative * value + 1.01 * precision.text.absolute;
  }

  const Judgement& judgement_;
  const std::vector<State>& states_;
  const Answers& answers_;
  double precision_;
  std::vector<std::size_t> failing_, passing_;
};

struct Candidate {
  Set mistakes;
  std::vector<bool> hits;
  double share = 0;
  double contradicted = 0;
};

/// The search at one precision.
class Search {
 public:
  Search(const Judgement& judgement, const std::vector<State>& states, const Answers& answers, double precision)
      : matcher_(judgement, states, answers, precision),
        precision_(precision),
        failing_(thinned(matcher_.failing(), 200)),
        passing_(thinned(matcher_.passing(), 300)),
        known_(mistakes_for(judgement.quantities, judgement.law)),
        is_costly_(judgement.law == "finite_reynolds"_law) {
    for (const std::size_t i : thinned(failing_, 24)) few_.push_back(i);
    for (const std::size_t i : thinned(passing_, 12)) few_.push_back(i);
  }

  bool has_failing() const { return failing_.size() >= 2; }

  std::vector<Suspicion> result(SearchDepth depth) {
    for (const Mistake* mistake : known_) {
      if (!is_costly_ || passes_few({mistake})) consider({mistake});
    }
    if (depth >= SearchDepth::pairs && !explained()) {
      for (std::size_t i = 0; i < known_.size(); ++i) {
        for (std::size_t j = i + 1; j < known_.size(); ++j) {
          if (passes_few({known_[i], known_[j]})) consider({known_[i], known_[j]});
        }
      }
    }
    if (depth >= SearchDepth::triples && !explained()) {
      const Set some = distinct();
      for (std::size_t i = 0; i < some.size(); ++i) {
        for (std::size_t j = i + 1; j < some.size(); ++j) {
          for (std::size_t k = j + 1; k < some.size(); ++k) {
            if (passes_few({some[i], some[j], some[k]})) consider({some[i], some[j], some[k]});
          }
        }
      }
    }
    return grouped();
  }

 private:
  bool explained() const {
    return std::ranges::any_of(candidates_, [](const Candidate& c) { return c.share >= 0.98; });
  }

  /// Most failing states must fit, and every right one: an answer that is right refutes.
  bool passes_few(const Set& set) const {
    const std::vector<Change> changes = changes_of(set);
    // One state of ten may be unlike the others.
    const std::size_t tolerated = set.size() > 2 ? 0 : 2;
    std::size_t misses = 0;
    for (std::size_t n = 0; n < few_.size(); ++n) {
      if (!matcher_.predicts(changes, few_[n]) && ++misses > (n < 4 ? tolerated : 2)) return false;
    }
    return true;
  }

  void consider(const Set& set) {
    Candidate c{set, {}};
    const std::vector<Change> changes = changes_of(set);
    std::size_t hits = 0, misses = 0;
    const std::size_t most_misses = failing_.size() / 2;
    for (const std::size_t i : failing_) {
      const Matcher::Match match = matcher_.match(changes, i);
      c.hits.push_back(match != Matcher::Match::miss);
      if (match == Matcher::Match::hit) ++hits;
      if (match == Matcher::Match::miss && ++misses > most_misses) return;
    }
    if (hits == 0) return;  // without effect
    std::size_t refuted = 0;
    const std::size_t tolerated = failing_.size() / 200;
    for (const std::size_t i : passing_) {
      c.hits.push_back(matcher_.predicts(changes, i));
      if (!c.hits.back() && ++refuted > tolerated) return;
    }
    c.share = static_cast<double>(hits) / static_cast<double>(hits + misses);
    c.contradicted = static_cast<double>(refuted) / static_cast<double>(failing_.size());
    candidates_.push_back(std::move(c));
  }

  /// One of each kind of mistake that gives the same answers to a few states; remembers the others of its kind.
  Set distinct() {
    std::map<std::vector<Real>, const Mistake*> kinds;
    Set list;
    for (const Mistake* mistake : known_) {
      std::vector<Real> key;
      for (const std::size_t i : few_) {
        const Solution s = matcher_.predicted(mistake->changes, i);
        const auto number = [](Real x) { return std::isnan(x) ? Real(-1e300L) : x; };
        for (const std::size_t k : matcher_.columns()) key.push_back(number(s.answer[k]));
      }
      const auto [place, is_new] = kinds.try_emplace(std::move(key), mistake);
      if (is_new) list.push_back(mistake);
      if (!is_new) alike_[place->second].push_back(mistake);
    }
    return list;
  }

  /// The same set with one mistake replaced by another of its kind.
  void add_alike(Suspicion& suspicion) const {
    for (std::size_t k = 0; k < suspicion.mistakes.size(); ++k) {
      const auto found = alike_.find(suspicion.mistakes[k]);
      if (found == alike_.end()) continue;
      for (const Mistake* other : found->second) {
        Set set = suspicion.mistakes;
        set[k] = other;
        suspicion.others.push_back(std::move(set));
      }
    }
  }

  /// Best first, the smaller set of those that explain as much; those with the same predictions become one suspicion.
  std::vector<Suspicion> grouped() {
    std::ranges::stable_sort(candidates_, [](const Candidate& x, const Candidate& y) {
      const double better = x.share - x.contradicted - y.share + y.contradicted;
      // A mistake more must explain a twentieth more.
      const double fewer = 0.05 * (static_cast<double>(y.mistakes.size()) - static_cast<double>(x.mistakes.size()));
      if (std::abs(better + fewer) > 1e-9) return better + fewer > 0;
      return x.mistakes.size() < y.mistakes.size();
    });
    std::vector<Suspicion> suspicions;
    std::vector<const Candidate*> heads;
    for (const Candidate& c : candidates_) {
      const auto same = std::ranges::find_if(heads, [&](const Candidate* head) { return head->hits == c.hits; });
      if (same != heads.end()) {
        Suspicion& suspicion = suspicions[static_cast<std::size_t>(same - heads.begin())];
        // A set that does what a smaller one does says nothing new.
        if (c.mistakes.size() == suspicion.mistakes.size()) suspicion.others.push_back(c.mistakes);
        continue;
      }
      if (suspicions.size() == 5) break;
      suspicions.push_back({c.mistakes, {}, c.share, c.contradicted, precision_});
      add_alike(suspicions.back());
      heads.push_back(&c);
    }
    if (!suspicions.empty() && suspicions[0].explains_all()) suspicions.resize(1);
    return suspicions;
  }

  Matcher matcher_;
  double precision_;
  std::vector<std::size_t> failing_, passing_, few_;
  Set known_;
  bool is_costly_;  ///< each state of it is solved for on grids
  std::map<const Mistake*, Set> alike_;
  std::vector<Candidate> candidates_;
};

}  // namespace

bool Suspicion::names(const std::vector<const Mistake*>& wanted) const {
  const std::set<const Mistake*> looked_for(wanted.begin(), wanted.end());
  const auto same = [&](const Set& set) { return std::set<const Mistake*>(set.begin(), set.end()) == looked_for; };
  return same(mistakes) || std::ranges::any_of(others, same);
}

std::vector<Suspicion> suspicions_of(const Judgement& judgement, const std::vector<State>& states,
                                     const Answers& answers, const std::vector<double>& precisions, SearchDepth depth) {
  std::vector<Suspicion> best;
  for (const double precision : precisions) {
    Search search(judgement, states, answers, precision);
    if (!search.has_failing()) break;
    const bool first = precision == precisions.front();
    std::vector<Suspicion> found = search.result(first ? depth : std::min(depth, SearchDepth::pairs));
    if (found.empty()) continue;
    if (best.empty() || found[0].share > best[0].share + 0.2) best = std::move(found);
    if (best[0].share >= 0.9) break;
  }
  return best;
}

}  // namespace lubjoint::verify
