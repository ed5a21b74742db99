/// How a run ended, and what it cost.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lubjoint {

/// Did a run reach its end?
enum class RunStatus {
  finished,  ///< it did
  stopped    ///< it could not go on; what it has until then stands
};

/// How a run ended, and its counts.
struct RunOutcome {
  RunStatus status = RunStatus::finished;  ///< did it reach its end?
  std::string integrator;                  ///< that ran
  std::string integrator_reason;           ///< why it was chosen; empty if the scene names it
  std::string coordinates;                 ///< of a mechanism: "independent" or "absolute"; empty of a journal alone
  std::string coordinates_reason;          ///< why they were chosen; empty if the scene names them
  std::string message;              ///< why a run stopped: time, joint, ε, and what to change; empty if it finished
  double t_end = 0;                 ///< [s]
  std::size_t steps = 0;            ///< accepted
  std::size_t rejected_steps = 0;   ///< trial steps that were given up
  std::size_t rhs_evaluations = 0;  ///< of ẏ = f(y, t)
  std::size_t jacobian_evaluations = 0;  ///< of ∂f/∂y
  std::size_t factorisations = 0;        ///< of an implicit method's matrices
  std::size_t mode_changes = 0;          ///< events: half films that changed their mode, and contacts
};

/// So many trial steps for so small a share of the duration: a run that would never end. At that pace the default limit
/// of steps is reached after a hundredth of it.
inline constexpr std::size_t stall_limit = 4000;
inline constexpr double stall_share = 2e-6;  ///< of the duration

/// Tolerances and limits of a run.
struct RunSettings {
  double duration = 1;                 ///< [s]
  double relative_tolerance = 1e-8;    ///< of every state
  double absolute_tolerance = 1e-8;    ///< of positions, in clearances
  double output_interval = 1e-3;       ///< [s]
  bool stop_at_outputs = false;        ///< steps of a multibody run end at the output times: no sample is interpolated
  std::size_t max_steps = 20'000'000;  ///< accepted and rejected together
  /// Times at which derivatives of the equations jump, ascending: a step ends there, and the method starts anew [s].
  std::vector<double> knots = {};
};

}  // namespace lubjoint
