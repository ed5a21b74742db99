/// How large errors of states are.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// Units a_i + ρ |x_i| of the states, in which an error of 1 is a tolerance.
/// @tparam N  number of states, or run_time_size
template <class R, std::size_t N>
class ErrorScale {
 public:
  using State = StateOf<R, N>;  ///< x
  /// Of Eigen's matrices.
  static constexpr int dimension = N == run_time_size ? Eigen::Dynamic : static_cast<int>(N);
  using Vector = Eigen::Matrix<R, dimension, 1>;  ///< an error

  /// @param absolute  a;  @param relative  ρ;  @param integrals  how many of the last states don't count
  ErrorScale(State absolute, const R& relative, std::size_t integrals)
      : absolute_(std::move(absolute)),
        relative_(relative),
        controlled_(static_cast<Eigen::Index>(absolute_.size() - integrals)),
        units_(Vector::Zero(static_cast<Eigen::Index>(absolute_.size()))) {}

  void leave_relative_out() { relative_ = R(0); }  ///< ρ = 0

  /// Takes the units at x.
  void take(const State& x) {
    using std::abs;
    for (std::size_t i = 0; i < x.size(); ++i)
      units_(static_cast<Eigen::Index>(i)) = absolute_[i] + relative_ * abs(x[i]);
  }

  Eigen::Index states() const { return static_cast<Eigen::Index>(absolute_.size()); }  ///< all
  Eigen::Index controlled() const {
    return N == run_time_size ? controlled_ : states();
  }  ///< number of those that count

  /// Σ (v_i/unit)² of those that count.
  R square(const Vector& v) const {
    if constexpr (N == run_time_size) {
      return v.head(controlled_).cwiseQuotient(units_.head(controlled_)).squaredNorm();
    } else {
      return v.cwiseQuotient(units_).squaredNorm();
    }
  }

 private:
  State absolute_;
  R relative_;
  Eigen::Index controlled_;
  Vector units_;
};

}  // namespace lubjoint
