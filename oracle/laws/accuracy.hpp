/// How many of a law's digits are right, by ε.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// Errors of one law at one ε over directions of motion, in double precision with exact inputs.
struct AccuracyRow {
  std::string law;
  double eccentricity_ratio;
  double one_minus_ratio;  ///< 1 − ε, exact
  double max_ulp;       ///< largest error of a component, in ulp of the sum of its terms' magnitudes (dynamic: of |F|)
  double rms_ulp;       ///< root mean square of the same
  double max_of_force;  ///< largest error over |F| [-]
};

/// Measures every law against 100-digit evaluation of the published forms.
/// @param directions  number of random directions of (a, b) at each ε, beside the eight axes and diagonals
std::vector<AccuracyRow> measure_accuracy(std::size_t directions, std::uint64_t seed);

/// The largest error of a law among rows with 1 − ε ≥ smallest.
double worst_ulp(const std::vector<AccuracyRow>& rows, const std::string& law, double smallest);
double worst_of_force(const std::vector<AccuracyRow>& rows, const std::string& law, double smallest);

std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

}  // namespace lubjoint::reports
