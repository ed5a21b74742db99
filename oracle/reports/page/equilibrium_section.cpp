#include <fmt/format.h>

#include <boost/math/constants/constants.hpp>

#include "oracle/reports/journal_report.hpp"
#include "oracle/reports/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {
constexpr double degrees = 180 / boost::math::constants::pi<double>();
}

Cell agreement(const std::vector<std::string>& failures) {
  if (failures.empty()) return verdict_cell(true, "agrees");
  std::string words;
  for (const std::string& failure : failures) words += (words.empty() ? "" : "; ") + failure;
  return verdict_cell(false, words);
}

Section equilibrium_section(const Content& content) {
  const std::vector<Column> of_rest = {{"law", {}, false},          {"the paper", {}, false},
                                       {"here", {}, false},         {"verdict", {}, false},
                                       {"ε at rest", "–"},          {"attitude", "°"},
                                       {"largest ε", "–"},          {"leading eigenvalue", "1/s"},
                                       {"displacement", {}, false}, {"distance after 3 × the run", "c"},
                                       {"second integrator", "c"}};
  Table rest("Equilibrium under the load of example 1, and its stability", of_rest);
  std::vector<Column> of_matrices = {{"law", {}, false}};
  for (const char* name : {"Kxx", "Kxy", "Kyx", "Kyy"}) of_matrices.push_back({name, "N/mm"});
  for (const char* name : {"Cxx", "Cxy", "Cyx", "Cyy"}) of_matrices.push_back({name, "N·s/mm"});
  Table matrices("Stiffness K and damping C at the equilibrium", of_matrices);
  for (const Example1Law& item : content.journal.laws) {
    const std::complex<double> leading = item.rest.eigenvalues[0];
    const double rate = leading.real();
    rest.row({item.law, item.paper == "-" ? "–" : item.paper, item.rests ? "rests" : "circles",
              agreement(item.failures), fmt::format("{:.6f}", item.rest.eccentricity_ratio),
              fmt::format("{:.4f}", degrees * item.rest.attitude),
              fmt::format("{:.6f}", item.run.max_eccentricity_ratio),
              fmt::format("{} ± {:.4f} i", std::abs(rate) < 0.1 ? scientific(rate, 3) : fmt::format("{:.4f}", rate),
                          std::abs(leading.imag())),
              stability_word(item.rest.stability()), scientific(item.long_run_distance),
              scientific(item.integrator_difference)});
    std::vector<Cell> cells{item.law};
    for (const Eigen::Matrix2d* matrix : {&item.rest.stiffness, &item.rest.damping}) {
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) cells.emplace_back(fmt::format("{:.4g}", 1e-3 * (*matrix)(i, j)));
      }
    }
    matrices.row(std::move(cells));
  }
  return {"equilibrium", "Equilibria and eigenvalues",
          filled("equilibrium.html",
                 {{"equilibria", rest.html()},
                  {"matrices", matrices.html()},
                  {"csv", csv_block("csv-journal", "journal-summary.csv", example_1_csv(content.journal))}})};
}

}  // namespace lubjoint::reports::page
