/// Reading the golden data.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::test {

inline std::filesystem::path golden_folder() { return std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data/golden"; }

struct PolarState {
  double eccentricity_ratio, slip_rate, squeeze_rate;
};

struct BearingAndOil {
  Bearing<double> bearing;
  Lubricant<double> oil;
};

/// A file of data/golden.
class GoldenTable {
 public:
  explicit GoldenTable(const std::string& file)
      : file_(file), table_(reports::read_input((golden_folder() / file).string()), file) {}

  std::size_t rows() const { return table_.rows(); }
  double number(std::size_t row, std::string_view column) const { return table_.number(row, table_.column(column)); }
  /// The field as it is written.
  std::string text(std::size_t row, std::string_view column) const {
    const std::string& line = table_.line(row);
    std::size_t begin = 0;
    for (std::size_t skip = table_.column(column); skip > 0; --skip) begin = line.find(',', begin) + 1;
    return line.substr(begin, line.find(',', begin) - begin);
  }
  /// An output rounded to double: strtod, as numbers below its range are wanted as what is left of them.
  double output(std::size_t row, std::string_view column) const {
    return std::strtod(text(row, column).c_str(), nullptr);
  }

  PolarState polar(std::size_t row) const {
    return {number(row, "eccentricity_ratio"), number(row, "slip_rate"), number(row, "squeeze_rate")};
  }
  BearingAndOil bearing(std::size_t row) const {
    return {{number(row, "length"), number(row, "radius"), number(row, "clearance")},
            Lubricant<double>(number(row, "viscosity"))};
  }
  JournalMotion<double> motion(std::size_t row) const {
    return {{number(row, "ex"), number(row, "ey")},
            {number(row, "vx"), number(row, "vy")},
            number(row, "omega_bearing"),
            number(row, "omega_journal")};
  }
  /// Line and row, for messages.
  std::string where(std::size_t row) const {
    return file_ + ", line " + std::to_string(row + 2) + ": " + table_.line(row);
  }

 private:
  std::string file_;
  reports::CsvTable table_;
};

/// ε, a, b of a motion, rounded from 50 digits: how near a state is to a jump can't be told in doubles.
inline PolarState polar_in_extended(const JournalMotion<double>& motion, double clearance) {
  using Exact = boost::multiprecision::cpp_bin_float_50;
  const Exact ex = motion.eccentricity.x(), ey = motion.eccentricity.y();
  const Exact vx = motion.velocity.x(), vy = motion.velocity.y();
  const Exact c = clearance;
  const Exact size = sqrt(ex * ex + ey * ey);
  if (size == 0) return {0, 0, static_cast<double>(Exact(sqrt(vx * vx + vy * vy) / c))};
  const Exact spins = Exact(motion.bearing_spin) + Exact(motion.journal_spin);
  return {static_cast<double>(Exact(size / c)),
          static_cast<double>(Exact((spins * size * size - 2 * (ex * vy - ey * vx)) / (size * c))),
          static_cast<double>(Exact((ex * vx + ey * vy) / (size * c)))};
}

}  // namespace lubjoint::test
