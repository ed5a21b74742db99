#include "oracle/verify/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <optional>

#include "oracle/reports/csv_table.hpp"
#include "oracle/verify/answers.hpp"

namespace lubjoint::verify {

namespace {

using Curve = boost::math::interpolators::makima<std::vector<double>>;

Curve curve(const std::vector<double>& t, const std::vector<double>& x) {
  return Curve(std::vector<double>(t), std::vector<double>(x));
}

std::vector<double> numbers(const reports::CsvTable& table, const std::string& column) {
  const std::size_t place = table.column(column);
  std::vector<double> list;
  for (std::size_t row = 0; row < table.rows(); ++row) list.push_back(table.number(row, place));
  return list;
}

bool has_column(const reports::CsvTable& table, const std::string& column) {
  return ("," + table.header() + ",").find("," + column + ",") != std::string::npos;
}

/// Root mean square distance of the path, `delay` later, from the reference, over the times that both have.
double mean_distance(const Path& reference, const Curve& x, const Curve& y, double first, double last, double delay) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    const double t = reference.t[i] + delay;
    if (t < first || t > last) continue;
    sum += std::pow(x(t) - reference.ex[i], 2) + std::pow(y(t) - reference.ey[i], 2);
    ++count;
  }
  return count == 0 ? INFINITY : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

Path read_path(std::string_view csv, const std::string& name, const std::string& joint, double clearance) {
  try {
    const reports::CsvTable table(csv, name);
    Path path{numbers(table, "t"), numbers(table, joint + ".ex"), numbers(table, joint + ".ey"), {}, {}};
    for (std::vector<double>* e : {&path.ex, &path.ey}) {
      for (double& value : *e) value /= clearance;
    }
    if (has_column(table, joint + ".fx") && has_column(table, joint + ".fy")) {
      path.fx = numbers(table, joint + ".fx");
      path.fy = numbers(table, joint + ".fy");
    }
    if (path.t.size() < 5) {
      throw UnjudgedError(fmt::format("{}: {} rows; required are at least 5", name, path.t.size()));
    }
    const auto back = std::ranges::adjacent_find(path.t, [](double a, double b) { return !(a < b); });
    if (back != path.t.end()) throw UnjudgedError(fmt::format("{}: times must increase; {} does not", name, back[1]));
    return path;
  } catch (const reports::CsvError& error) {
    throw UnjudgedError(error.what());
  }
}

PathComparison compare_paths(const Path& reference, const Path& path) {
  const double first = path.t.front(), last = path.t.back();
  const double duration = reference.t.back() - reference.t.front();
  if (std::min(last, reference.t.back()) - std::max(first, reference.t.front()) < duration / 2) {
    throw UnjudgedError(
        fmt::format("the trajectory is from {} s to {} s; the reference from {} s to {} s: required is "
                    "at least half of that",
                    first, last, reference.t.front(), reference.t.back()));
  }
  const Curve x = curve(path.t, path.ex), y = curve(path.t, path.ey);
  std::optional<Curve> fx, fy;
  const bool forces = !path.fx.empty() && !reference.fx.empty();
  if (forces) {
    fx = curve(path.t, path.fx);
    fy = curve(path.t, path.fy);
  }
  PathComparison result;
  double means[4] = {0, 0, 0, 0};  // of the reference's and the path's x and y
  std::vector<std::size_t> common;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    const double t = reference.t[i];
    if (t < first || t > last) continue;
    common.push_back(i);
    const double distance = std::hypot(x(t) - reference.ex[i], y(t) - reference.ey[i]);
    if (distance > result.worst) {
      result.worst = distance;
      result.worst_time = t;
    }
    if (forces) result.force = std::max(result.force, std::hypot((*fx)(t)-reference.fx[i], (*fy)(t)-reference.fy[i]));
    means[0] += reference.ex[i];
    means[1] += reference.ey[i];
    means[2] += x(t);
    means[3] += y(t);
  }
  result.times = common.size();
  for (double& m : means) m /= static_cast<double>(common.size());
  result.mean = mean_distance(reference, x, y, first, last, 0);

  const auto late = [&](double delay) { return mean_distance(reference, x, y, first, last, delay); };
  constexpr int steps = 200;
  const double step = 0.2 * duration / steps;
  int best = 0;
  for (int i = -steps / 2; i <= steps / 2; ++i) {
    if (late(i * step) < late(best * step)) best = i;
  }
  const auto [delay, mean] = boost::math::tools::brent_find_minima(late, (best - 1) * step, (best + 1) * step, 30);
  result.delay = delay;
  result.mean_without_delay = mean;

  double product = 0, square = 0;
  for (const std::size_t i : common) {
    const double t = reference.t[i], rx = reference.ex[i] - means[0], ry = reference.ey[i] - means[1];
    product += rx * (x(t) - means[2]) + ry * (y(t) - means[3]);
    square += rx * rx + ry * ry;
  }
  if (square > 0) result.amplitude = product / square;
  double left = 0;
  for (const std::size_t i : common) {
    const double t = reference.t[i];
    left += std::pow(x(t) - means[2] - result.amplitude * (reference.ex[i] - means[0]), 2) +
            std::pow(y(t) - means[3] - result.amplitude * (reference.ey[i] - means[1]), 2);
  }
  result.mean_without_amplitude = std::sqrt(left / static_cast<double>(common.size()));
  return result;
}

std::string PathComparison::words() const {
  const double least = std::min(mean_without_delay, mean_without_amplitude);
  if (least > mean / 3) return "neither a phase shift nor an amplitude error alone";
  if (mean_without_delay <= mean_without_amplitude) {
    return fmt::format("a phase shift: {:.4g} s {}; without it the mean error is {:.2g} clearances", std::abs(delay),
                       delay > 0 ? "late" : "early", mean_without_delay);
  }
  return fmt::format("an amplitude error: {:.6g} times the reference's; without it the mean error is {:.2g} clearances",
                     amplitude, mean_without_amplitude);
}

}  // namespace lubjoint::verify
