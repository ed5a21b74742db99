#include "oracle/measure/stress/stress_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/results/film_resolution.hpp"

namespace lubjoint::reports {

namespace {

/// Steps whose errors add up to as much as the tolerance allows: a run of more is one whose steps are bound by
/// something else. It rounds in all of them.
constexpr double steps_that_count = 1000;
/// A reference is not known better than to what its two methods differ by, and the sum of two such differences may be
/// larger than either.
constexpr double reference_margin = 10;

/// A distance from what is not finite is infinite.
double finite_or_infinite(double distance) {
  return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

double ratio(double error, double limit) {
  if (error == 0) return 0;
  return limit > 0 && std::isfinite(error) ? error / limit : std::numeric_limits<double>::infinity();  // error/∞ is 0
}

}  // namespace

const char* stress_status_name(StressStatus status) {
  switch (status) {
    case StressStatus::finished:
      return "finished";
    case StressStatus::coarse:
      return "coarse";
    case StressStatus::unreferenced:
      return "unreferenced";
    case StressStatus::stopped:
      return "stopped";
    case StressStatus::wrong:
      break;
  }
  return "wrong";
}

double expected_error(const StressAccuracy& run, double growth) {
  const auto steps = static_cast<double>(run.steps);
  const double most = std::max(std::min(steps_that_count * run.tolerance, 0.1), 1e-3);
  const double of_steps =
      std::min(steps, steps_that_count) * run.tolerance + std::max(steps, run.roundings) * run.rounding;
  return std::min(of_steps * growth, most);
}

StressDeviation deviation_of(const std::vector<StressSample>& samples, const StressReference& reference,
                             const StressAccuracy& run) {
  StressDeviation deviation;
  deviation.over_expected = 0;
  std::array<double, 3> largest{};
  double way = 0;
  Vector2<double> before = samples.empty() ? Vector2<double>(0, 0) : samples.front().place;
  std::size_t j = 0;
  const double force_unit = reference.force_unit > 0 ? reference.force_unit : 1;
  for (const ReferencePlace& row : reference.rows) {
    way += (row.place - before).norm();
    before = row.place;
    while (j < samples.size() && samples[j].t < row.t) ++j;
    if (j == samples.size()) break;
    if (samples[j].t != row.t) continue;
    ++deviation.compared;
    std::array<double, 3> errors = {(samples[j].place - row.place).norm(),
                                    (samples[j].rate - row.rate).norm() / reference.rate_unit,
                                    (samples[j].force - row.force).norm() / force_unit};
    for (double& error : errors) error = finite_or_infinite(error);
    const double expected = expected_error(run, row.growth);
    const double share = std::min(1.0, film_power * expected / run.thinnest_film);
    const double speed = row.rate.norm() / reference.rate_unit;
    const double rates = expected * run.rate_share;
    const std::array<double, 3> limits = {expected, rates, rates * row.force_gain};
    constexpr double open = std::numeric_limits<double>::infinity();
    const double warned_of = expected + std::min(run.unseen * row.growth, 0.1);  // as far as any error may grow
    const bool open_force = run.no_digit || share == 1;
    const std::array<double, 3> warned = {run.no_digit ? 1.0 : std::min(1.0, warned_of + share * way),
                                          run.no_digit ? open : warned_of * run.rate_share + share * (1 + speed),
                                          open_force ? open : warned_of * run.rate_share * row.force_gain};
    static constexpr std::array<const char*, 3> names = {"place", "rate", "force"};
    for (std::size_t k = 0; k < 3; ++k) {
      largest[k] = std::max(largest[k], errors[k]);
      const double known = reference_margin * reference.apart[k];
      const double over = ratio(errors[k], limits[k] + known);
      if (over > deviation.over_expected) {
        deviation.over_expected = over;
        deviation.worst = fmt::format("{} off by {:.1e} at {:.3g} s, where {:.0e} is expected", names[k], errors[k],
                                      row.t, limits[k] + known);
      }
      deviation.over_warned = std::max(deviation.over_warned, ratio(errors[k], warned[k] + known));
    }
  }
  if (deviation.compared > 0) {
    deviation.place = largest[0];
    deviation.rate = largest[1];
    deviation.force = largest[2];
  }
  deviation.whole = reference.whole() && deviation.compared == reference.rows.size();
  return deviation;
}

StressStatus stress_status(bool finished, const StressDeviation& deviation, bool warned) {
  const bool far_off = !(deviation.over_expected <= 1);
  if (far_off && !(warned && deviation.over_warned <= 1)) return StressStatus::wrong;
  if (!finished) return StressStatus::stopped;
  if (far_off) return StressStatus::coarse;
  return deviation.whole ? StressStatus::finished : StressStatus::unreferenced;
}

}  // namespace lubjoint::reports
