#include "oracle/results/spatial_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "lubjoint/joint/rebound.hpp"
#include "oracle/results/loss_columns.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/outcome_words.hpp"
#include "oracle/results/scene_warnings.hpp"
#include "oracle/results/sensor_report.hpp"

namespace lubjoint::reports {

namespace {

/// Share of the least film that a tilt may take at the bearing's edge before the plane's film is in doubt.
constexpr double largest_edge_share = 0.1;

std::string laws_of(const SpatialScene& scene) {
  std::string laws;
  for (const SpatialSceneJoint& joint : scene.joints) {
    if (laws.empty()) {
      laws = joint.plane.film;
    } else if (laws != joint.plane.film) {
      laws += "+" + joint.plane.film;
    }
  }
  return laws.empty() ? no_film : laws;
}

nlohmann::ordered_json vector_json(const Vector3<double>& v, double unit = 1) {
  return {v.x() / unit, v.y() / unit, v.z() / unit};
}

/// Names with how often each is there: "a" (2 rows), "b".
std::string counted(const std::vector<std::string>& names) {
  std::string words;
  for (std::size_t i = 0; i < names.size();) {
    const auto count = std::count(names.begin(), names.end(), names[i]);
    if (i > 0) words += ", ";
    words += fmt::format("\"{}\" ({} row{})", names[i], count, count == 1 ? "" : "s");
    i += static_cast<std::size_t>(count);
  }
  return words;
}

nlohmann::ordered_json joint_json(const SpatialSceneJoint& joint, const SpatialJointSample& last,
                                  const SpatialJointExtremes& extremes, nlohmann::ordered_json slides) {
  const double c = joint.plane.clearance;
  const double gap = c - extremes.eccentricity.value;
  nlohmann::ordered_json json{{"name", joint.plane.name},
                              {"final",
                               {{"e_over_c", vector_json(last.eccentricity, c)},
                                {"eccentricity_ratio", last.eccentricity_ratio},
                                {"force", vector_json(last.force)},
                                {"tilt", last.tilt},
                                {"sliding", last.sliding}}},
                              {"max_eccentricity_ratio", extremes.eccentricity.value / c},
                              {"max_force", extremes.force.value},
                              {"t_max_force", extremes.force.t},
                              {"min_film_thickness", std::max(gap, 0.0)},
                              {"min_film_over_safe", nullptr},
                              {"t_min_film_thickness", extremes.eccentricity.t},
                              {"max_indentation", nullptr},
                              {"rebound_ratio", nullptr},
                              {"max_tilt", extremes.tilt.value},
                              {"t_max_tilt", extremes.tilt.t},
                              {"max_sliding", extremes.sliding.value},
                              {"t_max_sliding", extremes.sliding.t},
                              {"max_edge_share", extremes.edge_share.value},
                              {"t_max_edge_share", extremes.edge_share.t},
                              {"film_slides", std::move(slides)}};
  if (joint.plane.film != no_film) {
    json["min_film_over_safe"] = std::max(gap, 0.0) / safe_film_thickness(joint.plane);
  }
  if (joint.plane.contact) {
    json["max_indentation"] = std::max(-gap, 0.0);
    json["rebound_ratio"] = rebound_ratio(joint.plane.contact->restitution);
  }
  if (joint.plane.shear) add_losses(json["final"], last.losses);
  return json;
}

}  // namespace

nlohmann::ordered_json summary_json(const SpatialScene& scene, const SpatialTrajectory& run) {
  nlohmann::ordered_json joints = nlohmann::ordered_json::array();
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    joints.push_back(
        joint_json(scene.joints[j], run.samples.back().joints[j], run.joints[j], slides_json(run.slides, j)));
  }
  nlohmann::ordered_json drivers = nlohmann::ordered_json::array();
  for (std::size_t d = 0; d < run.drivers.size(); ++d) {
    const char* what = run.driver_turns[d] ? "moment" : "force";
    nlohmann::ordered_json driver{{"name", run.driver_names[d]}};
    driver[fmt::format("max_{}", what)] = run.drivers[d].max_moment.value;
    driver[fmt::format("t_max_{}", what)] = run.drivers[d].max_moment.t;
    driver[fmt::format("min_{}", what)] = run.drivers[d].min_moment.value;
    driver[fmt::format("t_min_{}", what)] = run.drivers[d].min_moment.t;
    drivers.push_back(driver);
  }
  nlohmann::ordered_json reactions = nlohmann::ordered_json::array();
  for (const ReactionExtremes& reaction : run.reactions) {
    const std::string& name = scene.constraints[reaction.constraint].name;
    nlohmann::ordered_json json{{"name", name},
                                {"max_force", reaction.force.value},
                                {"t_max_force", reaction.force.t},
                                {"max_moment", nullptr},
                                {"t_max_moment", nullptr}};
    if (reaction.moment) {
      json["max_moment"] = reaction.moment->value;
      json["t_max_moment"] = reaction.moment->t;
    }
    reactions.push_back(json);
  }
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const ContactEvent& event : run.events) {
    events.push_back({{"t", event.t},
                      {"joint", scene.joints[event.joint].plane.name},
                      {"from", contact_phase_name(event.from)},
                      {"to", contact_phase_name(event.to)},
                      {"normal_speed", event.normal_speed},
                      {"force_jump", event.force_jump}});
  }
  nlohmann::ordered_json residual = nullptr;
  if (run.energy_residual) residual = *run.energy_residual;
  nlohmann::ordered_json summary = outcome_json(scene.name, laws_of(scene), run.outcome, run.wall_seconds);
  summary["dimension"] = 3;
  summary["joints"] = joints;
  summary["drivers"] = drivers;
  summary["reactions"] = reactions;
  if (!scene.sensors.empty()) summary["sensors"] = sensors_json(scene.sensors, run.sensors);
  summary["energy_residual"] = residual;
  summary["energy_scale"] = run.energy_scale;
  summary["constraint_rows"] = {{"all", run.rows}, {"rank", run.rank}, {"left_out", run.left_out}};
  summary["constraint_drift"] = {{"position", run.drift.position},
                                 {"velocity", run.drift.velocity},
                                 {"left_out", run.drift.left_out_position},
                                 {"euler_parameters", run.drift.norm}};
  summary["start_correction"] = {{"position", run.correction.position},
                                 {"angle", run.correction.angle},
                                 {"velocity", run.correction.velocity},
                                 {"spin", run.correction.spin}};
  summary["contact_events"] = events;
  return summary;
}

