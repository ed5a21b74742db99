#include "oracle/measure/stress/stress_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "oracle/files/files.hpp"
#include "oracle/measure/measuring_sources.hpp"
#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

namespace {

/// A case and an integrator, over all laws.
struct Summary {
  std::size_t laws = 0;
  std::size_t stopped = 0;
  std::size_t wrong = 0;
  std::size_t unreferenced = 0;
  double worst = -1;  ///< error of those that finished and were compared to the end; negative: none was
};

using Matrix = std::map<std::pair<std::string, std::string>, Summary>;

Matrix summarise(const std::vector<StressCell>& cells) {
  Matrix matrix;
  for (const StressCell& cell : cells) {
    Summary& at = matrix[{cell.scenario, cell.integrator}];
    ++at.laws;
    if (cell.status == StressStatus::wrong) ++at.wrong;
    if (cell.status == StressStatus::stopped) ++at.stopped;
    if (cell.status == StressStatus::wrong || cell.status == StressStatus::stopped) continue;
    if (cell.status == StressStatus::unreferenced) {
      ++at.unreferenced;
    } else {
      at.worst = std::max(at.worst, cell.deviation.place.value_or(0));
    }
  }
  return matrix;
}

std::string words(const Summary& at) {
  if (at.wrong > 0) return fmt::format("WRONG {}", at.wrong);
  if (at.stopped == at.laws) return "stopped";
  std::string text = at.worst >= 0 ? fmt::format("{:.0e}", at.worst) : "-";
  if (at.unreferenced > 0) text += fmt::format(" {}?", at.unreferenced);
  if (at.stopped > 0) text += fmt::format(" {}s", at.stopped);
  return text;
}

template <class Get>
std::vector<std::string> in_order(const std::vector<StressCell>& cells, const Get& get) {
  std::vector<std::string> names;
  for (const StressCell& cell : cells) {
    if (std::find(names.begin(), names.end(), get(cell)) == names.end()) names.push_back(get(cell));
  }
  return names;
}

const std::string& scenario_of(const StressCell& cell) { return cell.scenario; }
const std::string& integrator_of(const StressCell& cell) { return cell.integrator; }

std::string count_of(const std::vector<StressCell>& cells, StressStatus status) {
  const auto count = std::count_if(cells.begin(), cells.end(), [&](const auto& cell) { return cell.status == status; });
  return fmt::format("{} {}", count, stress_status_name(status));
}

}  // namespace

std::string stress_counts(const std::vector<StressCell>& cells) {
  std::string text;
  for (const StressStatus status : {StressStatus::finished, StressStatus::coarse, StressStatus::unreferenced,
                                    StressStatus::stopped, StressStatus::wrong}) {
    text += (text.empty() ? "" : ", ") + count_of(cells, status);
  }
  return text;
}

std::string stress_sentence(const std::vector<StressCell>& cells) {
  const auto count = [&](StressStatus status) {
    return std::count_if(cells.begin(), cells.end(), [&](const auto& cell) { return cell.status == status; });
  };
  return fmt::format(
      "As measured (`data/measured/stress.csv`), of {} runs of {} cases {} finished near their reference in place, "
      "velocity and force, {} finished further off and had warned of their own tolerance, {} finished without a "
      "reference, {} stopped with a reason, {} are wrong.",
      cells.size(), in_order(cells, scenario_of).size(), count(StressStatus::finished), count(StressStatus::coarse),
      count(StressStatus::unreferenced), count(StressStatus::stopped), count(StressStatus::wrong));
}

std::string measured_by(const std::vector<StressCell>& cells) {
  std::set<std::string> programs;
  for (const StressCell& cell : cells) programs.insert(cell.program);
  std::string text = "measured by ";
  for (const std::string& each : programs) text += (each == *programs.begin() ? "" : " and ") + each;
  const bool present = programs.size() == 1 && *programs.begin() == measuring_sources();
  return text + (present ? ", the sources of this program"
                         : fmt::format("; this program's sources are {}", measuring_sources()));
}

std::string stop_kind(const std::string& message) {
  static const std::regex place(R"(^stopped at t = [^:]*: )");
  static const std::regex number_pattern(R"([-+]?\d+(\.\d+)?(e[-+]?\d+)?)");
  // Names of methods keep their digits.
  std::string text = std::regex_replace(message, place, "");
  text = std::regex_replace(text, std::regex("radau_iia5"), "radau_iia~");
  text = std::regex_replace(text, number_pattern, "#");
  return std::regex_replace(text, std::regex("radau_iia~"), "radau_iia5");
}

