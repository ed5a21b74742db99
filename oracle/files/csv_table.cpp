#include "oracle/files/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lubjoint/text/printable.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr const char* no_row = "empty line; allowed is a row of numbers";
constexpr const char* no_header = ": empty; required is a header row";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::string_view without_quotes(std::string_view field) {
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') return field.substr(1, field.size() - 2);
  return field;
}

/// End of the field at the beginning of a text: its comma, or the text's size. npos if its quote is never closed.
std::size_t end_of_field(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos || text[first] != '"') return std::min(text.find(','), text.size());
  std::size_t close = text.find('"', first + 1);
  while (close != std::string_view::npos && close + 1 < text.size() && text[close + 1] == '"') {  // "" is a quote
    close = text.find('"', close + 2);
  }
  return close == std::string_view::npos ? close : std::min(text.find(',', close), text.size());
}

}  // namespace

CsvHeader::CsvHeader(std::string line, std::size_t number, std::string name)
    : name_(std::move(name)), line_(std::move(line)) {
  columns_.resize(1);  // fields() counts: it has to let every header through
  std::string_view rest = line_;
  for (std::size_t end = end_of_field(rest);; end = end_of_field(rest)) {
    if (end == std::string_view::npos) fail(number, "a quote is not closed; allowed are rows of one line");
    columns_.back() = without_quotes(trimmed(rest.substr(0, end)));
    if (end == rest.size()) return;
    rest.remove_prefix(end + 1);
    columns_.emplace_back();
  }
}

std::vector<std::string_view> CsvHeader::fields(std::string_view row, std::size_t line) const {
  std::vector<std::string_view> fields;
  fields.reserve(columns_.size());
  while (true) {
    const std::size_t end = end_of_field(row);
    if (end == std::string_view::npos) fail(line, "a quote is not closed; allowed are rows of one line");
    fields.push_back(trimmed(row.substr(0, end)));
    if (end == row.size()) break;
    row.remove_prefix(end + 1);
  }
  if (fields.size() == columns_.size()) return fields;
  fail(line, std::to_string(fields.size()) + " fields; allowed are " + std::to_string(columns_.size()) +
                 ", as in the header (commas between fields, points in decimals)");
}

std::size_t CsvHeader::column(std::string_view name) const {
  const auto count = std::count(columns_.begin(), columns_.end(), name);
  if (count != 1) {
    std::string there;
    for (const std::string& known : columns_) there += (there.empty() ? "" : ", ") + known;
    fail(1, "column \"" + std::string(name) + "\" is " + (count ? "there more than once" : "missing") +
                "; allowed is a header with one such column, and this one has " + there);
  }
  return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
}

double CsvHeader::number(std::string_view given, std::size_t column, std::size_t line) const {
  const std::string_view field = without_plus(without_quotes(given));
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool complete = error == std::errc() && end == field.data() + field.size();
  if (!complete || !std::isfinite(value)) {
    fail(line, columns_[column] + " is \"" + std::string(without_quotes(given)) +
                   "\"; allowed is a finite number that double precision can hold");
  }
  return value;
}

void CsvHeader::fail(std::size_t line, const std::string& what) const {
  throw CsvError(printable(name_ + ":" + std::to_string(line) + ": " + what));
}

CsvTable::CsvTable(std::string_view text, std::string name) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::size_t line_number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line_number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (trimmed(line).empty()) {
      if (trimmed(text).find_first_not_of("\r\n \t") == std::string_view::npos) break;
      CsvHeader("", line_number, name).fail(line_number, no_row);
    }
    if (header_.columns().empty()) {
      header_ = CsvHeader(std::move(line), line_number, name);
      continue;
    }
    rows_.push_back({std::move(line), line_number, {}});
  }
  if (header_.columns().empty()) throw CsvError(name + no_header);
  // Views only now: the strings have stopped moving.
  for (Row& row : rows_) row.fields = header_.fields(row.text, row.line);
}

std::string_view CsvTable::field(std::size_t row, std::size_t column) const {
  return without_quotes(rows_[row].fields[column]);
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  return header_.number(rows_[row].fields[column], column, rows_[row].line);
}

CsvStream::CsvStream(std::istream& stream, std::string name) : stream_(stream) {
  if (!next_line()) throw CsvError(name + no_header);
  if (text_.starts_with(byte_order_mark)) text_.erase(0, byte_order_mark.size());
  if (trimmed(text_).empty()) {
    if (next_line() && !trimmed(text_).empty()) CsvHeader("", 1, name).fail(1, no_row);
    throw CsvError(name + no_header);
  }
  header_ = CsvHeader(text_, number_, std::move(name));
}

bool CsvStream::next_line() {
  if (!std::getline(stream_, text_)) return false;
  ++number_;
  bytes_ += text_.size() + 1;
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return true;
}

bool CsvStream::next() {
  if (!next_line()) return false;
  if (trimmed(text_).empty()) {
    const std::size_t empty = number_;
    while (next_line()) {
      if (!trimmed(text_).empty()) header_.fail(empty, no_row);
    }
    return false;
  }
  fields_ = header_.fields(text_, number_);
  return true;
}

}  // namespace lubjoint::reports
