// Every number of a scene that is said to be off changes what a run of it does.
#include "oracle/verify/trajectory/scene_mistakes.hpp"

#include <catch2/catch.hpp>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"

namespace scene_mistakes_test {

using namespace lubjoint;

namespace {

/// Rates of a scene's states at a time, at its start with some speed in every coordinate.
std::vector<double> rates(const Scene& scene, double t) {
  const PlanarSystem<double> system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, false);
  std::vector<double> y = scene_start<double>(scene);
  std::vector<double> dydt(y.size());
  ode.rate(y, dydt, t);
  return dydt;
}

}  // namespace

TEST_CASE("scene mistakes: a load that is off is off whatever it is: constant, an unbalance, or a table") {
  for (const std::string name :
       {"journal.toml", "machines/rotor.toml", "machines/engine.toml", "machines/big-end.toml"}) {
    INFO(name);
    const Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name);
    std::size_t loads = 0;
    for (const verify::SceneNumber& number : verify::numbers_of(scene)) {
      if (!number.words.starts_with("the load on ")) continue;
      ++loads;
      Scene changed = scene;
      number.scale(changed, 2);
      CHECK(rates(changed, 1e-3) != rates(scene, 1e-3));
      number.scale(changed, 0.5);
      CHECK(rates(changed, 1e-3) == rates(scene, 1e-3));  // halves of twice: no rounding
    }
    CHECK(loads == scene.loads.size());
  }
}

}  // namespace scene_mistakes_test
