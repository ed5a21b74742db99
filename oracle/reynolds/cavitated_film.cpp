#include "oracle/reynolds/cavitated_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>

#include "oracle/reynolds/cavitated_grid.hpp"

namespace lubjoint::oracle {

namespace {

/// Steps from the middle to the edge of successive grids, about a fifth more each time.
constexpr std::array<int, 21> steps_along{4,  5,  6,  7,  8,  10, 12, 14, 16,  20, 24,
                                          28, 32, 40, 48, 56, 64, 80, 96, 112, 128};
/// The grids after these take a second each. They are for those who ask for least_tolerance or less, and no finer than
/// to reach it.
constexpr std::size_t usual_grids = 17;
constexpr double least_tolerance = 1e-5;
/// Nodes around for each step along: P is nearly a parabola in ζ, and r falls with the step around.
constexpr int around_per_along = 16;
constexpr std::size_t fitted = 6;         ///< grids in a fit: the coarsest is about twice as coarse as the finest
constexpr std::size_t earlier = 2;        ///< the fit compared with ends this many grids before
constexpr double standard_errors = 8.61;  ///< Student's t for 99.9 % with the four degrees of freedom of a fit

/// How far the observed order may be from 2 before the extrapolation is mistrusted.
constexpr double order_margin = 0.5;

std::unique_ptr<CavitatedGrid> next_grid(const ScaledFilm& film, bool pinned, int along, const CavitatedGrid* coarser) {
  auto grid = std::make_unique<CavitatedGrid>(film, pinned, around_per_along * along, along);
  if (coarser != nullptr) grid->start_from(*coarser);
  grid->solve();
  return grid;
}

/// A grid of any fineness, by way of coarser ones.
std::unique_ptr<CavitatedGrid> solved_grid(const ScaledFilm& film, bool pinned, int along) {
  std::unique_ptr<CavitatedGrid> grid;
  for (const int steps : steps_along) {
    if (steps < along) grid = next_grid(film, pinned, steps, grid.get());
  }
  return next_grid(film, pinned, along, grid.get());
}

template <int N>
using Values = typename ScaledResult<N>::Values;

template <int N>
struct Fit {
  Values<N> value;
  Values<N> standard_error;
};

/// Least squares for F₀ + C/n² through the values of grids first…last, weights n⁴.
template <int N>
Fit<N> extrapolate(const std::vector<Values<N>>& values, std::size_t first, std::size_t last) {
  double w0 = 0, w1 = 0, w2 = 0;
  Values<N> f0 = Values<N>::Zero(), f1 = Values<N>::Zero();
  const auto each = [&](auto&& use) {
    for (std::size_t g = first; g <= last; ++g) {
      const double x = 1 / static_cast<double>(steps_along[g] * steps_along[g]);
      use(1 / (x * x), x, values[g]);
    }
  };
  each([&](double w, double x, const Values<N>& seen) {
    w0 += w;
    w1 += w * x;
    w2 += w * x * x;
    f0 += w * seen;
    f1 += w * x * seen;
  });
  const double determinant = w0 * w2 - w1 * w1;
  const Values<N> value = (w2 * f0 - w1 * f1) / determinant;
  const Values<N> slope = (w0 * f1 - w1 * f0) / determinant;
  Values<N> scatter = Values<N>::Zero();
  each([&](double w, double x, const Values<N>& seen) { scatter += w * (seen - value - slope * x).cwiseAbs2(); });
  const auto freedom = static_cast<double>(last - first + 1 - 2);
  return {value, (scatter / freedom * w2 / determinant).cwiseSqrt()};
}

/// Slope of log|F − F₀| against log h over all grids but the finest, by least squares: the order of convergence towards
/// the extrapolated values.
template <int N>
double order_of_convergence(const std::vector<Values<N>>& values, const Values<N>& extrapolated) {
  double count = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t g = 0; g + 1 < values.size(); ++g) {
    const double x = -std::log(static_cast<double>(steps_along[g]));
    const double y = std::log((values[g] - extrapolated).norm());
    count += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

/// What the grids give, extrapolated, until its error is within the tolerance: a share of it, or of a size below which
/// it matters less.
template <int N, class Value>
ScaledResult<N> refined(const ScaledFilm& film, bool pinned, double relative_tolerance, double least_size,
                        const Value& value_of) {
  ScaledResult<N> result;
  std::vector<Values<N>> values;
  std::unique_ptr<CavitatedGrid> grid;
  Values<N> last_estimate = Values<N>::Zero();
  for (std::size_t last = 0; last < steps_along.size(); ++last) {
    grid = next_grid(film, pinned, steps_along[last], grid.get());
    values.push_back(value_of(*grid));
    if (last + 1 < fitted) continue;
    const Fit<N> fit = extrapolate<N>(values, last + 1 - fitted, last);
    const std::size_t before = last - earlier;
    const Fit<N> other = extrapolate<N>(values, before + 1 > fitted ? before + 1 - fitted : 0, before);
    const Values<N> drift = (fit.value - other.value).cwiseAbs();
    const double rounding =
        grid->unknowns() * std::numeric_limits<double>::epsilon() * std::max(fit.value.norm(), least_size);
    result.value = fit.value;
    Values<N> estimate = standard_errors * fit.standard_error + drift + Values<N>::Constant(rounding);
    result.unknowns = grid->unknowns();
    result.observed_order = order_of_convergence<N>(values, fit.value);
    // Where the grids do not yet converge at second order, the extrapolation is worth no more than its finest grid.
    if (!(std::abs(result.observed_order - 2) < order_margin)) {
      estimate = estimate.cwiseMax((values.back() - fit.value).cwiseAbs());
    }
    // r falls like h²: an estimate that falls faster than that from one grid to the next agrees by chance. The first
    // has nothing to be compared with and ends nothing.
    const double refinement = static_cast<double>(steps_along[last - 1]) / steps_along[last];
    result.error = estimate.cwiseMax(refinement * refinement * last_estimate);
    last_estimate = estimate;
    if (last + 1 == fitted) continue;
    const auto is_within = [&](double tolerance) {
      return result.error.norm() <= tolerance * std::max(result.value.norm(), least_size);
    };
    if (is_within(relative_tolerance)) break;
    if (last + 1 >= usual_grids && (relative_tolerance > least_tolerance || is_within(least_tolerance))) break;
  }
  return result;
}

}  // namespace

ScaledForce cavitated_film_force(const ScaledFilm& film, bool pinned, double relative_tolerance) {
  return refined<2>(film, pinned, relative_tolerance, 0, [](const CavitatedGrid& grid) { return grid.force(); });
}

ScaledFlow cavitated_film_flow(const ScaledFilm& film, bool pinned, double relative_tolerance) {
  return refined<1>(film, pinned, relative_tolerance, film.displacement(),
                    [](const CavitatedGrid& grid) { return ScaledFlow::Values(grid.edge_flow()); });
}

ScaledCouette cavitated_film_couette(const ScaledFilm& film, double relative_tolerance) {
  return refined<1>(film, false, relative_tolerance, 0,
                    [](const CavitatedGrid& grid) { return ScaledCouette::Values(grid.couette_integral()); });
}

std::vector<double> cavitated_film_pressure(const ScaledFilm& film, bool pinned, const std::vector<double>& theta,
                                            const std::vector<double>& zeta) {
  const int least_along = 32;
  const int along =
      std::max({least_along, static_cast<int>(zeta.size() + 1) / 2, static_cast<int>(theta.size()) / around_per_along});
  const std::unique_ptr<CavitatedGrid> grid = solved_grid(film, pinned, along);
  std::vector<double> pressure;
  pressure.reserve(theta.size() * zeta.size());
  for (const double angle : theta) {
    for (const double z : zeta) pressure.push_back(grid->pressure(angle, z));
  }
  return pressure;
}

ScaledPressure cavitated_film_pressure_at(const ScaledFilm& film, bool pinned, double theta, double zeta) {
  constexpr int along = 48;
  const std::unique_ptr<CavitatedGrid> coarser = solved_grid(film, pinned, along / 2);
  const std::unique_ptr<CavitatedGrid> grid = next_grid(film, pinned, along, coarser.get());
  const double value = grid->pressure(theta, zeta), largest = grid->largest_pressure();
  const double change = std::abs(value - coarser->pressure(theta, zeta));
  return {value, largest, change / 2 + largest / (4 * along * along)};
}

}  // namespace lubjoint::oracle
