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
constexpr std::array<int, 17> steps_along{4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 56, 64};
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

struct Fit {
  Eigen::Vector2d value;
  Eigen::Vector2d standard_error;
};

/// Least squares for F₀ + C/n² through the forces of grids first…last, weights n⁴.
Fit extrapolate(const std::vector<Eigen::Vector2d>& forces, std::size_t first, std::size_t last) {
  double w0 = 0, w1 = 0, w2 = 0;
  Eigen::Vector2d f0(0, 0), f1(0, 0);
  const auto each = [&](auto&& use) {
    for (std::size_t g = first; g <= last; ++g) {
      const double x = 1 / static_cast<double>(steps_along[g] * steps_along[g]);
      use(1 / (x * x), x, forces[g]);
    }
  };
  each([&](double w, double x, const Eigen::Vector2d& force) {
    w0 += w;
    w1 += w * x;
    w2 += w * x * x;
    f0 += w * force;
    f1 += w * x * force;
  });
  const double determinant = w0 * w2 - w1 * w1;
  const Eigen::Vector2d value = (w2 * f0 - w1 * f1) / determinant;
  const Eigen::Vector2d slope = (w0 * f1 - w1 * f0) / determinant;
  Eigen::Vector2d scatter(0, 0);
  each([&](double w, double x, const Eigen::Vector2d& force) {
    scatter += w * (force - value - slope * x).cwiseAbs2();
  });
  const auto freedom = static_cast<double>(last - first + 1 - 2);
  return {value, (scatter / freedom * w2 / determinant).cwiseSqrt()};
}

/// Slope of log|F − F₀| against log h over all grids but the finest, by least squares: the order of convergence towards
/// the extrapolated force.
double order_of_convergence(const std::vector<Eigen::Vector2d>& forces, const Eigen::Vector2d& extrapolated) {
  double count = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t g = 0; g + 1 < forces.size(); ++g) {
    const double x = -std::log(static_cast<double>(steps_along[g]));
    const double y = std::log((forces[g] - extrapolated).norm());
    count += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

}  // namespace

ScaledForce cavitated_film_force(const ScaledFilm& film, bool pinned, double relative_tolerance) {
  ScaledForce result;
  std::vector<Eigen::Vector2d> forces;
  std::unique_ptr<CavitatedGrid> grid;
  Eigen::Vector2d last_estimate = Eigen::Vector2d::Zero();
  for (std::size_t last = 0; last < steps_along.size(); ++last) {
    grid = next_grid(film, pinned, steps_along[last], grid.get());
    forces.push_back(grid->force());
    if (last + 1 < fitted) continue;
    const Fit fit = extrapolate(forces, last + 1 - fitted, last);
    const std::size_t before = last - earlier;
    const Fit other = extrapolate(forces, before + 1 > fitted ? before + 1 - fitted : 0, before);
    const Eigen::Vector2d drift = (fit.value - other.value).cwiseAbs();
    const double rounding = grid->unknowns() * std::numeric_limits<double>::epsilon() * fit.value.norm();
    result.value = fit.value;
    Eigen::Vector2d estimate = standard_errors * fit.standard_error + drift + Eigen::Vector2d::Constant(rounding);
    result.unknowns = grid->unknowns();
    result.observed_order = order_of_convergence(forces, fit.value);
    // Where the grids do not yet converge at second order, the extrapolation is worth no more than its finest grid.
    if (!(std::abs(result.observed_order - 2) < order_margin)) {
      estimate = estimate.cwiseMax((forces.back() - fit.value).cwiseAbs());
    }
    // r falls like h²: an estimate that falls faster than that from one grid to the next agrees by chance. The first
    // has nothing to be compared with and ends nothing.
    const double refinement = static_cast<double>(steps_along[last - 1]) / steps_along[last];
    result.error = estimate.cwiseMax(refinement * refinement * last_estimate);
    last_estimate = estimate;
    if (last + 1 == fitted) continue;
    if (result.error.norm() <= relative_tolerance * result.value.norm()) break;
  }
  return result;
}

std::vector<double> cavitated_film_pressure(const ScaledFilm& film, bool pinned, const std::vector<double>& theta,
                                            const std::vector<double>& zeta) {
  const int least_along = 32;
  const int along =
      std::max({least_along, static_cast<int>(zeta.size() + 1) / 2, static_cast<int>(theta.size()) / around_per_along});
  std::unique_ptr<CavitatedGrid> grid;
  for (const int steps : steps_along) {
    if (steps < along) grid = next_grid(film, pinned, steps, grid.get());
  }
  grid = next_grid(film, pinned, along, grid.get());
  std::vector<double> pressure;
  pressure.reserve(theta.size() * zeta.size());
  for (const double angle : theta) {
    for (const double z : zeta) pressure.push_back(grid->pressure(angle, z));
  }
  return pressure;
}

}  // namespace lubjoint::oracle
