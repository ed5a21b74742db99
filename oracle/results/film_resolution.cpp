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
  return thinnest_film(scene.joints[joint], run.joints[joint].eccentricity.value);
}

double thinnest_film(const SceneJoint& joint, double farthest) {
  if (joint.film == no_film) return 1;
  const double gap = 1 - farthest / joint.clearance;
  return joint.transition ? std::max(gap, 0.0) + joint.transition->e1 / joint.clearance : gap;
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

double unseen_error(const Scene& scene, const SceneJoint& joint, const std::string& integrator, double thinnest) {
  if (integrator != "fehlberg78" || joint.film == no_film) return 0;
  const double tolerance = tolerance_of_places(scene);
  // Where |e| has come to c the film is as thin as the transition's widening.
  const bool touched = joint.contact && joint.transition && thinnest <= joint.transition->e1 / joint.clearance;
  const double touching = touched ? std::min(1e4 * tolerance, 0.1) : 0;
  const double kinked = law_facts(joint.film).kinks && tolerance < 1e-11 ? 1e-8 : 0;
  return std::max(touching, kinked);
}

std::string unseen_warning(const Scene& scene, const SceneJoint& joint, const std::string& integrator,
                           double thinnest) {
  const double unseen = unseen_error(scene, joint, integrator, thinnest);
  if (unseen == 0) return {};
  return fmt::format(
      "warning: {}'s estimate of its error looks at the ends of a step alone, and {} inside it in joint \"{}\": places "
      "may be off by {:.0e} clearances, more than the tolerance of {:.0e}. dopri5 and radau_iia5 keep it.",
      integrator,
      unseen > 1e-8 ? std::string("film and contact change places")
                    : fmt::format("the force of {} has a kink where the squeeze changes sign", joint.film),
      joint.name, unseen, tolerance_of_places(scene));
}

}  // namespace lubjoint::reports
