#include <fmt/format.h>

#include <optional>

#include "oracle/measure/bench/equal_error.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

std::string milliseconds(const std::optional<Contender>& contender) {
  return contender ? fmt::format("{:.3g} ms", 1e3 * contender->seconds) : "–";
}

/// "ida, 6.1 ms": the fastest of a camp.
std::string fastest_of(const RaceVerdict& verdict, Camp camp) {
  const auto contender = verdict.fastest(camp);
  return contender ? contender->integrator + ", " + milliseconds(contender) : "–";
}

std::string joined(const std::vector<Contender>& contenders) {
  std::string names;
  for (const Contender& each : contenders) names += (names.empty() ? "" : " = ") + each.integrator;
  return names.empty() ? "–" : names;
}

/// For each race and error the times, and what they mean, in the order of the data.
std::string fastest_tables(const std::vector<BenchRow>& rows) {
  const Column scene{"scene", {}, false};
  const Column coordinates{"coordinates", {}, false};
  Table times("Times at equal error, by the rows below: between tolerances on a log-log line",
              {scene,
               coordinates,
               {"error", "c"},
               {"radau_iia5", {}, false},
               {"fastest of lubjoint's own", {}, false},
               {"of CVODE and IDA", {}, false},
               {"Simbody", {}, false}});
  Table advice("The fastest at equal error, and what to use",
               {scene, coordinates, {"error", "c"}, {"fastest (= tie)", {}, false}, {"use", {}, false}});
  for (const Race& race : races(rows)) {
    for (const double error : judged_errors) {
      const RaceVerdict verdict = judge_race(rows, race, error);
      const std::string at = with_powers(fmt::format("{:.0e}", error));
      times.row({race.scene, race.formulation, at, milliseconds(verdict.of("radau_iia5")),
                 fastest_of(verdict, Camp::own), fastest_of(verdict, Camp::sundials),
                 milliseconds(verdict.fastest(Camp::simbody))});
      advice.row({race.scene, race.formulation, at, joined(verdict.winners()), recommendation(verdict)});
    }
  }
  return times.html() + advice.html();
}

/// Runs that gave up, and runs that are far off without saying so.
std::string failed_table(const std::vector<BenchRow>& rows) {
  Table table("Runs that stopped, and runs that are wrong by more than 10⁻² c", {{"scene", {}, false},
                                                                                 {"coordinates", {}, false},
                                                                                 {"integrator", {}, false},
                                                                                 {"tolerance"},
                                                                                 {"error", "c"},
                                                                                 {"what happened", {}, false}});
  std::size_t count = 0;
  for (const BenchRow& row : rows) {
    const bool stopped = !row.run.finished;
    if (!stopped && row.run.error <= 1e-2) continue;
    table.row({row.scene, row.formulation, row.integrator, scientific(row.tolerance, 0),
               stopped ? "–" : scientific(row.run.error),
               stopped ? "stopped: " + (row.run.message.empty() ? "no reason given" : row.run.message)
                       : std::string("finished, without noticing")});
    ++count;
  }
  if (count == 0) return "<p>Every run finished, within 10⁻² c of the reference.</p>\n";
  return fmt::format(
      "<details>\n<summary>{} runs stopped or are off by more than 10<sup>−2</sup> c</summary>\n{}</details>\n", count,
      table.html());
}

std::string measured_words(const std::string& by) {
  return by.empty() ? std::string() : "<p>Measured by " + escaped(by) + ".</p>\n";
}

}  // namespace

Section run_time_section(const Content& content) {
  std::string inner =
      "<p>Not measured in this run. <code>./lubjoint bench scenes --out FOLDER</code> writes "
      "<code>bench-scenes.csv</code>, "
      "and "
      "<code>./lubjoint reproduce --data FOLDER</code> puts it here.</p>\n";
  if (content.run_times) {
    inner =
        filled("run-time-plot.html", {{"fastest", fastest_tables(content.run_times->rows)},
                                      {"failed", failed_table(content.run_times->rows)},
                                      {"measured", measured_words(content.run_times->measured_by)},
                                      {"csv", csv_block("csv-run-time", "bench-scenes.csv", content.run_times->csv)}});
  }
  return {"run-time", "Error against run time", filled("run-time.html", {{"content", inner}})};
}

}  // namespace lubjoint::reports::page
