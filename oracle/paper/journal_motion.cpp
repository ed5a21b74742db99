#include "oracle/paper/journal_motion.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "oracle/results/angles.hpp"

namespace lubjoint::reports {

namespace {

/// A path seen from a point.
class Path {
 public:
  Path(const std::vector<JournalSample>& samples, const Vector2<double>& centre) : samples_(samples), centre_(centre) {}

  std::size_t size() const { return samples_.size(); }
  double t(std::size_t i) const { return samples_[i].t; }

  Vector2<double> at(std::size_t i) const {
    return {samples_[i].state[0] - centre_.x(), samples_[i].state[1] - centre_.y()};
  }
  double distance(std::size_t i) const { return at(i).norm(); }

  /// At s = 0 … 1 between samples i − 1 and i.
  Vector2<double> between(std::size_t i, double s) const {
    const double h = t(i) - t(i - 1);
    const Vector2<double> from = at(i - 1);
    const Vector2<double> to = at(i);
    const auto cubic = [&](double p0, double p1, std::size_t k) {
      const double m0 = h * samples_[i - 1].state[2 + k];
      const double m1 = h * samples_[i].state[2 + k];
      const double rise = p1 - p0;
      return p0 + s * (m0 + s * (3 * rise - 2 * m0 - m1 + s * (m0 + m1 - 2 * rise)));
    };
    return {cubic(from.x(), to.x(), 0), cubic(from.y(), to.y(), 1)};
  }

 private:
  const std::vector<JournalSample>& samples_;
  Vector2<double> centre_;
};

/// The path passes the direction of a start once more.
struct Return {
  double t;
  double distance;
  std::size_t sample;  ///< the first at or after t
};

std::vector<Return> returns_to(const Path& path, std::size_t start, double floor) {
  std::vector<Return> found;
  const double length = path.distance(start);
  if (!(length > 0)) return found;
  const Vector2<double> direction = path.at(start) / length;
  bool left = false;  // the start's own direction is no return
  for (std::size_t i = start + 1; i < path.size(); ++i) {
    const double before = cross(direction, path.at(i - 1));
    const double after = cross(direction, path.at(i));
    left = left || dot(direction, path.at(i)) < 0;
    if (!left || dot(direction, path.at(i)) <= 0 || before == 0 || (before < 0) == (after < 0)) continue;
    std::uintmax_t iterations = 60;
    const auto bracket =
        boost::math::tools::toms748_solve([&](double s) { return cross(direction, path.between(i, s)); }, 0.0, 1.0,
                                          before, after, boost::math::tools::eps_tolerance<double>(50), iterations);
    const double s = (bracket.first + bracket.second) / 2;
    const double distance = path.between(i, s).norm();
    if (distance < floor) break;
    found.push_back({path.t(i - 1) + s * (path.t(i) - path.t(i - 1)), distance, i});
    left = false;
  }
  return found;
}

/// Nearest and farthest distance of samples first … last − 1.
std::pair<double, double> reach(const Path& path, std::size_t first, std::size_t last) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0;
  for (std::size_t i = first; i < last; ++i) {
    nearest = std::min(nearest, path.distance(i));
    farthest = std::max(farthest, path.distance(i));
  }
  return {nearest, farthest};
}

bool rests(const Path& path) {
  const double end = path.t(path.size() - 1);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (3 * path.t(i) >= 2 * end && !(path.distance(i) <= rest_share * path.distance(0))) return false;
  }
  return true;
}

bool circles(const Path& path) {
  const std::vector<Return> turns = returns_to(path, 0, 0);
  if (turns.size() < circling_turns) return false;
  const auto [nearest, farthest] = reach(path, 0, turns.front().sample);
  if (!(nearest > 0)) return false;
  const double sense = cross(path.at(0), path.at(1));
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!(sense * cross(path.at(i - 1), path.at(i)) > 0)) return false;
    const double distance = path.distance(i);
    if (distance < (1 - circling_share) * nearest || distance > (1 + circling_share) * farthest) return false;
  }
  // Inside of the ring a path could still shrink from its outer to its inner edge.
  const auto [last_nearest, last_farthest] = reach(path, turns[turns.size() - 2].sample, turns.back().sample);
  return std::abs(last_nearest / nearest - 1) <= circling_share &&
         std::abs(last_farthest / farthest - 1) <= circling_share;
}

}  // namespace

std::optional<MotionRate> rate_of_motion(const std::vector<JournalSample>& samples, const Vector2<double>& centre,
                                         double below, double floor) {
  const Path path(samples, centre);
  std::size_t first = 0;
  while (first < path.size() && !(path.distance(first) <= below)) ++first;
  if (first == path.size()) return {};
  const std::vector<Return> of_first = returns_to(path, first, floor);
  if (of_first.empty()) return {};
  constexpr std::size_t directions = 12;
  MotionRate motion{0, 0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  motion.turns = of_first.size();
  std::size_t count = 0;
  const std::size_t turn = of_first.front().sample - first;
  for (std::size_t k = 0; k < std::min(directions, turn); ++k) {
    const std::size_t start = first + k * turn / directions;
    const std::vector<Return> turns = returns_to(path, start, floor);
    if (turns.empty()) continue;
    const double time = turns.back().t - path.t(start);
    const double rate = std::log(turns.back().distance / path.distance(start)) / time;
    motion.rate += rate;
    motion.frequency += two_pi * static_cast<double>(turns.size()) / time;
    motion.least_rate = std::min(motion.least_rate, rate);
    motion.most_rate = std::max(motion.most_rate, rate);
    ++count;
  }
  motion.rate /= static_cast<double>(count);
  motion.frequency /= static_cast<double>(count);
  return motion;
}

const char* behaviour_word(Behaviour behaviour) {
  switch (behaviour) {
    case Behaviour::rests:
      return "rests";
    case Behaviour::circles:
      return "circles";
    case Behaviour::neither:
      break;
  }
  return "neither";
}

Behaviour behaviour_of(const std::vector<JournalSample>& samples, const Vector2<double>& centre) {
  const Path path(samples, centre);
  if (path.size() < 2) return Behaviour::neither;
  if (rests(path)) return Behaviour::rests;
  return circles(path) ? Behaviour::circles : Behaviour::neither;
}

}  // namespace lubjoint::reports
