// data/scenes.md names every key of a scene that the reader asks for, and no other.
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <set>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "support/temporary_folder.hpp"

namespace scene_reference_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Keys = std::set<std::string>;

namespace {

const std::string root = LUBJOINT_SOURCE_DIR "/";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// First columns of the tables under a heading that begins with a text; without what stands before the last dot.
Keys documented(const std::string& heading) {
  Keys keys;
  bool inside = false;
  for (const std::string& line : lines_of(read_text(root + "data/scenes.md"))) {
    if (line.starts_with("## ")) inside = line.starts_with("## " + heading);
    std::smatch match;
    if (!inside || !std::regex_search(line, match, std::regex(R"(^\| `([\w.]+)` \|)"))) continue;
    const std::string key = match[1];
    keys.insert(key.substr(key.rfind('.') + 1));
  }
  return keys;
}

/// Keys that some functions of the reader ask a table for. A call names its key as a text.
Keys asked_for(const std::string& file, const std::vector<std::string>& functions) {
  const std::string source = read_text(root + file);
  Keys keys;
  for (const std::string& function : functions) {
    INFO(function);
    const std::size_t begin = source.find(" " + function + "(TableReader");
    REQUIRE(begin != std::string::npos);
    const std::size_t body = source.find("{\n", begin);
    const std::string text = source.substr(body, source.find("\n}\n", body) - body);
    const std::regex call(
        R"(\b(?:number|number_or|text|text_or|name|vector|vector_or|vector3|vector3_or|numbers|flag_or|table|tables|is_table|has|poisson)\("(\w+)\")");
    for (auto it = std::sregex_iterator(text.begin(), text.end(), call); it != std::sregex_iterator(); ++it) {
      keys.insert((*it)[1]);
    }
    const std::regex body_name(R"((?:read_body_name|read_point|read_angle)\(\w+, "(\w+)\")");
    for (auto it = std::sregex_iterator(text.begin(), text.end(), body_name); it != std::sregex_iterator(); ++it) {
      keys.insert((*it)[1]);
    }
  }
  return keys;
}

Keys both(Keys a, const Keys& b) {
  a.insert(b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("scene reference: its tables have the keys that the reader asks for, and no other") {
  const std::string file = "lib/src/scene_file.cpp";
  const std::string parts = "lib/src/scene_parts.cpp";
  CHECK(documented("The file itself") ==
        both(asked_for(file, {"read_scene", "read_duration"}), asked_for(parts, {"read_coordinates"})));
  CHECK(documented("`[[bodies]]`") == asked_for(file, {"read_body"}));
  const std::string forces = "lib/src/scene_forces.cpp";
  const std::string tables = "lib/src/scene_tables.cpp";
  const std::string terms = "lib/src/scene_forces.hpp";
  CHECK(documented("`[[loads]]`") ==
        both(asked_for(forces, {"read_load", "read_harmonic", "read_oscillation", "read_unbalance"}),
             both(asked_for(tables, {"read_load_curves"}), {"table"})));
  CHECK(documented("`[[springs]]`") ==
        both(asked_for(forces, {"read_spring", "read_rotational", "read_translational_spring"}),
             asked_for(terms, {"read_rotational_terms", "read_translational_terms"})));
  CHECK(documented("`[[sensors]]`") == asked_for(forces, {"read_sensor"}));
  CHECK(documented("`[[joints]]`") == both(asked_for(file, {"read_joint", "read_joint_film", "read_shear"}),
                                           asked_for(parts, {"read_contact", "read_contact_table", "read_anchor"})));
  // A driver's constant term is called by what it is of.
  CHECK(documented("`[[constraints]]`") ==
        both(asked_for(parts, {"read_constraint", "read_ground", "read_translational", "read_sides"}),
             both(asked_for("lib/src/scene_drivers.cpp",
                            {"read_driver", "read_slide_driver", "read_motion", "read_swing"}),
                  asked_for(forces, {"read_oscillation"}))));
  CHECK(documented("`[stabilisation]`") == asked_for(parts, {"read_stabilisation"}));
  CHECK(documented("`[integrator]`") == asked_for(file, {"read_integrator"}));
  CHECK(documented("`[output]`") == asked_for(file, {"read_output"}));
}

TEST_CASE("scene reference: its tables of scenes in space have the keys that their reader asks for, and no other") {
  const std::string file = "lib/src/spatial_scene_file.cpp";
  const std::string parts = "lib/src/spatial_constraints.cpp";
  CHECK(documented("In space: the file") ==
        both(both(asked_for(file, {"read_spatial_scene"}), asked_for("lib/src/scene_file.cpp", {"read_duration"})),
             asked_for("lib/src/scene_parts.cpp", {"read_coordinates"})));
  CHECK(documented("In space: `[[bodies]]`") ==
        both(asked_for(file, {"read_spatial_body", "read_inertia"}), asked_for(parts, {"read_orientation"})));
  CHECK(documented("In space: `[[loads]]`") ==
        both(both(asked_for(file, {"read_spatial_load", "read_spatial_unbalance"}),
                  asked_for(parts, {"read_body_point"})),
             both(asked_for("lib/src/scene_forces.cpp", {"read_harmonic", "read_oscillation"}),
                  both(asked_for("lib/src/scene_tables.cpp", {"read_load_curves"}), {"table"}))));
  CHECK(documented("In space: `[[springs]]`") ==
        both(asked_for(file, {"read_spatial_spring", "read_about", "read_between_points"}),
             asked_for("lib/src/scene_forces.hpp", {"read_rotational_terms", "read_translational_terms"})));
  CHECK(documented("In space: `[[sensors]]`") ==
        both(asked_for(file, {"read_spatial_sensor"}), asked_for(parts, {"read_body_point"})));
  CHECK(documented("In space: `[[joints]]`") ==
        both(asked_for(file, {"read_spatial_joint"}), asked_for(parts, {"read_side", "read_body_point"})));
  CHECK(documented("In space: `[[constraints]]`") ==
        both(both(asked_for(parts, {"read_spatial_constraint", "read_sides", "read_ground_joint", "read_distance",
                                    "read_spatial_driver"}),
                  {"angle", "displacement"}),  // what read_motion calls its constant term
             both(asked_for("lib/src/scene_drivers.cpp", {"read_motion", "read_swing"}),
                  asked_for("lib/src/scene_forces.cpp", {"read_oscillation"}))));
}

TEST_CASE("scene reference: laws, integrators and defaults are those of the reader") {
  const std::string text = read_text(root + "data/scenes.md");
  for (const std::string_view law : named_film_laws) {
    CHECK(text.find("`" + std::string(law) + "`") != std::string::npos);
  }
  for (const std::string_view name : integrator_names()) {
    CHECK(text.find("`" + std::string(name) + "`") != std::string::npos);
  }
  const TemporaryFolder folder;
  const Scene scene = load_scene(
      folder.write("least.toml",
                   "name = \"least\"\nduration = 2.0\njoints = []\n[[bodies]]\nname = \"b\"\nmass = 1\ninertia = 1\n"));
  CHECK(scene.gravity == Vector2<double>(0, 0));
  CHECK(scene.bodies[0].position == Vector2<double>(0, 0));
  CHECK(scene.bodies[0].angle == 0);
  CHECK(scene.bodies[0].spin == 0);
  CHECK(scene.integrator == "radau_iia5");
  CHECK(scene.run.relative_tolerance == 1e-8);
  CHECK(scene.run.absolute_tolerance == 1e-8);
  CHECK(scene.run.max_steps == 20'000'000);
  CHECK(scene.run.output_interval == 2.0 / 1000);
  CHECK_FALSE(scene.energy_ledger);
  CHECK_FALSE(scene.stabilisation.projection);
  CHECK_FALSE(scene.stabilisation.passes_singular);
  CHECK(scene.stabilisation.alpha == 5);
  CHECK(scene.stabilisation.beta == 5);
  // The rebound at restitution 0.5: the root of the exact relation of a free impact with v0 = 1, d = 3 (1 - 1/4)/4.
  const double d = 3 * (1 - 0.25) / 4;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double v = (low + high) / 2;
    (-d * v - std::log1p(-d * v) < d - std::log1p(d) ? low : high) = v;
  }
  CHECK(text.find("gives " + std::to_string(low).substr(0, 5) + " for 0.5") != std::string::npos);
  CHECK(SceneContact().friction == 0);
  CHECK(SceneContact().slow_sliding == 1e-3);
}

}  // namespace scene_reference_test
