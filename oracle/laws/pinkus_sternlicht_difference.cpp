#include "oracle/laws/pinkus_sternlicht_difference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lubjoint/film/law.hpp"
#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::reports {

DifferenceGrid DifferenceGrid::uniform(double last, std::size_t eccentricity_ratios, std::size_t directions) {
  DifferenceGrid grid;
  grid.directions = directions;
  for (std::size_t i = 0; i < eccentricity_ratios; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(eccentricity_ratios);
    grid.eccentricity_ratios.push_back(last * part);
  }
  return grid;
}

std::vector<PinkusSternlichtDifference> pinkus_sternlicht_difference(const DifferenceGrid& grid) {
  if (grid.directions == 0) throw std::invalid_argument("directions is 0; allowed is 1 or more");
  // The scale cancels: any bearing and any oil give the same ratio.
  const Bearing<double> bearing(1, 1, 0.5);
  const Lubricant<double> oil(1);
  std::vector<PinkusSternlichtDifference> differences;
  for (const double epsilon : grid.eccentricity_ratios) {
    for (std::size_t i = 0; i < grid.directions; ++i) {
      const double turn = (static_cast<double>(i) + 0.5) / static_cast<double>(grid.directions);
      const double direction = 2 * std::numbers::pi * turn;
      const PolarFilmState<double> state(epsilon, -2 * std::sin(direction), std::cos(direction));
      const oracle::FilmForceEstimate film =
          oracle::film_force_by_quadrature(oracle::OneDimensionalFilm::long_dynamic, bearing, oil, state);
      const PolarForce<double> law = film_force<PinkusSternlicht>(bearing, oil, state);
      const double size = std::hypot(film.radial.value, film.tangential.value);
      const double apart = std::hypot(law.radial - film.radial.value, law.tangential - film.tangential.value);
      const double error = std::hypot(film.radial.error, film.tangential.error);
      differences.push_back(
          {epsilon, direction, state.slip_rate, state.squeeze_rate, apart / size, error / size * (1 + apart / size)});
    }
  }
  return differences;
}

DifferenceSummary summary_of(const std::vector<PinkusSternlichtDifference>& differences, SqueezeSign sign,
                             double eccentricity_ratio_below) {
  DifferenceSummary summary;
  std::vector<double> values;
  for (const PinkusSternlichtDifference& d : differences) {
    const bool of_the_sign = sign == SqueezeSign::closing ? d.squeeze_rate > 0 : d.squeeze_rate < 0;
    if (!of_the_sign || d.eccentricity_ratio >= eccentricity_ratio_below) continue;
    values.push_back(d.difference);
    if (d.difference > summary.largest) {
      summary.largest = d.difference;
      summary.eccentricity_ratio_of_largest = d.eccentricity_ratio;
    }
  }
  if (values.empty()) return summary;
  summary.states = values.size();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  summary.median = *middle;
  return summary;
}

}  // namespace lubjoint::reports
