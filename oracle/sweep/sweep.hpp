/// One row of numbers for every scene of a grid.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "oracle/sweep/sweep_grid.hpp"

namespace lubjoint::reports {

/// A row depends on its scene alone: not on the other points, the threads, or the time.
class Sweep {
 public:
  /// From when on extremes of a scene's later part are wanted [s]; throws std::invalid_argument.
  using LateStart = std::function<double(const Scene&)>;

  /// @param change  made in every scene beside its point's own, such as another law
  /// @param late  none: the extremes of the whole run alone
  /// @throws SceneError  point 0 can't be run
  Sweep(SceneFile file, SweepGrid grid, std::function<void(Scene&)> change, LateStart late = nullptr);

  const SceneFile& file() const { return file_; }
  const SweepGrid& grid() const { return grid_; }
  const std::string& scene_name() const { return name_; }

  /// Checks points as scene files are checked, and that they can start.
  /// @throws SceneError that names the first point that is refused, and why
  void require_valid(const std::vector<std::size_t>& points, unsigned threads) const;

  /// Columns of a row: index, keys, status, message, t_end; of each joint max_eccentricity_ratio, max_force and when,
  /// min_film_thickness and when, and what it is over the safe thickness, the same after a time if that was asked for,
  /// and at the end of the run ex_over_c, ey_over_c, fx, fy; of each driver max_moment, min_moment and when;
  /// energy_residual, steps, rejected_steps, rhs_evaluations. SI units.
  std::string header() const;
  /// Runs a point. Status is "finished", or "stopped" with its reason in the message.
  std::string row(std::size_t point) const;

  static bool is_stopped(const std::string& row, const SweepGrid& grid);
  /// Warnings of joints whose film was beyond the places at which its law's stated error was measured: one a joint, of
  /// the row that went farthest.
  /// @param rows  by their points, which have to be valid
  std::vector<std::string> beyond_table_warnings(const std::map<std::size_t, std::string>& rows) const;
  /// A row as an object: numbers, texts, null where a field is empty.
  nlohmann::ordered_json row_json(const std::string& row) const;

 private:
  Scene scene(std::size_t point) const;

  SceneFile file_;
  SweepGrid grid_;
  std::function<void(Scene&)> change_;
  LateStart late_;
  std::string name_;
  std::vector<std::string> columns_;
};

}  // namespace lubjoint::reports
