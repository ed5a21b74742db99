#include "oracle/verify/trajectory/scene_suspects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "oracle/verify/trajectory/scene_fit.hpp"
#include "oracle/verify/trajectory/scene_mistakes.hpp"

namespace lubjoint::verify {

namespace {

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

double norm(const std::vector<double>& x) { return std::sqrt(dot(x, x)); }

/// What explanations of the single signals amount to: one cause of all, or a list of them.
struct CommonSuspect {
  Suspect suspect{"", 0};
  bool one_cause = false;
};

std::optional<CommonSuspect> common_suspect(const TrajectoryVerification& v, const FailingSignals& failing) {
  double left = 0;
  std::vector<double> delays;
  std::size_t count = 0, explained = 0, offsets = 0;
  std::map<std::string, std::set<SignalKind>> opposite;  // by joint
  std::map<std::string, std::string> whose;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < v.deviations.size(); ++i) {
    const Deviation& d = v.deviations[i];
    if (d.agrees()) continue;
    ++count;
    double size = 0;
    for (std::size_t j = 0; j < d.t.size(); ++j) size += std::pow(d.error(j) / d.allowed[j], 2);
    const auto& e = v.explanations[i];
    left += size * (e ? std::pow(1 - e->share, 2) : 1);
    if (!e) continue;
    ++explained;
    words.push_back(d.signal.name() + ": " + e->words);
    if (e->delay) delays.push_back(*e->delay);
    if (e->words == "a constant offset") ++offsets;
    if (e->opposite) opposite[d.signal.owner].insert(d.signal.kind);
    if (!e->whose.empty()) whose[d.signal.owner] = e->whose;
  }
  if (explained == 0) return {};
  const double share = 1 - std::sqrt(left) / norm(failing.error());
  const auto [least, most] = std::ranges::minmax_element(delays);
  // What grows evenly, as a driven angle, is offset when it is late.
  if (!delays.empty() && delays.size() + offsets == count && offsets < delays.size() &&
      *most - *least <= 0.02 * std::abs(*most)) {
    const char* side = *most > 0 ? "late" : "early";
    return CommonSuspect{{fmt::format("the whole trajectory is {:.4g} s {}", std::abs(*most), side), share}, true};
  }
  for (const auto& each : opposite) {
    const std::string& owner = each.first;  // a structured binding is nothing that Clang 14 lets a lambda have
    const std::set<SignalKind>& kinds = each.second;
    if (!kinds.contains(SignalKind::eccentricity) || !kinds.contains(SignalKind::force)) continue;
    std::erase_if(words, [&](const std::string& line) { return line.starts_with(owner + ": "); });
    words.insert(words.begin(), "bearing and journal of " + owner + " are exchanged");
  }
  for (const auto& each : whose) {
    const std::string& owner = each.first;
    const std::string& other = each.second;
    if (!whose.contains(other) || whose.at(other) != owner || owner > other) continue;
    std::erase_if(words, [&](const std::string& line) {
      return line.starts_with(owner + ": ") || line.starts_with(other + ": ");
    });
    words.insert(words.begin(), fmt::format("the columns of {} and {} are exchanged", owner, other));
  }
  std::string all;
  for (const std::string& line : words) all += (all.empty() ? "" : "; ") + line;
  return CommonSuspect{{all, share}, words.size() == 1};
}

std::vector<Suspect> scene_suspects(const SceneReference& reference, const FailingSignals& failing,
                                    const std::function<void()>& progress) {
  std::vector<Suspect> list;
  for (const SceneVariant& change : changes_of(reference.scene)) {
    if (progress) progress();
    Scene scene = failing.scene();
    change.apply(scene);
    if (const auto shift = failing.shift(scene)) list.push_back({"as if " + change.words, failing.share(*shift)});
  }
  for (const Suspect& suspect : fitted_numbers(reference, failing, progress)) list.push_back(suspect);
  return list;
}

/// The tolerance at which our own run is about as wrong; none between 1e-6 and 1e-2.
std::optional<Suspect> inaccurate(const FailingSignals& failing) {
  for (const double tolerance : {1e-5, 1e-4, 1e-3, 1e-2}) {
    Scene scene = failing.scene();
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    const auto shift = failing.shift(scene);
    if (!shift) return {};
    const double ratio = norm(*shift) / norm(failing.error());
    if (ratio < 1.0 / 3) continue;
    if (ratio > 3) return {};
    return Suspect{fmt::format("right, but not accurate: our own run at tolerance {} is about as wrong", tolerance), 0};
  }
  return {};
}

}  // namespace

std::vector<Suspect> suspects(const SceneReference& reference, const TrajectoryVerification& verification,
                              const std::function<void()>& progress) {
  const FailingSignals failing(reference, verification);
  std::vector<Suspect> list;
  if (const auto common = common_suspect(verification, failing)) {
    list.push_back(common->suspect);
    if (common->one_cause && common->suspect.share >= 0.98) return list;
  }
  for (const Suspect& suspect : scene_suspects(reference, failing, progress)) list.push_back(suspect);
  std::erase_if(list, [](const Suspect& suspect) { return suspect.share < 2.0 / 3; });
  // In their order where they explain alike: one change before one number before two.
  std::ranges::stable_sort(list, std::ranges::greater(), [](const Suspect& s) { return std::round(50 * s.share); });
  if (list.size() > 5) list.resize(5);
  if (list.empty()) {
    if (const auto suspect = inaccurate(failing)) list.push_back(*suspect);
  }
  return list;
}

std::size_t runs_of_search(const Scene& scene) { return changes_of(scene).size() + steps_of_fit(scene); }

}  // namespace lubjoint::verify
