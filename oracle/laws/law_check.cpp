#include "oracle/laws/law_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::reports {

namespace {

constexpr double two_pi = boost::math::constants::two_pi<double>();
constexpr double smallest_gap = 1e-6;
// Rounding: the quadrature keeps 5e-15 of the film's terms, a law some ten ε_mach of them, and the terms of a half film
// that nearly cancel may be ten times their sum.
constexpr double allowed_difference = 1e-13;

std::vector<PolarFilmState<double>> random_states(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  // Canonical doubles, so that all machines draw the same.
  const auto unit = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<PolarFilmState<double>> states;
  for (std::size_t i = 0; i < count; ++i) {
    const double where = unit();
    const double epsilon = i % 2 ? 1 - std::pow(smallest_gap, where) : where * (1 - smallest_gap);
    const double direction = two_pi * unit();
    const double speed = std::pow(10.0, 6 * unit() - 3);
    states.emplace_back(epsilon, -2 * speed * std::sin(direction), speed * std::cos(direction));
  }
  return states;
}

template <FilmLaw Law>
LawCheck::Quadrature against_quadrature(const oracle::OneDimensionalFilm film,
                                        const std::vector<PolarFilmState<double>>& states) {
  const Bearing<double> bearing(0.04, 0.0098, 0.0002);  // ratios of forces do not depend on it
  const Lubricant<double> oil(0.4);
  LawCheck::Quadrature result;
  std::vector<double> differences;
  for (const PolarFilmState<double>& state : states) {
    const PolarForce<double> law = film_force<Law>(bearing, oil, state);
    const auto integral = oracle::film_force_by_quadrature(film, bearing, oil, state);
    const double size = std::hypot(integral.radial.value, integral.tangential.value);
    const double difference =
        std::hypot(law.radial - integral.radial.value, law.tangential - integral.tangential.value) / size;
    differences.push_back(difference);
    if (difference > result.largest || std::isnan(difference)) {
      result.largest = difference;
      result.eccentricity_ratio_of_largest = state.eccentricity_ratio;
    }
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  result.median = *middle;
  return result;
}

}  // namespace

Verdict LawCheck::verdict() const {
  const char* of_pressure = "force, by quadrature";
  const char* reason =
      "rounding: the quadrature keeps 5e-15 of the film's terms, a law some ten roundings of them, and terms of a half "
      "film that nearly cancel may be ten times their sum";
  Verdict made;
  made.checks.push_back(quadrature
                            ? Check::at_most(of_pressure, "quadrature of the pressure that the law claims to integrate",
                                             quadrature->largest, allowed, "|F|", reason)
                            : Check::not_checked(of_pressure, "the law is the integral of no pressure"));
  made.checks.push_back(Check::at_most("force, by formula", "the published formula in 100 digits", rounding, allowed,
                                       "|F|", "rounding of the law, as above"));
  return made;
}

bool LawChecks::passed() const {
  return std::all_of(laws.begin(), laws.end(), [](const LawCheck& law) { return law.agrees(); });
}

LawChecks check_laws(const LawCheckSettings& settings) {
  LawChecks checks{settings, {}, measure_accuracy(settings.directions, settings.seed), {}, {}};
  const auto states = random_states(std::max<std::size_t>(settings.states, 2), settings.seed);
  for_each_film_law([&]<class Law>() {
    LawCheck check;
    check.law = Law::name;
    check.states = states.size();
    check.allowed = allowed_difference;
    for (const oracle::OneDimensionalFilmEntry& entry : oracle::one_dimensional_films) {
      if (entry.name == Law::name) check.quadrature = against_quadrature<Law>(entry.film, states);
    }
    check.rounding = worst_of_force(checks.rounding, check.law, 0.99 * smallest_gap);
    checks.laws.push_back(std::move(check));
  });
  const auto differences = pinkus_sternlicht_difference(DifferenceGrid::uniform(0.97, 48, 72));
  checks.closing = summary_of(differences, SqueezeSign::closing);
  checks.opening = summary_of(differences, SqueezeSign::opening);
  return checks;
}

std::string law_check_table(const LawChecks& checks) {
  std::string text = fmt::format(
      "Force laws against the quadrature of their pressure ({} states, e/c up to 1 - 1e-6) and their published "
      "formulas in 100 digits\n\n{:<18} {:>10} {:>10} {:>14} {:>10}  {}\n",
      checks.laws.empty() ? 0 : checks.laws.front().states, "difference over |F|", "median", "largest", "at 1 - e/c",
      "100 digits", "agreement");
  for (const LawCheck& law : checks.laws) {
    const std::string integral =
        law.quadrature ? fmt::format("{:>10.1e} {:>10.1e} {:>14.1e}", law.quadrature->median, law.quadrature->largest,
                                     1 - law.quadrature->eccentricity_ratio_of_largest)
                       : fmt::format("{:>36}", "integral of no pressure");
    text += fmt::format("{:<19} {} {:>10.1e}  {}\n", law.law, integral, law.rounding, law.verdict().in_letters());
  }
  std::vector<Verdict> verdicts;
  std::vector<const Verdict*> pointers;
  for (const LawCheck& law : checks.laws) verdicts.push_back(law.verdict());
  for (const Verdict& verdict : verdicts) pointers.push_back(&verdict);
  return text + "\nagreement: a letter for each check that passed, a dash for each that was not made.\n" +
         check_legend(pointers) +
         fmt::format(
             "\npinkus_sternlicht approximates long_dynamic: while the film closes it is {:.1f} % off in the "
             "median and at most {:.0f} %;\nwhile it opens {:.1f} % and {:.0f} % (e/c up to 0.97).\n",
             100 * checks.closing.median, 100 * checks.closing.largest, 100 * checks.opening.median,
             100 * checks.opening.largest);
}

}  // namespace lubjoint::reports
