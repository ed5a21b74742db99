// The paper's examples with the film of the bearing's real length: the checks pass, and can fail.
#include "oracle/paper/real_film.hpp"

#include <catch2/catch.hpp>

#include "lubjoint/scene/scene_file.hpp"
#include "support/compiled_films.hpp"
#include "support/scene_text.hpp"

namespace real_film_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

const std::string crank_scene_file = LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml";

Scene short_scene(const std::string& file, std::string_view law, double duration) {
  Scene scene = with_compiled_film(load_scene(file), law);
  scene.run.duration = duration;
  scene.run.output_interval = duration / 50;
  scene.energy_ledger = file == crank_scene_file;
  return scene;
}

}  // namespace

TEST_CASE("real film: forces along a run are the solver's, and a force that is off is found") {
  for (const char* law : {"finite_full", "finite_half", "finite_dynamic", "finite_reynolds"}) {
    INFO(law);
    const Scene scene = short_scene(journal_scene_file, law, 0.05);
    JournalTrajectory run = simulate_journal(scene);
    const Check good = solved_force_check(scene, run);
    INFO(good.words());
    CHECK(good.outcome == CheckOutcome::passed);
    for (JournalSample& sample : run.samples) sample.force *= 1.001;
    CHECK(solved_force_check(scene, run).outcome == CheckOutcome::failed);
  }
  const Scene crank = short_scene(crank_scene_file, "finite_dynamic", 0.002);
  MultibodyTrajectory run = simulate_multibody(crank);
  CHECK(solved_force_check(crank, run).outcome == CheckOutcome::passed);
  for (MultibodySample& sample : run.samples) sample.joints[0].force *= 1.001;
  CHECK(solved_force_check(crank, run).outcome == CheckOutcome::failed);
  for (MultibodySample& sample : run.samples) sample.joints[0].force *= NAN;
  CHECK(solved_force_check(crank, run).outcome == CheckOutcome::failed);
  run.samples.clear();
  CHECK_FALSE(beyond_table(crank, run).has_value());
  CHECK(solved_force_check(crank, run).outcome == CheckOutcome::not_checked);
}

TEST_CASE("real film: where a run leaves its table, the table is held against the solver there, too") {
  Scene crank = short_scene(crank_scene_file, "finite_dynamic", 0.002);
  MultibodyTrajectory run = simulate_multibody(crank);
  CHECK_FALSE(beyond_table(crank, run).has_value());
  CHECK(words_of(beyond_table(crank, run)) == "no");
  auto table = std::make_shared<CompiledFilm>(*crank.joints[0].table);
  table->ratio_limit = run.samples[run.samples.size() / 2].joints[0].eccentricity_ratio;
  crank.joints[0].table = table;
  const std::optional<BeyondTable> beyond = beyond_table(crank, run);
  REQUIRE(beyond.has_value());
  CHECK(beyond->share > 0);
  CHECK(beyond->share < 1);
  CHECK(beyond->eccentricity_ratio > table->ratio_limit);
  CHECK(beyond->difference <= table->error + beyond->bound);
  for (MultibodySample& sample : run.samples) sample.joints[0].force *= 1.02;
  const std::optional<BeyondTable> off = beyond_table(crank, run);
  REQUIRE(off.has_value());
  CHECK(off->difference == Approx(0.02).epsilon(1e-3));  // of it, the table's own 1e-5
  CHECK_THAT(words_of(off), Contains(" %, to 2 %"));
  CHECK(words_of(BeyondTable{0.25, 0.999, 0.01, 0.03}) == "25 %, < 4 %");
  CHECK(words_of(BeyondTable{0.25, 0.999, 1e-9, 1e-7}) == "25 %, < 0.001 %");
}

TEST_CASE("real film: the table names each film with its numbers and its verdict") {
  RealFilms films;
  films.journal.resize(1);
  films.journal[0].scene = short_scene(journal_scene_file, "finite_dynamic", 0.05);
  films.journal[0].run = simulate_journal(films.journal[0].scene);
  films.journal[0].rest = journal_equilibrium(films.journal[0].scene);
  films.journal[0].verdict.checks.push_back(solved_force_check(films.journal[0].scene, films.journal[0].run));
  films.crank.resize(1);
  films.crank[0].scene = short_scene(crank_scene_file, "finite_dynamic", 0.002);
  films.crank[0].run = simulate_multibody(films.crank[0].scene);
  films.crank[0].verdict.checks.push_back(solved_force_check(films.crank[0].scene, films.crank[0].run));
  CHECK(films.passed());
  const std::string table = real_films_table(films);
  CHECK_THAT(table, Contains("finite_dynamic     0.3000           77.10"));  // as the solver has it (model-error)
  CHECK_THAT(table, Contains("yes A"));
  films.crank[0].verdict.checks.push_back(Check::at_most("a", "b", 2, 1, "", ""));
  CHECK_FALSE(films.passed());
  CHECK_THAT(real_films_table(films), Contains("NO"));
}

}  // namespace real_film_test
