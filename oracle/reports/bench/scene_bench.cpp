#include "oracle/reports/bench/scene_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lubjoint/dynamics/integrators.hpp"
#include "oracle/reports/bench/sundials_method.hpp"
#include "oracle/reports/csv_table.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/gnuplot.hpp"
#include "oracle/reports/golden_files.hpp"
#include "oracle/reports/kept_rows.hpp"
#include "oracle/reports/progress.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* csv_header =
    "scene,formulation,integrator,tolerance,error,seconds,steps,rejected,rhs_evaluations,jacobian_evaluations,"
    "factorisations,status,message\n";

std::string csv_line(const BenchRow& row) {
  const MethodRun& run = row.run;
  std::string message = run.message;
  std::replace(message.begin(), message.end(), ',', ';');
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.scene, row.formulation, row.integrator,
                     number(row.tolerance), run.finished ? number(run.error) : "",
                     run.finished ? number(run.seconds) : "", run.steps, run.rejected, run.rhs_evaluations,
                     run.jacobian_evaluations, run.factorisations, run.finished ? "finished" : "stopped", message);
}

std::string campaign_key(const SceneBenchSettings& settings, const std::vector<Scene>& scenes) {
  std::string key = fmt::format("repeats {} seconds {} tolerances", settings.limits.repeats, settings.limits.seconds);
  for (const double tolerance : settings.tolerances) key += " " + number(tolerance);
  for (const std::string& name : settings.integrators) key += " " + name;
  for (const Scene& scene : scenes) key += " " + scene.file + " " + sha256(read_input(scene.file));
  return key;
}

/// Rows of an interrupted campaign.
class Ledger {
 public:
  Ledger(const SceneBenchSettings& settings, const std::vector<Scene>& scenes)
      : kept_(settings.resume_file, campaign_key(settings, scenes), csv_header) {
    if (!kept_.earlier()) return;
    const CsvTable& table = *kept_.earlier();
    const auto count = [&](std::size_t row, const char* column) {
      return static_cast<std::size_t>(table.number(row, table.column(column)));
    };
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const auto text = [&](const char* column) { return std::string(table.field(i, table.column(column))); };
      BenchRow row{
          text("scene"), text("formulation"), text("integrator"), table.number(i, table.column("tolerance")), {}};
      row.run.finished = text("status") == "finished";
      row.run.message = text("message");
      if (row.run.finished) {
        row.run.error = table.number(i, table.column("error"));
        row.run.seconds = table.number(i, table.column("seconds"));
      }
      row.run.steps = count(i, "steps");
      row.run.rejected = count(i, "rejected");
      row.run.rhs_evaluations = count(i, "rhs_evaluations");
      row.run.jacobian_evaluations = count(i, "jacobian_evaluations");
      row.run.factorisations = count(i, "factorisations");
      rows_.push_back(row);
    }
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

  void add(const BenchRow& row) { kept_.add(csv_line(row)); }

 private:
  KeptRows kept_;
  std::vector<BenchRow> rows_;
};

std::vector<const BenchRow*> rows_of(const SceneBench& bench, const std::string& scene, const std::string& formulation,
                                     const std::string& integrator) {
  std::vector<const BenchRow*> rows;
  for (const BenchRow& row : bench.rows) {
    if (row.scene == scene && row.formulation == formulation && row.integrator == integrator && row.run.finished) {
      rows.push_back(&row);
    }
  }
  std::sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->tolerance > b->tolerance; });
  return rows;
}

template <class Get>
std::vector<std::string> names(const SceneBench& bench, const Get& get) {
  std::vector<std::string> found;
  for (const BenchRow& row : bench.rows) {
    const std::string name = get(row);
    if (!name.empty() && std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  }
  return found;
}

bool is_wanted(const std::string& method, const std::vector<std::string>& integrators) {
  return integrators.empty() || std::ranges::find(integrators, method) != integrators.end();
}

constexpr double targets[] = {1e-3, 1e-6, 1e-9};

std::string milliseconds(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.3g}", 1e3 * *seconds) : "-";
}

}  // namespace

std::vector<std::string> raced_methods() {
  std::vector<std::string> names(method_names.begin(), method_names.end());
  for (const std::string_view name : sundials_methods()) names.emplace_back(name);
  return names;
}

SceneBenchSettings scene_bench_settings(bool quick) {
  SceneBenchSettings settings;
  if (quick) {
    settings.tolerances = {1e-4, 1e-7, 1e-10};
    settings.limits = {3, 0.12};
  } else {
    for (int decade = 2; decade <= 13; ++decade) settings.tolerances.push_back(std::pow(10.0, -decade));
    settings.limits = {9, 10};
  }
  return settings;
}

SceneBench bench_scenes(const std::vector<Scene>& scenes, const SceneBenchSettings& settings) {
  SceneBench bench;
  bench.with_sundials = !sundials_methods().empty();
  Ledger ledger(settings, scenes);
  ProgressBar progress("bench", scenes.size());
  for (const Scene& scene : scenes) {
    const BenchScene made = bench_scene(scene);
    bench.references.push_back({made.name, made.reference_agreement});
    for (const auto& each : made.cases) {
      for (const double tolerance : settings.tolerances) {
        for (const std::string& method : each->methods()) {
          if (!is_wanted(method, settings.integrators)) continue;
          BenchRow row{made.name, each->formulation(), method, tolerance, {}};
          if (const BenchRow* known = ledger.find(row)) {
            row = *known;
          } else {
            row.run = each->run(method, tolerance, settings.limits);
            ledger.add(row);
          }
          bench.rows.push_back(row);
        }
      }
    }
    progress.advance();
  }
  return bench;
}

