#include "oracle/verify/states/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/verify/states/conditioning.hpp"
#include "oracle/verify/states/losses_oracle.hpp"
#include "oracle/verify/states/solved_films.hpp"
#include "oracle/verify/states/steady_slopes.hpp"

namespace lubjoint::verify {

namespace {

constexpr double double_roundoff = 0x1p-53;
constexpr double single_roundoff = 0x1p-24;
constexpr double largest_in_single = 1e18;  // its square is still a number of single precision

/// Σ|terms| of the slip rate a [1/s]: what its rounding is proportional to.
Real slip_terms(const Solution& s) {
  if (is_polar(s.quantities)) return std::abs(s.spin_part) + std::abs(s.attitude_part);
  const Real across = std::abs(s.v.x() * s.r.y()) + std::abs(s.v.y() * s.r.x());
  return s.ratio * (std::abs(s.omega_bearing) + std::abs(s.omega_journal)) + 2 * across / s.film_clearance;
}

/// Zero in any order of operations: at the centre, or without spin, e and v along x. In other directions a program that
/// works with angles gets what the cosine of a right angle is in its arithmetic.
bool slip_rate_is_exactly_zero(const Solution& s) {
  if (is_polar(s.quantities)) return s.spin_part == 0 && s.attitude_part == 0;
  if (is_zero(s.e)) return true;
  return s.omega_bearing + s.omega_journal == 0 && s.e.y() == 0 && s.v.y() == 0 && s.e.x() > 0;
}

/// Sizes of a state's numbers, and how far it is from a jump of the law.
void note_limits(Quantities quantities, const Solution& solution, const State& state, Reference& reference) {
  const auto see = [&](double number) {
    if (number == 0) return;
    reference.smallest = std::min(reference.smallest, std::abs(number));
    reference.largest = std::max(reference.largest, std::abs(number));
  };
  for (const StateColumn& column : state_columns(quantities)) see(state.*column.value);
  for (std::size_t k = 0; k < answer_columns(quantities).size(); ++k) {
    if (!std::isnan(reference.expected[k])) see(static_cast<double>(reference.expected[k]));
  }
  if (is_of_load(quantities)) return;
  if (quantities == Quantities::contact) {  // no film: neither thin nor near the centre
    reference.ratio = 0.5;
    return;
  }
  reference.ratio = static_cast<double>(solution.ratio);
  if (solution.of_dry < 1) reference.gap = static_cast<double>(solution.ratio_gap);
  // A half film jumps to the other side; its force only where there is squeeze.
  const bool jumps = is_half(solution.law) && (quantities == Quantities::extent || solution.b != 0);
  if (!jumps || slip_rate_is_exactly_zero(solution)) return;
  const Real terms = slip_terms(solution);
  reference.jump_margin = terms > 0 ? static_cast<double>(std::abs(solution.a) / terms) : 0;
}

/// ε and, of coefficients, K and C by quadrature of the pressure and its derivatives.
Solution rest_by_quadrature(const Solution& published) {
  Solution s = published;
  const RestPlace place =
      place_under_load([&](Real ratio, Real gap) { return slopes_by_quadrature(s.law, ratio, gap); },
                       s.rest.load / (s.scale * std::abs(s.rest.spin)), std::log(s.ratio / s.ratio_gap));
  s.ratio = place.ratio;
  s.ratio_gap = place.gap;
  s.rest.slopes = slopes_by_quadrature(s.law, s.ratio, s.ratio_gap);
  find_polar_coefficients(s);
  find_inertial_coefficients(s);
  s.answer = {s.ratio, s.rest.attitude};
  if (s.quantities == Quantities::coefficients) {
    std::ranges::copy(s.rest.stiffness, s.answer.begin() + 2);
    std::ranges::copy(s.rest.damping, s.answer.begin() + 6);
  }
  return s;
}

/// What the solver's error does to place and slopes: a force that is off moves ε as a load that is off does.
void add_solver_error(const Solution& s, Reference& result) {
  const RestErrors errors = s.films->errors_at_rest(s.law, s.shape, s.ratio);
  const auto elasticity = static_cast<double>(s.rest.slopes.size_by_ratio() / s.rest.slopes.size());  // d ln|F|/dε
  result.error[0] += errors.force / elasticity;
  result.error[1] += errors.force * result.size[1];
  for (std::size_t k = 2; k < most_answers; ++k) {
    result.error[k] += (k < 6 ? errors.stiffness : errors.damping) * result.size[k];
  }
}

/// What the columns of a table should be, and their sizes: of a number itself, an angle's is a right one, a matrix has
/// one size, and a sum that of its terms.
Reference table_reference(Quantities quantities, Law law, const State& state) {
  const Solution published = solve(quantities, law, state);
  Reference result{.expected = {}, .sensitivity = {}, .published = {}, .size = {}, .regime = Regime::moderate};
  if (is_of_load(quantities)) {
    const Solution s = is_solved_film(law) ? published : rest_by_quadrature(published);
    result.expected = s.answer;
    const auto size_of = [](const Entries& m) {
      return static_cast<double>(std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3]));
    };
    result.size = {static_cast<double>(s.ratio), static_cast<double>(pi<Real>() / 2)};
    std::fill_n(result.size.begin() + 2, 4, size_of(s.rest.stiffness));
    std::fill_n(result.size.begin() + 6, 4, size_of(s.rest.damping));
    result.regime = regime_at_rest(s.ratio, state.omega);
    result.ratio = static_cast<double>(s.ratio);
    result.gap = static_cast<double>(s.ratio_gap);
  } else {
    const auto expected = losses_by_quadrature(published);
    const auto sizes = size_of_costs(published);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      result.expected[k] = expected[k];
      result.size[k] = static_cast<double>(sizes[k]);
    }
    result.error = losses_quadrature_error(published);
    result.regime = regime_of(quantities, state);
  }
  const auto inputs = input_conditioning(state, published);
  for (std::size_t k = 0; k < answer_columns(quantities).size(); ++k) {
    result.sensitivity[k] = 8 * inputs[k] + 32 * result.size[k];
    // The sums are good to 1e-17 over 1 − ε, and move an answer as its own rounding and that of an input do.
    if (is_of_load(quantities)) result.error[k] = 1e-17 / result.gap * (inputs[k] + result.size[k]);
  }
  if (is_of_load(quantities) && is_solved_film(law)) add_solver_error(published, result);
  return result;
}

