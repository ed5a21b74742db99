/// Golden files as they lie in a folder: manifest, checksums, and what differs between two versions of one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports {

/// Version of the columns and conventions of data/README.md.
inline constexpr int golden_schema_version = 1;
inline constexpr std::string_view golden_manifest_name = "manifest.json";

struct GoldenFile {
  std::string name;
  std::string text;
};

/// One thing that is not as it should be.
struct GoldenDifference {
  std::string file;
  std::size_t line = 0;  ///< of the file, the header being 1; 0 where the file as a whole is meant
  std::string column;    ///< empty where the line as a whole is meant
  std::string what;      ///< "1.5 instead of 1.25, off by 0.2 of it"

  std::string text() const;  ///< one sentence
};

/// SHA-256 in lower-case hexadecimal digits (libcrypto).
std::string sha256(std::string_view bytes);

/// manifest.json: schema version, and for each file its name, size, rows and checksum.
std::string golden_manifest(const std::vector<GoldenFile>& files);

/// Compares a folder with its own manifest: schema version, missing files, checksums, and files that it doesn't list.
/// @param expected  the files there should be; empty: those of the manifest
std::vector<GoldenDifference> manifest_differences(const std::filesystem::path& folder,
                                                   const std::vector<std::string>& expected = {});

/// Compares a CSV with the rows that it should have, field by field.
/// @param rows  without line ends; an empty one is not compared
std::vector<GoldenDifference> csv_differences(const std::string& file, std::string_view header,
                                              const std::vector<std::string>& rows, std::string_view found);

}  // namespace lubjoint::reports
