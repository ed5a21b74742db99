#include "scene_tables.hpp"

#include <math.h>  // isnan without std::, which Boost's interpolators ask for

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/text/nearest_name.hpp"
#include "lubjoint/text/printable.hpp"
#include "scene_parts.hpp"

namespace lubjoint {

namespace {

using Cubic = TableCurves<1>::Cubic;

constexpr std::array<std::string_view, 3> interpolations = {"linear", "pchip", "makima"};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// A table file that is being read, and where.
struct Place {
  std::string file;
  std::size_t line = 0;

  [[noreturn]] void refuse(const std::string& given, const std::string& allowed) const {
    throw SceneError(file + ":" + std::to_string(line) + ": " + printable(given) + "; allowed is " + allowed);
  }
};

void read_header(const Place& place, std::string_view line, const std::vector<std::string_view>& first,
                 const std::vector<std::string_view>& others, TableColumns& result) {
  for (const std::string_view name : fields_of(line)) {
    const bool leads = result.names.empty();
    const std::vector<std::string_view>& known = leads ? first : others;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      place.refuse((leads ? "the first column is " : "a column is ") + in_quotes(std::string(name)),
                   one_of(known, name));
    }
    if (result.find(name) != nullptr)
      place.refuse("column " + in_quotes(std::string(name)) + " is there twice", "once");
    result.names.emplace_back(name);
    result.columns.emplace_back();
  }
  if (result.names.size() < 2) place.refuse("one column alone", "another beside it: " + one_of(others, ""));
}

void read_row(const Place& place, std::string_view line, TableColumns& result) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != result.names.size()) {
    place.refuse(std::to_string(fields.size()) + " fields", std::to_string(result.names.size()) + ", as in the header");
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    double value = 0;
    const auto [end, error] = std::from_chars(fields[i].data(), fields[i].data() + fields[i].size(), value);
    if (error != std::errc() || end != fields[i].data() + fields[i].size() || !std::isfinite(value)) {
      place.refuse("column " + result.names[i] + " is " + in_quotes(std::string(fields[i])), "a finite number");
    }
    std::vector<double>& column = result.columns[i];
    if (i == 0 && !column.empty() && !(value > column.back())) {
      place.refuse(result.names[0] + " is " + with_unit(value, "") + " after " + with_unit(column.back(), ""),
                   "a number above that of the row before");
    }
    column.push_back(value);
  }
  result.lines.push_back(place.line);
  if (result.columns[0].size() > most_rows) place.refuse("more than " + std::to_string(most_rows) + " rows", "fewer");
}

std::filesystem::path beside_scene(const TableReader& table, const std::string& given) {
  return std::filesystem::path(table.file()).parent_path() / given;
}

/// Slopes of one of Boost's interpolators at its points.
template <class Interpolator>
std::vector<double> slopes_of(std::vector<double> x, std::vector<double> y) {
  const std::vector<double> at = x;
  const Interpolator interpolator(std::move(x), std::move(y));
  std::vector<double> slopes;
  for (const double place : at) slopes.push_back(interpolator.prime(place));
  return slopes;
}

/// Slopes at all points; those of a periodic table with its neighbours beyond the ends.
std::vector<double> slopes_at(const std::vector<double>& knots, const std::vector<double>& values, bool monotone,
                              bool periodic) {
  std::vector<double> x = knots;
  std::vector<double> y = values;
  const std::size_t beyond = periodic ? 3 : 0;
  const double length = knots.back() - knots.front();
  const std::size_t intervals = knots.size() - 1;
  for (std::size_t i = 1; i <= beyond; ++i) {  // a table may have fewer intervals than neighbours are asked for
    const std::size_t turns = (i - 1) / intervals + 1;
    const std::size_t k = (i - 1) % intervals + 1;
    x.insert(x.begin(), knots[intervals - k] - static_cast<double>(turns) * length);
    y.insert(y.begin(), values[intervals - k]);
    x.push_back(knots[k] + static_cast<double>(turns) * length);
    y.push_back(values[k]);
  }
  using Points = std::vector<double>;
  Points slopes = monotone ? slopes_of<boost::math::interpolators::pchip<Points>>(std::move(x), std::move(y))
                           : slopes_of<boost::math::interpolators::makima<Points>>(std::move(x), std::move(y));
  const auto begin = slopes.begin() + static_cast<std::ptrdiff_t>(beyond);
  return {begin, begin + static_cast<std::ptrdiff_t>(knots.size())};
}

/// Refuses what a run of the scene would read beyond the ends of a table that is not periodic.
void require_cover(const TableReader& table, const std::vector<double>& t, double duration) {
  if (covers(t, 0, duration)) return;
  table.refuse("table", "a table from " + with_unit(t.front(), "s") + " to " + with_unit(t.back(), "s"),
               "one that covers the run, 0 s to " + with_unit(duration, "s") + ", or periodic = true for a load");
}

