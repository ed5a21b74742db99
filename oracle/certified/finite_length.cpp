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

constexpr FiniteFile file{
    "finite_film_force.csv",
    "film,length_over_diameter,eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential,uncertainty", 5};

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
  const std::string text = finite_csv(file, finite_golden_states(), run,
                                      [](const FiniteGoldenState& at) { return row_of(at, finite_golden_force(at)); });
  reports::prepare_folder(folder);
  reports::write_file(folder / file.name, text);
  const std::string coefficients = finite_coefficients_csv(run);
  reports::write_file(folder / finite_coefficients_file, coefficients);
  const std::string flow = finite_flow_csv(run);
  reports::write_file(folder / finite_flow_file, flow);
  reports::write_file(folder / reports::golden_manifest_name,
                      reports::golden_manifest(
                          {{file.name, text}, {finite_coefficients_file, coefficients}, {finite_flow_file, flow}}));
}

namespace {

std::vector<reports::GoldenDifference> check_finite_forces(const std::string& text, const GoldenRun& run) {
  const auto compare = [](const reports::CsvTable& table, std::size_t i, const FiniteGoldenForce& made,
                          const auto& tell) {
    const auto value = [&](const char* column) { return table.number(i, table.column(column)); };
    const double apart = std::hypot(value("radial") - made.radial, value("tangential") - made.tangential);
    if (!(apart <= value("uncertainty") + made.uncertainty)) {
      tell("", "the force is off by " + rounded(apart, 3) + " 1/s, more than both uncertainties");
    } else if (!(value("uncertainty") <= 10 * made.uncertainty)) {
      tell("uncertainty", "is " + rounded(value("uncertainty"), 3) + " 1/s instead of " + rounded(made.uncertainty, 3));
    }
  };
  return finite_differences(file, finite_golden_states(), text, run, finite_golden_force, row_of, compare);
}

}  // namespace

std::vector<reports::GoldenDifference> check_finite_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  std::vector<reports::GoldenDifference> differences =
      reports::manifest_differences(folder, {file.name, finite_coefficients_file, finite_flow_file});
  const auto look_at = [&](const char* name, const auto& check) {
    if (!std::filesystem::exists(folder / name)) return;  // the manifest's comparison has told of it
    for (auto& difference : check(reports::read_input((folder / name).string()), run))
      differences.push_back(std::move(difference));
  };
  look_at(file.name, check_finite_forces);
  look_at(finite_coefficients_file, check_finite_coefficients);
  look_at(finite_flow_file, check_finite_flow);
  return differences;
}

}  // namespace lubjoint::certified
