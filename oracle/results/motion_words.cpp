#include "oracle/results/motion_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/scene/scene_period.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::size_t fewest = 60;  ///< samples, 20 for each third

/// e/c between two samples.
Vector2<double> place_at(const std::vector<double>& t, const std::vector<Vector2<double>>& places, double at) {
  const auto next = std::upper_bound(t.begin(), t.end(), at);
  if (next == t.end()) return places.back();
  if (next == t.begin()) return places.front();
  const auto i = static_cast<std::size_t>(next - t.begin());
  const double share = (at - t[i - 1]) / (t[i] - t[i - 1]);
  return (1 - share) * places[i - 1] + share * places[i];
}

/// The largest distance from the mean place between two samples.
double amplitude(const std::vector<Vector2<double>>& places, std::size_t begin, std::size_t end) {
  Vector2<double> mean(0, 0);
  for (std::size_t i = begin; i < end; ++i) mean += places[i] / static_cast<double>(end - begin);
  double largest = 0;
  for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, (places[i] - mean).norm());
  return largest;
}

/// A period of a scene that a driver turns evenly; with tables, that of all that acts on it.
std::optional<double> period_of(const Scene& scene) {
  if (std::any_of(scene.loads.begin(), scene.loads.end(), [](const SceneLoad& load) { return load.table.has_value(); }))
    return scene_period(scene);
  const Driver<double>* driver = nullptr;
  for (const SceneConstraint& each : scene.constraints) {
    const auto* another = std::get_if<Driver<double>>(&each.constraint);
    if (another == nullptr) continue;
    if (driver != nullptr) return std::nullopt;
    driver = another;
  }
  if (driver == nullptr || driver->acceleration != 0 || driver->speed == 0 || driver->shape) return std::nullopt;
  return 2 * std::numbers::pi / std::abs(driver->speed);
}

}  // namespace

MotionOutcome motion_outcome(const std::vector<double>& t, const std::vector<Vector2<double>>& places,
                             const std::optional<double>& period) {
  const std::size_t n = t.size();
  if (n < fewest) return {};
  const double end = t.back();
  // From where on is it near its last place?
  std::size_t since = n - 1;
  while (since > 0 && (places[since - 1] - places.back()).norm() <= same_place) --since;
  if (end - t[since] >= 0.1 * (end - t.front())) return {MotionKind::rests, t[since], same_place};
  if (period) {
    if (end - t.front() < 2 * *period * (1 - 1e-9)) return {};  // rounding of the duration
    double apart = 0;
    for (std::size_t i = n; i-- > 0 && t[i] >= end - *period;) {
      apart = std::max(apart, (places[i] - place_at(t, places, t[i] - *period)).norm());
    }
    return {apart <= same_place ? MotionKind::periodic : MotionKind::not_periodic, 0, apart};
  }
  const double before = amplitude(places, n / 3, 2 * n / 3);
  const double last = amplitude(places, 2 * n / 3, n);
  const double ratio = before > 0 ? last / before : 1;
  if (ratio > 1 + same_amplitude) return {MotionKind::grows, 0, ratio};
  if (ratio < 1 - same_amplitude) return {MotionKind::dies_away, 0, ratio};
  return {MotionKind::keeps_on, 0, ratio};
}

MotionOutcome motion_outcome(const Scene&, const JournalTrajectory& run) {
  std::vector<double> t;
  std::vector<Vector2<double>> places;
  for (const JournalSample& sample : run.samples) {
    t.push_back(sample.t);
    places.emplace_back(sample.state[0], sample.state[1]);
  }
  return motion_outcome(t, places, std::nullopt);
}

MotionOutcome motion_outcome(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run) {
  std::vector<double> t;
  std::vector<Vector2<double>> places;
  for (const MultibodySample& sample : run.samples) {
    t.push_back(sample.t);
    places.emplace_back(sample.joints[joint].eccentricity / scene.joints[joint].clearance);
  }
  return motion_outcome(t, places, period_of(scene));
}

std::string motion_text(const MotionOutcome& outcome) {
  const auto line = [](const std::string& words) { return "  motion     " + words + "\n"; };
  switch (outcome.kind) {
    case MotionKind::rests:
      return line(
          fmt::format("rests: within {:g} clearances of its last place from {:.4g} s on", same_place, outcome.t));
    case MotionKind::periodic:
      return line(fmt::format("periodic: the last revolution repeats the one before within {:.1e} clearances",
                              outcome.measure));
    case MotionKind::not_periodic:
      return line(fmt::format("not periodic yet: the last revolution is {:.2g} clearances off the one before",
                              outcome.measure));
    case MotionKind::grows:
      return line(
          fmt::format("grows: in its last third the orbit is {:.3g} times as wide as in its second", outcome.measure));
    case MotionKind::dies_away:
      return line(fmt::format("dies away: in its last third the orbit is {:.3g} times as wide as in its second",
                              outcome.measure));
    case MotionKind::keeps_on:
      return line(fmt::format("goes on: in its last third the orbit is {:.3g} times as wide as in its second",
                              outcome.measure));
    case MotionKind::unknown:
      break;
  }
  return {};
}

nlohmann::ordered_json motion_json(const MotionOutcome& outcome) {
  constexpr const char* names[] = {"rests", "periodic", "not_periodic", "grows", "dies_away", "keeps_on"};
  if (outcome.kind == MotionKind::unknown) return nullptr;
  nlohmann::ordered_json json{{"kind", names[static_cast<std::size_t>(outcome.kind)]}, {"measure", outcome.measure}};
  if (outcome.kind == MotionKind::rests) json["t"] = outcome.t;
  return json;
}

}  // namespace lubjoint::reports
