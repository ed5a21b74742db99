#include "lubjoint/scene/periodic_orbit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "multibody_simulation.hpp"

namespace lubjoint {

namespace {

using State = std::vector<double>;
using Vector = Eigen::VectorXd;

constexpr std::size_t most_iterations = 20;
constexpr double step_share = 1e-4;  ///< of a unit, for differences: a clearance's ten-thousandth
constexpr std::size_t first_periods = 2;

/// The free directions at a state, and a state's coordinates along them, in the scene's units.
class FreeDirections {
 public:
  FreeDirections(const Scene& scene, const PlanarSystem<double>& system, const State& y)
      : n_(static_cast<Eigen::Index>(system.coordinates())), unit_(2 * n_) {
    const SceneUnits units = scene_units(scene);
    for (Eigen::Index i = 0; i < n_; ++i) {
      unit_(i) = i % 3 == 2 ? units.angle : units.length;
      unit_(n_ + i) = unit_(i) * units.rate;
    }
    if (system.constraint_rows() == 0) {
      basis_ = Eigen::MatrixXd::Identity(n_, n_);
      return;
    }
    SystemWorkspace<double> w = system.workspace<double>();
    system.evaluate_kinematics(0.0, y.data(), w);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(w.rows.size()), n_);
    for (std::size_t row = 0; row < w.rows.size(); ++row) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t first = system.first_body_of_row(row);
        const std::size_t second = system.second_body_of_row(row);
        const auto at = static_cast<Eigen::Index>(row);
        if (first != ground_body) rows(at, static_cast<Eigen::Index>(3 * first + k)) += w.rows[row].first[k];
        if (second != ground_body) rows(at, static_cast<Eigen::Index>(3 * second + k)) += w.rows[row].second[k];
      }
    }
    // In the units' metric: what is orthogonal to every row.
    const Eigen::MatrixXd scaled = rows * unit_.head(n_).asDiagonal();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(scaled.transpose());
    const Eigen::MatrixXd q = decomposition.householderQ();
    basis_ = q.rightCols(n_ - decomposition.rank());
  }

  Eigen::Index count() const { return 2 * basis_.cols(); }

  /// The difference of two states along the free directions.
  Vector between(const State& from, const State& to) const {
    Vector difference(2 * n_);
    for (Eigen::Index i = 0; i < 2 * n_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      // Angles of bodies that turn: whole turns are none.
      const double d = i < n_ && i % 3 == 2 ? std::remainder(to[k] - from[k], 2 * std::numbers::pi) : to[k] - from[k];
      difference(i) = d / unit_(i);
    }
    Vector result(count());
    result << basis_.transpose() * difference.head(n_), basis_.transpose() * difference.tail(n_);
    return result;
  }

  /// A state moved along them; a run brings it onto the constraints.
  State moved(const State& y, const Vector& z) const {
    const Vector q = basis_ * z.head(basis_.cols());
    const Vector v = basis_ * z.tail(basis_.cols());
    State result = y;
    for (Eigen::Index i = 0; i < n_; ++i) {
      result[static_cast<std::size_t>(i)] += unit_(i) * q(i);
      result[static_cast<std::size_t>(n_ + i)] += unit_(n_ + i) * v(i);
    }
    return result;
  }

 private:
  Eigen::Index n_;
  Vector unit_;
  Eigen::MatrixXd basis_;
};

void put_start(Scene& scene, const State& y) {
  const std::size_t n = y.size() / 2;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    SceneBody& body = scene.bodies[b];
    body.position = {y[3 * b], y[3 * b + 1]};
    body.angle = y[3 * b + 2];
    body.velocity = {y[n + 3 * b], y[n + 3 * b + 1]};
    body.spin = y[n + 3 * b + 2];
  }
}

class Shooting {
 public:
  Shooting(const Scene& scene, double period) : scene_(scene) {
    scene_.run.duration = period;
    scene_.run.output_interval = period;
    scene_.energy_ledger = false;
    scene_.sensors.clear();
  }

  /// A start that fulfils the constraints.
  State on_constraints(const State& y) {
    put_start(scene_, y);
    return detail::prepare(scene_).start;
  }

  /// The state a period after a start.
  State after_period(const State& start) {
    put_start(scene_, start);
    const MultibodyTrajectory run = simulate_multibody(scene_);
    ++runs;
    if (run.outcome.status != RunStatus::finished) {
      throw SceneError(scene_.file + ": a period from a start that was tried " + run.outcome.message +
                       "; allowed is a scene whose runs reach the end of the period from near its start");
    }
    State end = run.samples.back().state;
    end.resize(start.size());  // without works
    return end;
  }

