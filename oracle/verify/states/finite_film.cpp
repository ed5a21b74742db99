#include "oracle/verify/states/finite_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "oracle/files/parallel.hpp"

namespace lubjoint::verify {

namespace {

using oracle::FilmOnset;
using oracle::FiniteFilm;

constexpr std::array shapes = {0.25, 0.5, 1.0, 2.0};
constexpr std::array ratios = {0.1, 0.3, 0.5, 0.7, 0.9};

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

double error_asked_for(FiniteFilm film) { return film == FiniteFilm::finite_reynolds ? 3e-4 : 1e-6; }

/// ε, a and b of a state, and its radial direction; r is the velocity's at e = 0.
struct Place {
  PolarFilmState<double> film;
  Vector2<double> radial;
};

Place place_of(Quantities quantities, const State& s) {
  if (quantities == Quantities::polar) {
    const double a = s.eccentricity_ratio * (s.omega - 2 * s.attitude_rate);
    return {PolarFilmState<double>(s.eccentricity_ratio, a, s.squeeze_rate), {1, 0}};
  }
  const Vector2<double> e(s.ex / s.clearance, s.ey / s.clearance);
  const Vector2<double> v(s.vx / s.clearance, s.vy / s.clearance);
  const Vector2<double> r = direction(e);
  const double epsilon = norm(e);
  // Not through u: with v = 0 the squeeze is zero, and the onset may be pinned.
  const double a = epsilon * (s.omega_bearing + s.omega_journal) - 2 * dot(v, perpendicular(r));
  return {PolarFilmState<double>(epsilon, a, dot(v, r)), r};
}

/// The right answer, in the answer's components.
FiniteComparison expected_of(const FiniteClaim& claim, Quantities quantities, const State& s) {
  const Place place = place_of(quantities, s);
  const Bearing<double> bearing(s.length, s.radius, s.clearance);
  const double scale = force_scale(BearingLimit::long_bearing, bearing, Lubricant<double>(s.viscosity));
  const oracle::FiniteForce force = oracle::finite_force(
      claim.film, s.length / (2 * s.radius), place.film.in_own_frame(), {error_asked_for(claim.film), claim.onset});
  FiniteComparison comparison;
  comparison.expected = scale * (force.ratio.x() * place.radial + force.ratio.y() * perpendicular(place.radial));
  comparison.bound = force.relative_error();
  // On the half film's jump, at a = 0, rounding decides which side is meant.
  constexpr double rounding = 1e-9;
  const bool on_jump = std::abs(place.film.slip_rate) <= rounding * std::abs(place.film.squeeze_rate);
  if (claim.film == FiniteFilm::finite_half && on_jump) comparison.outcome = Outcome::left_out;
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
    list[i] = expected_of(claim, v.quantities, v.states[i]);
    compare(list[i], v.answers.values[i], 1, v.tolerance);
  });
  return list;
}

bool all_right(const std::vector<FiniteComparison>& list) {
  bool any = false;
  for (const FiniteComparison& c : list) {
    if (c.outcome == Outcome::wrong || c.outcome == Outcome::not_a_number) return false;
    any = any || c.outcome == Outcome::right;
  }
  return any;
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

std::string next_step(const FiniteVerification& v) {
  if (v.verdict == Verdict::agrees) return "Nothing: every state that the solver decides is right.";
  if (v.count(Outcome::not_a_number) > 0) {
    return "Why some answers are no numbers: run the program on one of the states by itself.";
  }
  if (v.factor) return fmt::format("All answers are {:.6g} times the right ones.", *v.factor);
  if (v.other) return "The answers are those of " + v.other->words() + ".";
  if (v.verdict == Verdict::agrees_to_digits) {
    return fmt::format("Right to {:.1g} of |F|: if it is meant to be numerical, say --tolerance {:.0e}.",
                       v.worst_error(), std::pow(10.0, std::ceil(std::log10(v.worst_error()))));
  }
  if (v.verdict == Verdict::undecided) return "The solver decides none of these states.";
  return "The worst state, step by step.";
}

std::size_t worst_state(const FiniteVerification& v) {
  const auto worst = std::ranges::max_element(v.comparisons, {}, &FiniteComparison::error);
  return static_cast<std::size_t>(worst - v.comparisons.begin());
}

std::string verdict_words(const FiniteVerification& v) {
  switch (v.verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::agrees_to_digits:
      return fmt::format("agrees to {:.1g} of |F|", v.worst_error());
    case Verdict::disagrees:
      return "disagrees";
    case Verdict::undecided:
      break;
  }
  return "could not be judged";
}

}  // namespace

std::string FiniteClaim::words() const {
  std::string text(oracle::name_of(film));
  if (film != FiniteFilm::finite_reynolds) return text;
  return text + (onset == FilmOnset::free ? ", free onset" : ", onset at the maximum film");
}

