// What an error of a trajectory looks like.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>

#include "oracle/verify/trajectory/deviation.hpp"

namespace lubjoint::verify {

namespace {

using Components = std::vector<std::vector<double>>;
constexpr double pi = boost::math::constants::pi<double>();

double rms_distance(const Components& x, const Components& y) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t i = 0; i < x[k].size(); ++i) sum += (x[k][i] - y[k][i]) * (x[k][i] - y[k][i]);
  }
  return std::sqrt(sum / static_cast<double>(x.front().size()));
}

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

Components scaled(const Components& x, const std::vector<double>& factors) {
  Components result = x;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (double& value : result[k]) value *= factors[k];
  }
  return result;
}

Components about_means(const Components& x) {
  Components result = x;
  for (std::vector<double>& component : result) {
    const double middle = mean(component);
    for (double& value : component) value -= middle;
  }
  return result;
}

double product(const Components& x, const Components& y) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t i = 0; i < x[k].size(); ++i) sum += x[k][i] * y[k][i];
  }
  return sum;
}

/// The factor of y in x that fits best; 1 where y is nil.
double fitted_factor(const Components& x, const Components& y) {
  const double square = product(y, y);
  return square > 0 ? product(x, y) / square : 1;
}

std::string opposite_words(SignalKind kind) {
  switch (kind) {
    case SignalKind::force:
      return "the opposite sign: the force on the bearing, not on the journal";
    case SignalKind::eccentricity:
      return "the opposite sign: from the journal's centre to the bearing's";
    case SignalKind::moment:
      return "the opposite sign: the moment on the body against which is driven";
    default:
      return "the opposite sign";
  }
}

struct Unit {
  double factor;
  const char* words;
};

/// Units in which such a signal may have been written instead of SI.
std::vector<Unit> units_of(const Signal& signal) {
  switch (signal.kind) {
    case SignalKind::eccentricity:
    case SignalKind::thickness:
      return {{1 / signal.scale, "in clearances, not in metres"},
              {1e3, "in millimetres"},
              {1e6, "in micrometres"},
              {2, "twice: diametral"},
              {0.5, "half"}};
    case SignalKind::place:
      return {{1e3, "in millimetres"}};
    case SignalKind::velocity:
      return {{1e3, "in mm/s"}};
    case SignalKind::angle:
      return {{180 / pi, "in degrees"}};
    case SignalKind::spin:
      return {{180 / pi, "in degrees per second"}, {30 / pi, "in revolutions per minute"}};
    case SignalKind::force:
      return {{1e-3, "in kN"}, {2, "twice"}, {0.5, "half"}};
    case SignalKind::moment:
      return {{1e3, "in N mm"}};
    default:
      return {};
  }
}

/// Collects candidates in the order of their simplicity.
class Candidates {
 public:
  explicit Candidates(const Deviation& deviation) : deviation_(deviation) {}

  /// The error that is left once it is looked at in this way.
  void add(double left, Explanation explanation) {
    explanation.share = deviation_.rms > 0 ? 1 - left / deviation_.rms : 0;
    list_.push_back(std::move(explanation));
  }

  /// The first that leaves at most one and a half times what the best one leaves, or no more than is allowed anyway.
  std::optional<Explanation> best() const {
    double most = 0;
    for (const Explanation& each : list_) most = std::max(most, each.share);
    if (most < 2.0 / 3) return {};
    const double allowed = deviation_.rms > 0 ? std::ranges::min(deviation_.allowed) / deviation_.rms : 0;
    for (const Explanation& each : list_) {
      if (1 - each.share <= std::max(1.5 * (1 - most) + 1e-6, std::min(allowed, 0.01))) return each;
    }
    return {};
  }

 private:
  const Deviation& deviation_;
  std::vector<Explanation> list_;
};

