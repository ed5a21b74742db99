#include <iostream>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/reports/bench/scene_bench.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/quadrature_bench.hpp"

namespace lubjoint::cli {

void add_bench(CLI::App& app, Action& action) {
  struct Options {
    std::optional<std::string> out;
    std::vector<std::string> scenes;
    bool quick = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("bench", "Error against run time: quadrature rules, finite-length films");
  command->add_option("--out", options->out, "Folder for bench-quadrature.csv");
  command->add_option("--scene", options->scenes, "Scene files");
  command->add_flag("--quick", options->quick, "Fewer cases and repeats");
  command->callback([options, &action] {
    action = [options] {
      if (options->out) reports::prepare_folder(*options->out);
      if (!options->scenes.empty()) {
        std::vector<Scene> scenes;
        for (const std::string& file : options->scenes) scenes.push_back(load_scene(file));
        auto settings = reports::scene_bench_settings(options->quick);
        if (options->out) settings.resume_file = std::filesystem::path(*options->out) / "bench-scenes.part";
        const auto bench = reports::bench_scenes(scenes, settings);
        std::cout << reports::scene_bench_table(bench);
        if (options->out) {
          reports::write_file(std::filesystem::path(*options->out) / "bench-scenes.csv", reports::scene_bench_csv(bench));
          reports::draw_scene_bench(bench, *options->out);
        }
        return 0;
      }
      auto rows = reports::time_quadrature(options->quick);
      const auto finite = reports::time_finite_length(options->quick);
      rows.insert(rows.end(), finite.begin(), finite.end());
      std::cout << reports::quadrature_table(rows);
      if (options->out) {
        const auto file = std::filesystem::path(*options->out) / "bench-quadrature.csv";
        reports::write_file(file, reports::quadrature_csv(rows));
        std::cerr << "written: " << file.string() << '\n';
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli
