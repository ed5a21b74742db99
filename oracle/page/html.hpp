/// HTML in small pieces: text, tables, templates, data that a script reads.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports::page {

/// Text as HTML shows it: & < > " ' replaced, in attributes too.
std::string escaped(std::string_view text);

/// A number with a minus sign for its hyphen, and 0 without one.
std::string with_minus(std::string number);

/// A number as people write it: "1.2 × 10⁻⁸", "0.26", "0".
std::string scientific(double value, int digits = 1);

/// Words with their "1e-08" as "10⁻⁸" and their "2.0e-10" as "2.0 × 10⁻¹⁰".
std::string with_powers(const std::string& words);

/// A share as a percentage without more digits than it deserves: "0.3 %", "38 %"; from 10 on as "72 times".
std::string percent(double share);

/// What stands in for {{name}} in a template, HTML already.
using Fields = std::map<std::string, std::string, std::less<>>;

/// A template of this folder with its fields filled in.
/// @throws std::logic_error for a field that the template asks for and is not given, or the other way round
std::string filled(std::string_view resource_name, const Fields& fields);

/// A cell of a table: text, and how it is to look (a class of page.css).
struct Cell {
  Cell(std::string words, std::string css_class = {}) : text(std::move(words)), look(std::move(css_class)) {}
  Cell(const char* words) : text(words) {}
  std::string text;
  std::string look;
};

/// "agrees" or what does not.
Cell verdict_cell(bool good, const std::string& words);

/// A heading of a column. Numbers are set flush right.
struct Column {
  std::string head;
  std::string unit = {};
  bool number = true;
};

/// A table with a caption; the first cell of a row is its heading.
class Table {
 public:
  Table(std::string caption, std::vector<Column> columns);
  /// @throws std::logic_error for another number of cells than of columns
  void row(std::vector<Cell> cells);
  /// On a narrow screen each row is a card, with every cell under its heading: for tables of words.
  Table& as_cards() {
    cards_ = true;
    return *this;
  }
  std::string html() const;

 private:
  std::string caption_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  bool cards_ = false;
};

/// JSON that a script of the page finds by the id, made safe inside of HTML.
/// @param json  valid JSON
std::string json_block(std::string_view id, std::string_view json);

/// A CSV inside of the page, found by the id, and a button that saves it as a file of that name.
std::string csv_block(std::string_view id, std::string_view file_name, std::string_view csv);

}  // namespace lubjoint::reports::page
