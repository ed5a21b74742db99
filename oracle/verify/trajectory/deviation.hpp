/// How far a trajectory is from a reference in one signal, and what its error looks like.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/trajectory/signals.hpp"

namespace lubjoint::verify {

/// A signal of the reference, sampled more closely than it is judged, and how large an error may be.
struct Yardstick {
  Signal signal;
  Samples fine;
  std::size_t stride = 1;  ///< one sample in this many is judged, and the given trajectory's own times
  /// Largest error until this time of a run that is as accurate as asked for; one number a sample [SI].
  std::vector<double> sensitivity;
  double tolerance = 0;  ///< what is allowed beside sensitivity and interpolation [SI]

  /// The time from which sensitivity leaves nothing to judge: four times it is more than a tenth of the scale [s].
  double horizon() const;
};

/// Both trajectories in one signal, and what is allowed, at the times at which they are judged.
struct Deviation {
  Signal signal;
  std::vector<double> t;
  std::vector<std::vector<double>> given, expected;  ///< one list a component
  std::vector<double> allowed;                       ///< tolerance + 4 sensitivity + interpolation [SI]
  double judged_until = 0;
  double horizon = 0;     ///< of the yardstick
  std::size_t worst = 0;  ///< place of the largest error over what is allowed
  double excess = 0;      ///< that ratio
  double rms = 0;         ///< root mean square of the error [SI]

  bool agrees() const { return excess <= 1; }
  double error(std::size_t i) const;  ///< distance of the two vectors [SI]
};

/// The given trajectory, interpolated by piecewise cubics, against the reference: at the reference's times, where the
/// error that interpolation makes of a perfect trajectory on the given times is allowed for, and at its own times.
/// @throws UnjudgedError if it covers less than half of the reference's duration
Deviation deviation(const Yardstick& yardstick, const Trajectory& given);

/// What an error looks like, with the share of its root mean square that is explained so.
struct Explanation {
  std::string words;
  double share = 0;
  std::optional<double> delay = {};  ///< if it is a phase shift [s]
  std::string whose = {};            ///< if the columns hold what belongs to another body or joint
  bool opposite = false;             ///< sign
};

/// The simplest of a phase shift, a wrong sign, unit or axis, another body's columns, an amplitude error, an offset
/// that explains at least two thirds of the error; none if none does.
/// @param all  what the reference says about the others
std::optional<Explanation> explanation(const Deviation& deviation, const Trajectory& given,
                                       const std::vector<Yardstick>& all);

}  // namespace lubjoint::verify
