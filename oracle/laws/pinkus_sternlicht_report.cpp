#include "oracle/laws/pinkus_sternlicht_report.hpp"

#include <fmt/format.h>

#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

std::vector<DifferenceByRatio> by_ratio(const std::vector<PinkusSternlichtDifference>& differences) {
  std::vector<DifferenceByRatio> rows;
  for (auto first = differences.begin(); first != differences.end();) {
    auto last = first;  // ε is outermost
    while (last != differences.end() && last->eccentricity_ratio == first->eccentricity_ratio) ++last;
    const std::vector<PinkusSternlichtDifference> same(first, last);
    rows.push_back(
        {first->eccentricity_ratio, summary_of(same, SqueezeSign::closing), summary_of(same, SqueezeSign::opening)});
    first = last;
  }
  return rows;
}

std::string difference_csv(const std::vector<DifferenceByRatio>& rows) {
  std::string csv = "eccentricity_ratio,closing_median,closing_largest,opening_median,opening_largest\n";
  for (const DifferenceByRatio& row : rows) {
    csv += fmt::format("{:.6g},{:.6e},{:.6e},{:.6e},{:.6e}\n", row.eccentricity_ratio, row.closing.median,
                       row.closing.largest, row.opening.median, row.opening.largest);
  }
  return csv;
}

std::string difference_text(const std::vector<PinkusSternlichtDifference>& differences) {
  const auto line = [&](const char* words, SqueezeSign sign, double below) {
    const DifferenceSummary s = summary_of(differences, sign, below);
    return fmt::format("{:<28} median {:6.2f} %, largest {:7.2f} % (at e/c {:.3f}), {} states\n", words, 100 * s.median,
                       100 * s.largest, s.eccentricity_ratio_of_largest, s.states);
  };
  return "|F_PS - F|/|F| of the Pinkus-Sternlicht law, F the long dynamic film by quadrature; eccentricity ratio and\n"
         "direction of motion with equal weight\n" +
         line("closing, all ratios", SqueezeSign::closing, 1) + line("opening, all ratios", SqueezeSign::opening, 1) +
         line("opening, ratios below 0.9", SqueezeSign::opening, 0.9);
}

void draw_difference(const std::vector<DifferenceByRatio>& rows, const std::filesystem::path& folder,
                     const std::string& name) {
  Plot plot;
  plot.width = 900;
  plot.height = 560;
  plot.script = "$data << EOD\n";
  for (const DifferenceByRatio& row : rows) {
    plot.script += fmt::format("{} {} {} {} {}\n", row.eccentricity_ratio, row.closing.median, row.closing.largest,
                               row.opening.median, row.opening.largest);
  }
  plot.script +=
      "EOD\nset title 'Pinkus-Sternlicht against the long dynamic film'\nset xlabel 'eccentricity ratio [-]'\n"
      "set ylabel 'difference over the force [-]'\nset logscale y\nset format y '%g'\nset yrange [0.001:20]\n"
      "set grid lc rgb '#dddddd'\nset tics nomirror\nset key top left\n"
      "plot $data using 1:2 with lines lw 2 lc rgb '#0072b2' title 'closing (b > 0), median', "
      "'' using 1:3 with lines lw 2 dt 2 lc rgb '#0072b2' title 'closing, largest', "
      "'' using 1:4 with lines lw 2 lc rgb '#d55e00' title 'opening (b < 0), median', "
      "'' using 1:5 with lines lw 2 dt 2 lc rgb '#d55e00' title 'opening, largest'\n";
  draw(plot, folder, name);
}

}  // namespace lubjoint::reports
