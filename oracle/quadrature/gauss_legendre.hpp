/// Fixed Gauss–Legendre rules.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracle/quadrature/estimate.hpp"
#include "oracle/quadrature/integrand.hpp"

namespace lubjoint::oracle {

/// Nodes and weights on [−1, 1]; exact for polynomials up to degree 2n − 1.
class GaussLegendreRule {
 public:
  /// The zeros of the Legendre polynomial, correctly rounded, and 2/((1 − x²) P'²) to three units roundoff.
  /// @param points  1 to 1024
  /// @throws std::invalid_argument for any other number
  explicit GaussLegendreRule(std::size_t points);

  std::size_t size() const { return nodes_.size(); }
  const std::vector<double>& nodes() const { return nodes_; }
  const std::vector<double>& weights() const { return weights_; }

  /// ∫ f over [from, to]
  double integrate(const Integrand& f, double from, double to) const;

 private:
  std::vector<double> nodes_;
  std::vector<double> weights_;
};

/// Numbers of points of the rules that follow each other as an integral is refined.
inline constexpr std::array<std::size_t, 8> gauss_legendre_ladder = {16, 32, 64, 96, 128, 256, 512, 1024};

/// The rule on one rung of the ladder; made at its first use and shared by all threads.
const GaussLegendreRule& gauss_legendre_rung(std::size_t rung);

/// ∫ f over [from, to] by the first rule of the ladder that agrees with the one before it. The error is that
/// difference, which belongs to the coarser rule, plus the rounding of the sum: an upper bound for analytic integrands.
/// @throws QuadratureError if 1024 points do not reach the tolerance
Estimate gauss_legendre(const Integrand& f, double from, double to, const Tolerance& tolerance);

}  // namespace lubjoint::oracle