std::optional<double> seconds_at_error(const SceneBench& bench, const std::string& scene,
                                       const std::string& formulation, const std::string& integrator, double error) {
  std::optional<double> least;
  const auto consider = [&](double seconds) { least = least ? std::min(*least, seconds) : seconds; };
  const BenchRow* before = nullptr;
  for (const BenchRow* row : rows_of(bench, scene, formulation, integrator)) {
    if (row->run.error <= error) {
      consider(row->run.seconds);
      if (before && before->run.error > error && row->run.error > 0) {
        const double share = std::log(before->run.error / error) / std::log(before->run.error / row->run.error);
        consider(before->run.seconds * std::pow(row->run.seconds / before->run.seconds, share));
      }
    }
    before = row;
  }
  return least;
}

std::optional<double> error_floor(const SceneBench& bench, const std::string& scene, const std::string& formulation,
                                  const std::string& integrator) {
  std::optional<double> least;
  for (const BenchRow* row : rows_of(bench, scene, formulation, integrator)) {
    least = least ? std::min(*least, row->run.error) : row->run.error;
  }
  return least;
}

std::string scene_bench_csv(const SceneBench& bench) {
  std::string csv = csv_header;
  for (const BenchRow& row : bench.rows) csv += csv_line(row);
  return csv;
}

std::string scene_bench_table(const SceneBench& bench) {
  std::string text =
      "Milliseconds to reach an error of the journal's position (in clearances), between tolerances on a "
      "log-log line; integration alone\n";
  for (const std::string& scene : names(bench, [](const BenchRow& r) { return r.scene; })) {
    for (const BenchReference& reference : bench.references) {
      if (reference.scene == scene) {
        text += fmt::format("\n{}: references by two integrators of extended precision lie {:.1e} apart\n", scene,
                            reference.agreement);
      }
    }
    const auto formulations =
        names(bench, [&](const BenchRow& r) { return r.scene == scene ? r.formulation : std::string(); });
    for (const std::string& formulation : formulations) {
      text += fmt::format("  {:<26}{:>10}{:>10}{:>10}{:>12}{:>9}{:>9}\n", formulation + " coordinates", "1e-3", "1e-6",
                          "1e-9", "least error", "BDF/1e-5", "BDF/1e-9");
      const auto methods = names(bench, [&](const BenchRow& r) {
        return r.scene == scene && r.formulation == formulation ? r.integrator : std::string();
      });
      std::map<double, std::pair<double, std::string>> fastest;
      for (const std::string& method : methods) {
        const auto at = [&](double error) { return seconds_at_error(bench, scene, formulation, method, error); };
        const auto against = [&](double error) -> std::string {
          const auto bdf = seconds_at_error(bench, scene, formulation, "cvode_bdf", error);
          const auto own = at(error);
          return bdf && own ? fmt::format("{:.2f}", *bdf / *own) : "-";
        };
        const auto floor = error_floor(bench, scene, formulation, method);
        text += fmt::format("    {:<24}{:>10}{:>10}{:>10}{:>12}{:>9}{:>9}\n", method, milliseconds(at(1e-3)),
                            milliseconds(at(1e-6)), milliseconds(at(1e-9)), floor ? fmt::format("{:.1e}", *floor) : "-",
                            against(1e-5), against(1e-9));
        for (const double target : targets) {
          const auto seconds = at(target);
          if (seconds && !is_sundials_method(method) && (!fastest.count(target) || *seconds < fastest[target].first)) {
            fastest[target] = {*seconds, method};
          }
        }
      }
      text += "    use:";
      for (const double target : targets) {
        text += fmt::format(" {:.0e} {};", target, fastest.count(target) ? fastest[target].second : "none reaches it");
      }
      text.back() = '\n';
    }
  }
  if (!bench.with_sundials) {
    text += "\nSUNDIALS was not built in: no comparison with CVODE and IDA (cmake -DLUBJOINT_SUNDIALS=ON)\n";
  }
  return text;
}

void draw_scene_bench(const SceneBench& bench, const std::filesystem::path& folder) {
  for (const std::string& scene : names(bench, [](const BenchRow& r) { return r.scene; })) {
    const auto formulations =
        names(bench, [&](const BenchRow& r) { return r.scene == scene ? r.formulation : std::string(); });
    for (const std::string& formulation : formulations) {
      Plot plot;
      plot.script =
          "set logscale xy\nset format '10^{%L}'\nset xlabel 'run time [s]'\nset key outside right\n"
          "set ylabel 'largest error of the journal''s position [clearances]'\nset grid\n";
      plot.script += fmt::format("set title '{}: {} coordinates' noenhanced\n", scene, formulation);
      std::string lines;
      int style = 0;
      for (const std::string& method : names(bench, [](const BenchRow& r) { return r.integrator; })) {
        std::string data;
        for (const BenchRow* row : rows_of(bench, scene, formulation, method)) {
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
      draw(plot, folder, fmt::format("bench-{}-{}", scene, formulation));
    }
  }
}

}  // namespace lubjoint::reports
