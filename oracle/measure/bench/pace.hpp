/// The machine's speed, which others on it change.
#pragma once

#include <Eigen/Core>

namespace lubjoint::reports {

/// Measures how fast the machine is beside what it was: by the processor time of some 50 microseconds of work of the
/// kind that races are made of, factors and solutions of small matrices, roots and sines; the least of four.
class Pace {
 public:
  Pace();
  /// Time of the work now over that of the start: above 1, the machine is slower.
  double now();

 private:
  double seconds();

  Eigen::MatrixXd matrix_;
  Eigen::VectorXd vector_;
  double usual_;
};

}  // namespace lubjoint::reports
