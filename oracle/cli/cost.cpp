#include <iostream>
#include <nlohmann/json.hpp>

#include "oracle/cli/programs.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/laws/scene_run.hpp"
#include "oracle/measure/chain_cost.hpp"
#include "oracle/measure/scene_cost.hpp"

namespace lubjoint::cli {

void add_cost(CLI::App& app, Action& action) {
  struct CostOptions : SceneOptions {
    bool chain = false;
    bool json = false;
    std::size_t rounds = 51;
  };
  auto options = std::make_shared<CostOptions>();
  CLI::App* command = app.add_subcommand("cost", words_of("cost"));
  CLI::Option* file = command->add_option("scene", options->file, "Scene file (TOML)");
  options->add_law(*command);
  command->add_flag("--chain", options->chain, "In place of a scene: chains of 1 to 1000 pendulums");
  command->add_option("--rounds", options->rounds, "Rounds of which medians are taken")->capture_default_str();
  command->add_flag("--json", options->json, "One JSON object");
  command->callback([options, file, &action] {
    action = [options, file] {
      if (options->chain == (file->count() > 0)) {
        throw std::invalid_argument("a scene is required, or --chain in its place; allowed is one of them");
      }
      if (options->chain && options->law) throw std::invalid_argument("--law is given; allowed with --chain is no law");
      require_option("--rounds", static_cast<double>(options->rounds),
                     options->rounds >= 9 && options->rounds <= 100000, "a whole number from 9 to 100000");
      const auto show = [&](const nlohmann::ordered_json& json, const std::string& text) {
        std::cout << (options->json ? json.dump(2) + "\n" : text);
        return 0;
      };
      if (options->chain) {
        const auto rows = reports::chain_cost(options->rounds);
        return show(reports::chain_json(rows), reports::chain_text(rows));
      }
      const reports::SceneToRun scene = reports::scene_to_run(SceneFile(options->file), *options, scene_films());
      const reports::SceneCost cost =
          std::visit([&](const auto& each) { return reports::scene_cost(each, options->rounds); }, scene);
      return show(reports::cost_json(cost), reports::cost_text(cost));
    };
  });
}

}  // namespace lubjoint::cli
