/// Knots of tables over an angle: places where derivatives of a load jump, and where a step ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lubjoint/multibody/table_curves.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// An angle of a state, and how fast it turns.
template <class R>
struct TurningAngle {
  R angle;  ///< [rad]
  R rate;   ///< [rad/s]
};

/// The piece of each table that a run is in, which its equations hold: a stage of a step that ends at a knot may lie a
/// little beyond it, and would read the next piece by as much. A body that turns either way meets the knot at the end
/// that it turns to.
/// @tparam Angles  PlanarAngles or SpatialAngles: visit_tables(visit(load, number of the angle, table)) and
///   at(t, y, number), a TurningAngle
template <class R, class Angles>
class TableKnots {
 public:
  using State = std::vector<R>;  ///< places, velocities, work

  static constexpr std::size_t margins_each = 2;  ///< surfaces of each table

  /// Finds the tables of loads.
  /// @param pieces  of the equations, one a load; kept by reference
  TableKnots(Angles angles, std::vector<TablePiece>& pieces) : angles_(std::move(angles)), pieces_(pieces) {
    angles_.visit_tables([&](std::size_t load, std::size_t angle, const Table* table) {
      auto known = std::find_if(watched_.begin(), watched_.end(),
                                [&](const Watched& w) { return w.angle == angle && w.table == table; });
      if (known == watched_.end()) known = watched_.insert(watched_.end(), Watched{angle, table, {}, {}});
      known->loads.push_back(load);
    });
  }

  bool empty() const { return watched_.empty(); }                         ///< is there no such table?
  std::size_t margins() const { return margins_each * watched_.size(); }  ///< number of surfaces

  /// The intervals that a start is in: at a knot, the one that the body turns into.
  void start(const R& t, const State& y) {
    for (Watched& each : watched_) {
      const TurningAngle<R> at = angles_.at(t, y, each.angle);
      const double place = static_cast<double>(at.angle);
      each.piece.turns = each.table->periods(place);
      each.piece.interval = each.table->interval(place - each.piece.turns * each.table->length());
      each.piece.is_held = true;
      hold(each);
      if (at.rate < 0 && !(at.angle - low(each) > rounding(at.angle))) move(each, false);
      if (at.rate > 0 && !(high(each) - at.angle > rounding(at.angle))) move(each, true);
    }
  }

  /// Adds the distances to the lower and to the upper knot of each interval [rad].
  void add_margins(const R& t, const State& y, std::vector<Margin<R>>& list) const {
    for (const Watched& each : watched_) {
      const R angle = angles_.at(t, y, each.angle).angle;
      list.push_back({R(angle - low(each)), rounding(angle)});
      list.push_back({R(high(each) - angle), rounding(angle)});
    }
  }

  /// Into the next interval beyond a surface.
  void cross(std::size_t margin) { move(watched_[margin / margins_each], margin % margins_each == 1); }

 private:
  using Table = typename Angles::Table;
  struct Watched {
    std::size_t angle;
    const Table* table;
    TablePiece piece;
    std::vector<std::size_t> loads;  ///< that read it
  };

  static R low(const Watched& w) { return knot(w, w.piece.interval); }
  static R high(const Watched& w) { return knot(w, w.piece.interval + 1); }
  static R knot(const Watched& w, std::size_t k) { return R(w.table->knots()[k] + w.piece.turns * w.table->length()); }
  /// A few units in the last place of the angle, or of one radian.
  static R rounding(const R& angle) {
    using std::abs;
    return 8 * std::numeric_limits<R>::epsilon() * (1 + abs(angle));
  }

  void move(Watched& w, bool upwards) {
    const std::size_t last = w.table->pieces().size() - 1;
    TablePiece& piece = w.piece;
    if (upwards) {
      piece.turns += piece.interval == last ? 1 : 0;
      piece.interval = piece.interval == last ? 0 : piece.interval + 1;
    } else {
      piece.turns -= piece.interval == 0 ? 1 : 0;
      piece.interval = piece.interval == 0 ? last : piece.interval - 1;
    }
    hold(w);
  }
  void hold(const Watched& w) {
    for (const std::size_t load : w.loads) pieces_[load] = w.piece;
  }

  Angles angles_;
  std::vector<TablePiece>& pieces_;
  std::vector<Watched> watched_;
};

}  // namespace lubjoint