/// Of what a solver says of the film: of a pressure, over that film's largest; else of the film's share of a force [N].
double solver_error(const Solution& s) {
  if (s.quantities == Quantities::pressure) return s.pressure_error * static_cast<double>(s.pressure_terms);
  return s.moving.error * static_cast<double>((1 - s.of_dry) * std::hypot(s.radial, s.tangential));
}

/// Certified numbers stand above ours.
void use_golden(const State& state, Law law, Reference& result) {
  if (!state.golden) return;
  const auto& row = state.golden->row[law.place];
  if (!row) return;
  result.golden = &*row;
  result.expected = row->answer;
  result.error = {};
}

Reference reference(Quantities quantities, Law law, const State& state) {
  const std::size_t columns = answer_columns(quantities).size();
  const Solution solution = solve(quantities, law, state);
  if (is_table(quantities)) {
    Reference result = table_reference(quantities, law, state);
    use_golden(state, law, result);
    note_limits(quantities, solution, state, result);
    return result;
  }
  Reference result{.expected = solution.answer,
                   .sensitivity = {},
                   .published = {},
                   .size = {},
                   .regime = regime_of(quantities, state)};
  use_golden(state, law, result);
  note_limits(quantities, solution, state, result);
  const auto inputs = input_conditioning(state, solution);
  const double force = std::hypot(static_cast<double>(solution.answer[0]), static_cast<double>(solution.answer[1]));
  const double terms = static_cast<double>(size_of_terms(solution));
  for (std::size_t k = 0; k < columns; ++k) {
    const double arm = quantities != Quantities::wrench || k < 2 ? 1
                       : k == 2 ? std::hypot(state.sx_i, state.sy_i) + std::hypot(state.ex, state.ey)
                                : std::hypot(state.sx_j, state.sy_j);
    result.size[k] = arm * (quantities == Quantities::pressure ? terms : force);
    result.sensitivity[k] = 8 * inputs[k] + 32 * result.size[k];
    result.published[k] = 16 * arm * terms;
    if (is_solved_film(law)) result.error[k] = arm * solver_error(solution);
  }
  return result;
}

bool none_is_wrong(const std::vector<Comparison>& comparisons) {
  return std::ranges::none_of(comparisons, [](const Comparison& c) { return c.outcome == Outcome::wrong; });
}

/// One number's error against what rounding explains.
struct NumberOutcome {
  Outcome outcome;
  double excess;
  double digits;
};

NumberOutcome compare_number(const Reference& reference, std::size_t k, double given, const Precision& precision,
                             double accepted) {
  const double size = reference.size[k];
  const auto error = static_cast<double>(std::abs(given - reference.expected[k]));
  const double rounding = precision.tolerance(reference, k);
  const double tolerance = std::max(rounding, accepted * size);
  NumberOutcome result{Outcome::right, 0, 17};
  if (error > 0) {
    result.excess = tolerance > 0 ? error / tolerance : std::numeric_limits<double>::max();
    // No digits are counted beyond those that the reference is good to.
    const double known = std::max(error, reference.error[k]);
    const double least = error > reference.error[k] ? 0 : 17;
    result.digits = size > 0 ? std::clamp(-std::log10(known / size), 0.0, 17.0) + 0.0 : least;
  }
  const bool coarse = size > 0 && rounding > std::max(coarsest_tolerance, accepted) * size;
  if (error <= tolerance) {
    if (coarse) result.outcome = Outcome::undecided;
  } else {
    const double published = precision.roundoff * reference.published[k];
    result.outcome = error <= tolerance + published ? Outcome::undecided : Outcome::wrong;
  }
  return result;
}

