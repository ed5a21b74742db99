#include "oracle/verify/states/finite_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "oracle/files/parallel.hpp"
#include "oracle/verify/states/finite_suspects.hpp"

namespace lubjoint::verify {

namespace {

using oracle::FilmOnset;
using oracle::FiniteFilm;

/// a/ε and b over the journal's spin, and the bearing's spin over it.
struct Motion {
  double whirl;    ///< γ̇, relative to the bearing
  double squeeze;  ///< b
  double spin;     ///< sign of the journal's
  double bearing;  ///< spin
};
/// Steady rotation of both signs, squeeze alone (of both signs: the whirl at half of the sum of the spins), both.
constexpr std::array motions = {Motion{0, 0, 1, 0},      Motion{0, 0, -1, 0},    Motion{0.5, 0.5, 1, 0},
                                Motion{0.5, -0.5, 1, 0}, Motion{0.1, 0.4, 1, 0}, Motion{-0.25, -0.2, -1, 0.5}};

/// A third of what is called right, as far as the solver reaches.
double error_asked_for(FiniteFilm film, double tolerance) {
  return film == FiniteFilm::finite_reynolds ? std::clamp(tolerance / 3, 1e-5, 3e-4)
                                             : std::clamp(tolerance / 3, 1e-9, 1e-6);
}

/// The right answer, in the answer's components.
FiniteComparison expected_of(const FiniteClaim& claim, Quantities quantities, const State& s, double tolerance) {
  const auto right = finite_answer(claim, quantities, s, {}, {error_asked_for(claim.film, tolerance), claim.onset});
  FiniteComparison comparison;
  comparison.expected = right->force;
  comparison.bound = right->bound;
  if (is_on_finite_jump(claim, quantities, s)) comparison.outcome = Outcome::left_out;
  return comparison;
}

void compare(FiniteComparison& c, const Answer& answer, double factor, double tolerance) {
  if (c.outcome == Outcome::left_out) return;
  const Vector2<double> given(answer[0], answer[1]);
  c.error = given.allFinite() ? (given - factor * c.expected).norm() / (std::abs(factor) * c.expected.norm())
                              : std::numeric_limits<double>::infinity();
  if (!given.allFinite()) {
    c.outcome = Outcome::not_a_number;
  } else if (!(c.bound <= tolerance)) {
    c.outcome = Outcome::undecided;
  } else {
    c.outcome = c.error <= tolerance + c.bound ? Outcome::right : Outcome::wrong;
  }
}

std::vector<FiniteComparison> comparisons_of(const FiniteClaim& claim, const FiniteVerification& v, unsigned threads) {
  std::vector<FiniteComparison> list(v.states.size());
  reports::run_parallel(list.size(), threads, [&](std::size_t i) {
    list[i] = expected_of(claim, v.quantities, v.states[i], v.tolerance);
    compare(list[i], v.answers.values[i], 1, v.tolerance);
  });
  return list;
}

/// Is none wrong, and are most of them right, and not undecided?
bool all_right(const std::vector<FiniteComparison>& list) {
  std::size_t right = 0, undecided = 0;
  for (const FiniteComparison& c : list) {
    if (c.outcome == Outcome::wrong || c.outcome == Outcome::not_a_number) return false;
    right += c.outcome == Outcome::right ? 1 : 0;
    undecided += c.outcome == Outcome::undecided ? 1 : 0;
  }
  return right > undecided;
}

/// The factor that makes all answers right, if there is one: the median of the projections on the right forces.
std::optional<double> common_factor(const FiniteVerification& v) {
  std::vector<double> factors;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    const FiniteComparison& c = v.comparisons[i];
    if (c.outcome == Outcome::left_out) continue;
    if (c.outcome == Outcome::not_a_number) return {};
    const Vector2<double> given(v.answers.values[i][0], v.answers.values[i][1]);
    factors.push_back(dot(given, c.expected) / dot(c.expected, c.expected));
  }
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  std::ranges::nth_element(factors, middle);
  if (!(std::abs(*middle) > 0)) return {};
  std::vector<FiniteComparison> scaled = v.comparisons;
  for (std::size_t i = 0; i < scaled.size(); ++i) compare(scaled[i], v.answers.values[i], *middle, v.tolerance);
  if (!all_right(scaled)) return {};
  return *middle;
}

/// The kind of a state's motion, as its terms are told apart; none at rest.
std::optional<MotionKind> kind_of(const PolarMotion& m) {
  constexpr double rounding = 1e-9;
  if (m.whirl == 0 && m.squeeze == 0) return m.turns ? std::optional(MotionKind::wedge) : std::nullopt;
  if (std::abs(m.slip) <= rounding * std::abs(m.squeeze)) {
    return m.squeeze > 0 ? MotionKind::closing : MotionKind::opening;
  }
  return MotionKind::mixed;
}

/// Radial and tangential component, each in one kind of motion, at the tolerance of the comparison.
std::vector<Term> terms_of_finite(const FiniteVerification& v) {
  TermNumbers numbers;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    const FiniteComparison& c = v.comparisons[i];
    if (!c.is_decided() || c.outcome == Outcome::not_a_number) continue;
    const PolarMotion motion = polar_motion(v.quantities, v.states[i]);
    const auto kind = kind_of(motion);
    if (!kind) continue;
    const double size = c.expected.norm();
    const Vector2<double> given(v.answers.values[i][0], v.answers.values[i][1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector2<double> axis = k == 0 ? motion.radial : perpendicular(motion.radial);
      numbers[k][static_cast<std::size_t>(*kind)].push_back(
          {dot(given, axis), dot(c.expected, axis), (v.tolerance + c.bound) * size, size, &v.states[i], motion.ratio,
           1 - motion.ratio, std::abs(motion.slip) + std::abs(motion.squeeze), 0, 0});
    }
  }
  return terms_of(numbers, false);
}

/// Where the answers are right, wrong, and no numbers.
void locate(FiniteVerification& v) {
  std::vector<int> right, wrong, none;
  for (const FiniteComparison& c : v.comparisons) {
    const bool is_none = c.outcome == Outcome::not_a_number;
    right.push_back(!c.is_decided() ? -1 : c.outcome == Outcome::right);
    wrong.push_back(!c.is_decided() || is_none ? -1 : c.outcome == Outcome::wrong);
    none.push_back(!c.is_decided() ? -1 : is_none);
  }
  v.right_where = domain_of(v.quantities, v.states, right);
  v.wrong_where = domain_of(v.quantities, v.states, wrong);
  v.not_a_number_where = domain_of(v.quantities, v.states, none);
}

std::vector<FiniteClaim> other_claims(const FiniteClaim& claim) {
  std::vector<FiniteClaim> list;
  for (const FiniteFilm film : {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic}) {
    if (film != claim.film) list.push_back({film});
  }
  for (const FilmOnset onset : {FilmOnset::free, FilmOnset::maximum_film}) {
    if (claim.film != FiniteFilm::finite_reynolds || claim.onset != onset) {
      list.push_back({FiniteFilm::finite_reynolds, onset});
    }
  }
  return list;
}

/// Every film and, where there is none, every law whose forces all answers are.
void find_other_films(FiniteVerification& v, unsigned threads) {
  for (const FiniteClaim& other : other_claims(v.claim)) {
    if (all_right(comparisons_of(other, v, threads))) v.others.push_back(other);
  }
  if (v.others.empty()) v.laws = laws_of_answers(v);
}

}  // namespace

