#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "fuzz/targets.hpp"
#include "oracle/cli/state_rows.hpp"

namespace lubjoint::fuzz {

void states(std::string_view bytes) {
  using reports::CsvTable;
  try {
    const CsvTable given(bytes, "any.csv");
    // Answers that say which state they belong to, to be found again in the output.
    const std::vector<std::string> names = {"echoed_e", "echoed_a", "echoed_b"};
    for (const std::string& name : names) {  // would be replaced
      if (std::count(given.columns().begin(), given.columns().end(), name) > 0) return;
    }
    std::istringstream stream{std::string(bytes)};
    reports::CsvStream states(stream, "any.csv");
    std::string csv;
    const auto echo = [](const PolarFilmState<double>& state) {
      return std::vector<double>{state.eccentricity_ratio, state.slip_rate, state.squeeze_rate};
    };
    cli::answer_rows(states, names, echo, [&csv](std::string_view row) { csv += row; });
    const CsvTable out(csv, "output");
    require(out.rows() == given.rows(), "as many rows out as in");
    const std::array<std::size_t, 3> column = {given.column("eccentricity_ratio"), given.column("slip_rate"),
                                               given.column("squeeze_rate")};
    for (std::size_t row = 0; row < given.rows(); ++row) {
      require(out.line(row).starts_with(given.line(row) + ","), "a row comes back as it was given");
      for (std::size_t k = 0; k < column.size(); ++k) {
        const std::string field(given.field(row, column[k]));
        char* end = nullptr;
        const double value = std::strtod(field.c_str(), &end);  // the C library's reading, not ours
        require(!field.empty() && end == field.c_str() + field.size(), "an accepted field is a whole number: " + field);
        require(std::isfinite(value), "an accepted number is finite: " + field);
        require(given.number(row, column[k]) == value, "a number is read as the C library reads it: " + field);
        require(out.number(row, given.columns().size() + k) == value, "a number survives the round trip");
      }
    }
  } catch (const reports::CsvError& error) {
    require_refusal(error.what(), "any.csv");
  }
}

}  // namespace lubjoint::fuzz
