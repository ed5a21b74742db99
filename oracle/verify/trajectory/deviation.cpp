#include "oracle/verify/trajectory/deviation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "oracle/verify/states/answers.hpp"

namespace lubjoint::verify {

namespace {

constexpr double turn = 2 * boost::math::constants::pi<double>();

/// Another integrator of the same tolerance may err by so many times as much.
constexpr double sensitivity_factor = 4;

double at_or_after(const std::vector<double>& t, const std::vector<double>& values, double time) {
  const auto place = std::ranges::lower_bound(t, time);
  return place == t.end() ? values.back() : values[static_cast<std::size_t>(place - t.begin())];
}

double distance(const std::vector<std::vector<double>>& x, const std::vector<std::vector<double>>& y, std::size_t i) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (x[k][i] - y[k][i]) * (x[k][i] - y[k][i]);
  return std::sqrt(sum);
}

/// The reference's judged times and the given ones, both only where both trajectories are.
std::vector<double> times_to_judge(const Yardstick& yardstick, const Trajectory& given) {
  const std::vector<double> own = thinned({yardstick.fine.t, {}}, yardstick.stride).t;
  const double first = std::max(own.front(), given.t.front()), last = std::min(own.back(), given.t.back());
  if (last - first < (own.back() - own.front()) / 2) {
    throw UnjudgedError(fmt::format(
        "{}: its times are from {} s to {} s, those of the scene from {} s to {} s: required is at least half of that",
        given.name, given.t.front(), given.t.back(), own.front(), own.back()));
  }
  const double until = std::min(last, yardstick.horizon());
  std::vector<double> t;
  std::ranges::set_union(own, given.t, std::back_inserter(t));
  std::erase_if(t, [&](double time) { return time < first || time > until; });
  return t;
}

}  // namespace

double Yardstick::horizon() const {
  for (std::size_t i = 0; i < sensitivity.size(); ++i) {
    if (sensitivity_factor * sensitivity[i] > 0.1 * signal.scale) return fine.t[i];
  }
  return fine.t.back();
}

double Deviation::error(std::size_t i) const { return distance(given, expected, i); }

Deviation deviation(const Yardstick& yardstick, const Trajectory& given) {
  const std::size_t components = yardstick.fine.components();
  Deviation d;
  d.signal = yardstick.signal;
  d.t = times_to_judge(yardstick, given);
  d.horizon = yardstick.horizon();
  d.judged_until = d.t.empty() ? 0 : d.t.back();
  const Samples rows = samples_of(yardstick.signal, given);
  const Curves curve(rows), reference(yardstick.fine);
  // A perfect trajectory on the given times, through every other sample: where those are ours, it is without error.
  const Curves coarse(thinned(yardstick.fine, 2));
  Samples perfect{{}, std::vector<std::vector<double>>(components)};
  for (const double t : rows.t) {
    if (t < coarse.first() || t > coarse.last()) continue;
    perfect.t.push_back(t);
    for (std::size_t k = 0; k < components; ++k) perfect.x[k].push_back(coarse(k, t));
  }
  if (perfect.t.size() < 5) {
    throw UnjudgedError(fmt::format("{}: {} of its rows are within the scene's time; required are at least 5",
                                    given.name, perfect.t.size()));
  }
  const Curves interpolated(perfect);
  d.given.resize(components);
  d.expected.resize(components);
  double squares = 0;
  for (std::size_t i = 0; i < d.t.size(); ++i) {
    const double t = d.t[i];
    double interpolation = 0;
    for (std::size_t k = 0; k < components; ++k) {
      d.given[k].push_back(curve(k, t));
      d.expected[k].push_back(reference(k, t));
      if (t < interpolated.first() || t > interpolated.last()) continue;
      interpolation += std::abs(interpolated(k, t) - d.expected[k].back());
    }
    if (d.signal.kind == SignalKind::angle && i == 0) {  // full turns do not matter
      d.given[0][0] -= turn * std::round((d.given[0][0] - d.expected[0][0]) / turn);
    } else if (d.signal.kind == SignalKind::angle) {
      d.given[0][i] += turn * std::round((d.given[0][0] - curve(0, d.t[0])) / turn);
    }
    d.allowed.push_back(yardstick.tolerance +
                        sensitivity_factor * at_or_after(yardstick.fine.t, yardstick.sensitivity, t) + interpolation);
    const double error = d.error(i);
    squares += error * error;
    if (error / d.allowed[i] <= d.excess) continue;
    d.excess = error / d.allowed[i];
    d.worst = i;
  }
  if (!d.t.empty()) d.rms = std::sqrt(squares / static_cast<double>(d.t.size()));
  return d;
}

}  // namespace lubjoint::verify
