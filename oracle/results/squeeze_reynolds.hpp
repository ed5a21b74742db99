/// Is the inertia of the oil small enough for Reynolds' equation, which leaves it out?
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// Re_s = ρ Ω c²/μ, inertia over shear in a film, with the fastest rate Ω at which its bearing sees the journal move at
/// an output time of the run: |ω_J − ω_B| of the spin, or |v − ω_B e⊥|/c of the squeeze.
struct SqueezeReynolds {
  double number;  ///< Re_s [-]
  double rate;    ///< Ω [1/s]
  double t;       ///< when [s]
};

/// From here on the oil's inertia is no smaller than its shear.
inline constexpr double large_squeeze_reynolds = 1;

/// A journal in its bearing at an instant of a run.
struct SeenMotion {
  double t;                      ///< [s]
  JournalMotion<double> motion;  ///< seen from the bearing or from anywhere
};

/// Nothing where the joint has no density, no film, or the run no sample.
std::optional<SqueezeReynolds> squeeze_reynolds(const Scene& scene, const JournalTrajectory& run);
std::optional<SqueezeReynolds> squeeze_reynolds(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run);
std::optional<SqueezeReynolds> squeeze_reynolds(const SceneJoint& joint, const std::vector<SeenMotion>& run);

/// The number, or null.
nlohmann::ordered_json squeeze_json(const std::optional<SqueezeReynolds>& film);

/// A line of a summary; empty for nothing.
std::string squeeze_reynolds_text(const std::optional<SqueezeReynolds>& film);

/// Says that the number is above 1; empty if not.
std::string squeeze_reynolds_warning(const SceneJoint& joint, const std::optional<SqueezeReynolds>& film);

}  // namespace lubjoint::reports
