#include "oracle/certified/finite_flow.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/certified/finite_length.hpp"
#include "oracle/certified/finite_rows.hpp"
#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::certified {

namespace {

using oracle::FiniteFilm;
using oracle::FiniteFlow;
using oracle::SmoothFilmMethod;

constexpr FiniteFile file{
    finite_flow_file, "film,length_over_diameter,eccentricity_ratio,slip_rate,squeeze_rate,side_flow,uncertainty", 5};

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
  return finite_csv(file, finite_flow_states(), run,
                    [](const FiniteGoldenState& at) { return row_of(at, finite_golden_flow(at)); });
}

std::vector<reports::GoldenDifference> check_finite_flow(const std::string& text, const GoldenRun& run) {
  const auto compare = [](const reports::CsvTable& table, std::size_t i, const FiniteGoldenFlow& made,
                          const auto& tell) {
    const double apart = std::abs(table.number(i, table.column("side_flow")) - made.flow);
    const double allowed = table.number(i, table.column("uncertainty"));
    if (!(apart <= allowed + made.uncertainty)) {
      tell("side_flow", "off by " + rounded(apart, 3) + " 1/s, more than both uncertainties");
    } else if (!(allowed <= 10 * made.uncertainty)) {
      tell("uncertainty", "is " + rounded(allowed, 3) + " 1/s instead of " + rounded(made.uncertainty, 3));
    }
  };
  return finite_differences(file, finite_flow_states(), text, run, finite_golden_flow, row_of, compare);
}

}  // namespace lubjoint::certified
