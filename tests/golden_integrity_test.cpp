// The golden files are what the manifest says, and a single changed digit is found.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>

#include "oracle/files/golden_files.hpp"
#include "support/golden.hpp"

namespace golden_integrity_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A copy of the golden data that is removed at the end.
class GoldenCopy {
 public:
  GoldenCopy() : folder(fs::temp_directory_path() / ("lubjoint-golden-" + std::to_string(::getpid()))) {
    fs::remove_all(folder);
    fs::copy(golden_folder(), folder, fs::copy_options::recursive);
  }
  ~GoldenCopy() { fs::remove_all(folder); }
  GoldenCopy(const GoldenCopy&) = delete;
  GoldenCopy& operator=(const GoldenCopy&) = delete;

  const fs::path folder;
};

std::vector<fs::path> golden_csv_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(golden_folder())) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  return files;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace

TEST_CASE("the golden files have the manifest's checksums and together less than 4 MB") {
  for (const reports::GoldenDifference& difference : reports::manifest_differences(golden_folder())) {
    FAIL_CHECK(difference.text());
  }
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(golden_folder())) {
    if (entry.is_regular_file()) bytes += fs::file_size(entry.path());
  }
  CHECK(bytes < 4'000'000);
  CHECK(golden_csv_files().size() >= 9);
}

TEST_CASE("SHA-256 is the standard's: FIPS 180-2, appendix B") {
  CHECK(reports::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_CASE(
    "every output of the golden files has 30 digits, is exact or is not defined, with half a unit as uncertainty") {
  for (const fs::path& path : golden_csv_files()) {
    const reports::CsvTable table(reports::read_input(path.string()), path.filename().string());
    const std::string& header = table.header();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      std::vector<std::string> names, fields;
      for (auto [text, parts] : {std::pair{&header, &names}, std::pair{&table.line(row), &fields}}) {
        std::size_t begin = 0;
        for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
          end = text->find(',', begin);
          parts->push_back(text->substr(begin, end - begin));
        }
      }
      for (std::size_t i = 1; i < names.size(); ++i) {
        if (names[i] != names[i - 1] + "_uncertainty" || fields[i] == "0") continue;
        INFO(path.filename() << ", row " << row + 1 << ", " << names[i - 1]);
        const std::string& value = fields[i - 1];
        if (value.empty()) {  // not defined: a long bearing's side flow, a threshold that there is not
          CHECK(fields[i].empty());
          continue;
        }
        const std::size_t e = value.find('e');
        CHECK(std::count_if(value.begin(), value.begin() + static_cast<long>(e), ::isdigit) == 30);
        CHECK(fields[i] == "5.1e" + std::to_string(std::stol(value.substr(e + 1)) - 30));
      }
    }
  }
}

TEST_CASE("a flipped digit in any golden file is found: the checksum names the file, the comparison row and column") {
  const GoldenCopy copy;
  for (const fs::path& original : golden_csv_files()) {
    const std::string name = original.filename().string();
    const std::string good = reports::read_input(original.string());
    std::vector<std::string> rows = lines_of(good);
    const std::string header = rows.front();
    rows.erase(rows.begin());
    // In the middle of the file, the fifth digit of an output: of its value, not of its uncertainty.
    std::size_t row = rows.size() / 2;
    std::size_t column = 0;
    std::size_t at = std::string::npos;
    for (; row < rows.size() && at == std::string::npos; ++row) {
      std::size_t begin = 0;
      for (std::size_t i = 0; begin <= rows[row].size(); ++i) {
        const std::size_t end = std::min(rows[row].find(',', begin), rows[row].size());
        if (end - begin > 30) {
          column = i;
          at = begin + 6;
        }
        begin = end + 1;
      }
    }
    --row;
    REQUIRE(at != std::string::npos);
    std::string bad = good;
    std::size_t offset = header.size() + 1;
    for (std::size_t i = 0; i < row; ++i) offset += rows[i].size() + 1;
    char& digit = bad[offset + at];
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
    reports::write_file(copy.folder / name, bad);

    const auto by_checksum = reports::manifest_differences(copy.folder);
    REQUIRE(by_checksum.size() == 1);
    CHECK_THAT(by_checksum[0].text(), Contains(name) && Contains("SHA-256"));

    const auto by_field = reports::csv_differences(name, header, rows, bad);
    REQUIRE(by_field.size() == 1);
    CHECK(by_field[0].file == name);
    CHECK(by_field[0].line == row + 2);
    std::string column_name = header;
    for (std::size_t i = 0; i < column; ++i) column_name.erase(0, column_name.find(',') + 1);
    CHECK(by_field[0].column == column_name.substr(0, column_name.find(',')));
    CHECK_THAT(by_field[0].text(), Contains("row " + std::to_string(row + 1)) && Contains("off by") && Contains("e-0"));
    reports::write_file(copy.folder / name, good);
  }
}

TEST_CASE("a golden folder with a file missing, a file too many, or no manifest is found") {
  const GoldenCopy copy;
  fs::remove(copy.folder / "film_extent.csv");
  reports::write_file(copy.folder / "stray.csv", "a\n1\n");
  const auto differences = reports::manifest_differences(copy.folder, {"absent.csv"});
  REQUIRE(differences.size() == 3);
  CHECK(differences[0].text() == "film_extent.csv: is missing");
  CHECK(differences[1].text() == "absent.csv: not in the manifest");
  CHECK(differences[2].text() == "stray.csv: not in the manifest");
  fs::remove(copy.folder / "manifest.json");
  const auto without = reports::manifest_differences(copy.folder);
  REQUIRE(without.size() == 1);
  CHECK_THAT(without[0].text(), Contains("manifest.json"));
}

TEST_CASE("golden comparison: headers, rows and fields that are missing are named") {
  const std::vector<std::string> rows = {"1,2", "3,4"};
  CHECK(reports::csv_differences("f", "a,b", rows, "a,b\n1,2\n3,4\n").empty());
  CHECK(reports::csv_differences("f", "a,b", {"", "3,4"}, "a,b\n9,9\n3,4\n").empty());  // an unasked row
  CHECK_THAT(reports::csv_differences("f", "a,b", rows, "a,c\n1,2\n3,4\n").at(0).text(), Contains("another header"));
  CHECK_THAT(reports::csv_differences("f", "a,b", rows, "a,b\n1,2\n").at(0).text(), Contains("1 rows instead of 2"));
  CHECK_THAT(reports::csv_differences("f", "a,b", rows, "a,b\n1,2\n3\n").at(0).text(), Contains("line 3 (row 2)"));
  CHECK_THAT(reports::csv_differences("f", "a,b", rows, "a,b\n1,2\n3,4").at(0).text(), Contains("has no end"));
}

}  // namespace golden_integrity_test