std::string summary_text(const SpatialScene& scene, const SpatialTrajectory& run) {
  std::string text = outcome_text(scene.name, laws_of(scene), run.outcome, run.wall_seconds);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const double c = scene.joints[j].plane.clearance;
    const SpatialJointSample& last = run.samples.back().joints[j];
    const SpatialJointExtremes& extremes = run.joints[j];
    text += fmt::format(
        "joint        {}\n  final      e/c = ({:.6f}, {:.6f}, {:.6f}), eccentricity ratio {:.6f}, force ({:.6f}, "
        "{:.6f}, {:.6f}) N\n",
        scene.joints[j].plane.name, last.eccentricity.x() / c, last.eccentricity.y() / c, last.eccentricity.z() / c,
        last.eccentricity_ratio, last.force.x(), last.force.y(), last.force.z());
    text += extremes_text(extremes.eccentricity.value / c, c - extremes.eccentricity.value, extremes.eccentricity.t,
                          extremes.force.value, extremes.force.t);
    text += fmt::format("  axes       tilt at most {:.3g} rad at {:.6g} s, sliding at most {:.3g} m at {:.6g} s\n",
                        extremes.tilt.value, extremes.tilt.t, extremes.sliding.value, extremes.sliding.t);
    if (const auto& contact = scene.joints[j].plane.contact) {
      text += fmt::format("  contact    restitution {:g}: a free impact gives back {:.4f} of its speed\n",
                          contact->restitution, rebound_ratio(contact->restitution));
    }
    if (scene.joints[j].plane.shear) text += loss_text(last.losses);
    text += slides_text(run.slides, j);
  }
  for (std::size_t d = 0; d < run.drivers.size(); ++d) {
    const char* unit = run.driver_turns[d] ? "N m" : "N";
    text +=
        fmt::format("driver       {}: {} from {:.6g} {} at {:.6g} s to {:.6g} {} at {:.6g} s\n", run.driver_names[d],
                    run.driver_turns[d] ? "moment" : "force", run.drivers[d].min_moment.value, unit,
                    run.drivers[d].min_moment.t, run.drivers[d].max_moment.value, unit, run.drivers[d].max_moment.t);
  }
  for (const ReactionExtremes& reaction : run.reactions) {
    text += fmt::format("reaction     {}: {}\n", scene.constraints[reaction.constraint].name, reaction_words(reaction));
  }
  text += sensors_text(scene.sensors, run.sensors);
  if (run.rows > 0) {
    text += fmt::format(
        "constraints  {} rows of rank {}, drift {:.1e} m or rad, {:.1e} per second, Euler parameters {:.1e}; start "
        "moved by {:.1e} m, {:.1e} rad, {:.1e} m/s, {:.1e} rad/s\n",
        run.rows, run.rank, run.drift.position, run.drift.velocity, run.drift.norm, run.correction.position,
        run.correction.angle, run.correction.velocity, run.correction.spin);
  } else {
    text += fmt::format("bodies       Euler parameters off by {:.1e} before they were normalised\n", run.drift.norm);
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

std::vector<std::string> unit_warnings(const SpatialScene& scene) {
  std::vector<SceneJoint> joints;
  for (const SpatialSceneJoint& joint : scene.joints) joints.push_back(joint.plane);
  std::vector<std::string> warnings =
      joint_unit_warnings(joints, scene_units(scene).mechanism, scene.bodies.size() > 1);
  for (const SpatialSceneConstraint& each : scene.constraints) {
    const auto* driver = std::get_if<RotationalDriver<double>>(&each.constraint);
    if (driver == nullptr || driver->second.body == ground_body) continue;
    const SpatialFrame<double> first = frame_at_start(scene, driver->first.body);
    const SpatialFrame<double> second = frame_at_start(scene, driver->second.body);
    const Vector3<double> n = inertial_vector(first, driver->first.axis);
    const double spin = dot(n, second.spin);
    const auto of_driver = driver_unit_warnings(each.name, scene.bodies[driver->second.body].name, driver->motion.speed,
                                                spin, spin - dot(n, first.spin));
    warnings.insert(warnings.end(), of_driver.begin(), of_driver.end());
  }
  return warnings;
}

std::vector<std::string> correction_warnings(const SpatialScene& scene, const SpatialTrajectory& run) {
  constexpr double share = 0.01;  // what a correction of rounding never reaches
  std::vector<std::string> warnings;
  if (run.samples.empty()) return warnings;
  const double mechanism = scene_units(scene).mechanism;
  const auto start = [&](std::size_t b) {
    return spatial_motion_in(run.samples.front().state.data(), scene.bodies.size(), b);
  };
  double fastest = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    fastest = std::max({fastest, start(b).velocity.norm(), start(b).body_spin.norm() * mechanism});
  const auto words = [](const auto& v) {
    std::string text;
    for (const double x : v) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", x);
    return text;
  };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SpatialSceneBody& given = scene.bodies[b];
    const SpatialMotion<double> needed = start(b);
    std::string moved;
    const auto say = [&](const std::string& what) { moved += (moved.empty() ? "" : "; ") + what; };
    if ((needed.position - given.position).norm() > share * mechanism)
      say(fmt::format("position [{}] m given, [{}] needed", words(given.position), words(needed.position)));
    const double turned = 2 * std::acos(std::min(1.0, std::abs(needed.parameters.dot(given.orientation))));
    if (turned > share) {
      say(fmt::format("orientation given off by {:.3g} rad, euler_parameters [{}] needed", turned,
                      words(needed.parameters)));
    }
    const double slowed = (needed.velocity - given.velocity).norm();
    if (slowed > share * std::max(needed.velocity.norm(), given.velocity.norm()) && slowed > share * fastest)
      say(fmt::format("velocity [{}] m/s given, [{}] needed", words(given.velocity), words(needed.velocity)));
    const double spun = (needed.body_spin - given.spin).norm();
    if (spun > share * std::max(needed.body_spin.norm(), given.spin.norm()) && spun * mechanism > share * fastest) {
      say(fmt::format("spin [{}] rad/s given, [{}] needed{}", words(given.spin), words(needed.body_spin),
                      unit_guess(given.spin.norm(), needed.body_spin.norm())));
    }
    if (moved.empty()) continue;
    warnings.push_back(
        fmt::format("warning: the start of body \"{}\" was moved onto the constraints: {}", given.name, moved));
  }
  return warnings;
}

