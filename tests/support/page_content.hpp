/// What the report tells of, from real runs that are made short: with loose tolerances, few states and a coarse map.
#pragma once

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/page/page.hpp"
#include "oracle/paper/journal_checks.hpp"
#include "oracle/paper/slider_crank_checks.hpp"
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
    item.found = law.ends_with("full") ? reports::Behaviour::circles : reports::Behaviour::rests;
    const std::complex<double> leading = item.rest.eigenvalues[0];
    item.near_rest = reports::MotionRate{leading.real(), leading.imag(), leading.real(), leading.real(), 4};
    // A run against itself: the page shows verdicts, it does not make them.
    item.verdict.checks = reports::compare_runs(item.scene, item.run, item.run, "itself");
    item.verdict.checks.push_back(reports::sampled_force_check(item.scene, item.run));
    item.verdict.checks.push_back(reports::equilibrium_check(item.scene, item.rest));
    for (const auto& check : reports::rate_checks(item.near_rest, leading)) item.verdict.checks.push_back(check);
    item.verdict.checks.push_back(reports::behaviour_check(item.found, leading, 3));
    item.verdict.checks.push_back(reports::paper_check(item.found, item.paper));
    example.load = item.rest.force.norm();
    example.laws.push_back(std::move(item));
  }
  return example;
}

/// What a run would be held against if it were right.
inline reports::ReferenceRun reference_of(const reports::Example2Case& item) {
  reports::ReferenceRun reference;
  const double c = item.scene.joints[0].clearance;
  for (const MultibodySample& sample : item.run.samples) {
    reference.samples.push_back({sample.joints[0].eccentricity / c, sample.joints[0].force, sample.driving_moments[0]});
  }
  const Peak& eccentricity = item.run.joints[0].eccentricity;
  reference.peaks = {{eccentricity.value / c, eccentricity.t},
                     item.run.joints[0].force,
                     item.run.drivers[0].max_moment,
                     item.run.drivers[0].min_moment};
  return reference;
}

inline reports::Example2 quick_example_2() {
  const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";
  reports::Example2 example;
  example.ideal = simulate_multibody(load_scene(scenes + "slider-crank-ideal.toml"));
  example.ideal_force = 2718.71;
  example.ideal_moment = 138.52;
  const auto ideal = [](const char* what) {
    return reports::Check::at_most(what, "closed form", 1e-10, 1e-9, "of its peak", "a test's reason");
  };
  example.ideal_verdict.checks = {ideal("gudgeon pin's force"), ideal("driving moment")};
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.4", "slider-crank-c0.1-mu0.4",
                           "slider-crank-c0.5-mu0.04", "slider-crank-c0.2-mu0.04"}) {
    reports::Example2Case item;
    item.scene = load_scene(scenes + name + ".toml");
    item.scene.run.relative_tolerance = item.scene.run.absolute_tolerance = 1e-6;
    item.scene.run.output_interval = 1e-4;
    item.run = simulate_multibody(item.scene);
    item.orbit.multipliers = {0.1, 0.01, 0, 0};
    item.verdict.checks = reports::compare_with_minimal_coordinates(item.scene, item.run, reference_of(item));
    item.verdict.checks.push_back(reports::energy_check(item.run, 1e-6));
    example.cases.push_back(std::move(item));
  }
  return example;
}

inline reports::page::SpaceExample quick_space_example() {
  SpatialScene scene =
      load_spatial_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/spatial-slider-crank.toml");
  scene.run.duration = 0.3;
  return reports::page::run_space_example(scene);
}

inline const reports::page::Content& quick_page_content() {
  static const reports::page::Content content = [] {
    reports::page::Content made;
    made.journal = quick_example_1();
    made.slider_crank = quick_example_2();
    made.space = quick_space_example();
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
