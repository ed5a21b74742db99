/// The rows of a sweep on disk, while it runs: what an interrupted sweep, or another shard of it, has done already.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lubjoint::reports {

/// What rows depend on, by name: a row of another sweep is not taken.
using SweepIdentity = std::vector<std::pair<std::string, std::string>>;

/// Every count-th point, beginning with that of the number; 1/1 is all.
struct Shard {
  std::size_t number = 1;  ///< from 1
  std::size_t count = 1;

  bool holds(std::size_t index) const { return index % count == number - 1; }
  std::vector<std::size_t> points(std::size_t all) const;  ///< of a grid of so many
};

/// Has a sweep of this identity been merged in a folder, and is its CSV as it was then? FOLDER/STEM.json says so, which
/// the merge leaves beside STEM.csv: identity, and checksum of the CSV.
bool is_merged(const std::filesystem::path& folder, const std::string& stem, const SweepIdentity& identity);

/// Why a part could not be locked, of the error of flock(2).
std::string lock_refusal(const std::filesystem::path& part, int error);

/// Rows by the index of their point, in files FOLDER/STEM.NUMBER-of-COUNT.part, one a shard.
///
/// The first line of a part is the identity, every other a row, each preceded by a checksum (SHA-256, cut to 64 bits)
/// of the identity and itself. A line is written in one piece. What has no line end or not its checksum is no row: a
/// sweep that was killed, or a disk that was full, costs the points that were at work.
class SweepStore {
 public:
  /// Reads all parts. Without a shard nothing will be added.
  /// @throws std::invalid_argument  a part of another sweep, a shard that another process is at work on, or two parts
  /// that give a point different rows
  /// @throws OutputError
  SweepStore(std::filesystem::path folder, std::string stem, const SweepIdentity& identity,
             const std::optional<Shard>& shard);
  ~SweepStore();
  SweepStore(const SweepStore&) = delete;
  SweepStore& operator=(const SweepStore&) = delete;

  /// Rows that were there, and those added since.
  const std::map<std::size_t, std::string>& rows() const { return rows_; }
  /// What was ignored, a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Appends a row; from any thread. @throws OutputError
  void add(std::size_t index, const std::string& row);

  /// If the parts hold all points: writes header and rows in order to STEM.csv, removes the parts, and says so. If
  /// another shard has done so already, the same. @throws as the constructor
  bool merge(const std::string& header, std::size_t points);

 private:
  std::string checksum(const std::string& line) const;
  std::string stamped(const std::string& line) const { return checksum(line) + " " + line + "\n"; }
  std::vector<std::filesystem::path> parts() const;
  void read_all();
  /// @returns length of the whole lines
  std::size_t read_part(const std::filesystem::path& file, const std::string& text);
  void require_own_identity(const std::filesystem::path& file, const std::string& line) const;
  std::filesystem::path part_of(const Shard& shard) const;
  void open_own();
  void append(const std::string& text);

  std::filesystem::path folder_;
  std::string stem_;
  SweepIdentity identity_;
  std::string header_;
  std::string digest_;  ///< of the identity
  std::filesystem::path own_;
  int descriptor_ = -1;
  std::mutex mutex_;
  std::map<std::size_t, std::string> rows_;
  std::vector<std::string> notes_;
};

}  // namespace lubjoint::reports
