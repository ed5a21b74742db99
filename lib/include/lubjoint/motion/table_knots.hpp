/// Knots of tables over a body's angle: places where derivatives of a load jump, and where a step ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// The interval of each table that a run is in. A body that turns either way meets the knot at the end that it turns
/// to.
template <class R>
class TableKnots {
 public:
  using State = std::vector<R>;  ///< (q, q̇, work)

  static constexpr std::size_t margins_each = 2;  ///< surfaces of each table

  /// Finds the tables of a system's loads.
  explicit TableKnots(const PlanarSystem<R>& system) : coordinates_(system.coordinates()) {
    for (const MovingLoad<R>& each : system.elements().loads) {
      const auto* load = std::get_if<TableLoad<R>>(&each);
      if (load == nullptr || !load->of_angle || load->at_known_times) continue;
      const bool known = std::any_of(watched_.begin(), watched_.end(), [&](const Watched& w) {
        return w.body == load->against && w.table == load->table.get();
      });
      if (!known) watched_.push_back({load->against, load->table.get(), 0, 0});
    }
  }

  bool empty() const { return watched_.empty(); }                         ///< is there no such table?
  std::size_t margins() const { return margins_each * watched_.size(); }  ///< number of surfaces

  /// The intervals that a start is in: at a knot, the one that the body turns into.
  void start(const State& y) {
    for (Watched& each : watched_) {
      const R& angle = y[planar_coordinates * each.body + 2];
      const double place = static_cast<double>(angle);
      each.turns = each.table->periods(place);
      each.interval = each.table->interval(place - each.turns * each.table->length());
      const R& spin = y[coordinates_ + planar_coordinates * each.body + 2];
      if (spin < 0 && !(angle - low(each) > rounding(angle))) move(each, false);
      if (spin > 0 && !(high(each) - angle > rounding(angle))) move(each, true);
    }
  }

  /// Adds the distances to the lower and to the upper knot of each interval [rad].
  void add_margins(const State& y, std::vector<Margin<R>>& list) const {
    for (const Watched& each : watched_) {
      const R& angle = y[planar_coordinates * each.body + 2];
      list.push_back({R(angle - low(each)), rounding(angle)});
      list.push_back({R(high(each) - angle), rounding(angle)});
    }
  }

  /// Into the next interval beyond a surface.
  void cross(std::size_t margin) { move(watched_[margin / margins_each], margin % margins_each == 1); }

 private:
  struct Watched {
    std::size_t body;
    const TableCurves<3>* table;
    std::size_t interval;
    double turns;  ///< periods of the table before it
  };

  static R low(const Watched& w) { return R(w.table->knots()[w.interval] + w.turns * w.table->length()); }
  static R high(const Watched& w) { return R(w.table->knots()[w.interval + 1] + w.turns * w.table->length()); }
  /// A few units in the last place of the angle, or of one radian.
  static R rounding(const R& angle) {
    using std::abs;
    return 8 * std::numeric_limits<R>::epsilon() * (1 + abs(angle));
  }

  static void move(Watched& w, bool upwards) {
    const std::size_t last = w.table->pieces().size() - 1;
    if (upwards) {
      w.turns += w.interval == last ? 1 : 0;
      w.interval = w.interval == last ? 0 : w.interval + 1;
    } else {
      w.turns -= w.interval == 0 ? 1 : 0;
      w.interval = w.interval == 0 ? last : w.interval - 1;
    }
  }

  std::size_t coordinates_;
  std::vector<Watched> watched_;
};

}  // namespace lubjoint
