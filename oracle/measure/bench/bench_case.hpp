/// A scene in one formulation, as the integrators' race runs it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/scene/scene.hpp"
#include "oracle/trajectories/reference.hpp"

namespace lubjoint::reports {

/// One run of one integrator at one tolerance.
struct MethodRun {
  bool finished = false;
  std::string message;  ///< why it stopped
  double error = 0;     ///< largest distance from the reference at its times, see Reference
  double seconds = 0;   ///< processor time: median of the repeats, integration alone, at the usual pace
  double spread = 0;    ///< of the repeats: between their quartiles, over the median
  std::size_t steps = 0;
  std::size_t rejected = 0;
  std::size_t rhs_evaluations = 0;
  std::size_t jacobian_evaluations = 0;
  std::size_t factorisations = 0;
};

/// The message of a run that took longer than it may.
inline constexpr std::string_view out_of_time = "given up after its share of time";

/// When a run is given up.
struct BenchLimits {
  int repeats = 9;
  double seconds = 1;  ///< of processor time: of one run, and of the repeats from the third on
  /// How slow the machine is now, beside what is usual: each repeat's time is divided by it. None: by nothing.
  std::function<double()> pace = {};
};

/// The integrators that are raced: those of the library, SUNDIALS' and Simbody's if they were built in.
std::vector<std::string> raced_methods();

/// An initial value problem in plain numbers.
struct PlainProblem {
  std::vector<double> start;
  std::vector<double> absolute_tolerance;  ///< of each state
  double relative_tolerance = 0;
  double duration = 0;
  bool second_order = false;  ///< y = (q, q̇), and the Jacobian's upper half is [0 I]
  std::vector<double> times;  ///< to observe; none: when it is timed
  std::function<void(double t, const double* y, double* dydt)> rate;  ///< std::domain_error: the step is too long
  std::function<void(double t, const double* y, double* jacobian)> jacobian;  ///< ∂f/∂y column by column, likewise
  std::function<void(double t, const double* y)> observe;
};

/// A scene without events, and what is looked at.
class BenchCase {
 public:
  virtual ~BenchCase() = default;
  /// journal, minimal, absolute, independent, embedded (a planar mechanism as one in space) or joint
  virtual std::string formulation() const = 0;
  /// Those of raced_methods() that this case can be given.
  virtual std::vector<std::string> methods() const = 0;
  virtual MethodRun run(const std::string& method, double tolerance, const BenchLimits& limits) = 0;
  /// The problem as another's solver is given it; nothing where none is.
  virtual std::optional<PlainProblem> plain_problem(double) { return std::nullopt; }
};

/// Runs once with a look at the reference's times, for the error; then again and again for the time alone.
/// @param once  a run; with somewhere to put what it sees, it looks
MethodRun measured_run(const BenchLimits& limits, const Reference& reference,
                       const std::function<MethodRun(Reference* seen)>& once);

/// Times at which errors are looked at where there is no golden trajectory.
std::vector<double> bench_times(double duration);

struct BenchScene {
  std::string name;
  std::vector<std::unique_ptr<BenchCase>> cases;
  bool golden = false;             ///< the reference is the golden trajectory
  double reference_agreement = 0;  ///< largest difference of the reference's two methods, as errors are measured
};

/// The formulations of a scene. The reference of a scene that ships is its golden trajectory; of any other, two
/// integrators of different families in extended precision.
/// @throws SceneError, std::invalid_argument
BenchScene bench_scene(const Scene& scene);

}  // namespace lubjoint::reports
