#include "oracle/verify/scene_suspects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/verify/answers.hpp"
#include "oracle/verify/scene_mistakes.hpp"

namespace lubjoint::verify {

namespace {

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

double norm(const std::vector<double>& x) { return std::sqrt(dot(x, x)); }

/// x − factor y
std::vector<double> less(std::vector<double> x, double factor, const std::vector<double>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= factor * y[i];
  return x;
}

/// The failing signals as one list of numbers, each over what is allowed.
class Failing {
 public:
  Failing(const SceneReference& reference, const TrajectoryVerification& verification)
      : reference_(reference), deviations_(verification.deviations) {
    for (const Deviation& d : deviations_) {
      if (d.agrees()) continue;
      for (std::size_t k = 0; k < d.given.size(); ++k) {
        for (std::size_t i = 0; i < d.t.size(); ++i) {
          error_.push_back((d.given[k][i] - d.expected[k][i]) / d.allowed[i]);
        }
      }
    }
  }

  const std::vector<double>& error() const { return error_; }

  /// How far another scene's run is from the reference; none if it does not run to the end.
  std::optional<std::vector<double>> shift(const Scene& scene) const {
    try {
      const Trajectory run = simulated(scene);
      std::vector<double> list;
      for (const Deviation& d : deviations_) {
        if (d.agrees()) continue;
        const Curves curve(samples_of(d.signal, run));
        for (std::size_t k = 0; k < d.given.size(); ++k) {
          for (std::size_t i = 0; i < d.t.size(); ++i) {
            list.push_back((curve(k, std::min(d.t[i], curve.last())) - d.expected[k][i]) / d.allowed[i]);
          }
        }
      }
      return list;
    } catch (const UnjudgedError&) {
      return {};
    } catch (const SceneError&) {
      return {};  // a change that makes no scene
    } catch (const std::invalid_argument&) {
      return {};
    }
  }

  double share(const std::vector<double>& explained) const {
    return 1 - norm(less(error_, 1, explained)) / norm(error_);
  }

  /// The scene with settings of which a search can afford many runs.
  Scene scene() const {
    Scene scene = reference_.scene;
    scene.integrator = "radau_iia5";
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-9;
    scene.run.max_steps = std::min(scene.run.max_steps, most_steps);
    return scene;
  }

 private:
  const SceneReference& reference_;
  const std::vector<Deviation>& deviations_;
  /// Ten times what the longest shipped scene takes; a change that needs more is no likely mistake.
  static constexpr std::size_t most_steps = 20'000;

  std::vector<double> error_;
};

/// What explanations of the single signals amount to: one cause of all, or a list of them.
struct CommonSuspect {
  Suspect suspect{"", 0};
  bool one_cause = false;
};

std::optional<CommonSuspect> common_suspect(const TrajectoryVerification& v, const Failing& failing) {
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

/// A number of the scene whose factor is fitted, by Gauss and Newton.
class Fit {
 public:
  Fit(const Failing& failing, SceneNumber number) : failing_(&failing), number_(std::move(number)) {
    constexpr double step = 1e-3;
    const auto moved = run(1 + step);
    if (!moved) return;
    slope_ = *moved;
    for (double& value : slope_) value /= step;
    if (norm(slope_) < 1e-3) return;  // the number does not matter
    factor_ = 1 + dot(slope_, failing_->error()) / dot(slope_, slope_);
    linear_share_ = failing_->share(less(std::vector<double>(slope_.size(), 0), 1 - factor_, slope_));
  }

  double linear_share() const { return linear_share_; }

  /// Two steps of it, the better one.
  std::optional<Suspect> refined() const {
    Suspect best{"", 0};
    double factor = factor_;
    for (int i = 0; i < 3; ++i) {
      if (!(factor > 0.2 && factor < 5)) break;
      const auto shift = run(factor);
      if (!shift) break;
      const double share = failing_->share(*shift);
      if (share > best.share) best = {fmt::format("as if {} were {:.5g} times as large", number_.words, factor), share};
      factor += dot(slope_, less(failing_->error(), 1, *shift)) / dot(slope_, slope_);
    }
    return best.share > 0 ? std::optional(best) : std::nullopt;
  }

 private:
  std::optional<std::vector<double>> run(double factor) const {
    Scene scene = failing_->scene();
    number_.scale(scene, factor);
    return failing_->shift(scene);
  }

  const Failing* failing_;
  SceneNumber number_;
  std::vector<double> slope_;
  double factor_ = 1;
  double linear_share_ = 0;
};

constexpr std::size_t most_refined = 4;

std::vector<Suspect> scene_suspects(const SceneReference& reference, const Failing& failing,
                                    const std::function<void()>& progress) {
  std::vector<Suspect> list;
  for (const SceneChange& change : changes_of(reference.scene)) {
    if (progress) progress();
    Scene scene = failing.scene();
    change.apply(scene);
    if (const auto shift = failing.shift(scene)) list.push_back({"as if " + change.words, failing.share(*shift)});
  }
  std::vector<Fit> fits;
  for (const SceneNumber& number : numbers_of(reference.scene)) {
    if (progress) progress();
    fits.emplace_back(failing, number);
  }
  std::ranges::stable_sort(fits, std::ranges::greater(), &Fit::linear_share);
  for (std::size_t i = 0; i < fits.size() && i < most_refined; ++i) {
    if (fits[i].linear_share() < 0.3) break;
    if (progress) progress();
    if (const auto suspect = fits[i].refined()) list.push_back(*suspect);
  }
  return list;
}

/// The tolerance at which our own run is about as wrong; none between 1e-6 and 1e-2.
std::optional<Suspect> inaccurate(const Failing& failing) {
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
  const Failing failing(reference, verification);
  std::vector<Suspect> list;
  if (const auto common = common_suspect(verification, failing)) {
    list.push_back(common->suspect);
    if (common->one_cause && common->suspect.share >= 0.98) return list;
  }
  for (const Suspect& suspect : scene_suspects(reference, failing, progress)) list.push_back(suspect);
  std::erase_if(list, [](const Suspect& suspect) { return suspect.share < 2.0 / 3; });
  std::ranges::stable_sort(list, std::ranges::greater(), &Suspect::share);
  if (list.size() > 5) list.resize(5);
  if (list.empty()) {
    if (const auto suspect = inaccurate(failing)) list.push_back(*suspect);
  }
  return list;
}

std::size_t runs_of_search(const Scene& scene) {
  return changes_of(scene).size() + numbers_of(scene).size() + most_refined;
}

}  // namespace lubjoint::verify
