#include "oracle/files/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lubjoint/text/printable.hpp"

namespace lubjoint::reports {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string name) : name_(std::move(name)) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::size_t line_number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line_number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (trimmed(line).empty()) {
      if (trimmed(text).find_first_not_of("\r\n \t") == std::string_view::npos) break;
      fail(line_number, "empty line; allowed is a row of numbers");
    }
    if (columns_.empty()) {
      for (const std::string_view field : split(line)) columns_.emplace_back(field);
      header_line_ = line;
      continue;
    }
    rows_.push_back({std::move(line), line_number, {}});
  }
  if (columns_.empty()) throw CsvError(name_ + ": empty; required is a header row");
  // Views only now: the strings have stopped moving.
  for (Row& row : rows_) {
    row.fields = split(row.text);
    if (row.fields.size() == columns_.size()) continue;
    fail(row.line, std::to_string(row.fields.size()) + " fields; allowed are " + std::to_string(columns_.size()) +
                       ", as in the header (commas between fields, points in decimals)");
  }
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto count = std::count(columns_.begin(), columns_.end(), name);
  if (count != 1) {
    std::string there;
    for (const std::string& known : columns_) there += (there.empty() ? "" : ", ") + known;
    fail(1, "column \"" + std::string(name) + "\" is " + (count ? "there more than once" : "missing") +
                "; required is one such column, and the header has " + there);
  }
  return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string_view field = without_plus(rows_[row].fields[column]);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool complete = error == std::errc() && end == field.data() + field.size();
  if (!complete || !std::isfinite(value)) {
    refuse(row, columns_[column] + " is \"" + std::string(rows_[row].fields[column]) +
                    "\"; allowed is a finite number that double precision can hold");
  }
  return value;
}

void CsvTable::refuse(std::size_t row, const std::string& what) const { fail(rows_[row].line, what); }

void CsvTable::fail(std::size_t line, const std::string& what) const {
  throw CsvError(printable(name_ + ":" + std::to_string(line) + ": " + what));
}

}  // namespace lubjoint::reports