std::string stress_table(const std::vector<StressCase>& cases, const std::vector<StressCell>& cells) {
  const Matrix matrix = summarise(cells);
  const std::vector<std::string> integrators = in_order(cells, integrator_of);
  std::string text = fmt::format("{} cells: {}\n", cells.size(), stress_counts(cells));
  text += measured_by(cells) + "\n";
  text +=
      "Largest error of the journal's position [clearances] over the laws; 3s: three laws stopped with a reason; "
      "2?: two finished without a reference\n"
      "finished: places, velocities and forces at all output times as near to a stored reference of other methods as "
      "the tolerance lets one expect\n"
      "coarse: further off, and warned that the tolerance does not resolve the film, or of what the estimate of a "
      "step's error does not see\n\n";
  text += fmt::format("{:<32}", "case");
  for (const std::string& name : integrators) {
    text += fmt::format("{:>12}", name == "adams_bashforth_moulton" ? "adams_b_m" : name.substr(0, 11));
  }
  text += '\n';
  for (const StressCase& each : cases) {
    std::string line;
    for (const std::string& name : integrators) {
      const auto at = matrix.find({each.name, name});
      if (at != matrix.end()) line += fmt::format("{:>12}", words(at->second));
    }
    if (!line.empty()) text += fmt::format("{:<32}{}  {}\n", each.name, line, each.what);
  }

  std::map<std::string, std::size_t> kinds;
  for (const StressCell& cell : cells) {
    if (cell.status == StressStatus::stopped) ++kinds[stop_kind(cell.message)];
  }
  std::vector<std::pair<std::size_t, std::string>> sorted;
  sorted.reserve(kinds.size());
  for (const auto& [kind, count] : kinds) sorted.emplace_back(count, kind);
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  text += sorted.empty() ? "\nNo run stopped.\n" : "\nReasons of the stops:\n";
  for (const auto& [count, kind] : sorted) text += fmt::format("{:>6} x {}\n", count, kind);

  std::string wrong;
  for (const StressCell& cell : cells) {
    if (cell.status != StressStatus::wrong) continue;
    wrong += fmt::format("  {}, {}, {}: {}\n", cell.scenario, cell.law, cell.integrator, cell.message);
  }
  text += wrong.empty() ? "\nNo cell is wrong.\n" : "\nWrong:\n" + wrong;
  return text;
}

void draw_stress(const std::vector<StressCell>& cells, const std::filesystem::path& folder) {
  const Matrix matrix = summarise(cells);
  const std::vector<std::string> integrators = in_order(cells, integrator_of);
  const std::vector<std::string> cases = in_order(cells, scenario_of);
  const auto rows = static_cast<int>(cases.size());
  const auto columns = static_cast<int>(integrators.size());
  Plot plot;
  plot.width = 1200;
  plot.height = 150 + 24 * rows;
  std::string text =
      "set title 'Largest error over the laws [log_{10} of clearances]; s: laws that stopped with a reason'\n"
      "set cbrange [-12:0]\nset cblabel 'log_{10} of the error'\nunset key\nset tics scale 0\n"
      "set palette defined (0 '#00204d', 0.25 '#31446b', 0.5 '#7c7b78', 0.75 '#b9ac70', 1 '#ffea46')\n"
      "set xtics rotate by 30 left offset 0,0.3\nset lmargin 34\nset tmargin 9\nset bmargin 2\n"
      "set link x2\nset x2tics noenhanced\nunset xtics\n";
  text += fmt::format("set xrange [-0.5:{}]\nset x2range [-0.5:{}]\nset yrange [{}:-0.5]\n", columns - 0.5,
                      columns - 0.5, rows - 0.5);
  std::string tics;
  for (int j = 0; j < columns; ++j) {
    tics += fmt::format("{}'{}' {}", j ? ", " : "", integrators[static_cast<std::size_t>(j)], j);
  }
  text += "set x2tics (" + tics + ") rotate by 25 left\n";
  tics.clear();
  for (int i = 0; i < rows; ++i) tics += fmt::format("{}'{}' {}", i ? ", " : "", cases[static_cast<std::size_t>(i)], i);
  text += "set ytics (" + tics + ") noenhanced\n";
  std::string data;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const auto found = matrix.find({cases[static_cast<std::size_t>(i)], integrators[static_cast<std::size_t>(j)]});
      if (found == matrix.end()) continue;
      const Summary& at = found->second;
      const bool coloured = at.wrong == 0 && at.worst >= 0;
      const double shade = std::clamp(std::log10(std::max(at.worst, 1e-12)), -12.0, 0.0);
      if (coloured) {
        data += fmt::format("{} {} {:.3f}\n", j, i, shade);
      } else {
        text += fmt::format(
            "set object rectangle center {},{} size 1,1 behind fillcolor rgb '{}' fillstyle solid noborder\n", j, i,
            at.wrong ? "#d41159" : "#e8e8e8");
      }
      std::string label = at.wrong                ? fmt::format("WRONG {}", at.wrong)
                          : at.stopped == at.laws ? "stopped"
                          : at.worst < 0          ? "-"
                          : at.worst > 0          ? fmt::format("{:.1f}", std::log10(at.worst))
                                                  : "0";
      if (at.unreferenced > 0) label += fmt::format("  {}?", at.unreferenced);
      if (at.stopped > 0 && at.stopped < at.laws) label += fmt::format("  {}s", at.stopped);
      const bool dark = at.wrong || (coloured && shade < -5);
      text += fmt::format("set label '{}' at {},{} center front textcolor rgb '{}'\n", label, j, i,
                          dark ? "#ffffff" : "#000000");
    }
  }
  // One cell outside the picture: a map of nothing but stops is no error.
  text += "$cells << EOD\n" + data +
          "-9 -9 0\nEOD\nplot $cells using 1:2:(0.5):(0.5):3 with boxxyerror lc palette fs solid noborder\n";
  plot.script = text;
  draw(plot, folder, "stress");
}

}  // namespace lubjoint::reports
