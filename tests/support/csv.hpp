/// Reading the project's CSV files in tests.
#pragma once

#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace lubjoint::test {

/// One row: column name to text.
using CsvRow = std::map<std::string, std::string>;

/// The header row of a CSV text.
inline std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Fields of a line; no quoting.
inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> list;
  std::istringstream stream(line + ',');
  for (std::string field; std::getline(stream, field, ',');) list.push_back(field);
  return list;
}

/// The number that a field is, whatever the locale.
/// @throws std::runtime_error if it is none, or more than one
inline double number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) throw std::runtime_error("no number: \"" + text + "\"");
  return value;
}

/// Rows of a CSV text with a header row; no quoting.
/// @throws std::runtime_error if a row has not as many fields as the header
inline std::vector<CsvRow> parse_csv(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> header = fields(line);
  std::vector<CsvRow> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> values = fields(line);
    if (values.size() != header.size()) throw std::runtime_error("a row with another number of fields: " + line);
    CsvRow row;
    for (std::size_t column = 0; column < header.size(); ++column) row[header[column]] = values[column];
    rows.push_back(row);
  }
  return rows;
}

/// Rows of a CSV file.
/// @throws std::runtime_error if the file cannot be read, or is none
inline std::vector<CsvRow> read_csv(const std::string& path) { return parse_csv(read_text(path)); }

}  // namespace lubjoint::test
