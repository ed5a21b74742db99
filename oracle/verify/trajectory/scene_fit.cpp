#include "oracle/verify/trajectory/scene_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/verify/states/answers.hpp"
#include "oracle/verify/terms/factor.hpp"
#include "oracle/verify/trajectory/scene_mistakes.hpp"

namespace lubjoint::verify {

namespace {

/// Ten times what the longest shipped scene takes; a change that needs more is no likely mistake.
constexpr std::size_t most_steps = 20'000;

using Shift = std::optional<Eigen::VectorXd>;

/// Some of the scene's numbers times factors, given by their logarithms.
class Model {
 public:
  Model(const FailingSignals& failing, std::vector<SceneNumber> numbers)
      : failing_(failing),
        numbers_(std::move(numbers)),
        error_(Eigen::Map<const Eigen::VectorXd>(failing.error().data(),
                                                 static_cast<Eigen::Index>(failing.error().size()))) {}

  std::size_t size() const { return numbers_.size(); }
  const std::string& words(std::size_t i) const { return numbers_[i].words; }
  const Eigen::VectorXd& error() const { return error_; }

  Shift run(const std::vector<std::size_t>& which, const Eigen::VectorXd& logarithms) const {
    Scene scene = failing_.scene();
    for (std::size_t k = 0; k < which.size(); ++k) {
      numbers_[which[k]].scale(scene, std::exp(logarithms[static_cast<Eigen::Index>(k)]));
    }
    const auto shift = failing_.shift(scene);
    if (!shift) return {};
    return Eigen::Map<const Eigen::VectorXd>(shift->data(), static_cast<Eigen::Index>(shift->size()));
  }

  double share(const Eigen::VectorXd& shift) const { return 1 - (error_ - shift).norm() / error_.norm(); }

 private:
  const FailingSignals& failing_;
  std::vector<SceneNumber> numbers_;
  Eigen::VectorXd error_;
};

struct Fitted {
  std::vector<std::size_t> which;
  Eigen::VectorXd logarithms;
  double share = 0;
};

constexpr double difference = 1e-4;  // of a logarithm: the run's tolerance of 1e-9 leaves five digits of the derivative

/// Gauss and Newton from a start; the best of its steps.
Fitted refined(const Model& model, Fitted start) {
  Fitted best = start;
  const auto count = static_cast<Eigen::Index>(start.which.size());
  Eigen::VectorXd x = start.logarithms;
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Shift here = model.run(start.which, x);
    if (!here) break;
    const double share = model.share(*here);
    if (iteration > 0 && share < best.share) break;
    best = {start.which, x, share};
    Eigen::MatrixXd slopes(here->size(), count);
    bool complete = true;
    for (Eigen::Index k = 0; complete && k < count; ++k) {
      Eigen::VectorXd moved = x;
      moved[k] += difference;
      const Shift there = model.run(start.which, moved);
      complete = there.has_value();
      if (complete) slopes.col(k) = (*there - *here) / difference;
    }
    if (!complete) break;
    Eigen::VectorXd step = slopes.colPivHouseholderQr().solve(model.error() - *here);
    const double longest = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest) || longest < 1e-6) break;  // as precise as the derivatives are
    x += step * std::min(1.0, 1.0 / longest);              // at most a factor e at once
  }
  return best;
}

/// Shares that derivatives promise: of each number, and of each pair.
class Linear {
 public:
  Linear(const Model& model, const std::function<void()>& progress) {
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (progress) progress();
      const Shift moved = model.run({i}, Eigen::VectorXd::Constant(1, 1e-3));
      slopes_.push_back(moved ? *moved / 1e-3 : Eigen::VectorXd());
    }
  }

  /// With the logarithms of the factors; the most promising first.
  std::vector<Fitted> singles(const Model& model) const {
    std::vector<Fitted> list;
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      if (matters(i)) list.push_back(promise(model, {i}));
    }
    std::ranges::stable_sort(list, std::ranges::greater(), &Fitted::share);
    return list;
  }
  std::vector<Fitted> pairs(const Model& model) const {
    std::vector<Fitted> list;
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      for (std::size_t j = i + 1; j < slopes_.size(); ++j) {
        if (matters(i) && matters(j)) list.push_back(promise(model, {i, j}));
      }
    }
    std::ranges::stable_sort(list, std::ranges::greater(), &Fitted::share);
    return list;
  }

 private:
  bool matters(std::size_t i) const { return slopes_[i].size() > 0 && slopes_[i].norm() > 1e-3; }

  Fitted promise(const Model& model, const std::vector<std::size_t>& which) const {
    Eigen::MatrixXd slopes(model.error().size(), static_cast<Eigen::Index>(which.size()));
    for (std::size_t k = 0; k < which.size(); ++k) slopes.col(static_cast<Eigen::Index>(k)) = slopes_[which[k]];
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(slopes);
    solver.setThreshold(1e-6);
    const Eigen::VectorXd logarithms = solver.solve(model.error());
    return {which, logarithms.cwiseMin(1.0).cwiseMax(-1.0), model.share(slopes * logarithms)};
  }

  std::vector<Eigen::VectorXd> slopes_;
};

