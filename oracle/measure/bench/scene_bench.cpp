#include "oracle/measure/bench/scene_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lubjoint/ode/integrators.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/measure/bench/equal_error.hpp"
#include "oracle/measure/bench/pace.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/measure/bench/spatial_cases.hpp"
#include "oracle/measure/bench/sundials_method.hpp"
#include "oracle/plot/gnuplot.hpp"

namespace lubjoint::reports {

namespace {

std::string campaign_key(const SceneBenchSettings& settings, const std::vector<std::string>& files) {
  std::string key = fmt::format("repeats {} seconds {} tolerances", settings.limits.repeats, settings.limits.seconds);
  for (const double tolerance : settings.tolerances) key += " " + number(tolerance);
  for (const std::string& name : settings.integrators) key += " " + name;
  for (const std::string& file : files) key += " " + file + " " + sha256(read_input(file));
  return key;
}

/// Rows of an interrupted campaign.
class Ledger {
 public:
  Ledger(const SceneBenchSettings& settings, const std::vector<std::string>& files)
      : kept_(settings.resume_file, campaign_key(settings, files), bench_header) {
    if (kept_.earlier()) rows_ = read_bench_rows(*kept_.earlier());
  }

  const BenchRow* find(const BenchRow& wanted) const {
    for (const BenchRow& row : rows_) {
      if (row.scene == wanted.scene && row.formulation == wanted.formulation && row.integrator == wanted.integrator &&
          row.tolerance == wanted.tolerance) {
        return &row;
      }
    }
    return nullptr;
  }

  void add(const BenchRow& row) { kept_.add(bench_line(row)); }

 private:
  KeptRows kept_;
  std::vector<BenchRow> rows_;
};

bool is_wanted(const std::string& method, const std::vector<std::string>& integrators) {
  return integrators.empty() || std::ranges::find(integrators, method) != integrators.end();
}

constexpr int hopeless = 2;  ///< tolerances in a row without an end

/// A row of one integrator after the other, and how often in a row each ran out of time.
class Campaign {
 public:
  Campaign(BenchCase& scene_case, const BenchLimits& limits) : case_(scene_case), limits_(limits) {}

  MethodRun run(const std::string& method, double tolerance) {
    if (failures_[method] >= hopeless) {
      MethodRun left_out;
      left_out.message = "not run: out of time at looser tolerances";
      return left_out;
    }
    return case_.run(method, tolerance, limits_);
  }

  void note(const BenchRow& row) {
    if (row.run.finished) failures_[row.integrator] = 0;
    if (row.run.message == out_of_time) ++failures_[row.integrator];
  }

 private:
  BenchCase& case_;
  BenchLimits limits_;
  std::map<std::string, int> failures_;
};

/// All runs of one case, each as a row.
void race_case(const std::string& scene, BenchCase& scene_case, const SceneBenchSettings& settings, Ledger& ledger,
               std::vector<BenchRow>& rows) {
  Campaign campaign(scene_case, settings.limits);
  for (const double tolerance : settings.tolerances) {
    for (const std::string& method : scene_case.methods()) {
      if (!is_wanted(method, settings.integrators)) continue;
      BenchRow row{scene, scene_case.formulation(), method, tolerance, {}};
      if (const BenchRow* known = ledger.find(row)) {
        row = *known;
      } else {
        row.run = campaign.run(method, tolerance);
        ledger.add(row);
      }
      campaign.note(row);
      rows.push_back(row);
    }
  }
}

}  // namespace

std::vector<std::string> raced_methods() {
  std::vector<std::string> names(method_names().begin(), method_names().end());
  for (const std::string_view name : sundials_methods()) names.emplace_back(name);
  for (const std::string_view name : simbody_methods()) names.emplace_back(name);
  return names;
}

SceneBenchSettings scene_bench_settings(bool quick) {
  SceneBenchSettings settings;
  if (quick) {
    settings.tolerances = {1e-4, 1e-7, 1e-10};
    settings.limits = {3, 0.12};
  } else {
    for (int decade = 2; decade <= 13; ++decade) settings.tolerances.push_back(std::pow(10.0, -decade));
    settings.limits = {9, 1};
  }
  return settings;
}

SceneBench bench_scenes(const std::vector<Scene>& scenes, const SceneBenchSettings& settings,
                        const std::vector<SpatialScene>& in_space) {
  Pace pace;
  SceneBenchSettings paced = settings;
  paced.limits.pace = [&pace] { return pace.now(); };
  std::vector<std::string> files;
  for (const Scene& scene : scenes) files.push_back(scene.file);
  for (const SpatialScene& scene : in_space) files.push_back(scene.file);
  SceneBench bench;
  Ledger ledger(settings, files);
  ProgressBar progress("bench", files.size());
  const auto race = [&](const BenchScene& made) {
    bench.references.push_back({made.name, made.golden, made.reference_agreement});
    for (const auto& each : made.cases) race_case(made.name, *each, paced, ledger, bench.rows);
    progress.advance();
  };
  for (const Scene& scene : scenes) race(bench_scene(scene));
  for (const SpatialScene& scene : in_space) race(bench_scene(scene));
  return bench;
}

std::string scene_bench_csv(const std::vector<BenchRow>& rows) {
  std::string csv = bench_header;
  for (const BenchRow& row : rows) csv += bench_line(row);
  return csv;
}

void draw_scene_bench(const std::vector<BenchRow>& rows, const std::filesystem::path& folder) {
  for (const Race& race : races(rows)) {
    Plot plot;
    plot.script =
        "set logscale xy\nset format '10^{%L}'\nset xlabel 'run time [s]'\nset key outside right\n"
        "set ylabel 'largest error of the position, as bench says'\nset grid\n";
    plot.script += fmt::format("set title '{}: {} coordinates' noenhanced\n", race.scene, race.formulation);
    std::string lines;
    int style = 0;
    for (const std::string& method : integrators_of(rows, race)) {
      std::string data;
      for (const BenchRow* row : finished_runs(rows, race, method)) {
        if (row->run.error > 0) data += fmt::format("{} {}\n", number(row->run.seconds), number(row->run.error));
      }
      ++style;
      if (data.empty()) continue;
      plot.script += fmt::format("$m{} << EOD\n{}EOD\n", style, data);
      lines += fmt::format("{}$m{} with linespoints lw 2 lt {} pt {} ps 1.2 title '{}' noenhanced",
                           lines.empty() ? "" : ", ", style, style, style, method);
    }
    if (lines.empty()) continue;
    plot.script += "plot " + lines + "\n";
    draw(plot, folder, fmt::format("bench-{}-{}", race.scene, race.formulation));
  }
}

}  // namespace lubjoint::reports
