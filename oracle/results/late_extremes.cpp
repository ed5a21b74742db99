#include "oracle/results/late_extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "oracle/files/files.hpp"
#include "oracle/files/require.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/outcome_words.hpp"

namespace lubjoint::reports {

namespace {

void require_finished(const RunOutcome& outcome, const char* part) {
  if (outcome.status == RunStatus::finished) return;
  throw std::invalid_argument(
      fmt::format("the extremes after a time need a run that reaches its end; {} {}", part, outcome.message));
}

/// The scene from a state on: drivers go on from where they are, f(t + T) = (φ₀ + ωT + ½αT²) + (ω + αT)t + ½αt², and so
/// do harmonic loads and tables of time.
Scene continued(const Scene& scene, double after) {
  Scene late = scene;
  late.run.duration = scene.run.duration - after;
  for (SceneConstraint& each : late.constraints) {
    if (auto* driver = std::get_if<Driver<double>>(&each.constraint))
      move_start(driver->angle, driver->speed, driver->acceleration, driver->shape, after);
    if (auto* driver = std::get_if<SlideDriver<double>>(&each.constraint))
      move_start(driver->position, driver->speed, driver->acceleration, driver->shape, after);
  }
  for (SceneLoad& load : late.loads) {
    if (load.harmonic) load.harmonic->phase += after * load.harmonic->rate;
    if (load.table) load.table->delay += after;
  }
  return late;
}

void shift(Peak& peak, double after) { peak.t += after; }

LateExtremes of_journal(const Scene& scene, const Scene& head, Scene late, double after) {
  const double clearance = scene.joints.front().clearance;
  if (after > 0) {
    const JournalTrajectory before = simulate_journal(head);
    require_finished(before.outcome, "up to it this one");
    const JournalSample& at = before.samples.back();
    SceneBody& body = late.bodies.front();
    body.position = scene.joints.front().bearing.point + clearance * Vector2<double>(at.state[0], at.state[1]);
    body.velocity = clearance * Vector2<double>(at.state[2], at.state[3]);
    body.angle += after * body.spin;
  }
  const JournalTrajectory run = simulate_journal(late);
  require_finished(run.outcome, "after it this one");
  JointExtremes extremes;
  extremes.eccentricity = {clearance - run.min_film_thickness, run.t_max_eccentricity_ratio + after};
  extremes.force = {run.max_force, run.t_max_force + after};
  return {after, {extremes}, {}, {}};
}

LateExtremes of_mechanism(const Scene& scene, const Scene& head, Scene late, double after) {
  if (after > 0) {
    const MultibodyTrajectory before = simulate_multibody(head);
    require_finished(before.outcome, "up to it this one");
    const MultibodySample& at = before.samples.back();
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      if (at.joints[j].film_thickness > 0) continue;
      throw std::invalid_argument(
          fmt::format("at {} s the journal of joint \"{}\" touches its wall; allowed for the extremes after a time is "
                      "one at which no journal does",
                      after, scene.joints[j].name));
    }
    const std::size_t n = 3 * scene.bodies.size();
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const double* q = at.state.data() + 3 * b;
      late.bodies[b].position = {q[0], q[1]};
      late.bodies[b].angle = q[2];
      late.bodies[b].velocity = {q[n], q[n + 1]};
      late.bodies[b].spin = q[n + 2];
    }
  }
  const MultibodyTrajectory run = simulate_multibody(late);
  require_finished(run.outcome, "after it this one");
  LateExtremes result{after, run.joints, run.drivers, run.reactions};
  for (JointExtremes& joint : result.joints) {
    shift(joint.eccentricity, after);
    shift(joint.force, after);
  }
  for (DriverExtremes& driver : result.drivers) {
    shift(driver.max_moment, after);
    shift(driver.min_moment, after);
  }
  for (ReactionExtremes& reaction : result.reactions) {
    shift(reaction.force, after);
    if (reaction.moment) shift(*reaction.moment, after);
  }
  return result;
}

/// How long before the end a body has turned by once less, [s]; at a constant acceleration.
double time_of_a_revolution(double final_speed, double acceleration) {
  const double turn = 2 * std::numbers::pi;
  const double speed = std::abs(final_speed);
  const double slowing = std::copysign(1.0, final_speed) * acceleration;  // backwards in time: speed·s − ½·slowing·s²
  const double root = speed * speed - 2 * slowing * turn;
  if (!(root >= 0)) return std::numeric_limits<double>::infinity();
  return 2 * turn / (speed + std::sqrt(root));
}

}  // namespace