/// The length of an angle's table as whole revolutions; what its digits leave out is put right.
void make_whole_revolutions(const TableReader& table, TableColumns& given) {
  std::vector<double>& angles = given.columns[0];
  const double revolution = 2 * std::numbers::pi;
  const double length = angles.back() - angles.front();
  const double turns = std::round(length / revolution);
  if (turns < 1 || std::abs(length - turns * revolution) > 1e-6 * length) {
    table.refuse("table", "a table over " + with_unit(length, "rad") + " of angle",
                 "one over whole revolutions, multiples of 6.283185307179586 rad; angles are in rad");
  }
  const double end = angles.front() + turns * revolution;
  const std::size_t before = angles.size() - 2;
  if (!(angles[before] < end)) {
    std::ostringstream row;  // in more digits than those that are the same
    std::ostringstream limit;
    row << "angle is " << std::setprecision(12) << angles[before] << " rad in the last row but one";
    limit << "an angle below the end of the table's whole revolutions, " << std::setprecision(12) << end << " rad";
    Place{given.file, given.lines[before]}.refuse(row.str(), limit.str());
  }
  angles.back() = end;
}

}  // namespace

const std::vector<double>* TableColumns::find(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

TableColumns read_table_file(TableReader& table, const std::vector<std::string_view>& first,
                             const std::vector<std::string_view>& others) {
  const std::string given = table.text("table");
  const std::filesystem::path path = beside_scene(table, given);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    table.refuse("table", in_quotes(given) + ", and there is no file " + path.string(),
                 "a CSV file, its path relative to the scene");
  }
  std::ifstream stream(path, std::ios::binary);
  TableColumns result;
  result.file = path.string();
  Place place{result.file, 0};
  for (std::string line; std::getline(stream, line);) {
    ++place.line;
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    if (result.names.empty()) {
      read_header(place, text, first, others, result);
    } else {
      read_row(place, text, result);
    }
  }
  if (stream.bad() || (place.line == 0 && !stream.eof())) {
    table.refuse("table", in_quotes(given) + ", which can't be read", "a CSV file");
  }
  place.line = std::max<std::size_t>(place.line, 1);
  if (result.names.empty()) place.refuse("no header", "a line of column names, the first of them " + one_of(first, ""));
  if (result.columns[0].size() < 2) {
    place.refuse("the table has " + std::to_string(result.columns[0].size()) + " rows", "two or more");
  }
  return result;
}

double passages(const std::vector<double>& knots, double way) {
  return static_cast<double>(knots.size() - 1) * way / (knots.back() - knots.front());
}

bool covers(const std::vector<double>& knots, double from, double to) {
  return knots.front() <= from && knots.back() >= to * (1 - 1e-14);
}

std::vector<Cubic> interpolated(const std::vector<double>& knots, const std::vector<double>& values,
                                std::string_view interpolation, bool periodic) {
  std::vector<Cubic> pieces;
  std::vector<double> slopes;
  if (interpolation != "linear") slopes = slopes_at(knots, values, interpolation == "pchip", periodic);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double h = knots[k + 1] - knots[k];
    const double rise = (values[k + 1] - values[k]) / h;
    if (slopes.empty()) {
      pieces.push_back({values[k], rise, 0, 0});
    } else {
      const double left = slopes[k];
      const double right = slopes[k + 1];
      pieces.push_back({values[k], left, (3 * rise - 2 * left - right) / h, (left + right - 2 * rise) / (h * h)});
    }
  }
  return pieces;
}

std::vector<Cubic> spline(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size() - 1;
  std::vector<double> h(n);
  std::vector<double> rise(n);
  for (std::size_t k = 0; k < n; ++k) {
    h[k] = x[k + 1] - x[k];
    rise[k] = (y[k + 1] - y[k]) / h[k];
  }
  // Second derivatives m: h_{k−1} m_{k−1} + 2(h_{k−1} + h_k) m_k + h_k m_{k+1} = 6(rise_k − rise_{k−1}); m_0 and m_n
  // are on the straight lines through their two neighbours.
  std::vector<double> below(n + 1), diagonal(n + 1), above(n + 1), m(n + 1);
  for (std::size_t k = 1; k < n; ++k) {
    below[k] = h[k - 1];
    diagonal[k] = 2 * (h[k - 1] + h[k]);
    above[k] = h[k];
    m[k] = 6 * (rise[k] - rise[k - 1]);
  }
  diagonal[1] += h[0] * (h[0] + h[1]) / h[1];
  above[1] -= h[0] * h[0] / h[1];
  diagonal[n - 1] += h[n - 1] * (h[n - 2] + h[n - 1]) / h[n - 2];
  below[n - 1] -= h[n - 1] * h[n - 1] / h[n - 2];
  for (std::size_t k = 2; k < n; ++k) {
    const double factor = below[k] / diagonal[k - 1];
    diagonal[k] -= factor * above[k - 1];
    m[k] -= factor * m[k - 1];
  }
  m[n - 1] /= diagonal[n - 1];
  for (std::size_t k = n - 2; k >= 1; --k) m[k] = (m[k] - above[k] * m[k + 1]) / diagonal[k];
  m[0] = m[1] + (m[1] - m[2]) * h[0] / h[1];
  m[n] = m[n - 1] + (m[n - 1] - m[n - 2]) * h[n - 1] / h[n - 2];
  std::vector<Cubic> pieces;
  for (std::size_t k = 0; k < n; ++k) {
    pieces.push_back({y[k], rise[k] - h[k] * (2 * m[k] + m[k + 1]) / 6, m[k] / 2, (m[k + 1] - m[k]) / (6 * h[k])});
  }
  return pieces;
}

