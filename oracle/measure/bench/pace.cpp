#include "oracle/measure/bench/pace.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/measure/timing.hpp"
#include "oracle/mechanisms/processor_time.hpp"

namespace lubjoint::reports {

namespace {
constexpr Eigen::Index size = 8;
constexpr int times = 50;
constexpr int looks = 25;  ///< of which the median is what is usual
}  // namespace

Pace::Pace() : matrix_(Eigen::MatrixXd::Random(size, size)), vector_(Eigen::VectorXd::Ones(size)) {
  matrix_.diagonal().array() += static_cast<double>(size);
  std::vector<double> all;
  for (int i = 0; i < looks; ++i) all.push_back(seconds());
  usual_ = median_of(all);
}

double Pace::now() { return seconds() / usual_; }

double Pace::seconds() {
  double least = INFINITY;  // the first finds the caches cold, and another one may be interrupted
  for (int trial = 0; trial < 4; ++trial) {
    const double begin = mechanisms::processor_seconds();
    for (int i = 0; i < times; ++i) {
      const Eigen::VectorXd solution = matrix_.partialPivLu().solve(vector_);
      vector_ = 1 + (solution.array().square() + 1).sqrt() / 8 + solution.array().sin();
    }
    least = std::min(least, mechanisms::processor_seconds() - begin);
  }
  return least;
}

}  // namespace lubjoint::reports