  std::size_t runs = 0;

 private:
  Scene scene_;
};

/// The largest modulus of a matrix's eigenvalues.
struct Modulus {
  double value;
  double doubt;
};

/// How far the eigenvalue λ of A moves with A is ‖x‖‖y‖/|yᵀx| times the change, to first order, with its right and left
/// eigenvectors x and y.
/// @param error  what the matrix may be off by, in the 2-norm
Modulus largest_modulus(const Eigen::MatrixXd& matrix, double error) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  const Eigen::MatrixXcd right = solver.eigenvectors();
  const Eigen::MatrixXcd left = right.inverse();
  const Eigen::ArrayXd condition = right.colwise().norm().transpose().array() * left.rowwise().norm().array();
  const Eigen::ArrayXd moduli = solver.eigenvalues().cwiseAbs().array();
  const double largest = moduli.maxCoeff();
  const double doubt = (moduli + error * condition).maxCoeff() - largest;  // another one may be the largest
  return {largest, std::isfinite(doubt) ? doubt : std::numeric_limits<double>::infinity()};
}

}  // namespace

int PeriodicOrbit::growth() const {
  const double beyond = largest_multiplier - 1;
  if (!(std::abs(beyond) > multiplier_doubt)) return 0;
  return beyond < 0 ? -1 : 1;
}

PeriodicOrbit periodic_orbit(const Scene& scene, double period, double tolerance) {
  if (is_free_journal(scene)) {
    throw SceneError(scene.file +
                     ": a journal under constant loads has no period; allowed is a scene with a driver, a table or a "
                     "harmonic load, or the command equilibrium");
  }
  Shooting shooting(scene, period);
  const PlanarSystem<double> system = planar_system<double>(scene);
  PeriodicOrbit orbit;
  orbit.period = period;
  State y = shooting.on_constraints(scene_start<double>(scene));
  const FreeDirections free(scene, system, y);
  if (free.count() == 0) {
    throw SceneError(scene.file +
                     ": the drivers leave nothing free; allowed is a scene whose motion is not prescribed");
  }
  const State at_start = y;
  // Driven bodies begin every period as the first one; the free directions are those of the start.
  const auto renewed = [&](const State& end) {
    return shooting.on_constraints(free.moved(at_start, free.between(at_start, end)));
  };
  for (std::size_t i = 0; i < first_periods; ++i) y = renewed(shooting.after_period(y));
  State end = shooting.after_period(y);
  const auto slope_at = [&](double h) {
    Eigen::MatrixXd slope(free.count(), free.count());
    for (Eigen::Index k = 0; k < free.count(); ++k) {
      const State other = shooting.on_constraints(free.moved(y, h * Vector::Unit(free.count(), k)));
      slope.col(k) = free.between(end, shooting.after_period(other)) / h;
    }
    return slope;
  };
  while (true) {
    const Vector miss = free.between(y, end);
    orbit.miss = miss.cwiseAbs().maxCoeff();
    const Eigen::MatrixXd slope = slope_at(step_share);
    if (orbit.miss <= tolerance) {
      // Differences the other way: what both ways differ by is what the steps' length and the runs' errors leave.
      const Eigen::MatrixXd other = slope_at(-step_share);
      const Eigen::JacobiSVD<Eigen::MatrixXd> apart((slope - other) / 2);
      const double error = apart.singularValues()(0) + scene.run.relative_tolerance / step_share;
      const Modulus largest = largest_modulus((slope + other) / 2, error);
      orbit.largest_multiplier = largest.value;
      orbit.multiplier_doubt = largest.doubt;
      break;
    }
    if (++orbit.iterations > most_iterations) {
      std::ostringstream message;
      message
          << scene.file << ": no motion of period " << period << " s after " << most_iterations
          << " iterations, whose last left " << orbit.miss
          << " clearances between its ends; allowed is a start nearer to one, a looser tolerance, or another period";
      throw SceneError(message.str());
    }
    const Vector step =
        (Eigen::MatrixXd::Identity(free.count(), free.count()) - slope).colPivHouseholderQr().solve(miss);
    // A step that leaves a film is too long.
    for (double share = 1;; share /= 2) {
      try {
        const State next = shooting.on_constraints(free.moved(y, share * step));
        end = shooting.after_period(next);
        y = next;
        break;
      } catch (const SceneError&) {
        if (share < 0.01) throw;
      }
    }
  }
  orbit.state = y;
  orbit.runs = shooting.runs;
  return orbit;
}

}  // namespace lubjoint