template <std::size_t N>
LoadCurves<N> read_load_curves(TableReader& table, double duration, const std::array<std::string_view, N>& quantities,
                               const std::vector<std::string_view>& of_angle_alone) {
  LoadCurves<N> result{};
  TableColumns given = read_table_file(table, {"t", "angle"}, {quantities.begin(), quantities.end()});
  std::vector<double>& knots = given.columns[0];
  result.of_angle = given.names[0] == "angle";
  const std::string interpolation = table.text_or("interpolation", "linear");
  if (std::find(interpolations.begin(), interpolations.end(), interpolation) == interpolations.end()) {
    table.refuse("interpolation", in_quotes(interpolation), one_of(interpolations, interpolation));
  }
  const bool periodic = result.of_angle || table.flag_or("periodic", false);
  if (result.of_angle) {
    if (table.has("periodic")) {
      table.refuse("periodic", "given for a table over an angle", "none: such a table always is periodic");
    }
    make_whole_revolutions(table, given);
  } else {
    for (const std::string_view key : of_angle_alone) {
      if (table.has(key)) table.refuse(key, "given for a table over t", "none, or a table whose first column is angle");
    }
  }
  if (interpolation != "linear" && !periodic && knots.size() < 4) {
    table.refuse("interpolation", in_quotes(interpolation) + " of " + std::to_string(knots.size()) + " rows",
                 "four rows or more, or \"linear\"");
  }
  if (!periodic) {
    require_cover(table, knots, duration);
  } else if (!result.of_angle) {
    const double count = passages(knots, duration);
    if (count > static_cast<double>(most_rows)) {
      table.refuse("table", "a table whose rows the run passes " + with_unit(count, "times"),
                   "at most " + std::to_string(most_rows) + " rows in a run");
    }
  }
  std::vector<std::array<Cubic, N>> pieces(knots.size() - 1, std::array<Cubic, N>{});
  for (std::size_t i = 0; i < N; ++i) {
    const std::vector<double>* values = given.find(quantities[i]);
    result.is_there[i] = values != nullptr;
    if (values == nullptr) continue;
    if (periodic && values->front() != values->back()) {
      table.refuse("table",
                   "a periodic table whose " + std::string(quantities[i]) + " is " + with_unit(values->front(), "") +
                       " in its first row and " + with_unit(values->back(), "") + " in its last",
                   "one whose first and last row are the same");
    }
    const std::vector<Cubic> of_column = interpolated(knots, *values, interpolation, periodic);
    for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k][i] = of_column[k];
  }
  result.curves = std::make_shared<const TableCurves<N>>(knots, std::move(pieces), periodic);
  return result;
}
template LoadCurves<3> read_load_curves(TableReader& table, double duration,
                                        const std::array<std::string_view, 3>& quantities,
                                        const std::vector<std::string_view>& of_angle_alone);
template LoadCurves<6> read_load_curves(TableReader& table, double duration,
                                        const std::array<std::string_view, 6>& quantities,
                                        const std::vector<std::string_view>& of_angle_alone);

std::shared_ptr<const TableCurves<1>> read_motion_table(TableReader& table, double duration,
                                                        std::string_view quantity) {
  const TableColumns given = read_table_file(table, {"t"}, {quantity});
  const std::vector<double>& knots = given.columns[0];
  if (knots.size() < 4) {
    table.refuse("table", "a table of " + std::to_string(knots.size()) + " rows", "four rows or more");
  }
  require_cover(table, knots, duration);
  std::vector<std::array<Cubic, 1>> pieces;
  for (const Cubic& cubic : spline(knots, given.columns[1])) pieces.push_back({cubic});
  return std::make_shared<const TableCurves<1>>(knots, std::move(pieces), false);
}

}  // namespace lubjoint
