#include "oracle/results/film_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lubjoint/film/law_facts.hpp"

namespace lubjoint::reports {

double tolerance_of_places(const Scene& scene) {
  const RunSettings& run = scene.run;
  return is_free_journal(scene) ? std::max(run.relative_tolerance, run.absolute_tolerance) : run.absolute_tolerance;
}

double thinnest_film(const Scene& scene, const JournalTrajectory& run) {
  return run.min_film_thickness / scene.joints.front().clearance;
}

double thinnest_film(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run) {
  const SceneJoint& at = scene.joints[joint];
  if (at.film == no_film) return 1;
  const double gap = 1 - run.joints[joint].eccentricity.value / at.clearance;
  return at.transition ? std::max(gap, 0.0) + at.transition->e1 / at.clearance : gap;
}

bool leaves_no_digit(const Scene& scene, double thinnest) {
  return film_power * tolerance_of_places(scene) > 0.1 * thinnest;
}

std::string resolution_warning(const Scene& scene, const SceneJoint& joint, double thinnest) {
  const double tolerance = tolerance_of_places(scene);
  if (tolerance <= coarse_share * thinnest) return {};
  const double needed = std::pow(10, std::floor(std::log10(coarse_share * std::max(thinnest, 1e-300))));
  const std::string share = tolerance < thinnest ? fmt::format("{:.2} of", tolerance / thinnest) : "more than";
  return fmt::format(
      "warning: the tolerance of {:.0e} clearances is {} the thinnest film in joint \"{}\", {:.1e} clearances: places "
      "may be off by much more than the tolerance{}. {}",
      tolerance, share, joint.name, thinnest,
      leaves_no_digit(scene, thinnest) ? ", and no digit of velocities and forces is known" : "",
      needed >= tightest_tolerance ? fmt::format("Tolerance {:.0e} would resolve it.", needed)
                                   : "No tolerance resolves it in double precision.");
}

std::string kink_warning(const Scene& scene, const SceneJoint& joint, const std::string& integrator) {
  const double tolerance = tolerance_of_places(scene);
  if (integrator != "fehlberg78" || joint.film == no_film || !(tolerance < kink_tolerance)) return {};
  if (!law_facts(joint.film).kinks) return {};
  return fmt::format(
      "warning: the force of {} in joint \"{}\" has a kink where the squeeze changes sign, and {}'s estimate of its "
      "error "
      "does not see it: places may be off by {:.0e} clearances, more than the tolerance of {:.0e}. dopri5 and "
      "radau_iia5 "
      "keep it.",
      joint.film, joint.name, integrator, kink_error, tolerance);
}

}  // namespace lubjoint::reports
