#include "oracle/verify/states/finite_suspects.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

namespace {

using oracle::FiniteFilm;

/// What the solver is asked for, of answers that are held against wrong ones.
oracle::FiniteLengthOptions quick(const FiniteClaim& claim) {
  if (claim.film == FiniteFilm::finite_reynolds) return {1e-3, claim.onset};
  return {1e-6, claim.onset, oracle::SmoothFilmMethod::circumferential_modes};
}

bool fails(const FiniteComparison& c) { return c.outcome == Outcome::wrong || c.outcome == Outcome::not_a_number; }

/// Would a program with these mistakes have given this answer?
bool reproduces(const FiniteVerification& v, const FiniteMistakes& mistakes, std::size_t i) {
  const auto wrong = finite_answer(v.claim, v.quantities, v.states[i], mistakes, quick(v.claim));
  const Vector2<double> given(v.answers.values[i][0], v.answers.values[i][1]);
  if (!wrong || !given.allFinite()) return !wrong && !given.allFinite();
  // Where such a program finds no force, rounding of a and b is all that it answers.
  constexpr double rounding = 1e-9;
  const double size = wrong->force.norm();
  const double allowed = size > 0 ? (v.tolerance + wrong->bound) * size : 0;
  return (given - wrong->force).norm() <= allowed + rounding * v.comparisons[i].expected.norm();
}

/// Some of the failing states and some of the right ones, from all of them: what most mistakes are told by.
std::vector<std::size_t> telling_states(const FiniteVerification& v) {
  std::vector<std::size_t> failing, right;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    if (!v.comparisons[i].is_decided()) continue;
    (fails(v.comparisons[i]) ? failing : right).push_back(i);
  }
  std::vector<std::size_t> some;
  const auto take = [&some](const std::vector<std::size_t>& from, std::size_t count) {
    const std::size_t taken = std::min(count, from.size());
    for (std::size_t k = 0; k < taken; ++k) some.push_back(from[k * from.size() / taken]);
  };
  take(failing, 7);
  take(right, 3);
  return some;
}

constexpr double nearly_all = 0.98;

std::optional<FiniteSuspicion> suspicion_of(const FiniteVerification& v, const std::vector<std::size_t>& telling,
                                            const FiniteMistakes& mistakes) {
  if (!std::ranges::all_of(telling, [&](std::size_t i) { return reproduces(v, mistakes, i); })) return {};
  double failing = 0, explained = 0, contradicted = 0;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    if (!v.comparisons[i].is_decided()) continue;
    const bool same = reproduces(v, mistakes, i);
    if (fails(v.comparisons[i])) {
      ++failing;
      explained += same ? 1 : 0;
    } else {
      contradicted += same ? 0 : 1;
    }
  }
  const FiniteSuspicion suspicion{mistakes, explained / failing, contradicted / failing};
  if (suspicion.share < nearly_all || suspicion.contradicted > 0) return {};
  return suspicion;
}

}  // namespace

std::vector<FiniteSuspicion> finite_suspicions(const FiniteVerification& v) {
  FiniteMistakes possible;
  for (const FiniteMistake& each : finite_gallery()) {
    if (each.applies(v.claim, v.quantities)) possible.push_back(&each);
  }
  const std::vector<std::size_t> telling = telling_states(v);
  std::vector<FiniteSuspicion> found;
  const auto look_at = [&](const FiniteMistakes& mistakes) {
    if (auto suspicion = suspicion_of(v, telling, mistakes)) found.push_back(std::move(*suspicion));
  };
  const auto likeliest_first = [&found] {
    std::stable_sort(found.begin(), found.end(),
                     [](const FiniteSuspicion& a, const FiniteSuspicion& b) { return a.share > b.share; });
    return found;
  };
  for (const FiniteMistake* each : possible) look_at({each});
  if (!found.empty()) return likeliest_first();
  for (std::size_t i = 0; i < possible.size(); ++i) {
    for (std::size_t k = i + 1; k < possible.size(); ++k) look_at({possible[i], possible[k]});
  }
  return likeliest_first();
}

std::vector<std::string> laws_of_answers(const FiniteVerification& v) {
  std::vector<std::string> names;
  for (const std::string_view name : law_names) {
    const Law law = law_of(name);
    bool all = true;
    for (std::size_t i = 0; i < v.states.size() && all; ++i) {
      if (!v.comparisons[i].is_decided()) continue;
      const Solution s = solve(v.quantities, law, v.states[i]);
      const Vector2<double> force(static_cast<double>(s.answer[0]), static_cast<double>(s.answer[1]));
      const Vector2<double> given(v.answers.values[i][0], v.answers.values[i][1]);
      all = given.allFinite() && (given - force).norm() <= v.tolerance * force.norm();
    }
    if (all) names.emplace_back(name);
  }
  return names;
}

}  // namespace lubjoint::verify
