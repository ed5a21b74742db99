/// A scene in one formulation, as the integrators' race runs it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// One run of one integrator at one tolerance.
struct MethodRun {
  bool finished = false;
  std::string message;  ///< why it stopped
  double error = 0;  ///< largest |e − e_ref| over c at the reference's times (no joint: of a coordinate, over its unit)
  double seconds = 0;  ///< median of the repeats, integration alone
  std::size_t steps = 0;
  std::size_t rejected = 0;
  std::size_t rhs_evaluations = 0;
  std::size_t jacobian_evaluations = 0;
  std::size_t factorisations = 0;
};

/// When a run is given up.
struct BenchLimits {
  int repeats = 9;
  double seconds = 10;  ///< of one run
};

/// The integrators that are raced: those of the library, and SUNDIALS' if it was built in.
std::vector<std::string> raced_methods();

/// Where a trajectory is at the reference's times, in clearances.
using Reference = std::vector<Vector2<double>>;

/// An initial value problem without events, and what is looked at.
class BenchCase {
 public:
  virtual ~BenchCase() = default;
  virtual std::string formulation() const = 0;  ///< journal, minimal or absolute
  /// Those of raced_methods() that this case can be given.
  virtual std::vector<std::string> methods() const = 0;
  virtual MethodRun run(const std::string& method, double tolerance, const BenchLimits& limits) = 0;
};

/// Times at which errors are looked at.
std::vector<double> bench_times(const Scene& scene);

struct BenchScene {
  std::string name;
  std::vector<std::unique_ptr<BenchCase>> cases;
  double reference_agreement = 0;  ///< largest difference of the two references, as errors are measured
};

/// The formulations of a scene, with references by two integrators of different families in extended precision.
/// @throws SceneError, std::invalid_argument
BenchScene bench_scene(const Scene& scene);

}  // namespace lubjoint::reports
