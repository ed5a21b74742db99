/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/multibody/constraint_chart.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"

namespace lubjoint {

/// z = (q_i, q̇_i) and, with a ledger, the work of each term, for the independent coordinates q_i of a chart. The others
/// follow: q_d by Newton's method on Φ = 0, q̇_d from Φ_d q̇_d = −Φ_i q̇_i − Φ_t, both to rounding, and with
///   V = [I; −Φ_d⁻¹Φ_i],  w = [0; Φ_d⁻¹γ]:   VᵀMV q̈_i = Vᵀ(g − Mw),  q̈ = V q̈_i + w.
/// Multipliers are solved for where the ledger wants them. Derivatives are exact: those of q_d and q̇_d by implicit
/// differentiation.
template <class R>
class IndependentOde final : public OdeSystem<R, run_time_size> {
 public:
  using State = std::vector<R>;                   ///< z
  using Jacobian = JacobianOf<R, run_time_size>;  ///< ∂ż/∂z
  /// A number with the derivatives of one pass.
  using Seeded = typename MultibodyOde<R>::Seeded;

  /// @param units  in which the coordinates are comparable, such as their tolerances
  IndependentOde(MultibodyOde<R>& ode, const std::vector<R>& units)
      : ode_(ode),
        system_(ode.system()),
        n_(system_.coordinates()),
        m_(system_.constraint_rows()),
        chart_(system_, units),
        w_(system_.template workspace<R>()),
        dual_(system_.template workspace<Seeded>()),
        y_(ode.dimension()),
        residual_(m_),
        step_(m_),
        sizes_(n_) {}

  const ConstraintChart<R>& chart() const { return chart_; }                       ///< the present one
  std::size_t freedoms() const { return n_ - m_; }                                 ///< number of q_i
  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - 2 * n_; }  ///< number of z

  /// Chooses coordinates at a state that fulfils the constraints. @throws std::domain_error where there is no choice
  void choose(const R& t, const State& y) {
    system_.evaluate_kinematics(t, y.data(), w_);
    if (!chart_.choose(w_.rows)) throw std::domain_error("the constraints determine no independent coordinates");
    using std::abs;
    R length(0);
    for (std::size_t i = 0; i < n_; ++i) {
      if (i % 3 != 2) length = std::max<R>(length, abs(y[i]));
    }
    for (std::size_t i = 0; i < n_; ++i) sizes_[i] = i % 3 == 2 ? R(1) : length;
  }

