/// Before a run: are the constraints independent, and does the start fulfil them?
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/multibody/start_correction.hpp"

namespace lubjoint {

/// Constraints that repeat or contradict each other; the message names them and the rank.
class ConstraintError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace detail {

template <class R>
using DenseMatrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
template <class R>
using DenseVector = Eigen::Matrix<R, Eigen::Dynamic, 1>;

/// Φq M^{-1/2} of an evaluated workspace: rows of comparable units.
template <class R>
DenseMatrix<R> scaled_constraint_matrix(const PlanarSystem<R>& system, const SystemWorkspace<R>& w) {
  using std::sqrt;
  DenseMatrix<R> matrix = DenseMatrix<R>::Zero(static_cast<Eigen::Index>(system.constraint_rows()),
                                               static_cast<Eigen::Index>(system.coordinates()));
  const auto put = [&](std::size_t row, std::size_t body, const std::array<R, 3>& columns) {
    if (body == ground_body) return;
    for (std::size_t k = 0; k < 3; ++k) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(3 * body + k)) +=
          columns[k] * sqrt(system.inverse_mass(body)[k]);
    }
  };
  for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
    put(row, system.first_body_of_row(row), w.rows[row].first);
    put(row, system.second_body_of_row(row), w.rows[row].second);
  }
  return matrix;
}

template <class R>
std::string constraint_of_row(const PlanarSystem<R>& system, std::size_t row) {
  std::size_t c = 0;
  while (system.first_row(c + 1) <= row) ++c;
  return "\"" + system.constraints()[c].name + "\"";
}

/// Of a workspace whose positions and velocities fulfil the constraints as far as they can be.
/// @throws ConstraintError that names the first constraint that repeats others or is conflicting with them, those
///   others, and the rank
template <class R>
void require_independent(const PlanarSystem<R>& system, const DenseMatrix<R>& matrix, const SystemWorkspace<R>& w) {
  const Eigen::Index rows = matrix.rows();
  // A constraint row counts as independent if more than this share of it is new.
  const R least = R(1e-9);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const DenseMatrix<R> earlier = matrix.topRows(row).transpose();
    DenseVector<R> rest = matrix.row(row).transpose();
    const R size = rest.norm();
    DenseVector<R> weights;
    if (row > 0) {
      weights = earlier.colPivHouseholderQr().solve(rest);
      rest -= earlier * weights;
    }
    if (rest.norm() > least * size) continue;
    Eigen::ColPivHouseholderQR<DenseMatrix<R>> decomposition(matrix.transpose());
    decomposition.setThreshold(least);
    // Where Φq depends on other rows, so must Φ_t and γ, or no velocities or accelerations fulfil them all.
    const auto disagrees = [&](const auto& value) {
      R difference = value(w.rows[static_cast<std::size_t>(row)]);
      R size_of_terms = std::abs(static_cast<double>(difference));
      for (Eigen::Index k = 0; k < row; ++k) {
        if (std::abs(static_cast<double>(weights(k) * earlier.col(k).norm() / size)) <= 1e-9) continue;  // rounding
        const R term = weights(k) * value(w.rows[static_cast<std::size_t>(k)]);
        difference -= term;
        size_of_terms += std::abs(static_cast<double>(term));
      }
      return std::abs(static_cast<double>(difference)) > 1e-6 * static_cast<double>(size_of_terms);  // as below
    };
    std::ostringstream message;
    message << "constraint " << constraint_of_row(system, static_cast<std::size_t>(row));
    if (disagrees([](const ConstraintRow<R>& r) { return r.time_rate; })) {
      message << " is conflicting: it demands another velocity than others do";
    } else if (disagrees([](const ConstraintRow<R>& r) { return r.gamma; })) {
      message << " is conflicting: it demands another acceleration than others do";
    } else {
      message << " repeats what others fix already";
    }
    std::vector<std::string> others;
    for (Eigen::Index k = 0; k < row; ++k) {
      const bool takes_part = std::abs(static_cast<double>(weights(k) * earlier.col(k).norm() / size)) > 1e-6;
      const std::string name = constraint_of_row(system, static_cast<std::size_t>(k));
      if (takes_part && std::find(others.begin(), others.end(), name) == others.end()) others.push_back(name);
    }
    for (std::size_t i = 0; i < others.size(); ++i) message << (i ? ", " : ": ") << others[i];
    message << "; the constraints have " << rows << " rows of rank " << decomposition.rank()
            << " at the start; allowed are independent ones";
    throw ConstraintError(message.str());
  }
}

