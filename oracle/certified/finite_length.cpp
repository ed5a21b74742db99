#include "oracle/certified/finite_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"
#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::certified {

namespace {

using oracle::FiniteFilm;
using oracle::FiniteForce;
using oracle::SmoothFilmMethod;

constexpr const char* file_name = "finite_film_force.csv";
constexpr const char* header =
    "film,length_over_diameter,eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential,uncertainty";

/// Shortest text that reads back as the same double.
std::string exact(double value) { return reports::number(value); }

std::string rounded(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

/// To a hundredth of an uncertainty; no minus before a zero.
std::string rounded_to(double value, double uncertainty) {
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(uncertainty))));
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos ? "0" : text;
}

std::string row_of(const FiniteGoldenState& at, const FiniteGoldenForce& force) {
  return std::string(oracle::name_of(at.film)) + "," + exact(at.length_to_diameter) + "," +
         exact(at.state.eccentricity_ratio) + "," + exact(at.state.slip_rate) + "," + exact(at.state.squeeze_rate) +
         "," + rounded_to(force.radial, force.uncertainty) + "," + rounded_to(force.tangential, force.uncertainty) +
         "," + rounded(force.uncertainty, 2);
}

/// F/S of finite_reynolds by finite elements.
Vector2<double> force_by_elements(const FiniteGoldenState& at) {
  const double a = std::abs(at.state.slip_rate);
  const double b = at.state.squeeze_rate;
  const double rate = std::max(a, std::abs(b));
  const double epsilon = at.state.eccentricity_ratio;
  const oracle::ScaledForce force = oracle::cavitated_force_by_elements(
      {epsilon, at.state.q / (1 + epsilon), a / rate, b / rate, at.length_to_diameter});
  // p = 6μ(R/c)² P over an area of R² dθ dζ, and R/L = 1/(2Λ).
  const Vector2<double> ratio = 3 * rate / at.length_to_diameter * force.value;
  return {ratio.x(), at.state.slip_rate < 0 ? -ratio.y() : ratio.y()};
}

template <class Work>
void in_parallel(const GoldenRun& run, std::size_t count, const Work& work) {
  std::mutex mutex;
  std::size_t done = 0;
  reports::run_parallel(count, run.threads ? run.threads : reports::available_cores(), [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    run.progress(++done, count);
  });
}

}  // namespace

std::vector<FiniteGoldenState> finite_golden_states() {
  constexpr std::array shapes = {0.25, 0.5, 1.0, 0.04 / (2 * 0.0098), 4.0};
  constexpr std::array ratios = {0.1, 0.5, 0.9};
  // a and b [1/s]
  constexpr std::array<std::array<double, 2>, 6> rates = {{{1, 0}, {0, 1}, {0, -1}, {2, 1}, {2, -1}, {-1, 1}}};
  std::vector<FiniteGoldenState> states;
  for (const FiniteFilm film :
       {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds}) {
    for (const double shape : shapes) {
      for (const double epsilon : ratios) {
        for (const auto& [a, b] : rates) states.push_back({film, shape, PolarFilmState<double>(epsilon, a, b)});
      }
    }
  }
  return states;
}

FiniteGoldenForce finite_golden_force(const FiniteGoldenState& at) {
  const FilmState<double> film = at.state.in_own_frame();
  const auto solved = [&](double tolerance, SmoothFilmMethod method) {
    return oracle::finite_force(at.film, at.length_to_diameter, film, {tolerance, oracle::FilmOnset::free, method});
  };
  if (at.film == FiniteFilm::finite_reynolds) {
    const FiniteForce volumes = solved(5e-5, SmoothFilmMethod::axial_series);
    const Vector2<double> elements = force_by_elements(at);
    return {volumes.ratio.x(), volumes.ratio.y(), (volumes.ratio - elements).norm() + volumes.error};
  }
  const FiniteForce series = solved(1e-10, SmoothFilmMethod::axial_series);
  const FiniteForce modes = solved(1e-10, SmoothFilmMethod::circumferential_modes);
  const double apart = (series.ratio - modes.ratio).norm();
  return {series.ratio.x(), series.ratio.y(), apart + series.error + modes.error};
}

void write_finite_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  const std::vector<FiniteGoldenState> states = finite_golden_states();
  std::vector<std::string> rows(states.size());
  in_parallel(run, rows.size(), [&](std::size_t i) { rows[i] = row_of(states[i], finite_golden_force(states[i])); });
  std::string text = std::string(header) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  reports::prepare_folder(folder);
  reports::write_file(folder / file_name, text);
  reports::write_file(folder / reports::golden_manifest_name, reports::golden_manifest({{file_name, text}}));
}

std::vector<reports::GoldenDifference> check_finite_golden(const std::filesystem::path& folder, const GoldenRun& run) {
  std::vector<reports::GoldenDifference> differences = reports::manifest_differences(folder, {file_name});
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
    const auto fields_before_force = [](const std::string& row) {  // film, L/D, ε, a, b
      std::size_t end = 0;
      for (int comma = 0; comma < 5; ++comma) end = row.find(',', end) + 1;
      return row.substr(0, end);
    };
    const double apart = std::hypot(value("radial") - made.radial, value("tangential") - made.tangential);
    if (fields_before_force(table.line(i)) != fields_before_force(inputs)) {
      what = "another state than " + fields_before_force(inputs);
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
  return differences;
}

}  // namespace lubjoint::certified
