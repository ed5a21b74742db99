#include "oracle/verify/terms/terms.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "oracle/verify/terms/factor.hpp"

namespace lubjoint::verify {

namespace {

using Number = TermNumber;

std::optional<MotionKind> kind_of(const Solution& s) {
  if (s.b == 0 && s.attitude_part == 0 && s.omega_bearing == 0 && s.a != 0) return MotionKind::wedge;
  // No spin at all: that two spins cancel is another question.
  const bool turns = s.spin_part != 0 || s.attitude_part != 0 || s.omega_bearing != 0;
  if (!turns && s.b != 0) return s.b > 0 ? MotionKind::closing : MotionKind::opening;
  if (s.a != 0 && s.b != 0) return MotionKind::mixed;
  return {};
}

/// A quantile of numbers; 0 the least.
double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

/// One number that a ratio may be a power of.
struct Base {
  const char* name;
  double (*value)(const Number&);
};
constexpr Base bases[] = {
    {"q", [](const Number& n) { return n.gap * (1 + n.ratio); }},
    {"eccentricity_ratio", [](const Number& n) { return n.ratio; }},
    {"two_plus_square", [](const Number& n) { return 2 + n.ratio * n.ratio; }},
    {"one_plus_two_squares", [](const Number& n) { return 1 + 2 * n.ratio * n.ratio; }},
    {"one_minus", [](const Number& n) { return n.gap; }},
    {"one_plus", [](const Number& n) { return 1 + n.ratio; }},
    {"length", [](const Number& n) { return n.state->length; }},
    {"radius", [](const Number& n) { return n.state->radius; }},
    {"clearance", [](const Number& n) { return n.state->clearance; }},
    {"viscosity", [](const Number& n) { return n.state->viscosity; }},
    {"bearing_radius", [](const Number& n) { return n.state->radius + n.state->clearance; }},
    {"rate", [](const Number& n) { return n.rate; }},
};
constexpr std::size_t base_count = std::size(bases);

/// log|ratio| = log(constant) + Σ exponent · log(base) with at most three bases, exponents in halves or thirds.
struct Fit {
  double constant;
  std::vector<std::pair<std::size_t, double>> exponents;
};

std::optional<Fit> fit(const std::vector<Number>& numbers, const std::vector<std::size_t>& chosen, double precision) {
  const auto rows = static_cast<Eigen::Index>(numbers.size());
  const auto columns = static_cast<Eigen::Index>(chosen.size()) + 1;
  if (rows < columns + 4) return {};
  Eigen::MatrixXd matrix(rows, columns);
  Eigen::VectorXd logarithms(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Number& n = numbers[static_cast<std::size_t>(i)];
    matrix(i, 0) = 1;
    for (Eigen::Index k = 1; k < columns; ++k)
      matrix(i, k) = std::log(bases[chosen[static_cast<std::size_t>(k - 1)]].value(n));
    logarithms[i] = std::log(std::abs(n.given / n.expected));
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(matrix);
  solver.setThreshold(1e-6);  // columns that are nearly multiples of each other say nothing about exponents
  if (solver.rank() < columns) return {};
  Eigen::VectorXd solution = solver.solve(logarithms);
  for (Eigen::Index k = 1; k < columns; ++k) {
    const double halves = std::round(2 * solution[k]) / 2;
    if (std::abs(solution[k] - halves) > std::max(1e-4, 20 * precision) || halves == 0 || std::abs(halves) > 4)
      return {};
    solution[k] = halves;
  }
  const Eigen::VectorXd rest = logarithms - matrix.rightCols(columns - 1) * solution.tail(columns - 1);
  const double constant = quantile({rest.begin(), rest.end()}, 0.5);
  std::vector<double> misses;
  for (const double x : rest) misses.push_back(std::abs(x - constant));
  if (quantile(misses, 0.95) > precision) return {};
  Fit result{std::exp(constant), {}};
  for (Eigen::Index k = 1; k < columns; ++k)
    result.exponents.emplace_back(chosen[static_cast<std::size_t>(k - 1)], solution[k]);
  return result;
}

/// The fit with fewest bases.
std::optional<Fit> best_fit(const std::vector<Number>& numbers, double precision) {
  for (std::size_t i = 0; i < base_count; ++i) {
    if (auto found = fit(numbers, {i}, precision)) return found;
  }
  for (std::size_t i = 0; i < base_count; ++i) {
    for (std::size_t j = i + 1; j < base_count; ++j) {
      if (auto found = fit(numbers, {i, j}, precision)) return found;
    }
  }
  for (std::size_t i = 0; i < base_count; ++i) {
    for (std::size_t j = i + 1; j < base_count; ++j) {
      for (std::size_t k = j + 1; k < base_count; ++k) {
        if (auto found = fit(numbers, {i, j, k}, precision)) return found;
      }
    }
  }
  return {};
}

/// Is the ratio the same wherever ε is?
bool depends_on_ratio_alone(std::vector<Number> numbers, double precision) {
  std::ranges::sort(numbers, {}, &Number::ratio);
  std::size_t pairs = 0, alike = 0;
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) {
    const Number &x = numbers[i], &y = numbers[i + 1];
    if (y.ratio - x.ratio > 1e-6 * y.gap) continue;
    ++pairs;
    if (std::abs(std::log(std::abs(x.given / x.expected)) - std::log(std::abs(y.given / y.expected))) <=
        precision + 1e-4)
      ++alike;
  }
  return pairs >= 4 && 10 * alike >= 9 * pairs;
}

const char* input_name(std::size_t base) {
  const std::string_view name = bases[base].name;
  return name == "length"           ? "L"
         : name == "radius"         ? "R"
         : name == "clearance"      ? "c"
         : name == "bearing_radius" ? "(R + c)"
         : name == "viscosity"      ? "viscosity"
         : name == "rate"           ? "rate"
                                    : nullptr;
}

/// "(R + c)/R", "pi L^2"; empty if a base is a function of ε.
std::string ratio_words(const Fit& fit, double sign, double precision) {
  std::string over, under;
  for (const auto& [base, exponent] : fit.exponents) {
    const char* name = input_name(base);
    if (name == nullptr) return "";
    std::string& side = exponent > 0 ? over : under;
    side += (side.empty() ? "" : " ") + std::string(name);
    if (std::abs(exponent) != 1) side += fmt::format("^{}", std::abs(exponent));
  }
  std::string constant = factor_words(sign * fit.constant, std::max(precision, 1e-9));
  if (constant.empty()) constant = fmt::format("{:.6g}", sign * fit.constant);
  if (constant == "1") constant = "";
  if (constant == "-1" && !over.empty()) constant = "-", over = constant + over, constant = "";
  std::string text = constant + (constant.empty() || over.empty() ? "" : " ") + over;
  if (text.empty()) text = "1";
  if (!under.empty())
    text += "/" + (under.find(' ') != std::string::npos && under[0] != '(' ? "(" + under + ")" : under);
  return text;
}

/// @param powers  are powers of ε and of the inputs looked for?
void judge_ratio(Term& term, const std::vector<Number>& all, double precision, bool powers) {
  // Thin films and the neighbourhood of the centre lose digits; they have their own lines elsewhere.
  std::vector<Number> numbers;
  double noise = 0;
  for (const Number& n : all) {
    if (std::abs(n.expected) < 0.01 * n.force || n.gap < 5e-4 || n.ratio < 5e-3) continue;
    numbers.push_back(n);
    noise = std::max(noise, 4 * n.tolerance / std::abs(n.expected));
  }
  if (numbers.size() < 5) return;
  const double tolerated = std::max({1e-9, noise, 5 * precision});
  std::vector<double> ratios, signs;
  for (const Number& n : numbers) {
    ratios.push_back(n.given / n.expected);
    signs.push_back(ratios.back() > 0 ? 1 : -1);
  }
  const double low = quantile(ratios, 0.02), middle = quantile(ratios, 0.5), high = quantile(ratios, 0.98);
  if (high - low <= tolerated * std::abs(middle)) {
    // A factor that is not told from one by its scatter is none.
    if (std::abs(middle - 1) <= 10 * tolerated) return;
    term.verdict = TermVerdict::factor;
    term.factor = middle;
    term.factor_text = factor_words(middle, std::max(tolerated, 1e-12));
    return;
  }
  const double sign = quantile(signs, 0.02) == quantile(signs, 0.98) ? signs.front() : 0;
  if (sign == 0 || std::ranges::any_of(ratios, [](double x) { return x == 0; })) return;
  constexpr double fewest_digits = 1e-3;  // below three digits too many powers fit
  const auto found = powers && precision <= fewest_digits ? best_fit(numbers, tolerated) : std::nullopt;
  if (found) {
    term.factor_text = ratio_words(*found, sign, tolerated);
    term.verdict = term.factor_text.empty() ? TermVerdict::function : TermVerdict::factor;
    for (const auto& [base, exponent] : found->exponents) term.exponents[bases[base].name] = exponent;
    if (term.verdict == TermVerdict::function) {
      term.factor = sign * found->constant;
      term.factor_text = factor_words(*term.factor, tolerated);
    }
    return;
  }
  // The error of a sum over angles, too, is a function of ε in steady states; but not such a large one in thick films.
  constexpr double of_a_rule = 0.03;
  std::vector<double> errors;
  for (const Number& n : numbers) {
    if (n.gap >= 0.1) errors.push_back(std::abs(n.given / n.expected - 1));
  }
  if (errors.size() >= 4 && quantile(errors, 0.5) > of_a_rule && depends_on_ratio_alone(numbers, tolerated)) {
    term.verdict = TermVerdict::function;
  }
}

Term judge_term_at(Component component, MotionKind kind, const std::vector<Number>& numbers, double precision,
                   bool powers) {
  Term term{component, kind};
  if (numbers.size() < 4) return term;
  std::vector<double> digits;
  bool all_zero = true, expected_zero = true;
  std::size_t right = 0;
  for (const Number& n : numbers) {
    if (n.error() <= std::max(n.tolerance, precision * n.force)) ++right;
    digits.push_back(n.error() > 0 ? std::min(17.0, -std::log10(n.error() / n.force)) : 17);
    if (std::abs(n.expected) > 1e-3 * n.force) {
      expected_zero = false;
      if (std::abs(n.given) > 1e-6 * std::abs(n.expected)) all_zero = false;
    }
  }
  term.digits = std::max(0.0, quantile(digits, 0.05));
  if (20 * right >= 19 * numbers.size()) {
    term.verdict = TermVerdict::right;
    term.vanishes = expected_zero;
    return term;
  }
  term.verdict = TermVerdict::wrong;
  if (!expected_zero && all_zero) {
    term.verdict = TermVerdict::absent;
    term.factor = 0;
  } else if (!expected_zero) {
    judge_ratio(term, numbers, precision, powers);
  }
  return term;
}

/// A mixed term that is wrong in one of its parts: what is left of the answer without the other, right part.
std::optional<Term> judge_part(const Term& whole, const std::vector<Number>& numbers, double Number::*part,
                               double Number::*other, const char* name) {
  std::vector<Number> left;
  for (const Number& n : numbers) {
    // Where the part is small, subtraction leaves nothing of it.
    if (std::abs(n.*part) < 0.01 * std::abs(n.*other) || n.*part == 0) continue;
    Number rest = n;
    rest.given -= n.*other;
    rest.expected = n.*part;
    rest.tolerance *= 1 + std::abs(n.*other / (n.*part));
    left.push_back(rest);
  }
  if (left.size() < 8) return {};
  Term term{whole.component, whole.states};
  term.part = name;
  term.digits = whole.digits;
  const auto is_absent = [](const Number& n) { return std::abs(n.given) <= n.tolerance + 1e-6 * std::abs(n.expected); };
  if (std::ranges::all_of(left, is_absent)) {
    term.verdict = TermVerdict::absent;
    term.factor = 0;
    return term;
  }
  judge_ratio(term, left, 0, true);
  if (term.verdict == TermVerdict::factor || term.verdict == TermVerdict::function) return term;
  return {};
}

/// At the precision that the program has there: a numerical program's terms are right to some digits.
Term judge_term(Component component, MotionKind kind, const std::vector<Number>& numbers, bool powers) {
  Term term;
  for (const double precision : {0.0, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    term = judge_term_at(component, kind, numbers, precision, powers);
    term.precision = precision;
    if (term.verdict != TermVerdict::wrong) break;
  }
  if (term.verdict != TermVerdict::wrong || kind != MotionKind::mixed) return term;
  if (auto squeeze = judge_part(term, numbers, &Number::squeeze, &Number::wedge, "squeeze")) return *squeeze;
  if (auto wedge = judge_part(term, numbers, &Number::wedge, &Number::squeeze, "wedge")) return *wedge;
  return term;
}

}  // namespace

std::string Term::words() const {
  if (!part.empty()) {
    Term alone = *this;
    alone.part.clear();
    return "right but for the part of the " + part + ", which is " + alone.words();
  }
  switch (verdict) {
    case TermVerdict::right:
      return precision == 0 ? "right" : fmt::format("right, to {:.0f} digits", std::floor(digits));
    case TermVerdict::absent:
      return "absent";
    case TermVerdict::factor:
      if (!factor_text.empty() && factor)
        return fmt::format("{} times what it should be ({:.10g})", factor_text, *factor);
      if (!factor_text.empty()) return factor_text + " times what it should be";
      return fmt::format("{:.10g} times what it should be", factor.value_or(0));
    case TermVerdict::function: {
      if (exponents.empty()) return "off by a function of the eccentricity alone";
      std::string text = "off by the factor";
      if (factor && std::abs(*factor - 1) > 1e-6)
        text += " " + (factor_text.empty() ? fmt::format("{:.6g}", *factor) : factor_text);
      static const std::map<std::string, std::string> written = {{"q", "(1 - e^2)"},
                                                                 {"eccentricity_ratio", "e"},
                                                                 {"two_plus_square", "(2 + e^2)"},
                                                                 {"one_minus", "(1 - e)"},
                                                                 {"one_plus_two_squares", "(1 + 2e^2)"},
                                                                 {"one_plus", "(1 + e)"},
                                                                 {"length", "L"},
                                                                 {"radius", "R"},
                                                                 {"clearance", "c"},
                                                                 {"bearing_radius", "(R + c)"}};
      for (const auto& [name, exponent] : exponents) {
        text += " " + (written.contains(name) ? written.at(name) : name) +
                (exponent == 1 ? "" : fmt::format("^{}", exponent));
      }
      return text + ", e the eccentricity ratio";
    }
    case TermVerdict::wrong:
      return "wrong, by no factor and no function of the eccentricity alone";
    case TermVerdict::undecided:
      break;
  }
  return "-";
}

std::vector<Term> terms_of(const Judgement& judgement, const std::vector<State>& states, const Answers& answers) {
  const Quantities q = judgement.quantities;
  if (!is_film_force(q)) return {};
  TermNumbers numbers;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Comparison& c = judgement.comparisons[i];
    if (c.left_out() || c.outcome == Outcome::not_a_number || judgement.references[i].size[0] == 0) continue;
    const Solution s = solve(q, judgement.law, states[i]);
    const std::optional<MotionKind> kind = kind_of(s);
    if (!kind) continue;
    const Reference& reference = judgement.references[i];
    const double tolerance =
        std::hypot(judgement.precision.tolerance(reference, 0), judgement.precision.tolerance(reference, 1));
    const Plane given(answers.values[i][0], answers.values[i][1]),
        expected(reference.expected[0], reference.expected[1]);
    const bool polar = is_polar(q);
    const Plane r = polar ? Plane(1, 0) : s.r, t = polar ? Plane(0, 1) : s.t;
    if (c.outcome == Outcome::undecided && tolerance > coarsest_tolerance * reference.size[0]) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const Plane& axis = k == 0 ? r : t;
      // A half film's tangential force jumps at a = 0.
      if (k == 1 && is_half(judgement.law) && *kind != MotionKind::wedge && *kind != MotionKind::mixed) continue;
      numbers[k][static_cast<std::size_t>(*kind)].push_back(
          {static_cast<double>(dot(given, axis)), static_cast<double>(dot(expected, axis)), tolerance,
           reference.size[0], &states[i], static_cast<double>(s.ratio), static_cast<double>(s.ratio_gap),
           static_cast<double>(std::abs(s.a) + std::abs(s.b)),
           static_cast<double>(s.scale * (k == 0 ? s.radial_wedge : s.tangential_wedge)),
           static_cast<double>(s.scale * (k == 0 ? s.radial_squeeze : s.tangential_squeeze))});
    }
  }
  return terms_of(numbers, true);
}

std::vector<Term> terms_of(const TermNumbers& numbers, bool powers) {
  std::vector<Term> terms;
  for (const Component component : {Component::radial, Component::tangential}) {
    for (const MotionKind kind : {MotionKind::wedge, MotionKind::closing, MotionKind::opening, MotionKind::mixed}) {
      terms.push_back(judge_term(component, kind,
                                 numbers[static_cast<std::size_t>(component)][static_cast<std::size_t>(kind)], powers));
    }
  }
  return terms;
}

}  // namespace lubjoint::verify
