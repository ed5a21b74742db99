#include "oracle/files/golden_files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// How far apart two fields are, if both are numbers.
std::string distance(std::string_view found, std::string_view expected) {
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;
  try {
    const Number is(std::string{found});
    const Number should(std::string{expected});
    const Number off = abs(is - should);
    if (should == 0) return ", off by " + off.str(2, std::ios::scientific);
    return ", off by " + Number(off / abs(should)).str(2, std::ios::scientific) + " of it";
  } catch (const std::runtime_error&) {
    return "";
  }
}

std::string contrast(std::string_view found, std::string_view expected) {
  return fmt::format("\"{}\" instead of \"{}\"{}", found, expected, distance(found, expected));
}

}  // namespace

std::string GoldenDifference::text() const {
  std::string sentence = file;
  if (line > 0) sentence += fmt::format(", line {} (row {})", line, line - 1);
  if (!column.empty()) sentence += ", column " + column;
  return sentence + ": " + what;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("libcrypto can't compute SHA-256");
  }
  std::string text;
  for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string golden_manifest(const std::vector<GoldenFile>& files) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const GoldenFile& file : files) {
    const auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    list.push_back(
        {{"name", file.name}, {"bytes", file.text.size()}, {"rows", lines - 1}, {"sha256", sha256(file.text)}});
  }
  const nlohmann::ordered_json manifest = {{"schema_version", golden_schema_version}, {"files", std::move(list)}};
  return manifest.dump(2) + "\n";
}

std::vector<GoldenDifference> manifest_differences(const std::filesystem::path& folder,
                                                   const std::vector<std::string>& expected) {
  const std::string manifest_name(golden_manifest_name);
  std::vector<GoldenDifference> differences;
  nlohmann::json manifest;
  std::vector<std::string> listed;
  try {
    manifest = nlohmann::json::parse(read_input((folder / manifest_name).string()));
    const int version = manifest.at("schema_version").get<int>();
    if (version != golden_schema_version) {
      differences.push_back(
          {manifest_name, 0, "", fmt::format("schema version {} instead of {}", version, golden_schema_version)});
    }
    for (const auto& entry : manifest.at("files")) {
      const std::string name = entry.at("name").get<std::string>();
      listed.push_back(name);
      if (!std::filesystem::exists(folder / name)) {
        differences.push_back({name, 0, "", "is missing"});
        continue;
      }
      const std::string found = sha256(read_input((folder / name).string()));
      const std::string wanted = entry.at("sha256").get<std::string>();
      if (found != wanted) {
        differences.push_back({name, 0, "", fmt::format("SHA-256 {} instead of the manifest's {}", found, wanted)});
      }
    }
  } catch (const std::exception& error) {  // no file, no JSON, or not ours
    return {{manifest_name, 0, "", error.what()}};
  }
  for (const std::string& name : expected) {
    if (std::ranges::find(listed, name) == listed.end()) differences.push_back({name, 0, "", "not in the manifest"});
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory() && std::filesystem::exists(entry.path() / manifest_name)) continue;  // has its own
    const std::string name = entry.path().filename().string();
    const bool known = name == manifest_name || std::ranges::find(listed, name) != listed.end();
    if (!known) differences.push_back({name, 0, "", "not in the manifest"});
  }
  return differences;
}

std::vector<GoldenDifference> csv_differences(const std::string& file, std::string_view header,
                                              const std::vector<std::string>& rows, std::string_view found) {
  std::vector<GoldenDifference> differences;
  if (!found.ends_with('\n')) differences.push_back({file, 0, "", "the last line has no end"});
  if (found.ends_with('\n')) found.remove_suffix(1);
  const std::vector<std::string_view> lines = split(found, '\n');
  if (lines.front() != header) differences.push_back({file, 1, "", "another header"});
  if (lines.size() != rows.size() + 1) {
    differences.push_back({file, 0, "", fmt::format("{} rows instead of {}", lines.size() - 1, rows.size())});
  }
  const std::vector<std::string_view> columns = split(header, ',');
  for (std::size_t i = 0; i < std::min(rows.size(), lines.size() - 1); ++i) {
    if (rows[i].empty() || rows[i] == lines[i + 1]) continue;
    const std::vector<std::string_view> is = split(lines[i + 1], ',');
    const std::vector<std::string_view> should = split(rows[i], ',');
    if (is.size() != should.size()) {
      differences.push_back({file, i + 2, "", fmt::format("{} fields instead of {}", is.size(), should.size())});
      continue;
    }
    for (std::size_t j = 0; j < is.size(); ++j) {
      if (is[j] == should[j]) continue;
      differences.push_back({file, i + 2, std::string(columns.at(j)), contrast(is[j], should[j])});
    }
  }
  return differences;
}

}  // namespace lubjoint::reports
