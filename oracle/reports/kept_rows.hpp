/// What an interrupted campaign has done so far, kept in a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/reports/csv_table.hpp"

namespace lubjoint::reports {

/// CSV rows of a campaign that was interrupted. The file's first line, the key, says of which campaign they are: rows
/// of another one are left aside. Without a file nothing is kept.
class KeptRows {
 public:
  /// @param key     of the campaign, one line: everything that its rows depend on
  /// @param header  of the rows, with its line end
  /// @throws CsvError if the file is of this campaign and its rows can't be read
  KeptRows(std::optional<std::filesystem::path> file, const std::string& key, const std::string& header);

  /// Rows of the campaign so far, before this run.
  const std::optional<CsvTable>& earlier() const { return earlier_; }

  /// Replaces the rows in the file, all of them or none. @throws OutputError
  void keep(std::string_view rows) const;

  /// The campaign is complete.
  void discard() const;

 private:
  std::optional<std::filesystem::path> file_;
  std::string head_;
  std::optional<CsvTable> earlier_;
};

}  // namespace lubjoint::reports
