/// Tables that a scene file names: CSV files beside it.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

/// Columns of a table, the first one ascending.
struct TableColumns {
  std::vector<std::string> names;            ///< of the file's header
  std::vector<std::vector<double>> columns;  ///< in that order, all of one length, two rows or more
  std::string file;                          ///< that they are from, for messages
  std::vector<std::size_t> lines;            ///< of each row there

  /// @returns nothing if there is none of that name
  const std::vector<double>* find(std::string_view name) const;
};

/// The file at the key "table", its path relative to the scene's.
/// @param first  what its first column may be called;  @param others  what the others may be called
/// @throws SceneError  as do all below: naming file, line and column where the table itself is wrong
TableColumns read_table_file(TableReader& table, const std::vector<std::string_view>& first,
                             const std::vector<std::string_view>& others);

/// Cubics between knots by the name of their interpolation: linear, pchip or makima (Boost.Math's slopes; the first and
/// the last of a periodic table are those of its neighbours beyond the ends).
std::vector<TableCurves<3>::Cubic> interpolated(const std::vector<double>& knots, const std::vector<double>& values,
                                                std::string_view interpolation, bool periodic);

/// The cubic spline through four points or more whose second derivative has no jump, and whose third has none at the
/// second and the last knot but one ("not a knot").
std::vector<TableCurves<1>::Cubic> spline(const std::vector<double>& knots, const std::vector<double>& values);

/// More rows, or passages of knots in a run, are a slip of the pen.
inline constexpr std::size_t most_rows = 1'000'000;

/// How often the variable of a periodic table meets its knots on a way of some length.
double passages(const std::vector<double>& knots, double way);

/// Does a table with these knots, ascending, reach from one place to another? Its end may be short by rounding: the
/// rest of a run that is cut in two ends where the whole one does.
bool covers(const std::vector<double>& knots, double from, double to);

/// What a load has from a table of time or of an angle, and which of its columns are there, whatever stands in them.
template <std::size_t N>
struct LoadCurves {
  std::shared_ptr<const TableCurves<N>> curves;  ///< of all N quantities; 0 of those that are not there
  bool of_angle;                                 ///< in place of time
  std::array<bool, N> is_there;                  ///< of each quantity
};

/// The table of a load and the keys that say how it is read: table, interpolation, periodic.
/// @param duration  of the run [s];  @param quantities  names of columns
/// @param of_angle_alone  keys that only a table over an angle has; who asked for it reads them
template <std::size_t N>
LoadCurves<N> read_load_curves(TableReader& table, double duration, const std::array<std::string_view, N>& quantities,
                               const std::vector<std::string_view>& of_angle_alone);

/// A table of time of the motion that a driver prescribes.
/// @param duration  of the run [s];  @param quantity  what its second column is called
std::shared_ptr<const TableCurves<1>> read_motion_table(TableReader& table, double duration, std::string_view quantity);

}  // namespace lubjoint
