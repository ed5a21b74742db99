/// How far the Pinkus–Sternlicht law is from the film that it approximates.
#pragma once

#include <cstddef>
#include <vector>

namespace lubjoint::reports {

/// States of the comparison: every ε with directions of u spread evenly over a turn, at the middles of equal arcs.
struct DifferenceGrid {
  std::vector<double> eccentricity_ratios;  ///< each in [0, 1)
  std::size_t directions = 360;             ///< of the pure-squeeze velocity u = (b, −a/2)

  /// Middles of n equal parts of [0, last].
  static DifferenceGrid uniform(double last, std::size_t eccentricity_ratios, std::size_t directions);
};

/// One state and the difference there.
struct PinkusSternlichtDifference {
  double eccentricity_ratio;  ///< ε [-]
  double direction;           ///< of u from the eccentricity, counter-clockwise, in [0, 2π) [rad]
  double slip_rate;           ///< a = −2 sin(direction), |u| = 1 [1/s]
  double squeeze_rate;        ///< b = cos(direction) [1/s]
  double difference;          ///< |F_PS − F|/|F|, F: the long dynamic film by quadrature [-]
  double error;               ///< of the difference, from the quadrature's own estimate [-]
};

/// The difference at every state of a grid, ε outermost. It does not depend on the bearing, the oil or |u|.
/// @throws FilmDomainError if an ε is outside [0, 1); std::invalid_argument if there are no directions
std::vector<PinkusSternlichtDifference> pinkus_sternlicht_difference(const DifferenceGrid& grid);

/// Median and maximum of a set of differences.
struct DifferenceSummary {
  std::size_t states = 0;
  double median = 0;
  double largest = 0;
  double eccentricity_ratio_of_largest = 0;
};

enum class SqueezeSign { closing, opening };  ///< b > 0, b < 0

/// Summary over the states of one sign of b with ε below a bound.
DifferenceSummary summary_of(const std::vector<PinkusSternlichtDifference>& differences, SqueezeSign sign,
                             double eccentricity_ratio_below = 1);

}  // namespace lubjoint::reports
