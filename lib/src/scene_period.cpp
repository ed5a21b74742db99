#include "lubjoint/scene/scene_period.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "overloaded.hpp"
#include "scene_tables.hpp"

namespace lubjoint {

namespace {

/// Does a time hold a period a whole number of times, to rounding of a file's digits?
bool holds(double time, double period) {
  const double count = std::round(time / period);
  return count >= 1 && std::abs(time - count * period) <= 1e-9 * time;
}

/// What a driver's speed is to the period of its motion.
enum class Way { turns, slides };

/// Adds the periods of what a driver prescribes. @returns whether it repeats
template <class AnyDriver>
bool add_periods(const AnyDriver& driver, Way way, std::vector<double>& periods) {
  if (driver.acceleration != 0 || (way == Way::slides && driver.speed != 0)) return false;
  if (driver.speed != 0) periods.push_back(2 * std::numbers::pi / std::abs(driver.speed));
  if (!driver.shape) return true;
  if (driver.shape->table) return false;
  if (driver.shape->amplitude != 0) periods.push_back(2 * std::numbers::pi / std::abs(driver.shape->rate));
  return true;
}

}  // namespace

std::optional<double> scene_period(const Scene& scene) {
  std::vector<double> periods;
  bool repeats = true;
  for (const SceneLoad& load : scene.loads) {
    if (load.harmonic) periods.push_back(2 * std::numbers::pi / std::abs(load.harmonic->rate));
    if (!load.table) continue;
    if (load.table->of_angle) {
      const std::optional<EvenTurn> turn = even_turn(scene, load.table->against);
      repeats = repeats && turn && turn->speed != 0;
      if (repeats) periods.push_back(load.table->curves->length() / std::abs(turn->speed));
    } else {
      repeats = repeats && load.table->curves->is_periodic();
      periods.push_back(load.table->curves->length());
    }
  }
  for (const SceneConstraint& each : scene.constraints) {
    const bool of_each = std::visit(
        Overloaded{[&](const Driver<double>& driver) { return add_periods(driver, Way::turns, periods); },
                   [&](const SlideDriver<double>& driver) { return add_periods(driver, Way::slides, periods); },
                   [](const GroundConstraint<double>&) { return true; }, [](const Revolute<double>&) { return true; },
                   [](const Translational<double>&) { return true; }},
        each.constraint);
    repeats = repeats && of_each;
  }
  for (const SceneBody& body : scene.bodies) {
    if (body.spin_is_held && body.spin != 0) periods.push_back(2 * std::numbers::pi / std::abs(body.spin));
  }
  if (!repeats || periods.empty()) return std::nullopt;
  const double longest = *std::max_element(periods.begin(), periods.end());
  for (int count = 1; count <= 24; ++count) {
    const double period = count * longest;
    if (std::all_of(periods.begin(), periods.end(), [&](double each) { return holds(period, each); })) return period;
  }
  return std::nullopt;
}

}  // namespace lubjoint