std::vector<State> finite_states(Quantities quantities, const Conjunction& domain) {
  const bool polar = quantities == Quantities::polar;
  if (!polar && quantities != Quantities::cartesian) {
    throw std::invalid_argument("the quantities " + std::string(name_of(quantities)) +
                                " are no force alone; allowed are cartesian and polar");
  }
  std::vector<State> states;
  for (std::size_t i = 0; i < finite_shapes.size(); ++i) {
    for (const double epsilon : finite_ratios) {
      for (const Motion& motion : motions) {
        State s;
        const double k = static_cast<double>(states.size());
        s.radius = 0.01 * (1 + static_cast<double>(i));
        s.length = 2 * s.radius * finite_shapes[i];
        s.clearance = s.radius / 512;
        s.viscosity = 0.02 + 0.01 * static_cast<double>(states.size() % 5);
        const double spin = 100 + 10 * static_cast<double>(states.size() % 7);
        s.omega_journal = motion.spin * spin;
        s.omega_bearing = motion.bearing * spin;
        s.omega = s.omega_journal - s.omega_bearing;
        s.attitude_rate = motion.whirl * spin;
        s.squeeze_rate = motion.squeeze * spin * epsilon;
        s.eccentricity_ratio = epsilon;
        const double angle = std::numbers::pi * std::fmod(0.7 * k, 2.0);
        const Vector2<double> r(std::cos(angle), std::sin(angle));
        const Vector2<double> e = s.clearance * epsilon * r;
        const Vector2<double> v =
            s.clearance * s.squeeze_rate * r + (s.attitude_rate + s.omega_bearing) * perpendicular(e);
        s.ex = e.x();
        s.ey = e.y();
        s.vx = v.x();
        s.vy = v.y();
        states.push_back(s);
      }
    }
  }
  std::erase_if(states, [&domain](const State& state) { return !holds(domain, state); });
  if (states.empty()) {
    throw std::invalid_argument("no state of a film of finite length has " + words(domain) +
                                "; allowed is a domain that holds one of them");
  }
  return states;
}

std::size_t FiniteVerification::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count(comparisons, outcome, &FiniteComparison::outcome));
}

double FiniteVerification::worst_error() const {
  double worst = 0;
  for (const FiniteComparison& c : comparisons) {
    if (c.outcome == Outcome::right || c.outcome == Outcome::wrong) worst = std::max(worst, c.error);
  }
  return worst;
}

FiniteVerification verify_finite_film(const FiniteClaim& claim, Quantities quantities, std::vector<State> states,
                                      Answers answers, double tolerance, unsigned threads, std::string domain) {
  FiniteVerification v;
  v.claim = claim;
  v.quantities = quantities;
  v.tolerance = tolerance > 0 ? tolerance : finite_tolerance;
  v.domain = std::move(domain);
  v.states = std::move(states);
  v.answers = std::move(answers);
  v.comparisons = comparisons_of(claim, v, threads);
  const std::size_t none = v.count(Outcome::not_a_number);
  const std::size_t judged = v.states.size() - v.count(Outcome::left_out);
  if (none == judged || v.count(Outcome::undecided) + none == judged) return v;
  if (all_right(v.comparisons)) {
    v.verdict = Verdict::agrees;
    return v;
  }
  if (none == 0 && v.count(Outcome::wrong) == 0) return v;  // most of them undecided
  v.verdict = Verdict::disagrees;
  v.suspicions = finite_suspicions(v);
  if (none == 0) {
    v.factor = common_factor(v);
    if (!v.factor && v.suspicions.empty()) find_other_films(v, threads);
  }
  v.terms = terms_of_finite(v);
  locate(v);
  constexpr double one_digit = 0.1;
  const bool explained = v.factor || !v.suspicions.empty() || !v.others.empty() || !v.laws.empty();
  if (none == 0 && !explained && v.worst_error() <= one_digit) v.verdict = Verdict::agrees_to_digits;
  if (v.verdict == Verdict::agrees_to_digits) v.right_where.clear();
  return v;
}

}  // namespace lubjoint::verify