/// In systems of so many rows full decompositions take longer than a run.
inline constexpr std::size_t many_rows = 100;

/// Are the rows of an evaluated workspace independent beyond doubt, and is the Schur complement factorised? Each has
/// then more than 1e-4 (sine of its angle) that those before it have not; 1e-9 count.
template <class R>
bool has_many_clear_rows(const PlanarSystem<R>& system, SystemWorkspace<R>& w) {
  if (system.constraint_rows() < many_rows) return false;
  try {
    system.factorise(w);
  } catch (const SingularConstraints&) {
    return false;
  }
  return w.schur.least_share() > R(1e-8);
}

}  // namespace detail

/// Moves a start onto the constraints: Gauss–Newton steps of least kinetic-energy norm for q, one linear step for q̇.
/// @param length  the size of the mechanism, of which a relative 1e-9 counts as fulfilled [m]
/// @throws ConstraintError  redundant constraints (with rank), or no position fulfils them all (with the worst)
template <class R>
StartCorrection<R> assemble_start(const PlanarSystem<R>& system, const R& t, const R& length, std::vector<R>& y) {
  using std::abs;
  using std::hypot;
  StartCorrection<R> correction;
  if (system.constraint_rows() == 0) return correction;
  using detail::DenseVector;
  const std::size_t n = system.coordinates();
  const std::vector<R> start = y;
  SystemWorkspace<R> w = system.template workspace<R>();
  const auto scaled_step = [&](const DenseVector<R>& residual, R* x) {
    using std::sqrt;
    if (detail::has_many_clear_rows(system, w)) {  // the same step
      std::vector<R> mu(residual.data(), residual.data() + residual.size());
      w.schur.solve(mu.data());
      system.subtract_constraint_forces(w.rows, mu.data(), x);
      return;
    }
    const detail::DenseMatrix<R> matrix = detail::scaled_constraint_matrix(system, w);
    Eigen::CompleteOrthogonalDecomposition<detail::DenseMatrix<R>> decomposition;
    decomposition.setThreshold(R(1e-9));
    decomposition.compute(matrix);
    const DenseVector<R> step = decomposition.solve(residual);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] -= step(static_cast<Eigen::Index>(i)) * sqrt(system.inverse_mass(i / 3)[i % 3]);
    }
  };
  const auto rows = static_cast<Eigen::Index>(system.constraint_rows());
  DenseVector<R> residual(rows);
  Eigen::Index worst = 0;
  R size(0);
  for (int iteration = 0; iteration < 50; ++iteration) {
    system.evaluate_kinematics(t, y.data(), w);
    for (Eigen::Index i = 0; i < rows; ++i) residual(i) = w.rows[static_cast<std::size_t>(i)].value;
    const R before = size;
    size = residual.cwiseAbs().maxCoeff(&worst);
    // To rounding of the mechanism's own size; the last step is taken anyway.
    if (size <= 4 * std::numeric_limits<R>::epsilon() * length) break;
    if (iteration > 8 && size < R(1e-9) * length && size >= before / 2) break;
    scaled_step(residual, y.data());
  }
  system.evaluate_kinematics(t, y.data(), w);
  for (Eigen::Index i = 0; i < rows; ++i) residual(i) = w.rows[static_cast<std::size_t>(i)].value;
  size = residual.cwiseAbs().maxCoeff(&worst);
  if (!(size <= R(1e-9) * length)) {
    const detail::DenseMatrix<R> matrix = detail::scaled_constraint_matrix(system, w);
    Eigen::ColPivHouseholderQR<detail::DenseMatrix<R>> decomposition(matrix.transpose());
    decomposition.setThreshold(R(1e-9));
    std::ostringstream message;
    message << "the constraints are conflicting: no position near the start fulfils them all, and the nearest leaves "
               "constraint "
            << detail::constraint_of_row(system, static_cast<std::size_t>(worst)) << " open by "
            << static_cast<double>(size) << " m or rad; the constraints have " << rows << " rows of rank "
            << decomposition.rank() << " there; allowed are constraints that don't contradict each other";
    throw ConstraintError(message.str());
  }
  for (Eigen::Index i = 0; i < rows; ++i) residual(i) = system.constraint_rate(static_cast<std::size_t>(i), w);
  scaled_step(residual, y.data() + n);
  system.evaluate_kinematics(t, y.data(), w);  // γ is of the velocities
  if (!detail::has_many_clear_rows(system, w))
    detail::require_independent(system, detail::scaled_constraint_matrix(system, w), w);

  const auto larger = [](R& largest, const R& value) { largest = std::max<R>(largest, abs(value)); };
  for (std::size_t b = 0; b < n / 3; ++b) {
    const auto change = [&](std::size_t i) { return R(y[3 * b + i] - start[3 * b + i]); };
    larger(correction.position, hypot(change(0), change(1)));
    larger(correction.angle, change(2));
    larger(correction.velocity, hypot(change(n), change(n + 1)));
    larger(correction.spin, change(n + 2));
  }
  return correction;
}

