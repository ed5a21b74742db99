#include <iostream>

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/reports/example_1.hpp"
#include "oracle/reports/example_2.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/model_error.hpp"

namespace lubjoint::cli {

void add_reproduce(CLI::App& app, Action& action) {
  struct Options {
    std::string out = "out/reproduce";
    std::string scenes = scenes_folder();
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("reproduce", "The paper's examples with every law, checked; table and plots");
  command->add_option("--out", options->out, "Folder for CSV files and plots")->capture_default_str();
  command->add_option("--scenes", options->scenes, "Folder of the scenes that ship with the project");
  command->callback([options, &action] {
    action = [options] {
      const Scene scene = load_scene(std::filesystem::path(options->scenes) / "journal.toml");
      journal_scene(scene);  // refuses what is no journal before a folder is made
      reports::prepare_folder(options->out);
      const reports::Example1 example = reports::run_example_1(scene);
      std::cout << reports::example_1_table(example);
      std::cout << '\n';
      for (const reports::Example1Law& item : example.laws) {
        const std::string warning =
            reports::model_warning(item.scene.joints[0], reports::visited_model_error(item.scene, item.run));
        if (!warning.empty()) std::cout << warning << '\n';
      }
      const reports::Example2 second = reports::run_example_2(options->scenes);
      std::cout << '\n' << reports::example_2_table(second);
      auto files = reports::write_example_1(example, options->out);
      for (const std::string& file : reports::write_example_2(second, options->out)) files.push_back(file);
      std::cerr << files.size() << " files written to " << options->out << ":";
      for (const std::string& file : files) std::cerr << ' ' << file;
      std::cerr << '\n';
      return example.passed() && second.passed() ? 0 : 1;
    };
  });
}

}  // namespace lubjoint::cli
