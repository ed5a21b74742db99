/// Numbers of a scene, fitted so that its run is a given trajectory.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oracle/verify/trajectory/scene_verification.hpp"

namespace lubjoint::verify {

/// The failing signals of a trajectory as one list of numbers, each over what is allowed.
class FailingSignals {
 public:
  FailingSignals(const SceneReference& reference, const TrajectoryVerification& verification);

  const std::vector<double>& error() const { return error_; }

  /// How far another scene's run is from the reference; none if it does not run to the end.
  std::optional<std::vector<double>> shift(const Scene& scene) const;

  /// Share of the error that a shift explains: 1 − |error − shift|/|error|.
  double share(const std::vector<double>& shift) const;

  /// The scene with settings of which a search can afford many runs.
  Scene scene() const;

 private:
  const SceneReference& reference_;
  const std::vector<Deviation>& deviations_;
  std::vector<double> error_;
};

/// One number of the scene, or two at once, with the factors that bring its run nearest to the trajectory: least
/// squares by Gauss and Newton in the logarithm of the factor, with derivatives of the trajectory by differences of
/// 1e-4; from 1, and where that explains too little from 0.01 … 100 times. The likeliest first.
std::vector<Suspect> fitted_numbers(const SceneReference& reference, const FailingSignals& failing,
                                    const std::function<void()>& progress);

/// Steps of the fit that it reports.
std::size_t steps_of_fit(const Scene& scene);

}  // namespace lubjoint::verify
