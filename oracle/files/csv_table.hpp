/// CSV with a header row, read with errors that name file, line and column.
#pragma once

#include <cstddef>
#include <istream>
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

/// The header row of a CSV: its columns, and how rows are read by it. Comma-separated fields, decimal points. Fields
/// may stand in quotes, as R and spreadsheets write them (RFC 4180), but a row is one line. A byte-order mark, carriage
/// returns and spaces around fields are tolerated.
class CsvHeader {
 public:
  /// No columns.
  CsvHeader() = default;
  /// @param name  of the file, for messages
  /// @throws CsvError if a quote is not closed
  CsvHeader(std::string line, std::size_t number, std::string name);

  const std::string& line() const { return line_; }  ///< as it was given
  const std::vector<std::string>& columns() const { return columns_; }

  /// Position of a column. @throws CsvError if it is missing or there twice
  std::size_t column(std::string_view name) const;
  /// The fields of a row, with the quotes that they have. @throws CsvError if there are more or less than columns
  std::vector<std::string_view> fields(std::string_view row, std::size_t line) const;
  /// A finite number. @throws CsvError
  double number(std::string_view field, std::size_t column, std::size_t line) const;
  /// @throws CsvError that names file and line
  [[noreturn]] void fail(std::size_t line, const std::string& what) const;

 private:
  std::string name_;
  std::string line_;
  std::vector<std::string> columns_;
};

/// A CSV in memory. Empty lines at the end are tolerated.
class CsvTable {
 public:
  /// @param name  of the file, for messages
  /// @throws CsvError if there is no header, or a row has another number of fields
  CsvTable(std::string_view text, std::string name);
  CsvTable(CsvTable&&) = default;  // no copies: fields are views of the rows' text

  std::size_t rows() const { return rows_.size(); }
  const std::string& header() const { return header_.line(); }
  const std::vector<std::string>& columns() const { return header_.columns(); }
  /// A row as it was given, without its line end.
  const std::string& line(std::size_t row) const { return rows_[row].text; }

  /// Position of a column. @throws CsvError if it is missing or there twice
  std::size_t column(std::string_view name) const { return header_.column(name); }
  /// The text of a field, without the spaces and quotes around it.
  std::string_view field(std::size_t row, std::size_t column) const;
  /// A finite number. @throws CsvError
  double number(std::size_t row, std::size_t column) const;
  /// The error of a row that is well formed but impossible.
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const { header_.fail(rows_[row].line, what); }

 private:
  struct Row {
    std::string text;
    std::size_t line;
    std::vector<std::string_view> fields;
  };
  CsvHeader header_;
  std::vector<Row> rows_;
};

/// A CSV that is read row by row, in memory that does not grow with it. The rules are those of CsvTable.
class CsvStream {
 public:
  /// Reads the header. @param name  of the file, for messages
  /// @throws CsvError if there is none
  CsvStream(std::istream& stream, std::string name);

  const CsvHeader& header() const { return header_; }
  /// Goes on to the next row. @returns whether there is one  @throws CsvError
  bool next();

  /// The row as it was given, without its line end.
  const std::string& line() const { return text_; }
  /// A field as it was given, with its quotes.
  std::string_view raw_field(std::size_t column) const { return fields_[column]; }
  /// A finite number. @throws CsvError
  double number(std::size_t column) const { return header_.number(fields_[column], column, number_); }
  /// The error of a row that is well formed but impossible.
  [[noreturn]] void refuse(const std::string& what) const { header_.fail(number_, what); }
  /// Bytes read so far.
  std::size_t bytes() const { return bytes_; }

 private:
  bool next_line();

  std::istream& stream_;
  CsvHeader header_;
  std::string text_;
  std::size_t number_ = 0;  // of the line, from 1
  std::size_t bytes_ = 0;
  std::vector<std::string_view> fields_;
};

}  // namespace lubjoint::reports
