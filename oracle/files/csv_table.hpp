/// CSV with a header row, read with errors that name file, line and column.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports {

/// A CSV that can't be used: file, line, column, what was given and what is allowed.
class CsvError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A field without the plus sign that std::from_chars does not take.
inline std::string_view without_plus(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  return field;
}

/// Comma-separated fields without quoting, decimal points, one header row. A byte-order mark, carriage returns,
/// spaces around fields and empty lines at the end are tolerated.
class CsvTable {
 public:
  /// @param name  of the file, for messages
  /// @throws CsvError if there is no header, or a row has another number of fields
  CsvTable(std::string_view text, std::string name);
  CsvTable(CsvTable&&) = default;  // no copies: fields are views of the rows' text

  std::size_t rows() const { return rows_.size(); }
  const std::string& header() const { return header_line_; }
  const std::vector<std::string>& columns() const { return columns_; }
  /// A row as it was given, without its line end.
  const std::string& line(std::size_t row) const { return rows_[row].text; }

  /// Position of a column. @throws CsvError if it is missing or there twice
  std::size_t column(std::string_view name) const;
  /// The text of a field, without the spaces around it.
  std::string_view field(std::size_t row, std::size_t column) const { return rows_[row].fields[column]; }
  /// A finite number. @throws CsvError
  double number(std::size_t row, std::size_t column) const;
  /// The error of a row that is well formed but impossible.
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const;

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const;

  struct Row {
    std::string text;
    std::size_t line;
    std::vector<std::string_view> fields;
  };
  std::string name_;
  std::string header_line_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace lubjoint::reports
