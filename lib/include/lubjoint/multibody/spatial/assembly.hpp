/// Before a run in space: are the constraints independent, and does the start fulfil them?
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/multibody/spatial/system.hpp"

namespace lubjoint {

/// What is done about constraints that repeat others, as those of most closed loops in space do.
enum class RedundantConstraints {
  refuse,  ///< the start is refused, with their names and the rank
  allow    ///< the run does without them: a largest independent set of rows is chosen once, at the start
};

/// A start on its constraints.
template <class R>
struct SpatialStart {
  StartCorrection<R> correction;      ///< what bringing the start onto the constraints has changed
  std::vector<std::size_t> left_out;  ///< rows that others imply, in order
  std::size_t rank = 0;               ///< of all rows
};

namespace detail {

/// S of a body with M⁻¹ = S Sᵀ, its part for ω′.
template <class R>
Matrix3<R> inverse_root(const Matrix3<R>& inertia) {
  const Matrix3<R> lower = inertia.llt().matrixL();
  return lower.transpose().template triangularView<Eigen::Upper>().solve(Matrix3<R>::Identity());
}

/// Φ_v S of an evaluated workspace: rows of comparable units.
template <class R>
DenseMatrix<R> scaled_constraint_matrix(const SpatialSystem<R>& system, const SpatialWorkspace<R>& w) {
  using std::sqrt;
  DenseMatrix<R> matrix = DenseMatrix<R>::Zero(static_cast<Eigen::Index>(system.constraint_rows()),
                                               static_cast<Eigen::Index>(system.velocities()));
  const auto put = [&](std::size_t row, std::size_t body, const std::array<R, 6>& columns) {
    if (body == ground_body) return;
    const R light = 1 / sqrt(system.bodies()[body].mass);
    const Vector3<R> turning =
        transposed_product(inverse_root(system.bodies()[body].inertia), Vector3<R>(columns[3], columns[4], columns[5]));
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto column = static_cast<Eigen::Index>(6 * body) + k;
      matrix(static_cast<Eigen::Index>(row), column) += columns[static_cast<std::size_t>(k)] * light;
      matrix(static_cast<Eigen::Index>(row), column + 3) += turning(k);
    }
  };
  for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
    put(row, system.first_body_of_row(row), w.rows[row].first);
    put(row, system.second_body_of_row(row), w.rows[row].second);
  }
  return matrix;
}

/// −S (Φ_v S)⁺ residual: the least change in the kinetic-energy norm.
template <class R>
std::vector<R> least_change(const SpatialSystem<R>& system, const DenseMatrix<R>& matrix,
                            const DenseVector<R>& residual) {
  using std::sqrt;
  Eigen::CompleteOrthogonalDecomposition<DenseMatrix<R>> decomposition;
  decomposition.setThreshold(R(1e-9));
  decomposition.compute(matrix);
  const DenseVector<R> step = decomposition.solve(residual);
  std::vector<R> change(system.velocities());
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const auto first = static_cast<Eigen::Index>(6 * b);
    const R light = 1 / sqrt(system.bodies()[b].mass);
    const Vector3<R> turning = product(inverse_root(system.bodies()[b].inertia),
                                       Vector3<R>(step(first + 3), step(first + 4), step(first + 5)));
    for (Eigen::Index k = 0; k < 3; ++k) {
      change[6 * b + static_cast<std::size_t>(k)] = -light * step(first + k);
      change[6 * b + 3 + static_cast<std::size_t>(k)] = -turning(k);
    }
  }
  return change;
}

template <class R>
std::string constraint_of_row(const SpatialSystem<R>& system, std::size_t row) {
  return "\"" + system.constraints()[system.constraint_of(row)].name + "\"";
}

/// How a row depends on others.
template <class R>
struct RowDependence {
  DenseVector<R> weights;  ///< of the others
  R share;                 ///< of the row that is new
};

template <class R>
RowDependence<R> dependence_of_row(const DenseMatrix<R>& matrix, Eigen::Index row,
                                   const std::vector<std::size_t>& others) {
  DenseVector<R> rest = matrix.row(row).transpose();
  const R size = rest.norm();
  RowDependence<R> result{DenseVector<R>::Zero(static_cast<Eigen::Index>(others.size())), R(1)};
  if (!others.empty()) {
    DenseMatrix<R> columns(matrix.cols(), static_cast<Eigen::Index>(others.size()));
    for (std::size_t k = 0; k < others.size(); ++k)
      columns.col(static_cast<Eigen::Index>(k)) = matrix.row(static_cast<Eigen::Index>(others[k])).transpose();
    result.weights = columns.colPivHouseholderQr().solve(rest);
    rest -= columns * result.weights;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) result.weights(k) *= columns.col(k).norm() / size;
  }
  result.share = size > 0 ? R(rest.norm() / size) : R(0);
  return result;
}

/// A constraint row counts as independent if more than this share of it is new.
inline constexpr double least_new_share = 1e-9;

/// Where a row of Φ_v depends on others, so must Φ_t and γ, or no velocities or accelerations fulfil them all.
/// @param units  of all rows: rad, or the size of the mechanism
/// @returns what they disagree on; empty if on nothing
template <class R>
std::string disagreement(const DenseMatrix<R>& matrix, const SpatialWorkspace<R>& w, std::size_t row,
                         const std::vector<std::size_t>& others, const RowDependence<R>& dependence,
                         const std::vector<R>& units) {
  using std::abs;
  const R size = matrix.row(static_cast<Eigen::Index>(row)).norm();
  const auto disagrees = [&](const auto& value) {
    R left = value(w.rows[row]);
    R of_terms = abs(left);
    R largest(0);  // rows across a plane of motion have nothing but rounding of the others
    for (std::size_t i = 0; i < w.rows.size(); ++i)
      largest = std::max<R>(largest, abs(value(w.rows[i])) / units[i] * units[row]);
    for (std::size_t k = 0; k < others.size(); ++k) {
      const R weight = dependence.weights(static_cast<Eigen::Index>(k));
      if (abs(weight) <= R(least_new_share)) continue;  // rounding
      const R term = weight * size / matrix.row(static_cast<Eigen::Index>(others[k])).norm() * value(w.rows[others[k]]);
      left -= term;
      of_terms += abs(term);
    }
    return abs(left) > R(1e-6) * of_terms + R(1e-10) * largest;
  };
  if (disagrees([](const SpatialRow<R>& r) { return r.time_rate; })) return "velocity";
  if (disagrees([](const SpatialRow<R>& r) { return r.gamma; })) return "acceleration";
  return {};
}

/// Throws for a row that depends on others: what it does, which those are, and the rank.
template <class R>
[[noreturn]] void refuse_row(const SpatialSystem<R>& system, std::size_t row, const std::vector<std::size_t>& others,
                             const RowDependence<R>& dependence, const std::string& disagreement, std::size_t rank,
                             const char* allowed) {
  using std::abs;
  std::ostringstream message;
  message << "constraint " << constraint_of_row(system, row);
  if (disagreement.empty()) {
    message << " repeats what others fix already";
  } else {
    message << " is conflicting: it demands another " << disagreement << " than others do";
  }
  std::vector<std::string> names;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::string name = constraint_of_row(system, others[k]);
    const bool takes_part = abs(dependence.weights(static_cast<Eigen::Index>(k))) > R(1e-6);
    if (takes_part && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (std::size_t i = 0; i < names.size(); ++i) message << (i ? ", " : ": ") << names[i];
  message << "; the constraints have " << system.constraint_rows() << " rows of rank " << rank
          << " at the start; allowed are " << allowed;
  throw ConstraintError(message.str());
}

/// Rows of a largest independent set, and those that are left out, both in order. Constraints are taken whole, drivers
/// first, whose efforts are what is asked for, then in their order: what closes a loop gives up rows, and not what
/// holds its links, whose other rows would have to do it by levers that a motion may turn away. Of one constraint the
/// row of which the most is new comes first (pivoting).
template <class R>
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> independent_rows(const SpatialSystem<R>& system,
                                                                               const DenseMatrix<R>& matrix) {
  std::vector<std::size_t> order;
  for (const bool drivers : {true, false}) {
    for (std::size_t c = 0; c < system.constraints().size(); ++c) {
      if (system.constraints()[c].is_driver() == drivers) order.push_back(c);
    }
  }
  std::vector<DenseVector<R>> basis;
  std::vector<std::size_t> kept, left_out;
  const auto rest_of = [&](std::size_t row) {
    DenseVector<R> rest = matrix.row(static_cast<Eigen::Index>(row)).transpose();
    const R size = rest.norm();
    if (!(size > 0)) return rest;
    rest /= size;
    for (int pass = 0; pass < 2; ++pass) {  // the second takes off what rounding left of the first
      for (const DenseVector<R>& each : basis) rest -= each.dot(rest) * each;
    }
    return rest;
  };
  for (const std::size_t c : order) {
    std::vector<std::size_t> rows;
    for (std::size_t row = system.first_row(c); row < system.first_row(c + 1); ++row) rows.push_back(row);
    while (!rows.empty()) {
      std::size_t best = 0;
      DenseVector<R> most = rest_of(rows[0]);
      for (std::size_t i = 1; i < rows.size(); ++i) {
        DenseVector<R> rest = rest_of(rows[i]);
        if (!(rest.norm() > most.norm())) continue;
        best = i;
        most.swap(rest);
      }
      if (!(most.norm() > R(least_new_share))) break;
      basis.push_back(most / most.norm());
      kept.push_back(rows[best]);
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(best));
    }
    left_out.insert(left_out.end(), rows.begin(), rows.end());
  }
  std::sort(kept.begin(), kept.end());
  std::sort(left_out.begin(), left_out.end());
  return {kept, left_out};
}