void add_signs_and_axes(const Deviation& d, Candidates& candidates) {
  const std::size_t n = d.expected.size();
  Explanation opposite{opposite_words(d.signal.kind), 0, {}, {}, true};
  candidates.add(rms_distance(d.given, scaled(d.expected, std::vector<double>(n, -1))), opposite);
  for (const Unit& unit : units_of(d.signal)) {
    candidates.add(rms_distance(d.given, scaled(d.expected, std::vector<double>(n, unit.factor))), {unit.words});
  }
  if (n != 2) return;
  candidates.add(rms_distance(d.given, {d.expected[1], d.expected[0]}), {"x and y are exchanged"});
  candidates.add(rms_distance(d.given, scaled(d.expected, {1, -1})), {"y has the opposite sign"});
  candidates.add(rms_distance(d.given, scaled(d.expected, {-1, 1})), {"x has the opposite sign"});
}

void add_others(const Deviation& d, const std::vector<Yardstick>& all, Candidates& candidates) {
  for (const Yardstick& other : all) {
    const bool alike = other.signal.kind == d.signal.kind && other.signal.owner != d.signal.owner &&
                       other.signal.columns.size() == d.signal.columns.size();
    if (!alike || d.signal.kind == SignalKind::energy) continue;
    const Curves curve(other.fine);
    Components theirs(d.expected.size());
    for (const double t : d.t) {
      for (std::size_t k = 0; k < theirs.size(); ++k) theirs[k].push_back(curve(k, t));
    }
    candidates.add(rms_distance(d.given, theirs), {"it is that of " + other.signal.owner, 0, {}, other.signal.owner});
  }
}

/// A delay of at most a tenth of the duration.
void add_delay(const Deviation& d, const Trajectory& given, Candidates& candidates) {
  const Samples rows = samples_of(d.signal, given);
  const Curves curve(rows);
  const auto left = [&](double delay) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < d.t.size(); ++i) {
      const double t = d.t[i] + delay;
      if (t < curve.first() || t > curve.last()) continue;
      for (std::size_t k = 0; k < d.expected.size(); ++k) {
        // Angles were turned by full turns.
        const double turned = d.given[k][0] - curve(k, d.t[0]);
        sum += std::pow(curve(k, t) + turned - d.expected[k][i], 2);
      }
      ++count;
    }
    return count == 0 ? INFINITY : std::sqrt(sum / static_cast<double>(count));
  };
  constexpr int steps = 200;
  const double step = 0.2 * (d.t.back() - d.t.front()) / steps;
  int best = 0;
  for (int i = -steps / 2; i <= steps / 2; ++i) {
    if (left(i * step) < left(best * step)) best = i;
  }
  const auto [delay, rms] = boost::math::tools::brent_find_minima(left, (best - 1) * step, (best + 1) * step, 30);
  candidates.add(rms,
                 {fmt::format("a phase shift: {:.4g} s {}", std::abs(delay), delay > 0 ? "late" : "early"), 0, delay});
}

void add_fits(const Deviation& d, Candidates& candidates) {
  const std::size_t n = d.expected.size();
  const double factor = fitted_factor(d.given, d.expected);
  candidates.add(rms_distance(d.given, scaled(d.expected, std::vector<double>(n, factor))),
                 {fmt::format("an amplitude error: {:.6g} times the reference's", factor)});
  const Components given = about_means(d.given), expected = about_means(d.expected);
  candidates.add(rms_distance(given, expected), {"a constant offset"});
  const double about = fitted_factor(given, expected);
  candidates.add(rms_distance(given, scaled(expected, std::vector<double>(n, about))),
                 {fmt::format("an amplitude error about its mean: {:.6g} times the reference's", about)});
}

}  // namespace

std::optional<Explanation> explanation(const Deviation& deviation, const Trajectory& given,
                                       const std::vector<Yardstick>& all) {
  if (deviation.t.size() < 5) return {};
  Candidates candidates(deviation);
  add_signs_and_axes(deviation, candidates);
  add_others(deviation, all, candidates);
  add_delay(deviation, given, candidates);
  add_fits(deviation, candidates);
  return candidates.best();
}

}  // namespace lubjoint::verify
