#include "oracle/certified/finite_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/certified/finite_coefficients.hpp"
#include "oracle/certified/finite_flow.hpp"
#include "oracle/certified/finite_rows.hpp"
#include "oracle/files/csv_table.hpp"

namespace lubjoint::certified {

namespace {

using oracle::FiniteFilm;

constexpr const char* file_name = "finite_film_force.csv";
constexpr const char* header =
    "film,length_over_diameter,eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential,uncertainty";

std::string row_of(const FiniteGoldenState& at, const FiniteGoldenForce& force) {
  return std::string(oracle::name_of(at.film)) + "," + exact(at.length_to_diameter) + "," +
         exact(at.state.eccentricity_ratio) + "," + exact(at.state.slip_rate) + "," + exact(at.state.squeeze_rate) +
         "," + rounded_to(force.radial, force.uncertainty) + "," + rounded_to(force.tangential, force.uncertainty) +
         "," + rounded(force.uncertainty, 2);
}

}  // namespace

std::vector<FiniteGoldenState> finite_golden_states() {
  constexpr std::array ratios = {0.1, 0.5, 0.9};
  // a and b [1/s]
  constexpr std::array<std::array<double, 2>, 6> rates = {{{1, 0}, {0, 1}, {0, -1}, {2, 1}, {2, -1}, {-1, 1}}};
  std::vector<FiniteGoldenState> states;
  for (const FiniteFilm film :
       {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds}) {
    for (const double shape : finite_golden_shapes) {
      for (const double epsilon : ratios) {
        for (const auto& [a, b] : rates) states.push_back({film, shape, PolarFilmState<double>(epsilon, a, b)});
      }
    }
  }
  return states;
}

FiniteGoldenForce finite_golden_force(const FiniteGoldenState& at) {
  FiniteGoldenForce force = first_solver(at);
  const FiniteGoldenForce other = second_solver(at);
  const double apart = std::hypot(force.radial - other.radial, force.tangential - other.tangential);
  // The elements' own estimate is not asked: of finite_reynolds the force is the volumes'.
  force.uncertainty += apart + (at.film == FiniteFilm::finite_reynolds ? 0 : other.uncertainty);
  return force;
}

void write_finite_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  const std::vector<FiniteGoldenState> states = finite_golden_states();
  std::vector<std::string> rows(states.size());
  in_parallel(run, rows.size(), [&](std::size_t i) { rows[i] = row_of(states[i], finite_golden_force(states[i])); });
  std::string text = std::string(header) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  reports::prepare_folder(folder);
  reports::write_file(folder / file_name, text);
  const std::string coefficients = finite_coefficients_csv(run);
  reports::write_file(folder / finite_coefficients_file, coefficients);
  const std::string flow = finite_flow_csv(run);
  reports::write_file(folder / finite_flow_file, flow);
  reports::write_file(folder / reports::golden_manifest_name,
                      reports::golden_manifest(
                          {{file_name, text}, {finite_coefficients_file, coefficients}, {finite_flow_file, flow}}));
}

std::vector<reports::GoldenDifference> check_finite_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  std::vector<reports::GoldenDifference> differences =
      reports::manifest_differences(folder, {file_name, finite_coefficients_file, finite_flow_file});
  if (!std::filesystem::exists(folder / file_name)) return differences;
  const std::vector<FiniteGoldenState> states = finite_golden_states();
  const reports::CsvTable table(reports::read_input((folder / file_name).string()), file_name);
  if (table.header() != header || table.rows() != states.size()) {
    differences.push_back({file_name, 1, "", "other columns or another number of rows than are made"});
    return differences;
  }
  const std::size_t every = std::max<std::size_t>(run.every, 1);
  std::mutex mutex;
  in_parallel(run, (states.size() + every - 1) / every, [&](std::size_t job) {
    const std::size_t i = job * every;
    const FiniteGoldenForce made = finite_golden_force(states[i]);
    const std::string inputs = row_of(states[i], made);
    const auto value = [&](const char* column) { return table.number(i, table.column(column)); };
    std::string what;
    const double apart = std::hypot(value("radial") - made.radial, value("tangential") - made.tangential);
    constexpr int given = 5;  // film, L/D, ε, a, b
    if (first_fields(table.line(i), given) != first_fields(inputs, given)) {
      what = "another state than " + first_fields(inputs, given);
    } else if (!(apart <= value("uncertainty") + made.uncertainty)) {
      what = "the force is off by " + rounded(apart, 3) + " 1/s, more than both uncertainties";
    } else if (!(value("uncertainty") <= 10 * made.uncertainty)) {
      what =
          "the uncertainty is " + rounded(value("uncertainty"), 3) + " 1/s instead of " + rounded(made.uncertainty, 3);
    }
    if (what.empty()) return;
    const std::lock_guard lock(mutex);
    differences.push_back({file_name, i + 2, "", what});
  });
  std::ranges::sort(differences, {}, &reports::GoldenDifference::line);
  if (std::filesystem::exists(folder / finite_coefficients_file)) {
    const std::string text = reports::read_input((folder / finite_coefficients_file).string());
    for (auto& difference : check_finite_coefficients(text, run)) differences.push_back(std::move(difference));
  }
  if (std::filesystem::exists(folder / finite_flow_file)) {
    const std::string text = reports::read_input((folder / finite_flow_file).string());
    for (auto& difference : check_finite_flow(text, run)) differences.push_back(std::move(difference));
  }
  return differences;
}

}  // namespace lubjoint::certified
