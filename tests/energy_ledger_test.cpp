#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace energy_ledger_test {

using namespace lubjoint;

TEST_CASE("energy ledger: it changes no step of a run, whatever the integrator") {
  for (const char* file : {"slider-crank.toml", "slider-crank-torque.toml"}) {
    for (const std::string_view integrator : method_names()) {
      INFO(file << " " << integrator);
      Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR "/data/scenes/") + file);
      scene.run.duration = 0.002;
      scene.run.output_interval = 2e-4;
      scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-6;
      scene.integrator = integrator;
      scene.energy_ledger = false;
      const MultibodyTrajectory without = simulate_multibody(scene);
      scene.energy_ledger = true;
      const MultibodyTrajectory with = simulate_multibody(scene);
      REQUIRE(without.outcome.status == RunStatus::finished);
      CHECK(with.outcome.steps == without.outcome.steps);
      CHECK(with.outcome.rejected_steps == without.outcome.rejected_steps);
      CHECK(with.outcome.rhs_evaluations == without.outcome.rhs_evaluations);
      double apart = 0;
      REQUIRE(with.samples.size() == without.samples.size());
      for (std::size_t i = 0; i < with.samples.size(); ++i) {
        for (std::size_t k = 0; k < without.samples[i].state.size(); ++k) {
          const double one = with.samples[i].state[k];
          const double other = without.samples[i].state[k];
          apart = std::max(apart, std::abs(one - other) / std::max(1.0, std::abs(other)));
        }
      }
      CHECK(apart < 1e-12);  // an implicit method's factors are of another size: rounding, as the film magnifies it
      CHECK(*with.energy_residual < 1e-3 * with.energy_scale);  // a thousand tolerances: no step is made for it
    }
  }
}

}  // namespace energy_ledger_test
