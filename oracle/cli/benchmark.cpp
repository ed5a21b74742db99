#include "oracle/results/benchmark.hpp"

#include <iostream>
#include <nlohmann/json.hpp>

#include "oracle/cli/command.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/programs.hpp"

namespace lubjoint::cli {

void add_benchmark(CLI::App& app, Action& action) {
  struct BenchmarkOptions {
    std::vector<std::string> names;
    std::optional<double> rtol;
    bool json = false;
    bool work_precision = false;
  };
  auto options = std::make_shared<BenchmarkOptions>();
  CLI::App* command = app.add_subcommand("benchmark", words_of("benchmark"));
  command->add_option("names", options->names, "Problems; none: all of them");
  CLI::Option* rtol =
      command->add_option("--rtol", options->rtol, "Relative and absolute tolerance in place of the scenes'");
  command
      ->add_flag("--work-precision", options->work_precision,
                 "Error against run time instead: every integrator at tolerances from 1e-4 to 1e-12")
      ->excludes(rtol);
  command->add_flag("--json", options->json, "One JSON array");
  command->callback([options, &action] {
    action = [options] {
      const auto literature = reports::data_folder() / "literature" / "benchmarks.csv";
      const auto scenes = reports::data_folder() / "scenes" / "benchmarks";
      const std::vector<std::string> known = reports::benchmark_names(literature);
      for (const std::string& name : options->names) require_name("the problem", name, known);
      if (options->rtol) {
        require_option("--rtol", *options->rtol, *options->rtol >= 1e-14 && *options->rtol < 1,
                       "a number from 1e-14 to below 1");
      }
      const std::vector<std::string>& names = options->names.empty() ? known : options->names;
      if (options->work_precision) {
        std::vector<reports::WorkPrecision> points;
        for (const std::string& name : names) {
          for (reports::WorkPrecision& point : reports::work_precision(name, literature, scenes))
            points.push_back(std::move(point));
        }
        std::cout << (options->json ? reports::work_precision_json(points).dump(2) + "\n"
                                    : reports::work_precision_text(points));
        return 0;
      }
      std::vector<reports::BenchmarkRun> runs;
      bool agree = true;
      for (const std::string& name : names) {
        runs.push_back(reports::run_benchmark(name, literature, scenes, options->rtol));
        agree = agree && runs.back().agrees();
      }
      std::cout << (options->json ? reports::benchmark_json(runs).dump(2) + "\n" : reports::benchmark_text(runs));
      return agree ? 0 : 1;
    };
  });
}

}  // namespace lubjoint::cli