/// Projects a state back onto positions and velocities that fulfil the constraints, in the kinetic-energy norm.
/// @returns the largest |Φ| before it
/// @throws SingularConstraints
template <class R>
R project_onto_constraints(const PlanarSystem<R>& system, const R& t, std::vector<R>& y, SystemWorkspace<R>& w) {
  using std::abs;
  R violation(0);
  const std::size_t rows = system.constraint_rows();
  if (rows == 0) return violation;
  std::vector<R> mu(rows);
  for (int iteration = 0; iteration < 2; ++iteration) {
    system.evaluate_kinematics(t, y.data(), w);
    system.factorise(w);
    for (std::size_t i = 0; i < rows; ++i) {
      mu[i] = w.rows[i].value;
      if (iteration == 0) violation = std::max<R>(violation, abs(mu[i]));
    }
    w.schur.solve(mu.data());
    system.subtract_constraint_forces(w.rows, mu.data(), y.data());
  }
  system.evaluate_kinematics(t, y.data(), w);
  system.factorise(w);
  for (std::size_t i = 0; i < rows; ++i) mu[i] = system.constraint_rate(i, w);
  w.schur.solve(mu.data());
  system.subtract_constraint_forces(w.rows, mu.data(), y.data() + system.coordinates());
  return violation;
}

/// Puts journals that slide back onto their lines, in place and in velocity, along what their tangential forces can do:
/// no other constraint is moved.
/// @param tolerance  nothing is done while every journal is within this many clearances of its line, and its velocity
///   across within as many times the rates of its motion along
/// @returns whether the state was changed
/// @throws FilmDomainError, SingularConstraints
template <class System, class R, class Workspace>
bool project_onto_slides(const System& system, const R& t, std::vector<R>& y, const std::vector<JointMemory<R>>& memory,
                         const R& tolerance, Workspace& w) {
  using std::abs;
  system.evaluate(t, y.data(), memory, w);
  if (w.slides.empty()) return false;
  R* const velocities = y.data() + system.places();
  const auto rate_across = [&](const auto& slide) {
    return R(detail::across_line(system, slide, [=](std::size_t i) -> const R& { return velocities[i]; }));
  };
  bool within = true;
  for (const auto& slide : w.slides) {
    const R allowed = tolerance * system.joint_in_plane(slide.joint).bearing.clearance();
    const JournalMotion<R>& motion = w.joints[slide.joint].kinematics.motion;
    const R turning = abs(motion.bearing_spin + motion.journal_spin) / 2;
    within = within && abs(slide.place.across) <= allowed &&
             abs(rate_across(slide)) <= allowed * turning + tolerance * abs(slide.place.rate);
  }
  if (within) return false;
  const auto count = static_cast<Eigen::Index>(w.slides.size());
  detail::DenseVector<R> open(count);
  std::vector<R> change(system.velocities());
  const auto find_change = [&] {
    const detail::DenseVector<R> by = w.slide_response.accelerations * w.slide_response.forces_for(open);
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = -by(static_cast<Eigen::Index>(i));
  };
  for (Eigen::Index k = 0; k < count; ++k) open(k) = w.slides[static_cast<std::size_t>(k)].place.across;
  find_change();
  system.displace(change, y.data());
  system.place(y.data(), w);
  system.place_slides(t, memory, w);
  for (Eigen::Index k = 0; k < count; ++k) open(k) = rate_across(w.slides[static_cast<std::size_t>(k)]);
  find_change();
  for (std::size_t i = 0; i < change.size(); ++i) velocities[i] += change[i];
  return true;
}

}  // namespace lubjoint
