// The run in space and its animation. Its data for space.js: name, end [s], frames, clearance [m], and, for each frame,
// in base64 of little-endian numbers:
//   eccentricity  int16 along the rod, across it: e/c times 32767, in the plane normal to the bearing's axis
//   force         float32 along the rod, across it [N]
//   film          float32: least film thickness [m]
// For each of the bodies its name, the ends of its arms, which are lines from the mass centre, in its axes [m], and
//   position      float32 x, y, z [m]
//   turn          int16: Euler parameters e0 … e3 times 32767
// Then lines by their ends [m]: the axes that the ground holds, and the pin, as long as the bearing, in its body's
// axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "oracle/page/packed_numbers.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_frames = 250;
constexpr double margin = 0.03;  ///< of a fixed axis beyond what moves along it [m]

Json point_json(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

SpatialFrame<double> frame_in(const SpatialScene& scene, const SpatialSample& sample, std::size_t body) {
  if (body == ground_body) return spatial_ground_frame<double>();
  return SpatialFrame<double>(spatial_motion_in(sample.state.data(), scene.bodies.size(), body));
}

/// The plane of a film, fixed to the bearing's body: along the body, from its mass centre to the bearing, and across.
struct FilmPlane {
  explicit FilmPlane(const BodyAxes<double>& bearing) {
    const Vector3<double> arm = bearing.point - bearing.point.dot(bearing.axis) * bearing.axis;
    along = is_zero(arm) ? bearing.across : Vector3<double>(arm.normalized());
    across = bearing.axis.cross(along);
  }
  /// An inertial vector in the plane.
  Vector2<double> components(const SpatialFrame<double>& body, const Vector3<double>& inertial) const {
    return {inertial_vector(body, along).dot(inertial), inertial_vector(body, across).dot(inertial)};
  }
  Vector3<double> along;
  Vector3<double> across;
};

/// Ends of the arms of a body: the points away from its mass centre that constraints and joints fix to it.
std::vector<Vector3<double>> arms_of(const SpatialScene& scene, std::size_t body) {
  std::vector<Vector3<double>> arms;
  const auto add = [&](std::size_t of, const Vector3<double>& point) {
    const bool known = std::any_of(arms.begin(), arms.end(), [&](const auto& arm) { return arm == point; });
    if (of == body && !is_zero(point) && !known) arms.push_back(point);
  };
  for (const SpatialSceneConstraint& each : scene.constraints) each.visit_points(add);
  for (const SpatialSceneJoint& joint : scene.joints) {
    add(joint.bearing.body, joint.bearing.point);
    add(joint.journal.body, joint.journal.point);
  }
  return arms;
}

/// Lines of the axes that constraints fix to the ground, as far as the other body's point goes along them.
Json fixed_axes(const SpatialScene& scene, const std::vector<SpatialSample>& samples) {
  Json axes = Json::array();
  const auto add = [&](const BodyAxes<double>& fixed, const BodyAxes<double>& moving) {
    double least = 0;
    double most = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vector3<double> point = point_motion(frame_in(scene, samples[i], moving.body), moving.point).position;
      const double along = fixed.axis.dot(point - fixed.point);
      least = i == 0 ? along : std::min(least, along);
      most = i == 0 ? along : std::max(most, along);
    }
    axes.push_back({point_json(fixed.point + (least - margin) * fixed.axis),
                    point_json(fixed.point + (most + margin) * fixed.axis)});
  };
  for (const SpatialSceneConstraint& each : scene.constraints) {
    std::visit(
        [&](const auto& constraint) {
          if constexpr (requires {
                          constraint.first.axis;
                          constraint.second.axis;
                        }) {
            if (constraint.first.body == ground_body) add(constraint.first, constraint.second);
          }
        },
        each.constraint);
  }
  return axes;
}

std::string seconds_words(double t) { return fmt::format("{:.3f}", t); }

std::string extremes_table(const SpaceExample& example) {
  const SpatialTrajectory& run = example.run;
  const SpatialJointExtremes& peak = run.joints.at(0);
  const double c = example.scene.joints.at(0).plane.clearance;
  Table table("What the run says of itself", {{"what", {}, false}, {"value"}, {"at", "s"}});
  table.row({"largest eccentricity ratio ε", fmt::format("{:.6f}", peak.eccentricity.value / c),
             seconds_words(peak.eccentricity.t)});
  table.row({"least film", fmt::format("{:.3f} µm", 1e6 * (c - peak.eccentricity.value)),
             seconds_words(peak.eccentricity.t)});
  table.row({"largest force of the film", fmt::format("{:.3f} N", peak.force.value), seconds_words(peak.force.t)});
  table.row({"largest tilt of the journal’s axis", scientific(peak.tilt.value) + " rad", seconds_words(peak.tilt.t)});
  table.row({"farthest slide along the axis", scientific(peak.sliding.value) + " m", seconds_words(peak.sliding.t)});
  table.row({"constraints off by", scientific(run.drift.position) + " m or rad", "–"});
  table.row({"their rates off by", scientific(run.drift.velocity) + " m/s or rad/s", "–"});
  table.row({"Euler parameters’ |p| off 1 by", scientific(run.drift.norm), "–"});
  table.row({"energy ledger off by", run.energy_residual ? scientific(*run.energy_residual) + " J" : "–", "–"});
  table.row({"largest energy or work", fmt::format("{:.4g} J", run.energy_scale), "–"});
  return table.html();
}

}  // namespace

