#include "oracle/results/multibody_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/joint/rebound.hpp"
#include "oracle/results/loss_columns.hpp"
#include "oracle/results/motion_words.hpp"
#include "oracle/results/outcome_words.hpp"
#include "oracle/results/scene_warnings.hpp"
#include "oracle/results/sensor_report.hpp"
#include "oracle/results/squeeze_reynolds.hpp"

namespace lubjoint::reports {

namespace {

/// Laws of the joints; one name where all are the same.
std::string laws_of(const Scene& scene) {
  std::string laws;
  for (const SceneJoint& joint : scene.joints) {
    if (laws.empty()) {
      laws = joint.film;
    } else if (laws != joint.film) {
      laws += "+" + joint.film;
    }
  }
  return laws.empty() ? no_film : laws;
}

/// A value that only joints with contact have.
nlohmann::ordered_json contact_json(const SceneJoint& joint, double value) {
  return joint.contact ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json rebound_json(const SceneJoint& joint) {
  return contact_json(joint, joint.contact ? rebound_ratio(joint.contact->restitution) : 0);
}

nlohmann::ordered_json passed_json(const MultibodyTrajectory& run) {
  nlohmann::ordered_json passed = nlohmann::ordered_json::array();
  for (const PassedPosition& each : run.passed) passed.push_back({{"t", each.t}, {"constraint", each.constraint}});
  return passed;
}

/// Peaks of the constraints' reactions, a line each.
std::string reactions_text(const Scene& scene, const MultibodyTrajectory& run) {
  std::string text;
  for (const ReactionExtremes& reaction : run.reactions) {
    text += fmt::format("reaction     {}: {}\n", scene.constraints[reaction.constraint].name, reaction_words(reaction));
  }
  return text;
}

}  // namespace

nlohmann::ordered_json slides_json(const std::vector<JointSlide>& slides, std::size_t joint) {
  nlohmann::ordered_json sliding = nlohmann::ordered_json::array();
  for (const JointSlide& slide : slides) {
    if (slide.joint == joint) sliding.push_back({slide.start, slide.end});
  }
  return sliding;
}

std::string slides_text(const std::vector<JointSlide>& slides, std::size_t joint) {
  std::string text;
  for (const JointSlide& slide : slides) {
    if (slide.joint == joint) text += slide_text(slide.start, slide.end);
  }
  return text;
}

nlohmann::ordered_json driver_extremes_json(const SceneDriver& driver, const DriverExtremes& extremes) {
  const std::string effort = driver.effort;
  return {{"max_" + effort, extremes.max_moment.value},
          {"t_max_" + effort, extremes.max_moment.t},
          {"min_" + effort, extremes.min_moment.value},
          {"t_min_" + effort, extremes.min_moment.t}};
}

std::string driver_words(const SceneDriver& driver, const DriverExtremes& extremes) {
  return fmt::format("{} from {:.6g} {} at {:.6g} s to {:.6g} {} at {:.6g} s", driver.effort, extremes.min_moment.value,
                     driver.unit, extremes.min_moment.t, extremes.max_moment.value, driver.unit, extremes.max_moment.t);
}

nlohmann::ordered_json reaction_json(const Scene& scene, const ReactionExtremes& reaction) {
  nlohmann::ordered_json json{{"name", scene.constraints[reaction.constraint].name},
                              {"max_force", reaction.force.value},
                              {"t_max_force", reaction.force.t},
                              {"max_moment", nullptr},
                              {"t_max_moment", nullptr}};
  if (reaction.moment) {
    json["max_moment"] = reaction.moment->value;
    json["t_max_moment"] = reaction.moment->t;
  }
  return json;
}

std::string reaction_words(const ReactionExtremes& reaction) {
  std::string text = fmt::format("force {:.6g} N at {:.6g} s", reaction.force.value, reaction.force.t);
  if (reaction.moment)
    text += fmt::format(", moment {:.6g} N m at {:.6g} s", reaction.moment->value, reaction.moment->t);
  return text;
}

nlohmann::ordered_json summary_json(const Scene& scene, const MultibodyTrajectory& run) {
  nlohmann::ordered_json joints = nlohmann::ordered_json::array();
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const double c = scene.joints[j].clearance;
    const JointSample& last = run.samples.back().joints[j];
    const double gap = c - run.joints[j].eccentricity.value;
    const double thinnest = std::max(gap, 0.0);
    nlohmann::ordered_json over_safe = nullptr;  // a dry joint has no film
    if (scene.joints[j].film != no_film) over_safe = thinnest / safe_film_thickness(scene.joints[j]);
    joints.push_back({{"name", scene.joints[j].name},
                      {"final",
                       {{"ex_over_c", last.eccentricity.x() / c},
                        {"ey_over_c", last.eccentricity.y() / c},
                        {"eccentricity_ratio", last.eccentricity_ratio},
                        {"fx", last.force.x()},
                        {"fy", last.force.y()}}},
                      {"max_eccentricity_ratio", run.joints[j].eccentricity.value / c},
                      {"max_force", run.joints[j].force.value},
                      {"t_max_force", run.joints[j].force.t},
                      {"min_film_thickness", thinnest},
                      {"min_film_over_safe", over_safe},
                      {"t_min_film_thickness", run.joints[j].eccentricity.t},
                      {"max_indentation", contact_json(scene.joints[j], std::max(-gap, 0.0))},
                      {"rebound_ratio", rebound_json(scene.joints[j])},
                      {"squeeze_reynolds_number", squeeze_json(squeeze_reynolds(scene, j, run))},
                      {"sliding", slides_json(run.slides, j)}});
    joints.back()["motion"] = motion_json(motion_outcome(scene, j, run));
    if (scene.joints[j].shear) add_losses(joints.back()["final"], last.losses);
  }
  const std::vector<SceneDriver> all_drivers = scene_drivers(scene);
  const auto driver_json = [&](std::size_t d) {
    nlohmann::ordered_json json{{"name", all_drivers[d].name}};
    json.update(driver_extremes_json(all_drivers[d], run.drivers[d]));
    return json;
  };
  nlohmann::ordered_json drivers = nlohmann::ordered_json::array();
  for (std::size_t d = 0; d < run.drivers.size(); ++d) drivers.push_back(driver_json(d));
  nlohmann::ordered_json reactions = nlohmann::ordered_json::array();
  for (const ReactionExtremes& reaction : run.reactions) reactions.push_back(reaction_json(scene, reaction));
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const ContactEvent& event : run.events) {
    events.push_back({{"t", event.t},
                      {"joint", scene.joints[event.joint].name},
                      {"from", contact_phase_name(event.from)},
                      {"to", contact_phase_name(event.to)},
                      {"normal_speed", event.normal_speed},
                      {"force_jump", event.force_jump}});
  }
  nlohmann::ordered_json driver = nullptr;
  if (!run.drivers.empty()) driver = driver_json(0);
  nlohmann::ordered_json residual = nullptr;
  if (run.energy_residual) residual = *run.energy_residual;
  nlohmann::ordered_json summary = outcome_json(scene.name, laws_of(scene), run.outcome, run.wall_seconds);
  summary["joints"] = joints;
  summary["driver"] = driver;
  summary["drivers"] = drivers;
  summary["reactions"] = reactions;
  if (!scene.sensors.empty()) summary["sensors"] = sensors_json(scene.sensors, run.sensors);
  summary["energy_residual"] = residual;
  summary["energy_scale"] = run.energy_scale;
  summary["constraint_drift"] = {{"position", run.drift.position}, {"velocity", run.drift.velocity}};
  summary["start_correction"] = {{"position", run.correction.position},
                                 {"angle", run.correction.angle},
                                 {"velocity", run.correction.velocity},
                                 {"spin", run.correction.spin}};
  if (scene.stabilisation.passes_singular) summary["singular_positions"] = passed_json(run);
  summary["contact_events"] = events;
  return summary;
}