/// Large where the answer is off by much of |F| at a state of ordinary numbers; numbers before NaN.
double how_much_it_shows(const Reference& reference, const Comparison& c) {
  if (c.outcome == Outcome::not_a_number) return 0;
  const double ordinary =
      1 / (1 + std::abs(std::log10(reference.gap)) + std::log10(reference.largest / reference.smallest) / 64);
  return (reference.regime == Regime::near_concentric ? 0.5 : 1) * ordinary + 100 / (1 + c.digits * c.digits);
}

/// A rule of integration makes the same relative error wherever ε and the direction of the rates are the same, whatever
/// the bearing; rounding does not. Steady rotation in a resting bearing, of the designed ratios of ε, shows it.
bool errs_alike(Quantities quantities, const std::vector<Reference>& references, const std::vector<State>& states,
                const Answers& answers) {
  struct Error {
    double ratio, along, across;
  };
  std::vector<Error> errors;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Reference& r = references[i];
    if (r.gap < 0.02 || r.ratio < 0.05 || r.size[0] == 0) continue;
    const Solution s = solve(quantities, "short_full"_law, states[i]);
    if (!(s.a > 0) || s.b != 0 || s.attitude_part != 0) continue;
    const double x = answers.values[i][0], y = answers.values[i][1];
    const auto fx = static_cast<double>(r.expected[0]), fy = static_cast<double>(r.expected[1]);
    const double squared = r.size[0] * r.size[0];
    errors.push_back({r.ratio, (x * fx + y * fy) / squared - 1, (y * fx - x * fy) / squared});
  }
  std::ranges::sort(errors, {}, &Error::ratio);
  std::size_t pairs = 0, alike = 0;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    const Error &p = errors[i], &q = errors[i + 1];
    const double size = std::hypot(p.along, p.across);
    if (q.ratio - p.ratio > 1e-6 || size == 0) continue;
    ++pairs;
    if (std::hypot(p.along - q.along, p.across - q.across) < 0.1 * size) ++alike;
  }
  return pairs >= 4 && 2 * alike > pairs;
}

/// What single precision leaves behind: errors of both signs, of the size of its rounding.
bool looks_like_single(const std::vector<Reference>& references, const Answers& answers,
                       const std::vector<Comparison>& at_double) {
  std::size_t moving = 0, failing = 0, larger = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (references[i].size[0] == 0 || at_double[i].left_out()) continue;
    ++moving;
    if (at_double[i].outcome != Outcome::wrong) continue;
    ++failing;
    Real along = 0, error = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Real off = answers.values[i][k] - references[i].expected[k];
      along += off * references[i].expected[k];
      error = std::max(error, std::abs(off));
    }
    if (along > 0) ++larger;
    errors.push_back(static_cast<double>(error) / references[i].size[0]);
  }
  if (5 * failing < 3 * moving) return false;
  // Of some hundred signs at random, less than a fifth or more than four fifths are alike by chance once in 1e10.
  if (5 * larger < failing || 5 * larger > 4 * failing) return false;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::ranges::nth_element(errors, middle);
  return *middle > single_roundoff / 8;  // a handful of roundings, each half of that on average
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
  return roundoff * reference.sensitivity[k] + 1.01 * text.relative * value + 1.01 * text.absolute + reference.error[k];
}

bool Precision::decides(const Reference& reference) const {
  const double largest = roundoff == single_roundoff ? largest_in_single : largest_in_double;
  // Answers are products of inputs: they may be larger.
  if (reference.smallest < 1 / largest || reference.largest > largest * largest) return false;
  if (reference.jump_margin <= 16 * roundoff) return false;  // roundings of a few operations
  return reference.gap > 64 * roundoff;  // 1/64 of 1 − ε, and more of the force, is lost in the input's rounding
}

Outcome number_outcome(const Reference& reference, std::size_t column, double given, const Precision& precision,
                       double accepted) {
  if (std::isnan(given)) return Outcome::not_a_number;
  return compare_number(reference, column, given, precision, accepted).outcome;
}