LateExtremes late_extremes(const Scene& scene, double after) {
  if (!(after >= 0 && after < scene.run.duration)) {
    throw std::invalid_argument(
        fmt::format("the time after which extremes are wanted is {} s; allowed is one from 0 to "
                    "below the duration, {} s",
                    after, scene.run.duration));
  }
  Scene head = scene;
  head.run.duration = after > 0 ? after : scene.run.duration;
  head.run.output_interval = head.run.duration;  // its end alone is wanted
  Scene late = continued(scene, after);
  late.run.output_interval = late.run.duration;
  return is_free_journal(scene) ? of_journal(scene, head, std::move(late), after)
                                : of_mechanism(scene, head, std::move(late), after);
}

double start_of_last_revolution(const Scene& scene, const LateNames& names) {
  const auto refuse = [&names](const std::string& why) {
    throw std::invalid_argument(names.last_revolution + ": " + why + names.after);
  };
  const double end = scene.run.duration;
  double length = 0;
  for (const SceneConstraint& each : scene.constraints) {
    const auto* driver = std::get_if<Driver<double>>(&each.constraint);
    if (driver == nullptr) continue;
    if (driver->shape) {
      refuse("driver \"" + each.name + "\" does not turn evenly; allowed is ");
    }
    const double speed = driver->speed + end * driver->acceleration;
    if (speed == 0) continue;
    const double own = time_of_a_revolution(speed, driver->acceleration);
    if (length > 0 && std::abs(own - length) > 1e-9 * length) {  // far above the rounding of equal speeds
      refuse("the drivers turn at different speeds; allowed is ");
    }
    length = own;
  }
  if (length == 0 && scene.bodies.size() == 1 && scene.bodies.front().spin != 0) {
    length = time_of_a_revolution(scene.bodies.front().spin, 0);
  }
  if (length == 0) refuse("nothing in the scene is driven round; allowed is ");
  if (!(length <= end)) {
    refuse(fmt::format("the scene ends before one revolution is made, after {} s; allowed is a longer duration, or ",
                       end));
  }
  return end - length;
}

void LateChoice::require() const {
  if (after && last_revolution) {
    throw std::invalid_argument(names.after + " and " + names.last_revolution + " are given; allowed is one of them");
  }
}

void LateChoice::require_none_in_space() const {
  if (!after && !last_revolution) return;
  throw std::invalid_argument((after ? names.after : names.last_revolution) +
                              " is for scenes in the plane, and this one is in space; allowed without it");
}

std::optional<double> LateChoice::start(const Scene& scene) const {
  if (last_revolution) return start_of_last_revolution(scene, names);
  if (after) {
    require_option(names.after, *after, *after >= 0 && *after < scene.run.duration,
                   "a time from 0 to below the duration, " + number(scene.run.duration) + " s");
  }
  return after;
}

void add_late_extremes(nlohmann::ordered_json& summary, const Scene& scene, const LateExtremes& late) {
  for (std::size_t j = 0; j < late.joints.size(); ++j) {
    const double c = scene.joints[j].clearance;
    const JointExtremes& extremes = late.joints[j];
    summary["joints"][j]["after"] = {{"t", late.after},
                                     {"max_eccentricity_ratio", extremes.eccentricity.value / c},
                                     {"max_force", extremes.force.value},
                                     {"t_max_force", extremes.force.t},
                                     {"min_film_thickness", std::max(c - extremes.eccentricity.value, 0.0)},
                                     {"t_min_film_thickness", extremes.eccentricity.t}};
  }
  for (std::size_t d = 0; d < late.drivers.size(); ++d) {
    nlohmann::ordered_json after = {{"t", late.after}};
    after.update(driver_extremes_json(scene_drivers(scene)[d], late.drivers[d]));
    summary["drivers"][d]["after"] = after;
    if (d == 0) summary["driver"]["after"] = after;
  }
  for (std::size_t r = 0; r < late.reactions.size(); ++r) {
    nlohmann::ordered_json after = reaction_json(scene, late.reactions[r]);
    after.erase("name");
    summary["reactions"][r]["after"] = {{"t", late.after}};
    summary["reactions"][r]["after"].update(after);
  }
}

std::string late_extremes_text(const Scene& scene, const LateExtremes& late) {
  std::string text = fmt::format("after        {:.6g} s\n", late.after);
  for (std::size_t j = 0; j < late.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    const Peak& e = late.joints[j].eccentricity;
    text += fmt::format("  {:<10} {}\n", joint.name,
                        extremes_words(e.value / joint.clearance, joint.clearance - e.value, e.t,
                                       late.joints[j].force.value, late.joints[j].force.t));
  }
  for (std::size_t d = 0; d < late.drivers.size(); ++d) {
    const SceneDriver driver = scene_drivers(scene)[d];
    text += fmt::format("  {:<10} {}\n", driver.name, driver_words(driver, late.drivers[d]));
  }
  for (const ReactionExtremes& reaction : late.reactions) {
    text += fmt::format("  {:<10} {}\n", scene.constraints[reaction.constraint].name, reaction_words(reaction));
  }
  return text;
}

}  // namespace lubjoint::reports