std::string space_animation_json(const SpaceExample& example) {
  const SpatialScene& scene = example.scene;
  const auto& samples = example.run.samples;
  if (samples.empty()) return "null";
  const SpatialSceneJoint& joint = scene.joints.at(0);
  const FilmPlane plane(joint.bearing);
  const double c = joint.plane.clearance;
  std::vector<PackedNumbers> positions(scene.bodies.size());
  std::vector<PackedNumbers> turns(scene.bodies.size());
  PackedNumbers eccentricity;
  PackedNumbers force;
  PackedNumbers film;
  std::size_t frames = 0;
  double end = 0;
  const std::size_t stride = stride_for(samples.size(), most_frames);
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    const SpatialJointSample& pin = samples[i].joints.at(0);
    const SpatialFrame<double> bearing = frame_in(scene, samples[i], joint.bearing.body);
    const Vector2<double> e = plane.components(bearing, pin.eccentricity);
    const Vector2<double> f = plane.components(bearing, pin.force);
    for (const double value : e) eccentricity.int16(32767 * value / c);
    for (const double value : f) force.float32(value);
    film.float32(pin.film_thickness);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const SpatialMotion<double> motion = spatial_motion_in(samples[i].state.data(), scene.bodies.size(), b);
      for (const double value : motion.position) positions[b].float32(value);
      for (const double value : motion.parameters) turns[b].int16(32767 * value);
    }
    ++frames;
    end = samples[i].t;
  }
  Json bodies = Json::array();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Json arms = Json::array();
    for (const Vector3<double>& arm : arms_of(scene, b)) arms.push_back(point_json(arm));
    bodies.push_back({{"name", scene.bodies[b].name},
                      {"arms", std::move(arms)},
                      {"position", positions[b].base64()},
                      {"turn", turns[b].base64()}});
  }
  const Vector3<double> half = joint.plane.length / 2 * joint.bearing.axis;
  return Json{{"name", scene.name},
              {"end", end},
              {"frames", frames},
              {"clearance", c},
              {"eccentricity", eccentricity.base64()},
              {"force", force.base64()},
              {"film", film.base64()},
              {"bodies", std::move(bodies)},
              {"axes", fixed_axes(scene, samples)},
              {"pin",
               {{"body", joint.bearing.body},
                {"ends", {point_json(joint.bearing.point - half), point_json(joint.bearing.point + half)}}}}}
      .dump();
}

Section space_section(const Content& content) {
  const SpaceExample& example = content.space;
  const SceneJoint& joint = example.scene.joints.at(0).plane;
  const auto crank = spatial_slider_crank_of(example.scene);
  const auto millimetres = [](double metres) { return fmt::format("{:g}", std::round(1e7 * metres) / 1e4); };
  return {
      "space", "In space: a slider-crank with a lubricated gudgeon pin",
      filled("space.html",
             {{"crank", millimetres(crank.crank_length)},
              {"rod", millimetres(crank.rod_length)},
              {"beside", millimetres(crank.offset_y)},
              {"above", millimetres(crank.offset_z)},
              {"speed", fmt::format("{:g}", crank_speed_of(example.scene))},
              {"length", millimetres(joint.length)},
              {"clearance", millimetres(joint.clearance)},
              {"viscosity", fmt::format("{:g}", joint.viscosity)},
              {"duration", fmt::format("{:g}", example.scene.run.duration)},
              {"tolerance", with_powers(fmt::format("{:.0e}", example.scene.run.relative_tolerance))},
              {"integrator", escaped(example.run.outcome.integrator)},
              {"steps", std::to_string(example.run.outcome.steps)},
              {"ratio", fmt::format("{:.4f}", example.run.joints.at(0).eccentricity.value / joint.clearance)},
              {"player", filled("player.html", {{"name", "space"}})},
              {"checked", checked_words({&example.verdict}, {"e/c", "joint force", "tilt", "constraints", "energy"})},
              {"extremes", extremes_table(example)},
              {"checks", checks_table("In space: what the letters of the verdict stand for", {&example.verdict})},
              {"checks_csv",
               csv_block("csv-space-checks", "space-checks.csv", checks_csv({example.scene.name}, {&example.verdict}))},
              {"length_to_diameter", fmt::format("{:.2f}", joint.length / (2 * joint.journal_radius))},
              {"data", json_block("space-data", space_animation_json(example))}})};
}

}  // namespace lubjoint::reports::page
