#include "oracle/results/journal_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/scene/journal_losses.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/results/loss_columns.hpp"
#include "oracle/results/motion_words.hpp"
#include "oracle/results/outcome_words.hpp"
#include "oracle/results/scene_warnings.hpp"
#include "oracle/results/squeeze_reynolds.hpp"

namespace lubjoint::reports {

nlohmann::ordered_json summary_json(const Scene& scene, const JournalTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  nlohmann::ordered_json sliding = nlohmann::ordered_json::array();
  for (const SlidingInterval& interval : run.sliding) sliding.push_back({interval.start, interval.end});
  nlohmann::ordered_json final_state = nullptr;
  if (!run.samples.empty()) {
    const JournalSample& last = run.samples.back();
    final_state = {{"ex_over_c", last.state[0]},
                   {"ey_over_c", last.state[1]},
                   {"eccentricity_ratio", last.eccentricity_ratio()},
                   {"fx", last.force.x()},
                   {"fy", last.force.y()}};
    if (joint.shear) add_losses(final_state, journal_losses(scene, last));
  }
  nlohmann::ordered_json joints = nlohmann::ordered_json::array();
  joints.push_back({{"name", joint.name},
                    {"final", final_state},
                    {"max_eccentricity_ratio", run.max_eccentricity_ratio},
                    {"max_force", run.max_force},
                    {"t_max_force", run.t_max_force},
                    {"min_film_thickness", run.min_film_thickness},
                    {"min_film_over_safe", run.min_film_thickness / safe_film_thickness(joint)},
                    {"t_min_film_thickness", run.t_max_eccentricity_ratio},
                    {"motion", motion_json(motion_outcome(scene, run))},
                    {"max_indentation", nullptr},
                    {"rebound_ratio", nullptr},
                    {"squeeze_reynolds_number", squeeze_json(squeeze_reynolds(scene, run))},
                    {"sliding", sliding}});
  nlohmann::ordered_json summary = outcome_json(scene.name, joint.film, run.outcome, run.wall_seconds);
  summary["joints"] = joints;
  // What only mechanisms have is here, too: programs find the same keys in every summary.
  summary["driver"] = nullptr;
  summary["drivers"] = nlohmann::ordered_json::array();
  summary["reactions"] = nlohmann::ordered_json::array();
  summary["energy_residual"] = nullptr;
  for (const char* key : {"energy_scale", "constraint_drift", "start_correction"}) summary[key] = nullptr;
  summary["contact_events"] = nlohmann::ordered_json::array();
  return summary;
}

std::string summary_text(const Scene& scene, const JournalTrajectory& run) {
  const SceneJoint& joint = scene.joints.front();
  std::string text = outcome_text(scene.name, joint.film, run.outcome, run.wall_seconds);
  if (!run.samples.empty()) {
    const JournalSample& last = run.samples.back();
    text += fmt::format(
        "joint        {}\n  final      e/c = ({:.6f}, {:.6f}), eccentricity ratio {:.6f}, force ({:.6f}, {:.6f}) N\n",
        joint.name, last.state[0], last.state[1], last.eccentricity_ratio(), last.force.x(), last.force.y());
    if (joint.shear) text += loss_text(journal_losses(scene, last));
  }
  text += extremes_text(run.max_eccentricity_ratio, run.min_film_thickness, run.t_max_eccentricity_ratio, run.max_force,
                        run.t_max_force);
  text += motion_text(motion_outcome(scene, run));
  text += squeeze_reynolds_text(squeeze_reynolds(scene, run));
  for (const SlidingInterval& interval : run.sliding) text += slide_text(interval.start, interval.end);
  return text;
}

std::string stability_word(Stability stability) {
  switch (stability) {
    case Stability::decays:
      return "decays";
    case Stability::grows:
      return "grows";
    case Stability::neutral:
      break;
  }
  return "neither";
}

nlohmann::ordered_json equilibrium_json(const Scene& scene, const JournalEquilibrium& rest) {
  const auto matrix = [](const Eigen::Matrix2d& m) {
    return nlohmann::ordered_json{{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}};
  };
  nlohmann::ordered_json eigenvalues = nlohmann::ordered_json::array();
  for (const auto& value : rest.eigenvalues) eigenvalues.push_back({{"re", value.real()}, {"im", value.imag()}});
  const std::string warning = stability_warning(scene.joints.front().film, scene.joints.front().table.get());
  return {{"scene", scene.name},
          {"law", scene.joints.front().film},
          {"eccentricity_ratio", rest.eccentricity_ratio},
          {"attitude", rest.attitude},
          {"ex_over_c", rest.eccentricity.x()},
          {"ey_over_c", rest.eccentricity.y()},
          {"fx", rest.force.x()},
          {"fy", rest.force.y()},
          {"stiffness", matrix(rest.stiffness)},
          {"damping", matrix(rest.damping)},
          {"eigenvalues", eigenvalues},
          {"eigenvalue_rounding", rest.eigenvalue_rounding},
          {"stability", stability_word(rest.stability())},
          {"warning", warning.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(warning)}};
}

std::string equilibrium_text(const Scene& scene, const JournalEquilibrium& rest) {
  const auto shown = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };  // a rounding of either sign is no −0
  std::string text = fmt::format(
      "scene               {}\nlaw                 {}\neccentricity ratio  {:.10f}\n"
      "attitude angle      {:.6f} deg (from the load to e, positive with the spin)\n"
      "e/c                 ({:.10f}, {:.10f})\nforce on journal    ({:.6f}, {:.6f}) N\n",
      scene.name, scene.joints.front().film, rest.eccentricity_ratio, degrees * rest.attitude, rest.eccentricity.x(),
      rest.eccentricity.y(), shown(rest.force.x()), shown(rest.force.y()));
  const auto matrix = [&](const char* name, const Eigen::Matrix2d& m) {
    text +=
        fmt::format("{:<20}{:14.6g} {:14.6g}\n{:<20}{:14.6g} {:14.6g}\n", name, m(0, 0), m(0, 1), "", m(1, 0), m(1, 1));
  };
  matrix("stiffness [N/m]", rest.stiffness);
  matrix("damping [N s/m]", rest.damping);
  for (std::size_t i = 0; i < 4; ++i) {
    text += fmt::format("{:<20}{:+.6e} {:+.6e} i\n", i ? "" : "eigenvalues [1/s]", rest.eigenvalues[i].real(),
                        rest.eigenvalues[i].imag());
  }
  text += fmt::format("small displacement  {}\n", stability_word(rest.stability()));
  return text;
}

}  // namespace lubjoint::reports
