#include <fmt/format.h>

#include <array>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/page/panel.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

/// Colour and marker of a curve: no two share either.
struct Pen {
  const char* colour;
  int marker;
};
constexpr std::array<Pen, 5> pens = {
    {{"#0072b2", 6}, {"#d55e00", 4}, {"#009e73", 8}, {"#cc79a7", 10}, {"#e69f00", 12}}};

Panel rounding_panel(const LawChecks& checks, const std::string& id, const std::string& words, bool is_short) {
  std::string blocks;
  std::string curves;
  std::size_t used = 0;
  for (const LawCheck& law : checks.laws) {
    if (law_facts(law.law).is_short() != is_short) continue;
    const std::string block = fmt::format("$d{}", used);
    blocks += block + " << EOD\n";
    for (const AccuracyRow& row : checks.rounding) {
      // A difference of nothing at all has no place on a logarithmic axis.
      if (row.law != law.law || row.max_of_force == 0 || row.one_minus_ratio == 1) continue;
      blocks += fmt::format("{:.4g} {:.4g}\n", row.one_minus_ratio, row.max_of_force);
    }
    blocks += "EOD\n";
    std::string title = law.law;
    for (std::size_t at = 0; (at = title.find('_', at)) != std::string::npos;) title[at] = ' ';
    const Pen& pen = pens[used % pens.size()];
    curves += fmt::format("{}{} with linespoints pt {} ps 0.7 lw 1.2 lc rgb '{}' title '{}'", used ? ", " : "plot ",
                          block, pen.marker, pen.colour, title);
    ++used;
  }
  Plot plot;
  plot.width = 400;
  plot.height = 360;
  plot.script = std::string(plain_axes) +
                "set logscale xy\nset xrange [1:1e-12] reverse\nset yrange [1e-17:1e-11<*]\nset format y '10^{%T}'\n"
                "set xtics ('1' 1, '10^{-3}' 1e-3, '10^{-6}' 1e-6, '10^{-9}' 1e-9, '10^{-12}' 1e-12)\n"
                "set mytics 1\nset xlabel '1 − ε [-]' offset 0,0.4\nset ylabel '|ΔF|/|F| [-]'\n"
                "set key outside center top horizontal samplen 2\nset lmargin 8\nset bmargin 3.2\nset rmargin 3\n" +
                blocks + curves + "\n";
  return {id, words, words + ": largest rounding error over the force against the distance from the wall, 1 − ε.",
          plot};
}

}  // namespace

Section laws_section(const Content& content) {
  const LawChecks& checks = content.laws;
  Table table("Each law against its oracles: differences over |F|", {{"law", {}, false},
                                                                     {"states"},
                                                                     {"quadrature, median"},
                                                                     {"quadrature, largest"},
                                                                     {"there, 1 − ε"},
                                                                     {"100 digits, largest"},
                                                                     {"allowed"},
                                                                     {"verdict", {}, false}});
  std::vector<Verdict> verdicts;
  for (const LawCheck& law : checks.laws) verdicts.push_back(law.verdict());
  std::vector<const Verdict*> judged;
  for (const Verdict& verdict : verdicts) judged.push_back(&verdict);
  for (const LawCheck& law : checks.laws) {
    std::vector<Cell> cells{law.law};
    if (law.quadrature) {
      cells.insert(cells.end(), {fmt::format("{}", law.states), scientific(law.quadrature->median),
                                 scientific(law.quadrature->largest),
                                 scientific(1 - law.quadrature->eccentricity_ratio_of_largest)});
    } else {
      cells.insert(cells.end(), {"–", "no pressure", "–", "–"});
    }
    cells.insert(cells.end(), {scientific(law.rounding), scientific(law.allowed, 0), agreement(law.verdict())});
    table.row(std::move(cells));
  }
  const std::vector<Panel> panels = {rounding_panel(checks, "rounding-short", "Short bearing", true),
                                     rounding_panel(checks, "rounding-long", "Long bearing", false)};
  return {"laws", "Each law against its oracle",
          filled("laws.html", {{"states", fmt::format("{}", checks.settings.states)},
                               {"closing_median", percent(checks.closing.median)},
                               {"closing_largest", percent(checks.closing.largest)},
                               {"opening_median", percent(checks.opening.median)},
                               {"opening_largest", percent(checks.opening.largest)},
                               {"table", table.html()},
                               {"checks", checks_table("Force laws: what the letters stand for", judged)},
                               {"plots", draw_panels(panels)},
                               {"csv", csv_block("csv-rounding", "rounding.csv", accuracy_csv(checks.rounding))}})};
}

}  // namespace lubjoint::reports::page