std::vector<Comparison> compare(const std::vector<Reference>& references, const Answers& answers,
                                const std::vector<std::size_t>& columns, const Precision& precision, double accepted) {
  std::vector<Comparison> list;
  list.reserve(references.size());
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (!precision.decides(references[i])) {
      list.push_back({Outcome::left_out, 0, 17});
      continue;
    }
    Comparison c{Outcome::right, 0, 17};
    for (const std::size_t k : columns) {
      const double given = answers.values[i][k];
      if (std::isnan(given)) {
        c = {Outcome::not_a_number, std::numeric_limits<double>::infinity(), 0};
        break;
      }
      const NumberOutcome number = compare_number(references[i], k, given, precision, accepted);
      c.outcome = std::max(c.outcome, number.outcome);
      c.excess = std::max(c.excess, number.excess);
      c.digits = std::min(c.digits, number.digits);
    }
    list.push_back(c);
  }
  return list;
}

Precision measured_precision(Quantities quantities, const std::vector<Reference>& references,
                             const std::vector<State>& states, const Answers& answers,
                             const std::vector<std::size_t>& columns) {
  const Precision in_double{double_roundoff, answers.text};
  const Precision in_single{single_roundoff, answers.text};
  if (answers.text.all_single) return in_single;
  const auto at_double = compare(references, answers, columns, in_double);
  if (none_is_wrong(at_double) || !none_is_wrong(compare(references, answers, columns, in_single))) return in_double;
  if (answers.text.digits <= 9) return in_single;
  if (is_table(quantities)) return in_double;  // differences in place of derivatives err like that, too
  if (errs_alike(quantities, references, states, answers)) return in_double;
  return looks_like_single(references, answers, at_double) ? in_single : in_double;
}

void summarise(Judgement& judgement) {
  judgement.failing.clear();
  judgement.left_out = judgement.undecided = judgement.not_numbers = 0;
  judgement.worst.reset();
  std::array<std::vector<double>, regime_names.size()> digits;
  std::array<RegimeResult, regime_names.size()> results{};
  double shows = -1;
  for (std::size_t i = 0; i < judgement.comparisons.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.left_out()) {
      ++judgement.left_out;
      continue;
    }
    const auto regime = static_cast<std::size_t>(judgement.references[i].regime);
    RegimeResult& result = results[regime];
    result.regime = judgement.references[i].regime;
    ++result.states;
    if (c.outcome == Outcome::undecided) {
      ++result.undecided;
      ++judgement.undecided;
      continue;
    }
    result.worst_digits = std::min(result.worst_digits, c.digits);
    digits[regime].push_back(c.digits);
    if (!c.fails()) continue;
    ++result.failing;
    judgement.failing.push_back(i);
    if (c.outcome == Outcome::not_a_number) ++judgement.not_numbers;
    const double here = how_much_it_shows(judgement.references[i], c);
    if (here <= shows) continue;
    shows = here;
    judgement.worst = i;
  }
  judgement.regimes.clear();
  for (std::size_t r = 0; r < results.size(); ++r) {
    if (results[r].states == 0) continue;
    if (!digits[r].empty()) {
      const auto middle = digits[r].begin() + static_cast<std::ptrdiff_t>(digits[r].size() / 2);
      std::ranges::nth_element(digits[r], middle);
      results[r].median_digits = *middle;
    }
    judgement.regimes.push_back(results[r]);
  }
}

double tolerance_of(const Judgement& judgement, std::size_t i, std::size_t k) {
  const Reference& reference = judgement.references[i];
  return std::max(judgement.precision.tolerance(reference, k), judgement.accepted * reference.size[k]);
}

void judge_at(Judgement& judgement, const Answers& answers, const Precision& precision) {
  judgement.precision = precision;
  judgement.comparisons = compare(judgement.references, answers, judgement.columns, precision, judgement.accepted);
  summarise(judgement);
}

std::vector<std::size_t> judged_columns(Quantities quantities, Law law, const Answers& answers) {
  std::vector<std::size_t> columns = answers.columns;
  if (quantities != Quantities::losses || loses_oil_by_its_sides(law)) return columns;
  std::erase_if(columns, [](std::size_t k) { return answer_columns(Quantities::losses)[k] == "side_flow"; });
  if (columns.empty()) {
    throw UnjudgedError("side_flow alone is given, and " + std::string(name_of(law)) +
                        " has none: no oil leaves a long bearing at its sides; expected are torques or power");
  }
  return columns;
}

Judgement judge(Quantities quantities, Law law, const std::vector<State>& states, const Answers& answers,
                double accepted) {
  Judgement judgement;
  judgement.quantities = quantities;
  judgement.law = law;
  judgement.columns = judged_columns(quantities, law, answers);
  judgement.references = references(quantities, law, states);
  judgement.accepted = accepted;
  judge_at(judgement, answers,
           measured_precision(quantities, judgement.references, states, answers, judgement.columns));
  return judgement;
}

}  // namespace lubjoint::verify
