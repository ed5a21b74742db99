/// Error against time of the oracle's quadrature rules and of the finite-length film.
#pragma once

#include <string>
#include <vector>

namespace lubjoint::reports {

/// One rule on one film at one ε with one tolerance: medians over directions of motion and repeats.
struct QuadratureTiming {
  std::string film;
  std::string rule;
  double one_minus_ratio;  ///< 1 − ε
  double tolerance;
  double error;         ///< largest true error over |F|, against 100 digits (finite films: a tolerance of 1e-6)
  double estimate;      ///< largest estimated error over |F|
  double microseconds;  ///< median of one force
};

/// @param quick  fewer films, ε and repeats
std::vector<QuadratureTiming> time_quadrature(bool quick);
std::vector<QuadratureTiming> time_finite_length(bool quick);

std::string quadrature_csv(const std::vector<QuadratureTiming>& rows);
std::string quadrature_table(const std::vector<QuadratureTiming>& rows);

}  // namespace lubjoint::reports
