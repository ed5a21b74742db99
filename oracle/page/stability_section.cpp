#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "oracle/measure/measuring_sources.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

/// Classes of a run's error: what colour it has, and what that says.
struct Level {
  double bound;
  const char* look;
  const char* words;
};
constexpr Level levels[] = {{1e-9, "level-3", "error up to 10⁻⁹ c"},
                            {1e-6, "level-2", "up to 10⁻⁶ c"},
                            {1e-3, "level-1", "up to 10⁻³ c"},
                            {1e300, "level-0", "more"}};

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// What a run that stopped said.
std::string why_stopped(const StabilityRow& row) {
  return (row.message.starts_with("stopped") ? "" : "stopped: ") + row.message;
}

/// A cell of the map: the digits that are right, × for a run that stopped, ! for one that is wrong.
std::string cell_of(const StabilityRow* row) {
  if (!row) return "<td class=\"level-none\">·</td>";
  if (row->status == RowStatus::stopped) {
    return fmt::format("<td class=\"level-stop\" title=\"{}\">×</td>", escaped(why_stopped(*row)));
  }
  if (row->status == RowStatus::wrong) {
    return fmt::format("<td class=\"level-wrong\" title=\"{}\">!</td>", escaped("wrong: " + row->message));
  }
  if (row->status == RowStatus::unreferenced || !row->error) {
    const std::string why = row->message.empty() ? "" : ": " + row->message;
    return fmt::format("<td class=\"level-none\" title=\"{}\">?</td>", escaped("finished, without a reference" + why));
  }
  const double error = *row->error;
  const Level* level = levels;
  while (error > level->bound) ++level;
  // Digits of e/c that are right, at most those of a double.
  const double digits = error > 0 ? std::clamp(std::floor(-std::log10(error)), 0.0, 16.0) : 16.0;
  const std::string said = row->message.empty() ? "" : "; it had warned";  // the data beside the map say of what
  return fmt::format("<td class=\"{}\" title=\"{}\">{:.0f}</td>", level->look,
                     escaped("finished, off by " + scientific(error) + " c, of velocity by " +
                             scientific(row->rate_error.value_or(0)) + ", of force by " +
                             scientific(row->force_error.value_or(0)) + said),
                     digits);
}

class Map {
 public:
  explicit Map(const std::vector<StabilityRow>& rows) {
    for (const StabilityRow& row : rows) {
      add_once(problems_, row.problem);
      add_once(laws_, row.law);
      add_once(integrators_, row.integrator);
      cells_[{row.integrator, row.problem, row.law}] = &row;
    }
  }

  /// One table an integrator: cases downwards, laws across.
  std::string html() const {
    std::string html = "<div class=\"maps\" id=\"stability-maps\">\n";
    for (const std::string& integrator : integrators_) html += table_of(integrator);
    return html + "</div>\n";
  }

 private:
  const StabilityRow* find(const std::string& integrator, const std::string& problem, const std::string& law) const {
    const auto found = cells_.find({integrator, problem, law});
    return found == cells_.end() ? nullptr : found->second;
  }

  std::string table_of(const std::string& integrator) const {
    std::string html = fmt::format(
        "<div class=\"map scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Stability with {0}\">\n<table>\n"
        "<caption>{0}</caption>\n"
        "<thead><tr><th scope=\"col\">case</th>",
        escaped(integrator));
    for (const std::string& law : laws_) html += "<th scope=\"col\"><span>" + escaped(law) + "</span></th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const std::string& problem : problems_) {
      html += "<tr><th scope=\"row\">" + escaped(problem) + "</th>";
      for (const std::string& law : laws_) html += cell_of(find(integrator, problem, law));
      html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n</div>\n";
  }

  std::vector<std::string> problems_;
  std::vector<std::string> laws_;
  std::vector<std::string> integrators_;
  std::map<std::array<std::string, 3>, const StabilityRow*> cells_;
};

std::string stopped_table(const std::vector<StabilityRow>& rows) {
  Table table("Runs that stopped, are too coarse, or are wrong",
              {{"case", {}, false}, {"law", {}, false}, {"integrator", {}, false}, {"what happened", {}, false}});
  std::size_t count = 0;
  for (const StabilityRow& row : rows) {
    if (row.status == RowStatus::finished) continue;
    const bool wrong = row.status == RowStatus::wrong;
    const std::string what =
        row.status == RowStatus::stopped ? why_stopped(row) : (wrong ? "✗ wrong: " : "finished, ") + row.message;
    table.row({row.problem, row.law, row.integrator, Cell(what, wrong ? "bad" : "")});
    ++count;
  }
  if (count == 0) return "<p>No run stopped, none is too coarse, and none is wrong.</p>\n";
  return fmt::format(
      "<details>\n<summary>{} of {} runs stopped, are too coarse and said so, or are wrong</summary>\n{}</details>\n",
      count, rows.size(), table.html());
}

std::string measured_by(const std::vector<StabilityRow>& rows) {
  std::set<std::string> programs;
  for (const StabilityRow& row : rows) programs.insert(row.program);
  std::string text;
  for (const std::string& each : programs) {
    text += (text.empty() ? "Measured by " : " and ") + (each.empty() ? std::string("an earlier program") : each);
  }
  const bool present = programs.size() == 1 && *programs.begin() == measuring_sources();
  return text +
         (present ? ", the sources of this program." : ", not by this program's sources, " + measuring_sources() + ".");
}

}  // namespace

Section stability_section(const Content& content) {
  std::string inner =
      "<p>Not run here. <code>./lubjoint stress --out FOLDER</code> writes <code>stress.csv</code>, and "
      "<code>./lubjoint reproduce "
      "--data FOLDER</code> puts it here.</p>\n";
  if (content.stability) {
    inner = "<ul class=\"key\" aria-label=\"Colours of the maps\">\n";
    for (const Level& level : levels) {
      inner += fmt::format("<li><span class=\"swatch {}\"></span>{}</li>\n", level.look, level.words);
    }
    inner +=
        "<li><span class=\"swatch level-stop\"></span>× stopped, with a reason</li>\n"
        "<li><span class=\"swatch level-wrong\"></span>! wrong</li>\n<li>? finished, without a reference</li>\n<li>· "
        "not run</li>\n</ul>\n";
    inner +=
        "<p>In the cells: digits of e/c that are right, against a stored motion of other methods; velocities and "
        "forces, "
        "which are compared with it too, where you point.</p>\n";
    inner += "<p>" + escaped(measured_by(content.stability->rows)) + "</p>\n";
    inner += Map(content.stability->rows).html();
    inner +=
        "<p class=\"readout\" id=\"stability-readout\" role=\"status\">Point at a cell for its error or reason.</p>\n";
    inner += stopped_table(content.stability->rows);
    inner += csv_block("csv-stability", "stress.csv", content.stability->csv);
  }
  return {"stability", "Stability", filled("stability.html", {{"content", inner}})};
}

}  // namespace lubjoint::reports::page
