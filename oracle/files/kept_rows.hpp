/// What an interrupted campaign has done so far, kept in a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/files/csv_table.hpp"

namespace lubjoint::reports {

/// CSV rows of a campaign from its first until its results are written. The file's first line says of which campaign
/// they are, and of which program: rows of another one are left aside. Without a file nothing is kept.
class KeptRows {
 public:
  /// @param campaign  one line: everything that its rows depend on but the program
  /// @param header    of the rows, with its line end
  /// @throws CsvError if the file is of this campaign and its rows can't be read
  KeptRows(std::optional<std::filesystem::path> file, const std::string& campaign, const std::string& header);

  /// What the file of a campaign begins with, with its line end.
  static std::string first_line(const std::string& campaign);

  /// Rows of the campaign so far, before this run.
  const std::optional<CsvTable>& earlier() const { return earlier_; }

  /// Adds rows, each with its line end, to those in the file: all of them or none. @throws OutputError
  void add(std::string_view rows);

 private:
  std::optional<std::filesystem::path> file_;
  std::string text_;
  std::optional<CsvTable> earlier_;
};

/// The campaign is complete and its results are where they belong: nothing is left to take up.
void discard_kept_rows(const std::optional<std::filesystem::path>& file);

}  // namespace lubjoint::reports
