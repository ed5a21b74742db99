#include <iostream>
#include <nlohmann/json.hpp>

#include "oracle/cli/programs.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/results/journal_report.hpp"

namespace lubjoint::cli {

void add_equilibrium(CLI::App& app, Action& action) {
  struct EquilibriumOptions : SceneOptions {
    bool json = false;
  };
  auto options = std::make_shared<EquilibriumOptions>();
  CLI::App* command = app.add_subcommand("equilibrium", words_of("equilibrium"));
  options->add_file(*command);
  options->add_law(*command);
  command->add_flag("--json", options->json, "One JSON object");
  command->callback([options, &action] {
    action = [options] {
      const Scene scene = options->load();
      const JournalEquilibrium rest = journal_equilibrium(scene);
      const SceneJoint& joint = scene.joints.front();
      const std::string warning = reports::stability_warning(joint.film, joint.table.get());
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
      const std::string beyond = reports::beyond_table_warning(joint, joint.clearance * rest.eccentricity_ratio);
      if (!beyond.empty()) std::cerr << beyond << '\n';
      if (options->json) {
        std::cout << reports::equilibrium_json(scene, rest).dump(2) << '\n';
      } else {
        std::cout << reports::equilibrium_text(scene, rest);
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli
