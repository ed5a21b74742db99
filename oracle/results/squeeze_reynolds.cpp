#include "oracle/results/squeeze_reynolds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/joint/kinematics.hpp"
#include "lubjoint/scene/journal_scene.hpp"

namespace lubjoint::reports {

namespace {

double rate_of(const JournalMotion<double>& motion, double clearance) {
  const Vector2<double> seen = motion.velocity - motion.bearing_spin * perpendicular(motion.eccentricity);
  return std::max(std::abs(motion.journal_spin - motion.bearing_spin), norm(seen) / clearance);
}

/// The largest over a run. @param motion_of  motion_of(sample) is the journal's in its bearing
template <class Sample, class Motion>
std::optional<SqueezeReynolds> largest(const SceneJoint& joint, const std::vector<Sample>& samples,
                                       const Motion& motion_of) {
  if (!joint.density || joint.film == no_film) return std::nullopt;
  std::optional<SqueezeReynolds> found;
  for (const Sample& sample : samples) {
    const double rate = rate_of(motion_of(sample), joint.clearance);
    if (found && !(rate > found->rate)) continue;
    found =
        SqueezeReynolds{*joint.density * rate * joint.clearance * joint.clearance / joint.viscosity, rate, sample.t};
  }
  return found;
}

}  // namespace

std::optional<SqueezeReynolds> squeeze_reynolds(const Scene& scene, const JournalTrajectory& run) {
  const JournalDrive<double> drive = journal_scene(scene).drive;
  const SceneJoint& joint = scene.joints.front();
  const double c = joint.clearance;
  return largest(joint, run.samples, [&](const JournalSample& sample) {
    const auto& y = sample.state;
    return JournalMotion<double>{c * Vector2<double>(y[0], y[1]), c * Vector2<double>(y[2], y[3]), drive.bearing_spin,
                                 drive.journal_spin};
  });
}

std::optional<SqueezeReynolds> squeeze_reynolds(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run) {
  const SceneJoint& at = scene.joints[joint];
  return largest(at, run.samples, [&](const MultibodySample& sample) {
    return joint_kinematics(motion_in(sample.state, at.bearing.body), at.bearing.point,
                            motion_in(sample.state, at.journal.body), at.journal.point)
        .motion;
  });
}

std::optional<SqueezeReynolds> squeeze_reynolds(const SceneJoint& joint, const std::vector<SeenMotion>& run) {
  return largest(joint, run, [](const SeenMotion& seen) { return seen.motion; });
}

nlohmann::ordered_json squeeze_json(const std::optional<SqueezeReynolds>& film) {
  return film ? nlohmann::ordered_json(film->number) : nlohmann::ordered_json(nullptr);
}

std::string squeeze_reynolds_text(const std::optional<SqueezeReynolds>& film) {
  if (!film) return {};
  return fmt::format("  inertia    squeeze Reynolds number {:.3g} (rho Omega c^2/mu, Omega = {:.4g} 1/s at {:.6g} s)\n",
                     film->number, film->rate, film->t);
}

std::string squeeze_reynolds_warning(const SceneJoint& joint, const std::optional<SqueezeReynolds>& film) {
  if (!film || !(film->number > large_squeeze_reynolds)) return {};
  return fmt::format(
      "warning: the squeeze Reynolds number of joint \"{}\" is {:.3g} at {:.6g} s, above 1: the inertia of its oil is "
      "not "
      "small against its shear, and Reynolds' equation leaves it out.",
      joint.name, film->number, film->t);
}

}  // namespace lubjoint::reports