  /// z of a whole state; its dependent coordinates are where the next search starts.
  void take(const State& y, State& z) {
    const auto& independent = chart_.independent();
    const std::size_t f = independent.size();
    z.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      z[k] = y[independent[k]];
      z[f + k] = y[n_ + independent[k]];
    }
    std::copy(y.begin() + static_cast<std::ptrdiff_t>(2 * n_), y.end(), z.begin() + static_cast<std::ptrdiff_t>(2 * f));
    std::copy(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_), y_.begin());
  }

  /// The whole state of z. @throws std::domain_error where no positions near the last ones fulfil the constraints
  void expand(const R& t, const State& z, State& y) {
    follow(t, z);
    const std::size_t f = freedoms();
    std::copy(z.begin() + static_cast<std::ptrdiff_t>(2 * f), z.end(), y_.begin() + static_cast<std::ptrdiff_t>(2 * n_));
    y = y_;
  }

  /// Accelerations of all coordinates at the state of the last expansion, from those of the independent ones.
  /// @param z_rate  (q̇_i, q̈_i, powers); @param y_rate  (q̇, q̈, powers), of its size
  void expand_rate(const State& z_rate, State& y_rate) {
    const auto& independent = chart_.independent();
    const std::size_t f = independent.size();
    for (std::size_t row = 0; row < m_; ++row) {
      residual_[row] = w_.rows[row].gamma;
      for (std::size_t k = 0; k < f; ++k) residual_[row] -= column(w_.rows, row, independent[k]) * z_rate[f + k];
    }
    chart_.solve(residual_.data(), step_.data());
    for (std::size_t k = 0; k < f; ++k) y_rate[n_ + independent[k]] = z_rate[f + k];
    for (std::size_t k = 0; k < m_; ++k) y_rate[n_ + chart_.dependent()[k]] = step_[k];
  }

  void rate(const State& z, State& dzdt, const R& t) override {
    ode_.count_evaluation();
    follow(t, z);
    const auto& independent = chart_.independent();
    const std::size_t f = independent.size();
    system_.apply_forces(ode_.memory(), w_);
    if (w_.slides.empty()) {
      accelerate();
    } else {
      system_.evaluate(t, y_.data(), ode_.memory(), w_);
    }
    for (std::size_t k = 0; k < f; ++k) {
      dzdt[k] = z[f + k];
      dzdt[f + k] = w_.accelerations[independent[k]];
    }
    if (ode_.with_ledger()) {
      if (w_.slides.empty()) find_multipliers();
      ode_.fill_powers(y_, w_, &dzdt[2 * f]);
    }
  }

  void jacobian(const State& z, Jacobian& j, const R& t) override {
    follow(t, z);
    derivatives_.fill([&](const auto& x, auto& dxdt) { fill(R(t), x, dxdt); }, z, 2 * freedoms(), j);
  }

  void time_slope(const State& z, State& slope, const R& t) override {
    follow(t, z);
    derivatives_.fill_time_slope([&](const auto& x, auto& dxdt, const Seeded& s) { fill(s, x, dxdt); }, z, t, slope);
  }

 private:
  static R column(const std::vector<ConstraintRow<R>>& rows, const PlanarSystem<R>& system, std::size_t row,
                  std::size_t coordinate) {
    const std::size_t body = coordinate / 3;
    R sum(0);
    if (system.first_body_of_row(row) == body) sum += rows[row].first[coordinate % 3];
    if (system.second_body_of_row(row) == body) sum += rows[row].second[coordinate % 3];
    return sum;
  }
  R column(const std::vector<ConstraintRow<R>>& rows, std::size_t row, std::size_t coordinate) const {
    return column(rows, system_, row, coordinate);
  }

  /// y = (q, q̇) of z to rounding, with the rows there and factors of Φ_d.
  void follow(const R& t, const State& z) {
    using std::abs;
    const auto& independent = chart_.independent();
    const auto& dependent = chart_.dependent();
    const std::size_t f = independent.size();
    for (std::size_t k = 0; k < f; ++k) {
      y_[independent[k]] = z[k];
      y_[n_ + independent[k]] = z[f + k];
    }
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      system_.evaluate_kinematics(t, y_.data(), w_);
      if (m_ == 0) return;
      for (std::size_t row = 0; row < m_; ++row) residual_[row] = w_.rows[row].value;
      if (iteration > 3) chart_.factorise(w_.rows);
      chart_.solve(residual_.data(), step_.data());
      R size(0);
      for (std::size_t k = 0; k < m_; ++k) size = std::max<R>(size, abs(step_[k]) / sizes_[dependent[k]]);
      const R rounding = 4 * std::numeric_limits<R>::epsilon();
      if (size <= rounding) break;  // the rows are those of this place
      if (!(size < 1) || iteration == most_iterations) {
        throw std::domain_error("no positions near the last ones fulfil the constraints");
      }
      if (iteration > 0 && size >= before && size < 1000 * rounding) break;  // as near as rounding lets it come
      before = size;
      for (std::size_t k = 0; k < m_; ++k) y_[dependent[k]] -= step_[k];
    }
    chart_.factorise(w_.rows);
    for (std::size_t row = 0; row < m_; ++row) {
      residual_[row] = -w_.rows[row].time_rate;
      for (std::size_t k = 0; k < f; ++k) residual_[row] -= column(w_.rows, row, independent[k]) * z[f + k];
    }
    chart_.solve(residual_.data(), step_.data());
    for (std::size_t k = 0; k < m_; ++k) y_[n_ + dependent[k]] = step_[k];
    system_.evaluate_kinematics(t, y_.data(), w_);  // γ and frames have the velocities
  }

  void accelerate() {
    const auto& independent = chart_.independent();
    const auto& dependent = chart_.dependent();
    const std::size_t f = independent.size();
    v_.resize(f * m_);
    for (std::size_t k = 0; k < f; ++k) {
      for (std::size_t row = 0; row < m_; ++row) residual_[row] = -column(w_.rows, row, independent[k]);
      chart_.solve(residual_.data(), &v_[k * m_]);
    }
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = w_.rows[row].gamma;
    chart_.solve(residual_.data(), step_.data());
    reduced_.resize(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(f));
    right_.resize(static_cast<Eigen::Index>(f));
    for (std::size_t a = 0; a < f; ++a) {
      const R* va = &v_[a * m_];
      R right = w_.forces[independent[a]];
      for (std::size_t k = 0; k < m_; ++k) right += va[k] * (w_.forces[dependent[k]] - mass(dependent[k]) * step_[k]);
      right_(static_cast<Eigen::Index>(a)) = right;
      for (std::size_t b = 0; b <= a; ++b) {
        const R* vb = &v_[b * m_];
        R sum = a == b ? mass(independent[a]) : R(0);
        for (std::size_t k = 0; k < m_; ++k) sum += va[k] * mass(dependent[k]) * vb[k];
        reduced_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = sum;
      }
    }
    Eigen::internal::llt_inplace<R, Eigen::Lower>::unblocked(reduced_);
    reduced_.template triangularView<Eigen::Lower>().solveInPlace(right_);
    reduced_.template triangularView<Eigen::Lower>().transpose().solveInPlace(right_);
    for (std::size_t a = 0; a < f; ++a) w_.accelerations[independent[a]] = right_(static_cast<Eigen::Index>(a));
    for (std::size_t k = 0; k < m_; ++k) {
      R sum = step_[k];
      for (std::size_t a = 0; a < f; ++a) sum += v_[a * m_ + k] * right_(static_cast<Eigen::Index>(a));
      w_.accelerations[dependent[k]] = sum;
    }
  }

  /// Φ_dᵀ λ = g_d − M_d q̈_d
  void find_multipliers() {
    const auto& dependent = chart_.dependent();
    for (std::size_t k = 0; k < m_; ++k) {
      residual_[k] = w_.forces[dependent[k]] - mass(dependent[k]) * w_.accelerations[dependent[k]];
    }
    chart_.solve_transposed(residual_.data(), w_.multipliers.data());
  }

  R mass(std::size_t coordinate) const {
    const PlanarBody<R>& body = system_.bodies()[coordinate / 3];
    return coordinate % 3 == 2 ? body.inertia : body.mass;
  }

  /// Rates with derivatives, at the place of the last follow.
  template <class Time>
  void fill(const Time& t, const std::vector<Seeded>& z, std::vector<Seeded>& dzdt) {
    const auto& independent = chart_.independent();
    const auto& dependent = chart_.dependent();
    const std::size_t f = independent.size();
    seeded_.assign(y_.begin(), y_.end());
    for (std::size_t k = 0; k < f; ++k) {
      seeded_[independent[k]] = z[k];
      seeded_[n_ + independent[k]] = z[f + k];
    }
    // One Newton step each, on the derivatives alone: the values fulfil both already.
    using Derivatives = std::decay_t<decltype(std::declval<Seeded>().derivatives())>;
    std::vector<Derivatives> right(m_), change(m_);
    if (m_ > 0) {
      system_.evaluate_kinematics(t, seeded_.data(), dual_);
      for (std::size_t row = 0; row < m_; ++row) right[row] = dual_.rows[row].value.derivatives();
      chart_.solve(right.data(), change.data());
      for (std::size_t k = 0; k < m_; ++k) seeded_[dependent[k]] = Seeded(y_[dependent[k]], Derivatives(-change[k]));
      system_.evaluate_kinematics(t, seeded_.data(), dual_);
      for (std::size_t row = 0; row < m_; ++row) right[row] = system_.constraint_rate(row, dual_).derivatives();
      chart_.solve(right.data(), change.data());
      for (std::size_t k = 0; k < m_; ++k) {
        seeded_[n_ + dependent[k]] = Seeded(y_[n_ + dependent[k]], Derivatives(-change[k]));
      }
    }
    system_.evaluate(t, seeded_.data(), ode_.memory(), dual_);
    for (std::size_t k = 0; k < f; ++k) {
      dzdt[k] = z[f + k];
      dzdt[f + k] = dual_.accelerations[independent[k]];
    }
    if (ode_.with_ledger()) ode_.fill_powers(seeded_, dual_, &dzdt[2 * f]);
  }

  static constexpr int most_iterations = 12;

  MultibodyOde<R>& ode_;
  const PlanarSystem<R>& system_;
  std::size_t n_, m_;
  ConstraintChart<R> chart_;
  SystemWorkspace<R> w_;
  SystemWorkspace<Seeded> dual_;
  State y_;
  std::vector<R> residual_, step_, sizes_, v_;
  std::vector<Seeded> seeded_;
  Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic> reduced_;
  Eigen::Matrix<R, Eigen::Dynamic, 1> right_;
  RunTimeJacobian<MultibodyOde<R>::jacobian_group, R> derivatives_;
};

}  // namespace lubjoint