std::string summary_text(const Scene& scene, const MultibodyTrajectory& run) {
  std::string text = outcome_text(scene.name, laws_of(scene), run.outcome, run.wall_seconds);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const double c = scene.joints[j].clearance;
    const JointSample& last = run.samples.back().joints[j];
    const JointExtremes& extremes = run.joints[j];
    text += fmt::format(
        "joint        {}\n  final      e/c = ({:.6f}, {:.6f}), eccentricity ratio {:.6f}, force ({:.6f}, {:.6f}) N\n",
        scene.joints[j].name, last.eccentricity.x() / c, last.eccentricity.y() / c, last.eccentricity_ratio,
        last.force.x(), last.force.y());
    text += extremes_text(extremes.eccentricity.value / c, c - extremes.eccentricity.value, extremes.eccentricity.t,
                          extremes.force.value, extremes.force.t);
    text += motion_text(motion_outcome(scene, j, run));
    text += squeeze_reynolds_text(squeeze_reynolds(scene, j, run));
    if (const auto& contact = scene.joints[j].contact) {
      text += fmt::format("  contact    restitution {:g}: a free impact gives back {:.4f} of its speed\n",
                          contact->restitution, rebound_ratio(contact->restitution));
    }
    if (scene.joints[j].shear) text += loss_text(last.losses);
    text += slides_text(run.slides, j);
  }
  for (std::size_t d = 0; d < run.drivers.size(); ++d) {
    const SceneDriver driver = scene_drivers(scene)[d];
    text += fmt::format("driver       {}: {}\n", driver.name, driver_words(driver, run.drivers[d]));
  }
  text += reactions_text(scene, run) + sensors_text(scene.sensors, run.sensors);
  for (const PassedPosition& each : run.passed) {
    text += fmt::format("singular     passed at {:.6g} s, where \"{}\" repeats what other constraints fix\n", each.t,
                        each.constraint);
  }
  if (!scene.constraints.empty()) {
    text += fmt::format(
        "constraints  drift {:.1e} m or rad, {:.1e} per second; start moved by {:.1e} m, {:.1e} rad, "
        "{:.1e} m/s, {:.1e} rad/s\n",
        run.drift.position, run.drift.velocity, run.correction.position, run.correction.angle, run.correction.velocity,
        run.correction.spin);
  }
  if (run.energy_residual) {
    text += fmt::format("energy       residual {:.2e} J, largest energy or work {:.4g} J\n", *run.energy_residual,
                        run.energy_scale);
  }
  if (!run.events.empty()) {
    text += fmt::format("contact      {} events, first at {:.9g} s\n", run.events.size(), run.events.front().t);
  }
  return text;
}

}  // namespace lubjoint::reports
