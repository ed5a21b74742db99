/// Eigenvalues of a rigid rotor on its films: the other way to its threshold.
#pragma once

#include <Eigen/Eigenvalues>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "lubjoint/film/rotor_threshold.hpp"

namespace lubjoint {

/// The motion that decays slowest, or grows fastest.
template <class R>
struct RotorMode {
  R growth;     ///< largest real part of the eigenvalues [1/s]
  R frequency;  ///< its imaginary part's magnitude [rad/s]
};

/// Leading eigenvalue of a rotor of mass m. Time is counted in units of `rate` inside, so that no unit of the caller's
/// spoils the balance of the matrix.
template <class R>
RotorMode<R> leading_mode(const Eigen::Matrix<R, 2, 2>& k, const Eigen::Matrix<R, 2, 2>& c, const R& mass,
                          const R& rate) {
  using std::abs;
  Eigen::Matrix<R, 4, 4> a = Eigen::Matrix<R, 4, 4>::Zero();
  a.template topRightCorner<2, 2>().setIdentity();
  a.template bottomLeftCorner<2, 2>() = -k / R(mass * rate * rate);
  a.template bottomRightCorner<2, 2>() = -c / R(mass * rate);
  const Eigen::EigenSolver<Eigen::Matrix<R, 4, 4>> solver(a, false);
  RotorMode<R> mode{-std::numeric_limits<R>::infinity(), R(0)};
  for (int i = 0; i < 4; ++i) {
    const auto value = solver.eigenvalues()(i);
    if (value.real() > mode.growth) mode = {value.real(), R(abs(value.imag()))};
  }
  return {R(mode.growth * rate), R(mode.frequency * rate)};
}

/// The threshold by eigenvalues alone: the mass at which the leading one crosses the imaginary axis.
/// @param unit  a mass to start from; searched are 1e-6 to 1e6 of it;  @param rate  [1/s], e.g. the spin
/// @returns an infinite mass if all that were looked at are stable, 0 if none is
template <class R>
RotorThreshold<R> eigenvalue_threshold(const Eigen::Matrix<R, 2, 2>& k, const Eigen::Matrix<R, 2, 2>& c, const R& unit,
                                       const R& rate) {
  using std::exp;
  using std::log;
  const auto mass_at = [&](const R& x) { return R(unit * exp(x)); };
  const auto growth = [&](const R& x) { return leading_mode<R>(k, c, mass_at(x), rate).growth; };
  const R decade = log(R(10));
  for (int i = -6; i <= 6; ++i) {
    if (!(growth(R(i * decade)) > 0)) continue;
    if (i == -6) return {R(0), leading_mode<R>(k, c, mass_at(R(i * decade)), rate).frequency};
    std::uintmax_t iterations = 200;
    const boost::math::tools::eps_tolerance<R> tolerance(std::numeric_limits<R>::digits - 1);
    const auto bracket =
        boost::math::tools::toms748_solve(growth, R((i - 1) * decade), R(i * decade), tolerance, iterations);
    const R mass = mass_at(R((bracket.first + bracket.second) / 2));
    return {mass, leading_mode<R>(k, c, mass, rate).frequency};
  }
  return {std::numeric_limits<R>::infinity(), std::nullopt};
}

}  // namespace lubjoint
