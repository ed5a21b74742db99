/// What the report tells of, from real runs that are made short: with loose tolerances, few states and a coarse map.
#pragma once

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/reports/page/page.hpp"
#include "support/temporary_folder.hpp"

namespace lubjoint::test {

inline reports::Example1 quick_example_1() {
  reports::Example1 example;
  for (const std::string_view law : film_law_names) {
    reports::Example1Law item;
    item.law = law;
    item.scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/journal.toml");
    item.scene.joints.front().film = law;
    item.scene.run.output_interval = 5e-3;
    item.paper = law.ends_with("full") ? "circles" : "rests";
    item.run = simulate_journal(item.scene);
    item.rest = journal_equilibrium(item.scene);
    item.rests = item.rest.stability() == Stability::decays;
    example.load = item.rest.force.norm();
    example.laws.push_back(std::move(item));
  }
  return example;
}

inline reports::Example2 quick_example_2() {
  const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";
  reports::Example2 example;
  example.ideal = simulate_multibody(load_scene(scenes + "slider-crank-ideal.toml"));
  example.ideal_force = 2718.71;
  example.ideal_moment = 138.52;
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.4", "slider-crank-c0.1-mu0.4",
                           "slider-crank-c0.5-mu0.04", "slider-crank-c0.2-mu0.04"}) {
    reports::Example2Case item;
    item.scene = load_scene(scenes + name + ".toml");
    item.scene.run.relative_tolerance = item.scene.run.absolute_tolerance = 1e-6;
    item.scene.run.output_interval = 1e-4;
    item.run = simulate_multibody(item.scene);
    item.orbit.multipliers = {0.1, 0.01, 0, 0};
    example.cases.push_back(std::move(item));
  }
  return example;
}

inline const reports::page::Content& quick_page_content() {
  static const reports::page::Content content = [] {
    reports::page::Content made;
    made.journal = quick_example_1();
    made.slider_crank = quick_example_2();
    made.laws = reports::check_laws({20, 1, 1});
    const JournalScene parts = journal_scene(made.journal.laws.front().scene);
    made.model_error.length_to_diameter = parts.bearing.length() / (2 * parts.bearing.radius());
    made.model_error.map = reports::model_error_map(parts.bearing, {{0.3, 0.7}, 3, 1e-2});
    made.model_error.loaded = {
        {"short_half", 0.1174, 1.42}, {"pinkus_sternlicht", 0.1673, 1.46}, {"finite_reynolds", 0.2413, 1.38}};
    made.model_error.visited.assign(made.journal.laws.size(), {0.4, 0.5, 7, 0.1});
    made.provenance = {"0.0", {{"compiler", "some"}}, {{"processor", "some"}}};
    return made;
  }();
  return content;
}

/// Run times and stability that nobody measured, for tests alone.
inline std::string invented_data(const std::string& file) {
  return read_text(std::string(LUBJOINT_SOURCE_DIR) + "/tests/page/invented-data/" + file);
}

}  // namespace lubjoint::test
