#include <fmt/format.h>

#include <algorithm>

#include "oracle/files/files.hpp"
#include "oracle/paper/example_1.hpp"
#include "oracle/plot/orbit.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/trajectory_csv.hpp"

namespace lubjoint::reports {

namespace {

/// One panel a law; `script(item)` is what it plots.
template <class Script>
Figure figure_of(const Example1& example, const std::string& title, const std::string& axes, const Script& script) {
  Figure figure{title, axes, {}};
  for (const Example1Law& item : example.laws) {
    std::string name = item.law;
    std::replace(name.begin(), name.end(), '_', ' ');
    figure.panels.push_back({name, script(item)});
  }
  return figure;
}

const std::string line = "plot $data with lines lw 1.5 lc rgb '#0072b2' notitle";

}  // namespace

Figure journal_orbit_figure(const Example1& example) {
  return figure_of(example, std::string("Journal centre, e/c (+: equilibrium; ") + orbit_words + ")",
                   std::string(plain_axes) + orbit_axes, [](const Example1Law& item) {
                     std::vector<PlotPoint> places;
                     for (const JournalSample& s : item.run.samples) places.push_back({s.state[0], s.state[1]});
                     return orbit_script(places, PlotPoint{item.rest.eccentricity.x(), item.rest.eccentricity.y()});
                   });
}

Figure journal_force_figure(const Example1& example, ForceComponent component) {
  const bool horizontal = component == ForceComponent::horizontal;
  const double duration = example.laws.empty() ? 1 : example.laws.front().scene.run.duration;
  const std::string axes = std::string(plain_axes) +
                           fmt::format("set xlabel 't [ms]'\nset xtics {:g}\n", 1e3 * duration / 4) +
                           "set format y '%g'\nset ylabel '" + (horizontal ? "F_X [mN]" : "F_Y − W [mN]") + "'\n";
  const std::string title =
      horizontal ? std::string("Horizontal force on the journal, from 1 ms")
                 : fmt::format("Vertical force on the journal over the load of {:.4f} N, from 1 ms", example.load);
  return figure_of(example, title, axes, [&](const Example1Law& item) {
    std::string script = "$data << EOD\n";
    for (const JournalSample& s : item.run.samples) {
      // The start, from rest to the film's full force, takes some tens of microseconds: it would hide the rest.
      if (s.t < 1e-3) continue;
      script +=
          fmt::format("{:.7g} {:.7g}\n", 1e3 * s.t, 1e3 * (horizontal ? s.force.x() : s.force.y() - example.load));
    }
    return script + "EOD\n" + line + "\n";
  });
}

std::vector<std::string> write_example_1(const Example1& example, const std::filesystem::path& folder) {
  prepare_folder(folder);
  std::vector<std::string> files;
  for (const Example1Law& item : example.laws) {
    files.push_back(item.scene.name + ".csv");
    write_file(folder / files.back(), trajectory_csv(item.scene, item.run));
  }
  files.push_back("journal-summary.csv");
  write_file(folder / files.back(), example_1_csv(example));
  files.push_back("journal-checks.csv");
  write_file(folder / files.back(), example_1_checks_csv(example));
  const auto sheet = [&](const Figure& figure, int height, const char* name) {
    draw(on_one_sheet(figure, 2, 4, 1400, height), folder, name);
    for (const char* extension : {".svg", ".png"}) files.push_back(std::string(name) + extension);
  };
  sheet(journal_orbit_figure(example), 760, "journal-orbit");
  sheet(journal_force_figure(example, ForceComponent::horizontal), 620, "journal-fx");
  sheet(journal_force_figure(example, ForceComponent::vertical), 620, "journal-fy");
  return files;
}

}  // namespace lubjoint::reports
