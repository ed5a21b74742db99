#include "oracle/measure/quadrature_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "oracle/files/progress.hpp"
#include "oracle/laws/published_forms.hpp"
#include "oracle/measure/timing.hpp"
#include "oracle/reynolds/film_integral.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::reports {

namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

constexpr std::array<std::array<double, 2>, 6> motions = {{{2, 0}, {0, 1}, {1, 1}, {1, -1}, {0, -1}, {-1.5, 0.3}}};

struct Reference {
  double radial;
  double tangential;
  double size;
};

Reference exact_force(const oracle::OneDimensionalFilmEntry& film, const Bearing<double>& bearing, double epsilon,
                      double a, double b) {
  const auto terms = published_terms<Exact>(film.name, Exact(epsilon), Exact(a), Exact(b));
  const Exact length(bearing.length());
  const Exact radius(bearing.radius());
  const Exact clearance(bearing.clearance());
  const Exact scale = (film.limit() == BearingLimit::short_bearing ? Exact(radius * length * length * length)
                                                                   : Exact(length * radius * radius * radius)) /
                      (clearance * clearance);
  Exact radial = 0;
  Exact tangential = 0;
  for (const Exact& term : terms.radial) radial += scale * term;
  for (const Exact& term : terms.tangential) tangential += scale * term;
  return {static_cast<double>(radial), static_cast<double>(tangential),
          static_cast<double>(sqrt(radial * radial + tangential * tangential))};
}

template <class Function>
double median_microseconds(int repeats, const Function& f) {
  return interleaved_medians(repeats, {[&f] { f(); }}).front() / 1000;
}

const Bearing<double> paper_bearing(0.04, 0.0098, 0.0002);
const Lubricant<double> unit_oil(1.0);

}  // namespace

std::vector<QuadratureTiming> time_quadrature(bool quick) {
  const std::vector<double> gaps =
      quick ? std::vector<double>{0.5, 1e-3, 1e-9} : std::vector<double>{0.9, 0.5, 0.1, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12};
  const std::vector<double> tolerances =
      quick ? std::vector<double>{1e-6, 1e-10} : std::vector<double>{1e-3, 1e-6, 1e-10, 1e-13};
  const int repeats = quick ? 5 : 21;
  std::vector<QuadratureTiming> rows;
  const auto& rules = oracle::film_quadrature_rule_names;
  ProgressBar progress("quadrature", oracle::one_dimensional_films.size() * rules.size() * gaps.size());
  for (const auto& film : oracle::one_dimensional_films) {
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const auto rule = static_cast<oracle::FilmQuadratureRule>(r);
      for (const double gap : gaps) {
        progress.advance();
        if (rule == oracle::FilmQuadratureRule::trapezoid && film.extent() != FilmExtent::full) continue;
        for (const double tolerance : tolerances) {
          QuadratureTiming row{std::string(film.name), std::string(rules[r]), gap, tolerance, 0, 0, 0};
          std::vector<double> times;
          try {
            for (const auto& [a, b] : motions) {
              const PolarFilmState<double> state(1 - gap, a, b);
              const Reference exact = exact_force(film, paper_bearing, 1 - gap, a, b);
              const auto evaluate = [&] {
                return film_force_by_quadrature(film.film, paper_bearing, unit_oil, state, {rule, tolerance});
              };
              const auto force = evaluate();
              row.error = std::max(
                  row.error, std::hypot(force.radial.value - exact.radial, force.tangential.value - exact.tangential) /
                                 exact.size);
              row.estimate =
                  std::max(row.estimate, std::hypot(force.radial.error, force.tangential.error) / exact.size);
              times.push_back(median_microseconds(repeats, evaluate));
            }
          } catch (const std::exception&) {
            row.error = row.estimate = row.microseconds = -1;  // the rule gave up, as its report says
            rows.push_back(row);
            continue;
          }
          row.microseconds = median_of(times);
          rows.push_back(row);
        }
      }
    }
  }
  return rows;
}

std::vector<QuadratureTiming> time_finite_length(bool quick) {
  using oracle::FiniteFilm;
  const std::vector<double> gaps =
      quick ? std::vector<double>{0.5, 0.05} : std::vector<double>{0.9, 0.5, 0.2, 0.1, 0.05, 0.01};
  const std::vector<double> tolerances = quick ? std::vector<double>{1e-3} : std::vector<double>{1e-2, 1e-3, 1e-4};
  const int repeats = quick ? 3 : 9;
  const std::array<FiniteFilm, 4> films = {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic,
                                           FiniteFilm::finite_reynolds};
  std::vector<QuadratureTiming> rows;
  ProgressBar progress("finite length", films.size() * gaps.size() * tolerances.size());
  for (const FiniteFilm film : films) {
    for (const double gap : gaps) {
      for (const double tolerance : tolerances) {
        progress.advance();
        QuadratureTiming row{std::string(name_of(film)), "L/D 2.04", gap, tolerance, 0, 0, 0};
        std::vector<double> times;
        for (const auto& [a, b] : motions) {
          const PolarFilmState<double> state(1 - gap, a, b);
          const auto fine = finite_length_force(film, paper_bearing, unit_oil, state, {1e-6, {}});
          const auto evaluate = [&] {
            return finite_length_force(film, paper_bearing, unit_oil, state, {tolerance, {}});
          };
          const auto force = evaluate();
          const double size = std::hypot(fine.radial, fine.tangential);
          row.error =
              std::max(row.error, std::hypot(force.radial - fine.radial, force.tangential - fine.tangential) / size);
          row.estimate = std::max(row.estimate, std::hypot(force.radial_error, force.tangential_error) / size);
          times.push_back(median_microseconds(repeats, evaluate));
        }
        row.microseconds = median_of(times);
        rows.push_back(row);
      }
    }
  }
  return rows;
}

std::string quadrature_csv(const std::vector<QuadratureTiming>& rows) {
  std::string csv = "film,rule,one_minus_ratio,tolerance,error,estimate,microseconds\n";
  for (const QuadratureTiming& row : rows) {
    if (row.microseconds < 0) {
      csv += fmt::format("{},{},{},{},failed,failed,failed\n", row.film, row.rule, row.one_minus_ratio, row.tolerance);
      continue;
    }
    csv += fmt::format("{},{},{},{},{:.3e},{:.3e},{:.4g}\n", row.film, row.rule, row.one_minus_ratio, row.tolerance,
                       row.error, row.estimate, row.microseconds);
  }
  return csv;
}

std::string quadrature_table(const std::vector<QuadratureTiming>& rows) {
  std::string text = fmt::format("{:<16} {:<15} {:>8} {:>10} {:>12} {:>12} {:>12}\n", "film", "rule", "1 - e",
                                 "tolerance", "error/|F|", "estimate", "time [us]");
  for (const QuadratureTiming& row : rows) {
    const std::string start =
        fmt::format("{:<16} {:<15} {:>8.0e} {:>10.0e}", row.film, row.rule, row.one_minus_ratio, row.tolerance);
    text += row.microseconds < 0
                ? fmt::format("{} {:>12} {:>12} {:>12}\n", start, "failed", "", "")
                : fmt::format("{} {:>12.1e} {:>12.1e} {:>12.1f}\n", start, row.error, row.estimate, row.microseconds);
  }
  return text;
}

}  // namespace lubjoint::reports
