/// Comparison of a journal's path with a reference path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::verify {

/// A journal's path at increasing times: eccentricity in clearances, force on the journal [N].
struct Path {
  std::vector<double> t;
  std::vector<double> ex, ey;
  std::vector<double> fx, fy;  ///< empty where they are not given
};

/// Reads the columns t, JOINT.ex, JOINT.ey and, if wanted and there, JOINT.fx, JOINT.fy.
/// @throws UnjudgedError for a missing column, a field that is no number, times that don't increase, under five rows
Path read_path(std::string_view csv, const std::string& name, const std::string& joint, double clearance);

/// How far a path is from the reference, at the reference's times within the path's; the path between its own times is
/// interpolated by piecewise cubics (modified Akima).
struct PathComparison {
  std::size_t times = 0;
  double worst = 0;       ///< largest distance between the centres [clearances]
  double worst_time = 0;  ///< [s]
  double mean = 0;        ///< root mean square of the distance [clearances]
  double force = 0;       ///< largest difference of the forces [N]; 0 if none are given
  double delay = 0;       ///< by which the path is late where that fits best [s], at most a tenth of the duration
  double mean_without_delay = 0;
  double amplitude = 1;  ///< factor of the path about the reference's mean that fits best
  double mean_without_amplitude = 0;

  bool agrees(double tolerance) const { return worst <= tolerance; }
  /// One sentence: a phase shift, an amplitude error, or neither alone.
  std::string words() const;
};

/// @throws UnjudgedError if the path covers less than half of the reference's duration
PathComparison compare_paths(const Path& reference, const Path& path);

}  // namespace lubjoint::verify
