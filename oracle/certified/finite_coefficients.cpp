#include "oracle/certified/finite_coefficients.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "oracle/certified/finite_force.hpp"
#include "oracle/certified/finite_rows.hpp"

namespace lubjoint::certified {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using oracle::FiniteFilm;

constexpr FiniteFile file{
    finite_coefficients_file,
    "film,length_over_diameter,eccentricity_ratio,sommerfeld,load,load_uncertainty,attitude,attitude_uncertainty,"
    "kxx,kxy,kyx,kyy,stiffness_uncertainty,cxx,cxy,cyx,cyy,damping_uncertainty",
    3};

/// A vector, or a column of a matrix, with a bound of its error.
struct Bounded {
  Vector2d value;
  double error;
};

/// −dF/dx at 0 from F at ±h and ±2h: fourth order. The error: the bounds of the forces, and the truncation, E of 16 E
/// over twice the step, a fifteenth of the difference.
template <class Force>
Bounded minus_slope(double h, const Force& force) {
  const Bounded left = force(-h), right = force(h), far_left = force(-2 * h), far_right = force(2 * h);
  const Bounded farther_left = force(-4 * h), farther_right = force(4 * h);
  const auto slope = [](const Vector2d& near, const Vector2d& far, double step) {
    return Vector2d((8 * near - far) / (12 * step));
  };
  const Vector2d close = slope(right.value - left.value, far_right.value - far_left.value, h);
  const Vector2d wide = slope(far_right.value - far_left.value, farther_right.value - farther_left.value, 2 * h);
  const double carried = (8 * (left.error + right.error) + far_left.error + far_right.error) / (12 * h);
  return {-close, carried + (wide - close).norm() / 15};
}

/// Everything by one solver, in (r, t).
struct OneSolver {
  Bounded force;
  Matrix2d stiffness, damping;
  double stiffness_error, damping_error;
};

template <class Solve>
OneSolver by_solver(const FiniteSteadyState& at, double step, const Solve& solve) {
  const double epsilon = at.eccentricity_ratio;
  const double h = step * std::min(epsilon, 1 - epsilon);
  const auto force = [&](double ratio, double b) {
    const FiniteGoldenForce f =
        solve(FiniteGoldenState{at.film, at.length_to_diameter, PolarFilmState<double>(ratio, ratio, b)});
    return Bounded{{f.radial, f.tangential}, f.uncertainty};
  };
  OneSolver all{force(epsilon, 0), {}, {}, 0, 0};
  const Bounded outward = minus_slope(h, [&](double d) { return force(epsilon + d, 0); });
  const Bounded squeezed = minus_slope(step * epsilon, [&](double b) { return force(epsilon, b); });
  const Vector2d& f = all.force.value;
  all.stiffness << outward.value[0], f[1] / epsilon, outward.value[1], -f[0] / epsilon;
  all.damping << squeezed.value[0], 2 * f[0] / epsilon, squeezed.value[1], 2 * f[1] / epsilon;  // a = ε
  all.stiffness_error = outward.error + all.force.error / epsilon;
  all.damping_error = squeezed.error + 2 * all.force.error / epsilon;
  return all;
}

std::array<double, 4> in_frame(const Matrix2d& frame, const Matrix2d& m) {
  const Matrix2d turned = frame.transpose() * m * frame;
  return {turned(0, 0), turned(0, 1), turned(1, 0), turned(1, 1)};
}

std::string row_of(const FiniteSteadyState& at, const FiniteSteadyFilm& film) {
  std::string row =
      std::string(oracle::name_of(at.film)) + "," + exact(at.length_to_diameter) + "," + exact(at.eccentricity_ratio);
  const double sommerfeld = 1 / (std::numbers::pi * film.load);
  row += "," + rounded_to(sommerfeld, sommerfeld * film.load_uncertainty / film.load);
  const auto add = [&row](double value, double uncertainty) { row += "," + rounded_to(value, uncertainty); };
  const auto add_bound = [&row](double uncertainty) { row += "," + rounded(uncertainty, 2); };
  add(film.load, film.load_uncertainty);
  add_bound(film.load_uncertainty);
  add(film.attitude, film.attitude_uncertainty);
  add_bound(film.attitude_uncertainty);
  for (const double k : film.stiffness) add(k, film.stiffness_uncertainty);
  add_bound(film.stiffness_uncertainty);
  for (const double c : film.damping) add(c, film.damping_uncertainty);
  add_bound(film.damping_uncertainty);
  return row;
}

}  // namespace

