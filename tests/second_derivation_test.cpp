// Every golden trajectory against a derivation of its own, row by row and column by column.
#include "oracle/trajectories/second_derivation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"

namespace second_derivation_test {

using namespace lubjoint;

namespace {

const std::filesystem::path data = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data";

struct Golden {
  std::string name;  ///< of the file, without its ending
  std::filesystem::path scene;
  std::string law;  ///< empty: the scene's own
};

std::vector<Golden> all_golden() {
  std::vector<Golden> all;
  for (const auto& entry : std::filesystem::directory_iterator(data / "scenes")) {
    if (!entry.is_regular_file()) continue;  // the published problems have a folder, and numbers of their own
    const std::string stem = entry.path().stem().string();
    if (!is_free_journal(load_scene(entry.path()))) {
      all.push_back({stem, entry.path(), ""});
      continue;
    }
    for (const std::string_view law : film_law_names) {
      all.push_back({stem + "-" + std::string(law), entry.path(), std::string(law)});
    }
  }
  std::sort(all.begin(), all.end(), [](const Golden& a, const Golden& b) { return a.name < b.name; });
  return all;
}

std::string text_of(const Golden& golden) {
  return reports::read_input((data / "golden" / "trajectories" / (golden.name + ".csv")).string());
}

/// Digits that data/README.md states for a file: the last field of its line in the table of second derivations.
std::map<std::string, double> stated_digits() {
  std::map<std::string, double> stated;
  std::istringstream lines(reports::read_input((data / "README.md").string()));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("| second derivation |") != std::string::npos) inside = true;
    if (line.empty()) inside = false;
    if (!inside || !line.starts_with("| `")) continue;
    const std::size_t end = line.rfind('|');
    const std::size_t begin = line.rfind('|', end - 1);
    stated[line.substr(3, line.find('`', 3) - 3)] = std::stod(line.substr(begin + 1, end - begin - 1));
  }
  return stated;
}

/// The text with one number of one row changed by so much.
std::string falsified(const std::string& text, std::size_t row, const std::string& column, double by) {
  const reports::CsvTable table(text, "golden");
  const std::size_t at = table.column(column);
  std::string result = table.header() + "\n";
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t k = 0; k < table.columns().size(); ++k) {
      std::ostringstream field;
      field.precision(17);
      if (i == row && k == at) {
        field << table.number(i, k) + by;
      } else {
        field << table.field(i, k);
      }
      result += (k == 0 ? "" : ",") + field.str();
    }
    result += "\n";
  }
  return result;
}

}  // namespace

TEST_CASE("golden trajectories: every row and column is what a second derivation says, to the digits stated") {
  const std::map<std::string, double> stated = stated_digits();
  for (const Golden& golden : all_golden()) {
    CAPTURE(golden.name);
    const reports::CsvTable file(text_of(golden), golden.name);
    const auto found = reports::second_agreement(load_scene(golden.scene), golden.law, file);
    REQUIRE(found.apart.size() == file.rows());
    const std::size_t wrong = found.first_wrong();
    CAPTURE(wrong);
    if (wrong < file.rows()) FAIL_CHECK(found.apart[wrong] << " apart, allowed is " << found.allowed[wrong]);
    REQUIRE(stated.contains(golden.name));
    // To one decimal. The second derivation's own error is its tolerance, 1e-13 of a step, and rounding decides how its
    // steps fall: on one processor they took 0.4 of a digit from one trajectory, which steps of 0.9 to 1.2 times that
    // tolerance gave back. Where the two happen to be nearer it says nothing.
    CAPTURE(found.digits, stated.at(golden.name));
    CHECK(found.digits > stated.at(golden.name) - 0.5);
    CHECK(found.digits < stated.at(golden.name) + 1);
  }
  CHECK(stated.size() == all_golden().size());
}

TEST_CASE("golden trajectories: one wrong number in any column of any file is noticed in its row") {
  for (const Golden& golden : all_golden()) {
    CAPTURE(golden.name);
    const std::string text = text_of(golden);
    const reports::CsvTable file(text, golden.name);
    std::vector<double> times;
    for (std::size_t row = 0; row < file.rows(); ++row) times.push_back(file.number(row, 0));
    const auto second = reports::second_derivation(load_scene(golden.scene), golden.law, times);
    const std::vector<double> allowed = reports::second_agreement(second, file).allowed;
    const std::vector<double> sizes = reports::largest_sizes(second.rows, second.columns.vectors);
    std::size_t column = 0;
    for (std::size_t v = 0; v < sizes.size(); ++v) {
      for (const std::size_t end = column + second.columns.vectors[v]; column < end; ++column) {
        const std::size_t row = (7 * column + 11) % file.rows();
        CAPTURE(second.columns.names[column], row);
        // What is allowed, once for where the right number may be already, and once more for being beyond it.
        const double by = 2.1 * allowed[row] * sizes[v];
        const reports::CsvTable wrong(falsified(text, row, second.columns.names[column], by), golden.name);
        CHECK(reports::second_agreement(second, wrong).first_wrong() == row);
      }
    }
  }
}

}  // namespace second_derivation_test
