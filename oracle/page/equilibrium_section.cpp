#include <fmt/format.h>

#include "oracle/page/sections.hpp"
#include "oracle/results/angles.hpp"
#include "oracle/results/journal_report.hpp"

namespace lubjoint::reports::page {

namespace {

std::string rate_words(double rate) {
  return std::abs(rate) < 0.1 ? scientific(rate, 3) : with_minus(fmt::format("{:.4f}", rate));
}

std::string rate_words(const std::optional<MotionRate>& motion) {
  return motion ? rate_words(motion->rate) : std::string("–");
}
}  // namespace

Section equilibrium_section(const Content& content) {
  Table rest("Equilibrium under the load of example 1, and whether the journal comes to rest there",
             {{"law", {}, false},
              {"the paper says", {}, false},
              {"found", {}, false},
              {"verdict", {}, false},
              {"ε at rest", "–"},
              {"attitude", "°"},
              {"largest ε of the run", "–"},
              {"distance from rest after 3 times the run", "c"}});
  Table stability("What becomes of a small displacement from the equilibrium",
                  {{"law", {}, false},
                   {"it", {}, false},
                   {"leading eigenvalue", "1/s"},
                   {"rate of a run from 10⁻³ c off", "1/s"},
                   {"rate of the run from rest", "1/s"}});
  std::vector<Column> of_matrices = {{"law", {}, false}};
  for (const char* name : {"Kxx", "Kxy", "Kyx", "Kyy"}) of_matrices.push_back({name, "N/mm"});
  for (const char* name : {"Cxx", "Cxy", "Cyx", "Cyy"}) of_matrices.push_back({name, "N·s/mm"});
  Table matrices("Stiffness K and damping C at the equilibrium", of_matrices);
  for (const Example1Law& item : content.journal.laws) {
    const std::complex<double> leading = item.rest.eigenvalues[0];
    rest.row({item.law, item.paper == "-" ? "–" : item.paper, behaviour_word(item.found), agreement(item.verdict),
              fmt::format("{:.6f}", item.rest.eccentricity_ratio), fmt::format("{:.4f}", degrees * item.rest.attitude),
              fmt::format("{:.6f}", item.run.max_eccentricity_ratio), scientific(item.long_run_distance)});
    stability.row({item.law, stability_word(item.rest.stability()),
                   fmt::format("{} ± {:.4f} i", rate_words(leading.real()), std::abs(leading.imag())),
                   rate_words(item.near_rest), rate_words(item.from_the_start)});
    std::vector<Cell> cells{item.law};
    for (const Eigen::Matrix2d* matrix : {&item.rest.stiffness, &item.rest.damping}) {
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) cells.emplace_back(fmt::format("{:.4g}", 1e-3 * (*matrix)(i, j)));
      }
    }
    matrices.row(std::move(cells));
  }
  return {
      "equilibrium", "Equilibria and eigenvalues",
      filled(
          "equilibrium.html",
          {{"equilibria", rest.html()},
           {"stability", stability.html()},
           {"matrices", matrices.html()},
           {"checks", checks_table("Example 1: what the letters of a verdict stand for", content.journal.verdicts())},
           {"checks_csv", csv_block("csv-journal-checks", "journal-checks.csv", example_1_checks_csv(content.journal))},
           {"csv", csv_block("csv-journal", "journal-summary.csv", example_1_csv(content.journal))}})};
}

}  // namespace lubjoint::reports::page
