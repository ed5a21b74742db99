#include "oracle/certified/finite_flow.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/certified/finite_length.hpp"
#include "oracle/certified/finite_rows.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::certified {

namespace {

using oracle::FiniteFilm;
using oracle::FiniteFlow;
using oracle::SmoothFilmMethod;

constexpr const char* header =
    "film,length_over_diameter,eccentricity_ratio,slip_rate,squeeze_rate,side_flow,uncertainty";
constexpr int inputs = 5;

FiniteFlow solved(const FiniteGoldenState& at, double tolerance, SmoothFilmMethod method) {
  return oracle::finite_side_flow(at.film, at.length_to_diameter, at.state.in_own_frame(),
                                  {tolerance, oracle::FilmOnset::free, method});
}

/// Q/(cRL) = cR² (rate) ∫ −H³ ∂ζP dθ/(cRL), and R/L = 1/(2Λ).
double by_elements(const FiniteGoldenState& at) {
  const double a = std::abs(at.state.slip_rate);
  const double b = at.state.squeeze_rate;
  const double rate = std::max(a, std::abs(b));
  const double epsilon = at.state.eccentricity_ratio;
  const oracle::ScaledFlow flow = oracle::cavitated_flow_by_elements(
      {epsilon, at.state.q / (1 + epsilon), a / rate, b / rate, at.length_to_diameter});
  return rate * flow.value[0] / (2 * at.length_to_diameter);
}

std::string row_of(const FiniteGoldenState& at, const FiniteGoldenFlow& flow) {
  return std::string(oracle::name_of(at.film)) + "," + exact(at.length_to_diameter) + "," +
         exact(at.state.eccentricity_ratio) + "," + exact(at.state.slip_rate) + "," + exact(at.state.squeeze_rate) +
         "," + rounded_to(flow.flow, flow.uncertainty) + "," + rounded(flow.uncertainty, 2);
}

}  // namespace

std::vector<FiniteGoldenState> finite_flow_states() {
  std::vector<FiniteGoldenState> states = finite_golden_states();
  std::erase_if(states, [](const FiniteGoldenState& at) { return at.film == FiniteFilm::finite_full; });
  return states;
}

FiniteGoldenFlow finite_golden_flow(const FiniteGoldenState& at) {
  if (at.film == FiniteFilm::finite_reynolds) {
    const FiniteFlow volumes = solved(at, 5e-5, SmoothFilmMethod::axial_series);
    return {volumes.ratio, volumes.error + std::abs(volumes.ratio - by_elements(at))};
  }
  const FiniteFlow series = solved(at, 1e-10, SmoothFilmMethod::axial_series);
  const FiniteFlow modes = solved(at, 1e-10, SmoothFilmMethod::circumferential_modes);
  return {series.ratio, series.error + modes.error + std::abs(series.ratio - modes.ratio)};
}

std::string finite_flow_csv(const GoldenRun& run) {
  const std::vector<FiniteGoldenState> states = finite_flow_states();
  std::vector<std::string> rows(states.size());
  in_parallel(run, rows.size(), [&](std::size_t i) { rows[i] = row_of(states[i], finite_golden_flow(states[i])); });
  std::string text = std::string(header) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

std::vector<reports::GoldenDifference> check_finite_flow(const std::string& text, const GoldenRun& run) {
  const std::vector<FiniteGoldenState> states = finite_flow_states();
  const reports::CsvTable table(text, finite_flow_file);
  if (table.header() != header || table.rows() != states.size()) {
    return {{finite_flow_file, 1, "", "other columns or another number of rows than are made"}};
  }
  std::vector<reports::GoldenDifference> differences;
  const std::size_t every = std::max<std::size_t>(run.every, 1);
  std::mutex mutex;
  in_parallel(run, (states.size() + every - 1) / every, [&](std::size_t job) {
    const std::size_t i = job * every;
    const FiniteGoldenFlow made = finite_golden_flow(states[i]);
    const std::string again = row_of(states[i], made);
    const auto tell = [&](const std::string& column, const std::string& what) {
      const std::lock_guard lock(mutex);
      differences.push_back({finite_flow_file, i + 2, column, what});
    };
    if (first_fields(table.line(i), inputs) != first_fields(again, inputs)) {
      return tell("", "another state than " + first_fields(again, inputs));
    }
    const double apart = std::abs(table.number(i, table.column("side_flow")) - made.flow);
    const double allowed = table.number(i, table.column("uncertainty"));
    if (!(apart <= allowed + made.uncertainty)) {
      tell("side_flow", "off by " + rounded(apart, 3) + " 1/s, more than both uncertainties");
    } else if (!(allowed <= 10 * made.uncertainty)) {
      tell("uncertainty", "is " + rounded(allowed, 3) + " 1/s instead of " + rounded(made.uncertainty, 3));
    }
  });
  std::ranges::sort(differences, {}, &reports::GoldenDifference::line);
  return differences;
}

}  // namespace lubjoint::certified