std::vector<SeenMotion> seen_motions(const SpatialScene& scene, std::size_t joint, const SpatialTrajectory& run) {
  const SpatialSceneJoint& at = scene.joints[joint];
  std::vector<SeenMotion> motions;
  for (const SpatialSample& sample : run.samples) {
    const auto frame = [&](std::size_t body) {
      return SpatialFrame<double>(spatial_motion_in(sample.state.data(), scene.bodies.size(), body));
    };
    motions.push_back({sample.t, spatial_joint_kinematics<double>(frame(at.bearing.body), at.bearing,
                                                                  frame(at.journal.body), at.journal)
                                     .motion});
  }
  return motions;
}

std::vector<std::string> run_warnings(const SpatialScene& scene, const SpatialTrajectory& run) {
  std::vector<std::string> warnings;
  if (!run.left_out.empty()) {
    warnings.push_back(fmt::format(
        "warning: the constraints have {} rows of rank {}; the run does without rows of {}, which the others "
        "implied at the start. Motions are not touched by the choice while they are redundant; reactions of the joints "
        "of that loop are not unique, and those shown are one of many.",
        run.rows, run.rank, counted(run.left_out)));
  }
  const auto moved = correction_warnings(scene, run);
  warnings.insert(warnings.end(), moved.begin(), moved.end());
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j].plane;
    const SpatialJointExtremes& extremes = run.joints[j];
    if (joint.film == no_film) continue;
    const std::string thin =
        thin_film_warning(joint, joint.clearance - extremes.eccentricity.value, extremes.eccentricity.t);
    if (!thin.empty()) warnings.push_back(thin);
    if (!(extremes.edge_share.value > largest_edge_share)) continue;
    std::string warning = fmt::format(
        "warning: the tilt of joint \"{}\" took {:.3g} of the least film at the bearing's edge at {:.6g} s, {:.3g} rad "
        "at the most; the film is that of parallel axes, and is good for a tenth.",
        joint.name, extremes.edge_share.value, extremes.edge_share.t, extremes.tilt.value);
    if (joint.contact && extremes.edge_share.value >= 1) {
      warning +=
          " There its edge met the wall, by more than the transition's width: the run went on with the plane's "
          "contact, which does not see that.";
    }
    warnings.push_back(warning);
  }
  return warnings;
}

}  // namespace lubjoint::reports
