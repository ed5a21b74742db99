#include "oracle/laws/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "lubjoint/film/every_law.hpp"
#include "oracle/laws/published_forms.hpp"

namespace lubjoint::reports {

namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;  // the dynamic forms lose 45 digits at 1 − ε = 1e-12

/// One unit in the last place, taken as the machine epsilon times the value: the same for all values of a binade's
/// length, and never above the spacing of doubles there.
double ulp(double value) { return std::max(0x1p-52 * std::abs(value), 0x1p-1074); }

std::vector<double> ratios() {
  std::vector<double> all;
  for (int exponent = -300; exponent < -20; exponent += 40) all.push_back(std::pow(10.0, exponent));
  for (int exponent = -20; exponent < -1; exponent += 2) all.push_back(std::pow(10.0, exponent));
  for (int i = 1; i < 20; ++i) all.push_back(0.05 * i);
  double gap = 2e-2;
  while (gap > 0.9e-12) {
    all.push_back(1 - gap);
    gap /= std::sqrt(10.0);
  }
  all.push_back(1 - 1e-12);
  return all;
}

std::vector<std::array<double, 2>> motions(std::size_t random, std::uint64_t seed) {
  std::vector<std::array<double, 2>> all = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
  std::mt19937_64 generator(seed);
  // Directions uniform, magnitudes over six decades; canonical doubles, so that all machines draw the same.
  const auto unit = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i < random; ++i) {
    const double angle = 6.283185307179586 * unit();
    const double size = std::pow(10.0, 6 * unit() - 3);
    all.push_back({2 * size * std::cos(angle), size * std::sin(angle)});
  }
  return all;
}

Exact total(const std::vector<Exact>& terms) {
  Exact sum = 0;
  for (const Exact& term : terms) sum += term;
  return sum;
}

Exact magnitude(const std::vector<Exact>& terms) {
  Exact sum = 0;
  for (const Exact& term : terms) sum += abs(term);
  return sum;
}

template <FilmLaw Law>
AccuracyRow measure(double epsilon, const std::vector<std::array<double, 2>>& directions) {
  constexpr bool dynamic = Law::name.ends_with("dynamic");
  const Bearing<double> bearing(0.04, 0.0098, 0.0002);
  const Lubricant<double> oil(0.4);
  const Exact c(bearing.clearance());
  const Exact l(bearing.length());
  const Exact r(bearing.radius());
  const bool is_short = Law::limit == BearingLimit::short_bearing;
  const Exact scale =
      is_short ? Exact(oil.viscosity() * r * l * l * l / (c * c)) : Exact(oil.viscosity() * l * r * r * r / (c * c));
  AccuracyRow row{std::string(Law::name), epsilon, 1 - epsilon, 0, 0, 0};
  double squares = 0;
  for (const auto& [a, b] : directions) {
    const PolarForce<double> force = film_force<Law>(bearing, oil, PolarFilmState<double>(epsilon, a, b));
    const PublishedTerms<Exact> terms = published_terms<Exact>(Law::name, Exact(epsilon), Exact(a), Exact(b));
    const Exact radial = scale * total(terms.radial);
    const Exact tangential = scale * total(terms.tangential);
    const Exact size = sqrt(radial * radial + tangential * tangential);
    if (size == 0) {  // a wedge alone, on a law of the squeeze alone: no rounding, or no digit
      if (force.radial != 0 || force.tangential != 0) row.max_of_force = std::numeric_limits<double>::infinity();
      continue;
    }
    const Exact errors[2] = {abs(force.radial - radial), abs(force.tangential - tangential)};
    const Exact units[2] = {dynamic ? size : Exact(scale * magnitude(terms.radial)),
                            dynamic ? size : Exact(scale * magnitude(terms.tangential))};
    for (int i = 0; i < 2; ++i) {
      row.max_of_force = std::max(row.max_of_force, static_cast<double>(errors[i] / size));
      if (errors[i] == 0) continue;
      const double in_ulp = static_cast<double>(errors[i] / ulp(static_cast<double>(units[i])));
      row.max_ulp = std::max(row.max_ulp, in_ulp);
      squares += in_ulp * in_ulp;
    }
  }
  row.rms_ulp = std::sqrt(squares / (2 * static_cast<double>(directions.size())));
  return row;
}

}  // namespace

std::vector<AccuracyRow> measure_accuracy(std::size_t directions, std::uint64_t seed) {
  std::vector<AccuracyRow> rows;
  const auto all = motions(directions, seed);
  for_each_film_law<StateFilmLaws>([&]<class Law>() {
    for (const double epsilon : ratios()) rows.push_back(measure<Law>(epsilon, all));
  });
  return rows;
}

double worst_ulp(const std::vector<AccuracyRow>& rows, const std::string& law, double smallest) {
  double worst = 0;
  for (const AccuracyRow& row : rows) {
    if (row.law == law && row.one_minus_ratio >= smallest) worst = std::max(worst, row.max_ulp);
  }
  return worst;
}

double worst_of_force(const std::vector<AccuracyRow>& rows, const std::string& law, double smallest) {
  double worst = 0;
  for (const AccuracyRow& row : rows) {
    if (row.law == law && row.one_minus_ratio >= smallest) worst = std::max(worst, row.max_of_force);
  }
  return worst;
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  std::string csv = "law,eccentricity_ratio,one_minus_ratio,max_ulp,rms_ulp,max_error_over_force\n";
  for (const AccuracyRow& row : rows) {
    csv += fmt::format("{},{},{},{:.3f},{:.3f},{:.3e}\n", row.law, row.eccentricity_ratio, row.one_minus_ratio,
                       row.max_ulp, row.rms_ulp, row.max_of_force);
  }
  return csv;
}

}  // namespace lubjoint::reports