std::vector<FiniteSteadyState> finite_steady_states() {
  std::vector<FiniteSteadyState> states;
  for (const FiniteFilm film :
       {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds}) {
    for (const double shape : finite_golden_shapes) {
      for (const double epsilon : {0.1, 0.3, 0.5, 0.7, 0.9}) states.push_back({film, shape, epsilon});
    }
  }
  return states;
}

FiniteSteadyFilm finite_steady_film(const FiniteSteadyState& at) {
  // Steps over which rounding and truncation are about as large: forces to 1e-10, and to some 1e-5 on grids.
  const bool on_grids = at.film == FiniteFilm::finite_reynolds;
  const double step = on_grids ? 0.06 : 0.005;
  const OneSolver first = by_solver(at, step, first_solver);
  const OneSolver second = by_solver(at, step, second_solver);
  const double force_error = (first.force.value - second.force.value).norm() + first.force.error + second.force.error;
  const double load = first.force.value.norm();
  const double turn = force_error / load;
  const auto apart = [&](const Matrix2d& one, const Matrix2d& other) {
    return (one - other).cwiseAbs().maxCoeff() + 2 * turn * one.cwiseAbs().maxCoeff();
  };
  Matrix2d frame;  // columns: x and y in (r, t)
  frame.col(0) = -first.force.value / load;
  frame.col(1) << -frame(1, 0), frame(0, 0);
  FiniteSteadyFilm film;
  film.load = load;
  film.attitude = std::atan2(first.force.value[1], -first.force.value[0]);
  film.stiffness = in_frame(frame, first.stiffness);
  film.damping = in_frame(frame, first.damping);
  film.load_uncertainty = force_error;
  film.attitude_uncertainty = turn;
  // An entry in the load's axes is a sum of four, with factors whose squares make one.
  film.stiffness_uncertainty =
      2 * (apart(first.stiffness, second.stiffness) + first.stiffness_error + second.stiffness_error);
  film.damping_uncertainty = 2 * (apart(first.damping, second.damping) + first.damping_error + second.damping_error);
  return film;
}

std::string finite_coefficients_csv(const GoldenRun& run) {
  return finite_csv(file, finite_steady_states(), run,
                    [](const FiniteSteadyState& at) { return row_of(at, finite_steady_film(at)); });
}

std::vector<reports::GoldenDifference> check_finite_coefficients(const std::string& text, const GoldenRun& run) {
  const auto compare = [](const reports::CsvTable& table, std::size_t i, const FiniteSteadyFilm& made,
                          const auto& tell) {
    const auto hold = [&](const std::string& column, double value, const std::string& bound, double uncertainty) {
      const double printed = table.number(i, table.column(column));
      const double allowed = table.number(i, table.column(bound));
      if (!(std::abs(printed - value) <= allowed + uncertainty)) {
        tell(column, "off by " + rounded(std::abs(printed - value), 3) + ", more than both uncertainties");
      } else if (!(allowed <= 10 * uncertainty)) {
        tell(bound, "is " + rounded(allowed, 3) + " instead of " + rounded(uncertainty, 3));
      }
    };
    hold("load", made.load, "load_uncertainty", made.load_uncertainty);
    hold("attitude", made.attitude, "attitude_uncertainty", made.attitude_uncertainty);
    const std::array<std::string, 4> axes = {"xx", "xy", "yx", "yy"};
    for (std::size_t k = 0; k < axes.size(); ++k) {
      hold("k" + axes[k], made.stiffness[k], "stiffness_uncertainty", made.stiffness_uncertainty);
      hold("c" + axes[k], made.damping[k], "damping_uncertainty", made.damping_uncertainty);
    }
  };
  return finite_differences(file, finite_steady_states(), text, run, finite_steady_film, row_of, compare);
}

}  // namespace lubjoint::certified