/// Values of the rows of an evaluated workspace.
/// @throws ConstraintError  that names a row that is not finite
template <class R>
DenseVector<R> finite_residual(const SpatialSystem<R>& system, const SpatialWorkspace<R>& w) {
  DenseVector<R> residual(static_cast<Eigen::Index>(w.rows.size()));
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    const SpatialRow<R>& row = w.rows[i];
    const auto is_finite = [](const R& x) { return std::isfinite(static_cast<double>(x)); };
    if (!is_finite(row.value) || !std::all_of(row.first.begin(), row.first.end(), is_finite) ||
        !std::all_of(row.second.begin(), row.second.end(), is_finite)) {
      throw ConstraintError("constraint " + constraint_of_row(system, i) +
                            " has no finite value near the start: what it measures is not defined there; allowed are "
                            "starts near a position that fulfils the constraints");
    }
    residual(static_cast<Eigen::Index>(i)) = row.value;
  }
  return residual;
}

/// A body that is held to the ground as a whole has one place: there it is put, because the rows of its orientation are
/// fulfilled by seven others as well, and steps from afar may come to those.
template <class R>
void place_held_bodies(const SpatialSystem<R>& system, R* y) {
  const std::size_t bodies = system.bodies().size();
  const auto axes = [](const BodyAxes<R>& at) {
    Matrix3<R> a;
    a << at.across, at.third(), at.axis;
    return a;
  };
  for (const NamedSpatialConstraint<R>& each : system.constraints()) {
    const auto* hold = std::get_if<FixedJoint<R>>(&each.constraint);
    if (hold == nullptr || (hold->first.body != ground_body && hold->second.body != ground_body)) continue;
    const bool of_second = hold->second.body != ground_body;
    const BodyAxes<R>& ground = of_second ? hold->first : hold->second;
    const BodyAxes<R>& held = of_second ? hold->second : hold->first;
    const Matrix3<R> a = axes(ground) * axes(held).transpose();
    EulerParameters<R> p = euler_parameters<R>(a);
    if (p.dot(spatial_motion_in(y, bodies, held.body).parameters) < 0) p = -p;
    const Vector3<R> position = ground.point - a * held.point;
    R* q = y + spatial_coordinates * held.body;
    std::copy(position.data(), position.data() + 3, q);
    std::copy(p.data(), p.data() + 4, q + 3);
  }
}

}  // namespace detail