Suspect suspect_of(const Model& model, const Fitted& fitted) {
  std::string text = "as if ";
  for (std::size_t k = 0; k < fitted.which.size(); ++k) {
    text += fmt::format("{}{} were {:#.5g} times as large", k ? ", and " : "", model.words(fitted.which[k]),
                        std::exp(fitted.logarithms[static_cast<Eigen::Index>(k)]));
  }
  return {text, fitted.share};
}

constexpr std::size_t most_refined = 4;
constexpr double enough = 0.98;
constexpr double far_starts[] = {1e-3, 0.01, 0.1, 0.3, 3, 10, 100, 1e3};

}  // namespace

FailingSignals::FailingSignals(const SceneReference& reference, const TrajectoryVerification& verification)
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

std::optional<std::vector<double>> FailingSignals::shift(const Scene& scene) const {
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

double FailingSignals::share(const std::vector<double>& shift) const {
  double left = 0, all = 0;
  for (std::size_t i = 0; i < error_.size(); ++i) {
    left += (error_[i] - shift[i]) * (error_[i] - shift[i]);
    all += error_[i] * error_[i];
  }
  return 1 - std::sqrt(left / all);
}

Scene FailingSignals::scene() const {
  Scene scene = reference_.scene;
  scene.integrator = "radau_iia5";
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-9;
  scene.run.max_steps = std::min(scene.run.max_steps, most_steps);
  return scene;
}

std::vector<Suspect> fitted_numbers(const SceneReference& reference, const FailingSignals& failing,
                                    const std::function<void()>& progress) {
  const auto step = [&] {
    if (progress) progress();
  };
  const Model model(failing, numbers_of(reference.scene));
  const Linear linear(model, progress);
  std::vector<Fitted> found;
  const auto best = [&] { return found.empty() ? 0 : std::ranges::max(found, {}, &Fitted::share).share; };
  const std::vector<Fitted> singles = linear.singles(model);
  for (std::size_t i = 0; i < singles.size() && i < most_refined; ++i) {
    step();
    if (singles[i].share > 0.3) found.push_back(refined(model, singles[i]));
  }
  if (best() < enough) {  // a unit, or a decimal point: far from one
    std::vector<Fitted> far;
    for (const Fitted& single : singles) {
      step();
      Fitted nearest{single.which, Eigen::VectorXd::Zero(1), 0};
      for (const double factor : far_starts) {
        const Eigen::VectorXd logarithm = Eigen::VectorXd::Constant(1, std::log(factor));
        const Shift shift = model.run(single.which, logarithm);
        if (shift && model.share(*shift) > nearest.share) nearest = {single.which, logarithm, model.share(*shift)};
      }
      if (nearest.share > 0) far.push_back(nearest);
    }
    std::ranges::stable_sort(far, std::ranges::greater(), &Fitted::share);
    for (std::size_t i = 0; i < far.size() && i < most_refined; ++i) found.push_back(refined(model, far[i]));
  }
  if (best() < enough) {
    const std::vector<Fitted> pairs = linear.pairs(model);
    for (std::size_t i = 0; i < pairs.size() && i < most_refined; ++i) {
      step();
      found.push_back(refined(model, pairs[i]));
    }
  }
  // Two numbers explain less than one that does as much; a factor of a unit or a diameter more than another one.
  std::ranges::stable_sort(found, std::ranges::greater(), [](const Fitted& f) {
    const bool plain = f.which.size() == 1 && !factor_words(std::exp(f.logarithms[0]), 1e-3).empty();
    return std::round(50 * f.share) - static_cast<double>(f.which.size()) + (plain ? 0.5 : 0.0);
  });
  std::vector<Suspect> list;
  for (const Fitted& each : found) {
    Suspect suspect = suspect_of(model, each);
    if (each.share > 0 && std::ranges::find(list, suspect.words, &Suspect::words) == list.end())
      list.push_back(suspect);
  }
  return list;
}

std::size_t steps_of_fit(const Scene& scene) { return 2 * numbers_of(scene).size() + 2 * most_refined; }

}  // namespace lubjoint::verify
