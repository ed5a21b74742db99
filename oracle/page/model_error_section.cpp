#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/page/panel.hpp"
#include "oracle/page/sections.hpp"
#include "oracle/results/angles.hpp"

namespace lubjoint::reports::page {

namespace {

constexpr oracle::FiniteFilm reference = oracle::FiniteFilm::finite_reynolds;

/// Classes of the maps: an error up to this, in this colour (viridis, dark for the worst).
struct Level {
  double bound;
  const char* colour;
  const char* words;
};
constexpr std::array<Level, 5> levels = {{{0.05, "#fde725", "within 5 %"},
                                          {0.10, "#5ec962", "within 10 %"},
                                          {0.25, "#21918c", "within 25 %"},
                                          {1.00, "#3b528b", "within 100 %"},
                                          {1e300, "#440154", "worse"}}};

std::size_t level_of(double error) {
  std::size_t level = 0;
  while (level + 1 < levels.size() && error > levels[level].bound) ++level;
  return level;
}

Panel map_panel(const std::vector<ModelErrorEntry>& map, std::string_view law) {
  std::string data;
  double last = -1;
  std::size_t states = 0;
  std::size_t within = 0;
  for (const ModelErrorEntry& entry : map) {
    if (entry.law != law || entry.film != reference) continue;
    if (last >= 0 && entry.eccentricity_ratio != last) data += '\n';
    last = entry.eccentricity_ratio;
    data += fmt::format("{} {} {}\n", entry.eccentricity_ratio, degrees * entry.direction, level_of(entry.error));
    ++states;
    within += entry.error <= 0.25;
  }
  std::string colours;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    colours += fmt::format("{}{} '{}'", i ? ", " : "", i, levels[i].colour);
  }
  Plot plot;
  plot.width = 400;
  plot.height = 300;
  plot.script = fmt::format(
      "set xlabel 'e/c [-]' offset 0,0.4\nset ylabel 'direction of u [°]'\nset xrange [0:1]\nset yrange [-187.5:7.5]\n"
      "set xtics 0.25\nset ytics 45\nset tics out nomirror\nset border lw 0.5\nunset key\nunset colorbox\nset bmargin "
      "3.2\nset rmargin 3\nset tmargin 0.8\n"
      "set cbrange [0:{}]\nset palette defined ({})\n$data << EOD\n{}EOD\nplot $data using 1:2:3 with image pixels\n",
      levels.size() - 1, colours, data);
  const std::string words = law_words(law);
  return {"model-error-" + std::string(law), words,
          fmt::format("Error of the law {} by eccentricity ratio and direction of motion: within 25 % at {} of {} "
                      "states.",
                      words, within, states),
          plot};
}

std::string loaded_table(const std::vector<LoadedState>& loaded) {
  Table table("Where the journal rests under the load of example 1: by each law, and by films of finite length",
              {{"law or film", {}, false}, {"ε", "–"}, {"attitude", "°"}});
  for (const LoadedState& state : loaded) {
    table.row({state.label(), fmt::format("{:.4f}", state.eccentricity_ratio),
               fmt::format("{:.2f}", degrees * state.attitude)});
  }
  return table.html();
}

std::string visited_table(const Content& content) {
  Table table("Error of each law where its own orbit of example 1 goes, against finite_reynolds",
              {{"law", {}, false}, {"median"}, {"largest"}, {"there, ε", "–"}, {"states"}});
  for (std::size_t i = 0; i < content.model_error.visited.size(); ++i) {
    const VisitedModelError& error = content.model_error.visited[i];
    table.row({content.journal.laws.at(i).law, percent(error.median), percent(error.largest),
               fmt::format("{:.3f}", error.eccentricity_ratio_of_largest), fmt::format("{}", error.states)});
  }
  return table.html();
}

/// Lines break after commas alone: numbers stay beside their units and signs.
std::string without_breaks(std::string text) {
  const std::string space = "\u00a0";
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    if (at > 0 && text[at - 1] != ',') text.replace(at, 1, space);
  }
  return text;
}

