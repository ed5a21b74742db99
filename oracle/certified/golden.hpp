/// The golden data: written, and compared with what is there.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "oracle/files/golden_files.hpp"

namespace lubjoint::certified {

struct GoldenRun {
  unsigned threads = 0;   ///< 0: one a core
  std::size_t every = 1;  ///< checks one row in this many, of the files whose checksum is right
  /// Rows done and rows in all; called from one thread at a time.
  std::function<void(std::size_t, std::size_t)> progress = [](std::size_t, std::size_t) {};
};

/// Writes all golden files and manifest.json. The bytes depend on nothing but the source.
/// @throws std::logic_error if two enclosures of one number contradict each other; reports::OutputError
void write_golden(const std::filesystem::path& folder, const GoldenRun& run = {});

/// Makes every value again and compares files and manifest byte for byte. Every difference of a file is named by row,
/// column and size; files that are missing or unknown, and checksums, by name.
std::vector<reports::GoldenDifference> check_golden(const std::filesystem::path& folder, const GoldenRun& run = {});

}  // namespace lubjoint::certified