/// Moves a start onto the constraints: Gauss–Newton steps of least kinetic-energy norm for places, one linear step for
/// velocities; Euler parameters are normalised. Rows that others imply are refused, or left out of the system.
/// @param length  the size of the mechanism, of which a relative 1e-9 counts as fulfilled, as 1e-9 rad does [m]
/// @throws ConstraintError  redundant constraints (with rank), rows that conflict with others, or no position fulfils
///   them all (with the worst)
template <class R>
SpatialStart<R> assemble_spatial_start(SpatialSystem<R>& system, const R& t, const R& length, std::vector<R>& y,
                                       RedundantConstraints redundant) {
  using detail::DenseVector;
  using std::abs;
  SpatialStart<R> result;
  const std::size_t bodies = system.bodies().size();
  const std::vector<R> given = y;
  system.displace(std::vector<R>(system.velocities(), R(0)), y.data());  // |p| = 1
  if (system.constraint_rows() == 0) return result;
  detail::place_held_bodies(system, y.data());
  system.leave_out({});
  SpatialWorkspace<R> w = system.template workspace<R>();
  const std::size_t rows = system.constraint_rows();
  std::vector<R> units;
  for (std::size_t row = 0; row < rows; ++row) units.push_back(system.row_is_length(row) ? length : R(1));
  DenseVector<R> residual;
  Eigen::Index worst = 0;
  // The largest share of a unit by which a row is open.
  const auto largest_open = [&] {
    return R(residual.cwiseAbs()
                 .cwiseQuotient(Eigen::Map<const DenseVector<R>>(units.data(), residual.size()))
                 .maxCoeff(&worst));
  };
  R size(0);
  for (int iteration = 0; iteration < 50; ++iteration) {
    system.evaluate_kinematics(t, y.data(), w);
    residual = detail::finite_residual(system, w);
    const R before = size;
    size = largest_open();
    // To rounding of angles, and of the mechanism's own size; the last step is taken anyway.
    if (size <= 4 * std::numeric_limits<R>::epsilon()) break;
    if (iteration > 8 && size < R(1e-9) && size >= before / 2) break;
    system.displace(detail::least_change(system, detail::scaled_constraint_matrix(system, w), residual), y.data());
  }
  system.evaluate_kinematics(t, y.data(), w);
  const detail::DenseMatrix<R> matrix = detail::scaled_constraint_matrix(system, w);
  residual = detail::finite_residual(system, w);
  size = largest_open();
  auto [kept, left_out] = detail::independent_rows(system, matrix);
  result.rank = kept.size();
  if (!(size <= R(1e-9))) {
    std::ostringstream message;
    message << "the constraints are conflicting: no position near the start fulfils them all, and the nearest leaves "
               "constraint "
            << detail::constraint_of_row(system, static_cast<std::size_t>(worst)) << " open by "
            << static_cast<double>(abs(residual(worst))) << " m or rad; the constraints have " << rows
            << " rows of rank " << result.rank << " there; allowed are constraints that don't contradict each other";
    throw ConstraintError(message.str());
  }
  for (std::size_t i = 0; i < rows; ++i) residual(static_cast<Eigen::Index>(i)) = system.constraint_rate(i, w);
  const std::vector<R> change = detail::least_change(system, matrix, residual);
  for (std::size_t i = 0; i < change.size(); ++i) y[system.places() + i] += change[i];
  system.evaluate_kinematics(t, y.data(), w);  // γ is of the velocities

  if (redundant == RedundantConstraints::refuse && !left_out.empty()) {
    std::vector<std::size_t> earlier;
    for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
      const auto dependence = detail::dependence_of_row(matrix, static_cast<Eigen::Index>(row), earlier);
      if (!(dependence.share > R(detail::least_new_share))) {
        detail::refuse_row(system, row, earlier, dependence,
                           detail::disagreement(matrix, w, row, earlier, dependence, units), result.rank,
                           "independent ones, or redundant = \"allow\"");
      }
      earlier.push_back(row);
    }
  }
  for (const std::size_t row : left_out) {
    const auto dependence = detail::dependence_of_row(matrix, static_cast<Eigen::Index>(row), kept);
    const std::string word = detail::disagreement(matrix, w, row, kept, dependence, units);
    if (!word.empty())
      detail::refuse_row(system, row, kept, dependence, word, result.rank, "constraints that don't contradict others");
  }
  system.leave_out(left_out);
  result.left_out = std::move(left_out);

  const auto larger = [](R& largest, const R& value) { largest = std::max<R>(largest, abs(value)); };
  for (std::size_t b = 0; b < bodies; ++b) {
    const SpatialMotion<R> before = spatial_motion_in(given.data(), bodies, b);
    const SpatialMotion<R> after = spatial_motion_in(y.data(), bodies, b);
    larger(result.correction.position, R((after.position - before.position).norm()));
    const EulerParameters<R> turned = after.parameters - normalised<R>(before.parameters);
    larger(result.correction.angle, R(2 * turned.norm()));  // of a small turn
    larger(result.correction.velocity, R((after.velocity - before.velocity).norm()));
    larger(result.correction.spin, R((after.body_spin - before.body_spin).norm()));
  }
  return result;
}

/// Projects a state back onto places and velocities that fulfil the constraints, in the kinetic-energy norm.
/// @throws SingularConstraints
template <class R>
void project_onto_constraints(const SpatialSystem<R>& system, const R& t, std::vector<R>& y, SpatialWorkspace<R>& w) {
  if (system.constraint_rows() == system.left_out().size()) return;
  std::vector<R> mu(system.constraint_rows());
  std::vector<R> change(system.velocities());
  for (int iteration = 0; iteration < 2; ++iteration) {
    system.evaluate_kinematics(t, y.data(), w);
    system.factorise(w);
    for (std::size_t i = 0; i < mu.size(); ++i) mu[i] = w.rows[i].value;
    system.solve_schur(w, mu.data());
    std::fill(change.begin(), change.end(), R(0));
    system.subtract_constraint_forces(w, mu.data(), change.data());
    system.displace(change, y.data());
  }
  system.evaluate_kinematics(t, y.data(), w);
  system.factorise(w);
  for (std::size_t i = 0; i < mu.size(); ++i) mu[i] = system.constraint_rate(i, w);
  system.solve_schur(w, mu.data());
  system.subtract_constraint_forces(w, mu.data(), y.data() + system.places());
}

}  // namespace lubjoint