std::vector<State> finite_states(Quantities quantities) {
  const bool polar = quantities == Quantities::polar;
  if (!polar && quantities != Quantities::cartesian) {
    throw std::invalid_argument("--quantities " + std::string(name_of(quantities)) +
                                " is not judged for films of finite length; allowed are cartesian and polar");
  }
  std::vector<State> states;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const double epsilon : ratios) {
      for (const Motion& motion : motions) {
        State s;
        const double k = static_cast<double>(states.size());
        s.radius = 0.01 * (1 + static_cast<double>(i));
        s.length = 2 * s.radius * shapes[i];
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
                                      Answers answers, double tolerance, unsigned threads) {
  FiniteVerification v;
  v.claim = claim;
  v.quantities = quantities;
  v.tolerance = tolerance > 0 ? tolerance : finite_tolerance;
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
  v.verdict = Verdict::disagrees;
  if (none > 0) return v;
  v.factor = common_factor(v);
  if (v.factor) return v;
  for (const FiniteClaim& other : other_claims(claim)) {
    if (!all_right(comparisons_of(other, v, threads))) continue;
    v.other = other;
    return v;
  }
  constexpr double one_digit = 0.1;
  if (v.worst_error() <= one_digit) v.verdict = Verdict::agrees_to_digits;
  return v;
}

std::string text_report(const FiniteVerification& v) {
  const std::size_t failing = v.count(Outcome::wrong) + v.count(Outcome::not_a_number);
  std::string text = fmt::format("{}: {}, {} states, {} failing, {} undecided; right is an error of {:.0e} of |F|\n\n",
                                 verdict_words(v), v.claim.words(), v.states.size() - v.count(Outcome::left_out),
                                 failing, v.count(Outcome::undecided), v.tolerance);
  text += "L/D     states  failing  undecided  error, median  error, worst\n";
  for (const double shape : shapes) {
    std::vector<double> errors;
    std::size_t states = 0, wrong = 0, undecided = 0;
    for (std::size_t i = 0; i < v.states.size(); ++i) {
      if (std::abs(v.states[i].length / (2 * v.states[i].radius) - shape) > 1e-9) continue;
      const FiniteComparison& c = v.comparisons[i];
      if (c.outcome == Outcome::left_out) continue;
      ++states;
      undecided += c.outcome == Outcome::undecided ? 1 : 0;
      wrong += c.outcome == Outcome::wrong || c.outcome == Outcome::not_a_number ? 1 : 0;
      errors.push_back(c.error);
    }
    if (errors.empty()) continue;
    std::ranges::sort(errors);
    text += fmt::format("{:<8g}{:6d}{:9d}{:11d}{:15.1e}{:14.1e}\n", shape, states, wrong, undecided,
                        errors[errors.size() / 2], errors.back());
  }
  if (const std::size_t left_out = v.count(Outcome::left_out)) {
    text += fmt::format("{} states are left out: rounding decides on which side of the half film's jump they lie.\n",
                        left_out);
  }
  if (v.verdict != Verdict::agrees) {
    const std::size_t i = worst_state(v);
    const FiniteComparison& c = v.comparisons[i];
    text += "\nWorst state:\n" + state_header(v.quantities) + "\n" + state_row(v.quantities, v.states[i], i + 1) + "\n";
    for (std::size_t k = 0; k < 2; ++k) {
      text += fmt::format("  {:<11} expected {:<22.9g} received {:<22.9g} solver's bound {:.0e} of |F|\n",
                          answer_columns(v.quantities)[k], c.expected[static_cast<Eigen::Index>(k)],
                          v.answers.values[i][k], c.bound);
    }
  }
  return text + "\nNext: " + next_step(v) + "\n";
}

nlohmann::ordered_json json_report(const FiniteVerification& v) {
  constexpr std::array names = {"agrees", "agrees_to_digits", "disagrees", "undecided"};
  const double worst = v.worst_error();
  return {{"verdict", names[static_cast<std::size_t>(v.verdict)]},
          {"law", oracle::name_of(v.claim.film)},
          {"onset", v.claim.onset == FilmOnset::free ? "free" : "maximum_film"},
          {"digits", worst > 0 ? nlohmann::ordered_json(-std::log10(worst)) : nlohmann::ordered_json(nullptr)},
          {"tolerance", v.tolerance},
          {"states", v.states.size()},
          {"failing", v.count(Outcome::wrong) + v.count(Outcome::not_a_number)},
          {"undecided", v.count(Outcome::undecided)},
          {"left_out", v.count(Outcome::left_out)},
          {"factor", v.factor ? nlohmann::ordered_json(*v.factor) : nlohmann::ordered_json(nullptr)},
          {"other", v.other ? nlohmann::ordered_json(v.other->words()) : nlohmann::ordered_json(nullptr)},
          {"next", next_step(v)}};
}

}  // namespace lubjoint::verify
