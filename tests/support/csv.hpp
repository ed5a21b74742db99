/// Reading the project's CSV files in tests.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace lubjoint::testing {

/// One row: column name to text.
using CsvRow = std::map<std::string, std::string>;

/// Rows of a file with a header row; no quoting.
/// @throws std::runtime_error if the file cannot be read or a row has not as many fields as the header
inline std::vector<CsvRow> read_csv(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  const auto fields = [](const std::string& line) {
    std::vector<std::string> list;
    std::string field;
    std::istringstream stream(line + ',');
    while (std::getline(stream, field, ',')) list.push_back(field);
    return list;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = fields(line);
  std::vector<CsvRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = fields(line);
    if (values.size() != header.size())
      throw std::runtime_error(path + ": a row with another number of fields: " + line);
    CsvRow row;
    for (std::size_t column = 0; column < header.size(); ++column) row[header[column]] = values[column];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace lubjoint::testing
