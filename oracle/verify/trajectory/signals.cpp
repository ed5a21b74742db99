#include "oracle/verify/trajectory/signals.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/scene/multibody_scene.hpp"

namespace lubjoint::verify {

namespace {

constexpr double turn = 2 * boost::math::constants::pi<double>();

/// Adds signals with scales from the reference's largest value.
class SignalList {
 public:
  explicit SignalList(const Trajectory& reference) : reference_(reference) {}

  /// @param scale  0: the reference's largest value, but at least `least`
  void add(SignalKind kind, const std::string& owner, const std::string& quantity,
           const std::vector<std::string>& columns, double scale, double least, double unit,
           const std::string& unit_name) {
    Signal signal{kind, owner, quantity, {}, scale, unit, unit_name};
    const std::string prefix = owner + ".";
    for (const std::string& column : columns) signal.columns.push_back(prefix + column);
    const bool known = std::ranges::all_of(signal.columns, [&](const auto& column) { return reference_.has(column); });
    if (!known) return;
    if (scale == 0) signal.scale = std::max(largest(signal), least);
    list.push_back(std::move(signal));
  }

  std::vector<Signal> list;

 private:
  double largest(const Signal& signal) const {
    double squared = 0;
    for (std::size_t i = 0; i < reference_.t.size(); ++i) {
      double sum = 0;
      for (const std::string& column : signal.columns) sum += std::pow(reference_.columns.at(column)[i], 2);
      squared = std::max(squared, sum);
    }
    return std::sqrt(squared);
  }

  const Trajectory& reference_;
};

}  // namespace

std::vector<Signal> signals_of(const Scene& scene, const Trajectory& reference) {
  const SceneUnits units = scene_units(scene);
  const bool jointed = !scene.joints.empty();
  const double length_unit = jointed ? units.length : 1;
  const std::string length_name = jointed ? "clearances" : "m";
  SignalList signals(reference);
  for (const SceneJoint& joint : scene.joints) {
    const double c = joint.clearance;
    signals.add(SignalKind::eccentricity, joint.name, "eccentricity", {"ex", "ey"}, c, 0, c, "clearances");
    signals.add(SignalKind::ratio, joint.name, "eccentricity ratio", {"eccentricity_ratio"}, 1, 0, 1, "-");
    signals.add(SignalKind::thickness, joint.name, "film thickness", {"film_thickness"}, c, 0, c, "clearances");
    signals.add(SignalKind::force, joint.name, "force on the journal", {"fx", "fy"}, 0, units.energy / units.mechanism,
                1, "N");
  }
  for (const SceneBody& body : scene.bodies) {
    signals.add(SignalKind::place, body.name, "place", {"x", "y"}, units.length, 0, length_unit, length_name);
    signals.add(SignalKind::angle, body.name, "angle", {"phi"}, units.angle, 0, 1, "rad");
    signals.add(SignalKind::velocity, body.name, "velocity", {"vx", "vy"}, 0, units.length * units.rate, 1, "m/s");
    signals.add(SignalKind::spin, body.name, "spin", {"omega"}, 0, units.angle * units.rate, 1, "rad/s");
  }
  for (const SceneConstraint& each : scene.constraints) {
    if (std::holds_alternative<Driver<double>>(each.constraint))
      signals.add(SignalKind::moment, each.name, "driving moment", {"moment"}, 0, units.energy, 1, "N m");
    if (std::holds_alternative<SlideDriver<double>>(each.constraint))
      signals.add(SignalKind::moment, each.name, "driving force", {"force"}, 0, units.energy / units.mechanism, 1, "N");
  }
  for (const char* term : {"kinetic", "potential"}) {
    signals.add(SignalKind::energy, "energy", term, {term}, 0, units.energy, 1, "J");
  }
  for (std::size_t i = 0; i < ledger_works(scene); ++i) {
    const char* term = ledger_names[i];
    signals.add(SignalKind::energy, "work", std::string("of ") + term, {term}, 0, units.energy, 1, "J");
  }
  return std::move(signals.list);
}

std::vector<Signal> signals_in(const std::vector<Signal>& signals, const Trajectory& given) {
  std::vector<Signal> list;
  for (Signal signal : signals) {
    const std::size_t all = signal.columns.size();
    std::erase_if(signal.columns, [&](const std::string& column) { return !given.has(column); });
    if (signal.columns.empty()) continue;
    if (signal.columns.size() < all) {
      signal.quantity += ", " + signal.columns.front().substr(signal.owner.size() + 1) + " alone";
    }
    list.push_back(std::move(signal));
  }
  return list;
}

std::vector<std::string> add_eccentricities(const Scene& scene, Trajectory& given) {
  std::vector<std::string> used;
  for (const SceneJoint& joint : scene.joints) {
    const std::string ratio = joint.name + ".eccentricity_ratio", attitude = joint.name + ".attitude";
    const std::string ex = joint.name + ".ex", ey = joint.name + ".ey";
    if (!given.has(ratio) || !given.has(attitude) || given.has(ex) || given.has(ey)) continue;
    used.push_back(attitude);
    for (std::size_t i = 0; i < given.t.size(); ++i) {
      const double distance = joint.clearance * given.columns[ratio][i], angle = given.columns[attitude][i];
      given.columns[ex].push_back(distance * std::cos(angle));
      given.columns[ey].push_back(distance * std::sin(angle));
    }
  }
  return used;
}

Samples samples_of(const Signal& signal, const Trajectory& trajectory) {
  Samples samples{trajectory.t, {}};
  for (const std::string& column : signal.columns) samples.x.push_back(trajectory.columns.at(column));
  if (signal.kind != SignalKind::angle) return samples;
  std::vector<double>& angle = samples.x.front();
  for (std::size_t i = 1; i < angle.size(); ++i) {
    angle[i] -= turn * std::round((angle[i] - angle[i - 1]) / turn);
  }
  return samples;
}

}  // namespace lubjoint::verify
