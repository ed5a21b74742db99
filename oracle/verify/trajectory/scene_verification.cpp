#include "oracle/verify/trajectory/scene_verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lubjoint/scene/simulate.hpp"
#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/trajectory/scene_suspects.hpp"

namespace lubjoint::verify {

namespace {

/// Samples between two of the scene's output times, so that the reference is known at times that are not its own.
constexpr std::size_t samples_an_interval = 8;

void set_tolerance(Scene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

/// Largest distance of two runs until each time, and a fiftieth of the duration beyond: the same peak comes later in
/// one of them.
std::vector<double> largest_distance(const Samples& x, const Samples& y) {
  const std::size_t n = x.t.size();
  std::vector<double> largest(n, 0);
  double so_far = 0;
  std::size_t ahead = 0;
  const double reach = (x.t.back() - x.t.front()) / 50;
  for (std::size_t i = 0; i < n; ++i) {
    for (; ahead < n && x.t[ahead] <= x.t[i] + reach; ++ahead) {
      double sum = 0;
      for (std::size_t k = 0; k < x.components(); ++k) sum += std::pow(x.x[k][ahead] - y.x[k][ahead], 2);
      so_far = std::max(so_far, std::sqrt(sum));
    }
    largest[i] = so_far;
  }
  return largest;
}

std::string law_of_joints(const Scene& scene) {
  std::string laws;
  for (const SceneJoint& joint : scene.joints) {
    if (laws.find(joint.film) == std::string::npos) laws += (laws.empty() ? "" : "+") + joint.film;
  }
  return laws.empty() ? no_film : laws;
}

std::string known_columns(const std::vector<Yardstick>& yardsticks) {
  std::string list;
  for (const Yardstick& yardstick : yardsticks) {
    for (const std::string& column : yardstick.signal.columns) list += (list.empty() ? "" : ", ") + column;
  }
  return list;
}

}  // namespace

Trajectory simulated(const Scene& scene) {
  const auto table = [&](const auto& run) {
    if (run.outcome.status != RunStatus::finished) {
      throw UnjudgedError(fmt::format("our own run of {} at tolerance {} stops at {} s: {}", scene.file,
                                      scene.run.relative_tolerance, run.outcome.t_end, run.outcome.message));
    }
    return as_trajectory(trajectory_table(scene, run), "our own run of " + scene.file);
  };
  return is_free_journal(scene) ? table(simulate_journal(scene)) : table(simulate_multibody(scene));
}

SceneReference scene_reference(const Scene& scene, double tolerance) {
  SceneReference reference{scene, tolerance, std::clamp(1e-8 * tolerance, 1e-12, 1e-11), 1e-3 * tolerance, {}, {}};
  Scene fine = scene;
  fine.run.output_interval /= samples_an_interval;
  // The implicit method is at home in every scene, stiff or not.
  fine.integrator = "radau_iia5";
  set_tolerance(fine, reference.sensitivity_tolerance);
  const Trajectory other = simulated(fine);
  set_tolerance(fine, reference.reference_tolerance);
  reference.run = simulated(fine);
  for (const Signal& signal : signals_of(scene, reference.run)) {
    const Samples samples = samples_of(signal, reference.run);
    reference.yardsticks.push_back({signal, samples, samples_an_interval,
                                    largest_distance(samples, samples_of(signal, other)), tolerance * signal.scale});
  }
  return reference;
}

bool TrajectoryVerification::agrees() const {
  return std::ranges::all_of(deviations, [](const Deviation& d) { return d.agrees(); });
}

TrajectoryVerification verify_trajectory(const SceneReference& reference, std::string_view csv, const std::string& name,
                                         const std::function<void()>& progress) {
  Trajectory given = read_trajectory(csv, name, &reference.run);
  end_films_in_contact(reference.scene, given);
  const std::vector<std::string> used = add_eccentricities(reference.scene, given);
  TrajectoryVerification result;
  result.scene = reference.scene.name;
  result.law = law_of_joints(reference.scene);
  result.tolerance = reference.tolerance;
  result.reference_tolerance = reference.reference_tolerance;
  result.sensitivity_tolerance = reference.sensitivity_tolerance;
  result.duration = reference.run.t.back();
  result.not_read = given.not_read;
  for (const SceneJoint& joint : reference.scene.joints) {  // the angle of e says nothing near e = 0
    const std::string attitude = joint.name + ".attitude";
    if (given.has(attitude) && std::ranges::find(used, attitude) == used.end()) result.not_read.push_back(attitude);
  }
  for (const Yardstick& yardstick : reference.yardsticks) {
    const std::vector<Signal> present = signals_in({yardstick.signal}, given);
    if (present.empty()) {
      result.not_given.push_back(yardstick.signal.name());
      continue;
    }
    Yardstick part = yardstick;
    part.signal = present.front();
    part.fine = samples_of(part.signal, reference.run);
    result.deviations.push_back(deviation(part, given));
  }
  if (result.deviations.empty()) {
    throw UnjudgedError(
        fmt::format("{}: no column is known; allowed are t and any of {}", name, known_columns(reference.yardsticks)));
  }
  const auto judged = [&](const Deviation& d) { return d.judged_until >= 0.1 * result.duration; };
  if (std::ranges::none_of(result.deviations, judged)) {
    throw UnjudgedError(fmt::format(
        "scene {} enlarges errors too much: our own runs at tolerances {} and {} part at once. A smaller --tolerance "
        "asks for more accurate runs, and can be judged for longer",
        result.scene, reference.reference_tolerance, reference.sensitivity_tolerance));
  }
  for (const Deviation& d : result.deviations) {
    result.explanations.push_back(d.agrees() ? std::nullopt : explanation(d, given, reference.yardsticks));
  }
  if (!result.agrees()) result.suspects = suspects(reference, result, progress);
  return result;
}

}  // namespace lubjoint::verify