/// Both examples with films of finite length; nothing where they were not run.
std::string real_films_tables(const std::optional<RealFilms>& films) {
  if (!films) return {};
  Table journal("Example 1 with the film of the bearing’s real length", {{"film", {}, false},
                                                                         {"verdict", {}, false},
                                                                         {"rests at ε", "–"},
                                                                         {"attitude", "°"},
                                                                         {"largest ε", "–"},
                                                                         {"largest force", "N"}});
  for (const RealFilmJournal& item : films->journal) {
    journal.row({item.scene.joints.front().film, agreement(item.verdict),
                 fmt::format("{:.4f}", item.rest.eccentricity_ratio),
                 fmt::format("{:.2f}", degrees * item.rest.attitude),
                 fmt::format("{:.4f}", item.run.max_eccentricity_ratio), fmt::format("{:.3f}", item.run.max_force)});
  }
  Table crank(
      "Example 2 with it: extremes of both revolutions; share of the output times beyond the places where the "
      "table’s error was measured, and how far it is off the solver where the force is largest there",
      {{"film", {}, false},
       {"clearance, viscosity", {}, false},
       {"verdict", {}, false},
       {"largest ε", "–"},
       {"least film", "µm"},
       {"largest force", "N"},
       {"largest moment", "N·m"},
       {"least moment", "N·m"},
       {"beyond the table, off", {}, false}});
  for (const RealFilmCrank& item : films->crank) {
    const double clearance = item.scene.joints.front().clearance;
    const double farthest = item.run.joints.front().eccentricity.value;
    const DriverExtremes& moment = item.run.drivers.front();
    crank.row(
        {item.scene.joints.front().film, without_breaks(pair_of(item.scene.joints.front())), agreement(item.verdict),
         fmt::format("{:.4f}", farthest / clearance), fmt::format("{:.3f}", 1e6 * (clearance - farthest)),
         fmt::format("{:.2f}", item.run.joints.front().force.value), fmt::format("{:.3f}", moment.max_moment.value),
         fmt::format("{:.3f}", moment.min_moment.value), without_breaks(words_of(item.beyond))});
  }
  return journal.html() + checks_table("Example 1: what the letters stand for", films->journal_verdicts()) +
         crank.html() + checks_table("Example 2: what the letters stand for", films->crank_verdicts());
}

std::string summary_table(const std::vector<ModelErrorEntry>& map) {
  Table table("Each law against films of finite length: |F_law − F|/|F| over the states of the grid below",
              {{"film", {}, false},
               {"law", {}, false},
               {"median"},
               {"largest"},
               {"states within 5 %"},
               {"within 10 %"},
               {"within 25 %"},
               {"closing, within 25 %"},
               {"sliding, within 25 %"},
               {"opening, within 25 %"}});
  const std::vector<ModelErrorSummary> summaries = summaries_of(map);
  // The least wrong assumption first: a film that ruptures where its pressure says.
  for (const oracle::FiniteFilm film :
       {reference, oracle::FiniteFilm::finite_dynamic, oracle::FiniteFilm::finite_half}) {
    for (const ModelErrorSummary& s : summaries) {
      if (s.film != film) continue;
      table.row({std::string(name_of(s.film)), std::string(s.law), percent(s.median), percent(s.largest),
                 percent(s.share_within[0]), percent(s.share_within[1]), percent(s.share_within[2]),
                 percent(s.by_direction[2][0]), percent(s.by_direction[2][1]), percent(s.by_direction[2][2])});
    }
  }
  return table.html();
}

}  // namespace

BearingModelError bearing_model_error(const Example1& example) {
  if (example.laws.empty()) throw std::invalid_argument("the model error needs a run of example 1");
  const JournalScene parts = journal_scene(example.laws.front().scene);
  BearingModelError result;
  result.length_to_diameter = parts.bearing.length() / (2 * parts.bearing.radius());
  result.map = model_error_map(parts.bearing, ModelErrorGrid::standard());
  // The example's own laws.
  std::erase_if(result.map, [](const auto& entry) { return std::ranges::count(film_law_names, entry.law) == 0; });
  result.loaded =
      loaded_states(parts.bearing, parts.oil, parts.drive.load.norm(), std::abs(2 * parts.drive.mean_spin()));
  for (const Example1Law& item : example.laws) result.visited.push_back(visited_model_error(item.scene, item.run));
  return result;
}

Section model_error_section(const Content& content) {
  std::string key;
  for (const Level& level : levels) {
    key +=
        fmt::format("<li><span class=\"swatch\" style=\"background:{}\"></span>{}</li>\n", level.colour, level.words);
  }
  std::vector<Panel> panels;
  panels.reserve(film_law_names.size());
  for (const std::string_view law : film_law_names) panels.push_back(map_panel(content.model_error.map, law));
  return {"model-error", "Model error for this bearing",
          filled("model-error.html",
                 {{"ratio", fmt::format("{:.2f}", content.model_error.length_to_diameter)},
                  {"loaded", loaded_table(content.model_error.loaded)},
                  {"real", paper_conclusions(content) + real_films_tables(content.real_films)},
                  {"visited", visited_table(content)},
                  {"summary", summary_table(content.model_error.map)},
                  {"key", key},
                  {"maps", draw_panels(panels)},
                  {"csv", csv_block("csv-model-error", "model-error.csv", model_error_csv(content.model_error.map))}})};
}

}  // namespace lubjoint::reports::page
