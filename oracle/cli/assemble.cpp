#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/scene_assembly.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/results/assembly_report.hpp"

namespace lubjoint::cli {

namespace {

/// NAME=VALUE. @throws std::invalid_argument
std::pair<std::string, double> parse_angle(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  double angle = 0;
  const char* end = text.data() + text.size();
  const char* begin = equals == std::string::npos ? end : text.data() + equals + 1;
  const auto [last, error] = std::from_chars(begin, end, angle);
  if (equals == 0 || begin == end || error != std::errc() || last != end || !std::isfinite(angle)) {
    throw std::invalid_argument("--angle is \"" + text +
                                "\"; allowed is NAME=VALUE, the name of a driver or a body and an angle [rad]");
  }
  return {text.substr(0, equals), angle};
}

}  // namespace

void add_assemble(CLI::App& app, Action& action) {
  struct Options {
    std::string file;
    std::vector<std::string> angles, open;
    std::size_t branch = 1;
    bool list = false;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("assemble", words_of("assemble"));
  command->add_option("scene", options->file, "Scene file (TOML)")->required();
  command->add_option("--angle", options->angles,
                      "NAME=VALUE: angle of a driver, or of a body that is held for the assembly [rad]");
  command->add_option("--open", options->open, "Joints whose journals stay where they are; all others are centred");
  CLI::Option* branch =
      command->add_option("--branch", options->branch, "Which of the branches: 1 is that of the guesses");
  CLI::Option* list =
      command->add_flag("--list", options->list, "The branches alone, without a scene")->excludes(branch);
  command->add_flag("--json", options->json, "The same as one JSON object")->excludes(branch)->excludes(list);
  command->callback([options, &action] {
    action = [options] {
      AssemblyRequest request;
      for (const std::string& each : options->angles) request.angles.push_back(parse_angle(each));
      request.open_joints = options->open;
      const SceneFile file(options->file);
      const Scene scene = file.rough_scene();  // its places are guesses
      const SceneAssembly assembly = assemble_scene(scene, request);
      if (options->branch < 1 || options->branch > assembly.branches.size()) {
        throw std::invalid_argument("--branch is " + std::to_string(options->branch) +
                                    "; allowed is a number from 1 to " + std::to_string(assembly.branches.size()));
      }
      if (options->json) {
        std::cout << reports::assembly_json(scene, assembly).dump(2) << '\n';
      } else if (options->list) {
        std::cout << reports::assembly_text(scene, assembly);
      } else {
        std::cout << assembled_text(file, scene, request, assembly.branches[options->branch - 1]);
        std::cerr << reports::assembly_text(scene, assembly);
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli
