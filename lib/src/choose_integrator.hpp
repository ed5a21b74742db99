/// The choice behind the integrator "auto".
#pragma once

#include <Eigen/Core>
#include <string>

#include "lubjoint/run/outcome.hpp"

namespace lubjoint::detail {

/// What a pilot run shows of a scene.
struct StiffnessMeasure {
  bool pilot_finished = false;
  double pilot_steps = 0;      ///< of radau_iia5 at pilot_tolerance
  double stability_steps = 0;  ///< that the stability of dopri5 asks for, however loose the tolerance
  bool smooth = false;         ///< no film and no contact, whose forces have kinks that an order of 8 does not see
  bool independent = false;    ///< are its states free of constraints, and of the size of a clearance?
};

inline constexpr double pilot_tolerance = 1e-4;
inline constexpr int pilot_samples = 64;

/// Settings of the pilot run of a scene.
RunSettings pilot_settings(const RunSettings& settings);

/// Rate at which the fastest motion dies out, max(0, −Re λ) of a Jacobian's eigenvalues [1/s]; of a large one, its norm
/// in units of the tolerances. An oscillation, such as that of a contact's stiffness, is no stiffness: who follows it
/// takes its steps for accuracy.
double fastest_decay(const Eigen::MatrixXd& jacobian, const std::vector<double>& tolerances);

struct IntegratorChoice {
  std::string name;
  std::string reason;
};

IntegratorChoice choose_integrator(const StiffnessMeasure& measure, double relative_tolerance);

}  // namespace lubjoint::detail
