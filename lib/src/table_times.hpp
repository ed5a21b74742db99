/// Tables of a scene along a run: where their knots are, and whether they reach far enough.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "lubjoint/multibody/driven_motion.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "scene_tables.hpp"

namespace lubjoint {

/// Knots of a table that is read at delay + t, t in (0, duration).
template <std::size_t N>
void add_knots(const TableCurves<N>& curves, double delay, double duration, std::vector<double>& times) {
  const double length = curves.is_periodic() ? curves.length() : 0;
  double turns = curves.periods(delay);
  do {
    for (const double knot : curves.knots()) {
      const double t = knot + turns * length - delay;
      if (t > 0 && t < duration) times.push_back(t);
    }
    turns += 1;
  } while (length > 0 && curves.knots().front() + turns * length - delay < duration);
}
/// Those of a driver's table.
inline void add_knots(const std::shared_ptr<const MotionShape<double>>& shape, double duration,
                      std::vector<double>& times) {
  if (shape && shape->table) add_knots(*shape->table, shape->delay, duration, times);
}

/// In order; neighbours that rounding alone tells apart are one.
inline std::vector<double> in_order(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto same = [](double a, double b) { return b - a <= 1e-14 * b; };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  return times;
}

/// A table that is not periodic has nothing beyond its ends. The duration may be another than that of the file.
/// @param what  whose table it is;  @throws SceneError, as does the one below
template <std::size_t N>
void require_cover(const std::string& file, double duration, const std::string& what, const TableCurves<N>& curves,
                   double delay) {
  const double end = delay + duration;
  if (curves.is_periodic() || covers(curves.knots(), delay, end)) return;
  std::ostringstream message;
  message << file << ": " << what << " has a table from " << curves.knots().front() << " s to " << curves.knots().back()
          << " s, and the run needs it from " << delay << " s to " << end
          << " s; allowed is a table that covers the run, or a shorter duration";
  throw SceneError(message.str());
}
/// That of a driver.
inline void require_cover(const std::string& file, double duration, const std::string& name,
                          const std::shared_ptr<const MotionShape<double>>& shape) {
  if (shape && shape->table) require_cover(file, duration, "driver \"" + name + "\"", *shape->table, shape->delay);
}

/// The passages of a periodic table's knots are listed before the run.
/// @param way  of the table's variable in the run
template <std::size_t N>
void require_few_passages(const std::string& file, const std::string& what, const TableCurves<N>& curves, double way) {
  const double count = passages(curves.knots(), way);
  if (count <= static_cast<double>(most_rows)) return;
  std::ostringstream message;
  message << file << ": " << what << " has a table whose rows the run passes " << count
          << " times; allowed are at most " << most_rows << " rows in a run, or a shorter duration";
  throw SceneError(message.str());
}

/// Of a motion that a driver prescribes: the fastest that its shape turns or moves, or oscillates.
/// @param note  note(rate of f), and note_oscillation(ν) [1/s]
template <class Note, class NoteOscillation>
void for_each_rate(double speed, const std::shared_ptr<const MotionShape<double>>& shape, const Note& note,
                   const NoteOscillation& note_oscillation) {
  note(speed);
  if (!shape) return;
  if (shape->amplitude != 0) note_oscillation(shape->rate);
  if (!shape->table) return;
  for (const double knot : shape->table->knots()) note(shape->table->with_derivatives(knot).slope[0]);
}

}  // namespace lubjoint
