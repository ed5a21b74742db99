// Films of finite length in scenes: their tables, both engines, the jump of the half film, equilibria, sweeps.
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "lubjoint/joint/chosen_film.hpp"
#include "lubjoint/multibody/massless_journal.hpp"
#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/laws/film_store.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/laws/scene_films.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "support/compiled_films.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"
#include "support/scenes.hpp"

namespace finite_film_scene_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Vec = Vector2<double>;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 3> continuous_films = {"finite_full", "finite_dynamic", "finite_reynolds"};

Scene journal_with(std::string_view law) { return with_compiled_film(load_scene(journal_scene_file), law); }

Scene short_run(Scene scene, double duration) {
  scene.run.duration = duration;
  scene.run.output_interval = duration / 10;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
  return scene;
}

/// Largest distance in clearances of two runs of one journal, by the engine of free journals and that of mechanisms.
double apart(const JournalTrajectory& alone, const MultibodyTrajectory& general, double clearance) {
  REQUIRE(alone.outcome.status == RunStatus::finished);
  REQUIRE(general.outcome.status == RunStatus::finished);
  REQUIRE(alone.samples.size() == general.samples.size());
  double worst = 0;
  for (std::size_t i = 0; i < alone.samples.size(); ++i) {
    const Vec here(alone.samples[i].state[0], alone.samples[i].state[1]);
    worst = std::max(worst, (here - general.samples[i].joints[0].eccentricity / clearance).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("finite films in joints: a chosen film is its law to the bit, with its exact derivatives") {
  const Bearing<double> bearing(0.02, 0.02, 1e-4);  // L/D = 1/2
  const Lubricant<double> oil(0.25);
  using D = Dual<double, 6>;
  for (const char* name : continuous_films) {
    INFO(name);
    const auto table = shipped_film(name, "0.5");
    const ChosenFilm<double> film(name, bearing, oil, table.get());
    with_compiled_law(*table, [&](const auto& law) {
      for (int i = 0; i < 60; ++i) {
        const double epsilon = 0.95 * std::sqrt((i + 0.5) / 60);
        const FilmState<double> state(epsilon * Vec(std::cos(2.4 * i), std::sin(2.4 * i)),
                                      Vec(7 * std::cos(0.7 * i), 7 * std::sin(0.7 * i)));
        CHECK(film.force(state) == film_force(law, bearing, oil, state));
        const Vector2<D> e(D::variable(state.eccentricity.x(), 0), D::variable(state.eccentricity.y(), 3));
        const Vector2<D> u(D::variable(state.velocity.x(), 1) + 0.5 * e.y() - 0.5 * state.eccentricity.y(),
                           D::variable(state.velocity.y(), 5));
        const FilmState<D> seeded(e, u);
        const Vector2<D> chosen = film.force(seeded);
        const Vector2<D> own = film_force(law, bearing, oil, seeded);
        for (int k = 0; k < 2; ++k) {
          // Rounding of q, times the slope's terms: at most 1/q of each other.
          CHECK((chosen(k).derivatives() - own(k).derivatives()).norm() <=
                1e-12 * std::hypot(own(0).derivatives().norm(), own(1).derivatives().norm()));
        }
      }
    });
  }
}

TEST_CASE("finite films in joints: a law without its table, and one of another bearing, are refused by name") {
  const Bearing<double> bearing(0.02, 0.02, 1e-4);
  const Lubricant<double> oil(0.25);
  CHECK_THROWS_WITH(ChosenFilm<double>("finite_full", bearing, oil),
                    Contains("finite_full") && Contains("none was given") && Contains("compile-film"));
  CHECK_THROWS_WITH(ChosenFilm<double>("finite_full", bearing, oil, shipped_film("finite_dynamic", "0.5").get()),
                    Contains("is one of \"finite_dynamic\""));
  CHECK_THROWS_WITH(ChosenFilm<double>("finite_full", bearing, oil, shipped_film("finite_full", "1").get()),
                    Contains("compiled for length over diameter 1, the bearing has 0.5"));
  CHECK_THROWS_WITH(ChosenFilm<double>("finite_half", bearing, oil, shipped_film("finite_half", "0.5").get()),
                    Contains("finite_half jumps"));
  Scene scene = journal_with("finite_half");
  scene.joints[0].table = nullptr;
  CHECK_THROWS_WITH(simulate_journal(scene), Contains("finite_half") && Contains("none was given"));
  scene.joints[0].film = "finite_reynolds";
  CHECK_THROWS_WITH(simulate_journal(scene), Contains("finite_reynolds") && Contains("none was given"));
  CHECK_THROWS_WITH(journal_equilibrium(scene), Contains("finite_reynolds") && Contains("none was given"));
  std::string text = SceneText(read_text(journal_scene_file)).with("joints[0].film", "\"finite_reynolds\"");
  CHECK_NOTHROW(parse_scene(text, "scene.toml"));
  text = SceneText(text).with("joints[0].length", "0.2");
  CHECK_THROWS_WITH(parse_scene(text, "long.toml"),
                    Contains("joints[0].film") && Contains("L/D = 10.2") && Contains("from 0.05 to 10"));
  text = SceneText(text).with("joints[0].film", "\"finite_reynold\"");
  CHECK_THROWS_WITH(parse_scene(text, "typo.toml"), Contains("did you mean finite_reynolds?"));
}

TEST_CASE("finite films in scenes: both engines alike, and the ledger closes") {
  for (const char* law : continuous_films) {
    INFO(law);
    Scene scene = short_run(journal_with(law), 0.02);
    scene.bodies[0].position = {5e-5, 2e-5};
    REQUIRE(is_free_journal(scene));
    const JournalTrajectory alone = simulate_journal(scene);
    scene.energy_ledger = true;  // the engine of mechanisms
    const MultibodyTrajectory general = simulate_multibody(scene);
    CHECK(apart(alone, general, scene.joints[0].clearance) < 1e-8);  // each keeps 1e-10 a step, over some hundred
    const auto& last = alone.samples.back().state;
    CHECK((Vec(last[0], last[1]) - Vec(0.25, 0.1)).norm() > 0.02);
    REQUIRE(general.energy_residual);
    CHECK(*general.energy_residual < 1e-7 * general.energy_scale);  // the tolerance times steps
  }
}

TEST_CASE(
    "finite half film: it jumps at a = 0 by twice the wedge's radial force, and pushes to a = 0 where it closes") {
  const FiniteHalf law(*shipped_film("finite_half", "1"));
  for (const double epsilon : {1e-3, 0.1, 0.5, 0.9, 0.98}) {
    const auto solved = [&](double a, double b) {  // of a solver that the table was not made with
      const PolarFilmState<double> state(epsilon, a, b);
      return oracle::finite_force(oracle::FiniteFilm::finite_half, 1, state.in_own_frame(), {1e-9});
    };
    const double tiny = 1e-9;  // of b: the wedge's own share
    const double jump = solved(tiny, 1).ratio.y() - solved(-tiny, 1).ratio.y();
    CHECK(jump == Approx(-4 * solved(1, 0).ratio.x()).epsilon(1e-6));  // the table's and the solver's error
    CHECK(jump > 0);                                                   // to a = 0: a grows against F_t
    const auto compiled = [&](HalfFilmSide side) {
      return law.force_ratio(PolarFilmState<double>(epsilon, 0, 1), side).tangential;
    };
    CHECK(compiled(HalfFilmSide::converging) - compiled(HalfFilmSide::mirrored) == Approx(jump).epsilon(1e-6));
  }
  const PolarFilmState<double> centred(0, 0, 1);
  CHECK(law.force_ratio(centred, HalfFilmSide::converging).tangential == 0);
  CHECK(law.force_ratio(centred, HalfFilmSide::mirrored).tangential == 0);
}

TEST_CASE(
    "finite half film: journals slide on its jump, by both engines alike, and at rest it is where its force is W") {
  Scene scene = short_run(journal_with("finite_half"), 0.02);
  const JournalTrajectory alone = simulate_journal(scene);
  scene.energy_ledger = true;
  const MultibodyTrajectory general = simulate_multibody(scene);
  CHECK(apart(alone, general, scene.joints[0].clearance) < 1e-7);  // 1e-10 a step, and both ends of the slide
  REQUIRE(alone.sliding.size() == general.slides.size());
  REQUIRE_FALSE(alone.sliding.empty());
  double slid = 0;
  for (std::size_t i = 0; i < alone.sliding.size(); ++i) {
    CHECK(alone.sliding[i].start == Approx(general.slides[i].start).margin(1e-7));
    CHECK(alone.sliding[i].end == Approx(general.slides[i].end).margin(1e-7));
    slid += alone.sliding[i].end - alone.sliding[i].start;
  }
  CHECK(slid > 1e-3);  // not a touch
}

TEST_CASE("finite films: equilibria are the solver's, and coefficients the differences of its forces") {
  for (const char* law : {"finite_half", "finite_dynamic", "finite_reynolds"}) {
    INFO(law);
    const Scene scene = journal_with(law);
    const SceneJoint& joint = scene.joints[0];
    const JournalEquilibrium rest = journal_equilibrium(scene);
    const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
    const Lubricant<double> oil(joint.viscosity);
    const oracle::FiniteFilm film = oracle::finite_film_of(law);
    const double spin = scene.bodies[0].spin;
    const reports::LoadedState solved =
        reports::finite_equilibrium(film, oracle::FilmOnset::free, bearing, oil, rest.force.norm(), spin);
    CHECK(rest.eccentricity_ratio == Approx(solved.eccentricity_ratio).epsilon(2e-4));  // force 1e-4, root 1e-5
    CHECK(rest.attitude == Approx(solved.attitude).margin(2e-4));
    CHECK(rest.force.norm() == Approx(30 + 0.13 * 9.81).epsilon(1e-12));
    // K and C against differences of the solver's forces, about the compiled law's place.
    const double scale = force_scale(BearingLimit::long_bearing, bearing, oil);
    const double tolerance = film == oracle::FiniteFilm::finite_reynolds ? 2e-5 : 1e-9;
    const auto force = [&](const Vec& e, const Vec& v) {
      const Vec u(v.x() + spin / 2 * e.y(), v.y() - spin / 2 * e.x());
      return Vec(scale * oracle::finite_force(film, length_to_diameter(bearing), {e, u}, {tolerance}).ratio);
    };
    // The half film's coefficients are those of its side: steps must not cross a = 0, and at a > 0 they do not.
    const double step = 0.01;
    for (int i = 0; i < 2; ++i) {
      const Vec d = step * Vec::Unit(i);
      const Vec at(rest.eccentricity);
      const Vec k = -(force(at + d, Vec(0, 0)) - force(at - d, Vec(0, 0))) / (2 * step * bearing.clearance());
      const Vec c = -(force(at, spin * d) - force(at, -spin * d)) / (2 * step * spin * bearing.clearance());
      // Step squared times third derivatives, and the forces' errors over the step.
      const double allowed = 3e-3 + 2 * tolerance / step;
      CHECK((k - rest.stiffness.col(i)).norm() < allowed * rest.stiffness.norm());
      CHECK((c - rest.damping.col(i)).norm() < allowed * rest.damping.norm());
    }
  }
}

TEST_CASE("finite films: the velocity of a journal without mass is the one at which its film carries the load") {
  const Bearing<double> bearing(0.02, 0.02, 1e-4);
  const Lubricant<double> oil(0.25);
  for (const char* name : continuous_films) {
    INFO(name);
    const ChosenFilm<double> film(name, bearing, oil, shipped_film(name, "0.5").get());
    REQUIRE(film.has_velocity());
    for (int i = 0; i < 200; ++i) {
      const double epsilon = 0.98 * std::sqrt(i / 200.0);
      const Vec e = epsilon * Vec(std::cos(2.4 * i), std::sin(2.4 * i));
      const Vec load = 30 * Vec(std::cos(0.7 * i), std::sin(0.7 * i));
      const Vec u = film.velocity(e, load);
      CHECK((film.force(FilmState<double>(e, u)) - load).norm() < 1e-10 * load.norm());  // rounding times 6/q
    }
  }
  Scene scene = journal_with("finite_reynolds");
  scene.bodies[0].mass = 0;
  scene.run.duration = 2;
  const JournalTrajectory run = simulate_journal(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  Scene heavy = journal_with("finite_reynolds");
  heavy.loads[0].force = {0, -30};
  heavy.gravity = {0, 0};
  const JournalEquilibrium rest = journal_equilibrium(heavy);  // where it comes to rest, mass or none
  const auto& last = run.samples.back().state;
  CHECK((Vec(last[0], last[1]) - rest.eccentricity).norm() < 1e-3);  // what the whirl has left after two seconds
  scene = journal_with("finite_half");
  scene.bodies[0].mass = 0;
  CHECK_THROWS_WITH(simulate_journal(scene), Contains("finite_half") && Contains("finite_reynolds"));
}

TEST_CASE("finite films: each table is asked for once, and a changed length asks for another") {
  std::vector<std::pair<std::string, double>> asked;
  reports::SceneFilms films([&](const std::string& law, double shape) {
    asked.emplace_back(law, shape);
    CompiledFilm table = *shipped_film(law, "1");
    table.shape = shape;
    return table;
  });
  Scene scene = load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml");
  films.provide(scene);
  CHECK(asked.empty());
  CHECK(scene.joints[0].table == nullptr);
  scene.joints[0].film = "finite_full";
  films.provide(scene);
  Scene same = scene;
  films.provide(same);
  CHECK(asked.size() == 1);
  CHECK(same.joints[0].table == scene.joints[0].table);
  same.joints[0].length *= 1.5;
  films.provide(same);
  REQUIRE(asked.size() == 2);
  CHECK(asked[1].second == same.joints[0].length / (2 * same.joints[0].journal_radius));
  CHECK(same.joints[0].table->shape == asked[1].second);
  same.joints[0].film = "short_full";
  films.provide(same);
  CHECK(same.joints[0].table == nullptr);
  same.joints[0].film = "finite_full";
  same.joints[0].length = 1;
  CHECK_THROWS_WITH(films.provide(same), Contains("finite_full") && Contains("from 0.05 to 10"));
}

TEST_CASE("finite films: states beyond the table are warned of, once, and others not") {
  const Scene scene = journal_with("finite_reynolds");
  const SceneJoint& joint = scene.joints[0];
  const double limit = joint.table->ratio_limit;
  CHECK(reports::beyond_table_warning(joint, limit * joint.clearance).empty());
  CHECK_THAT(reports::beyond_table_warning(joint, (limit + 0.01) * joint.clearance),
             Contains("reached eccentricity ratio 0.96") && Contains("measured up to 0.95"));
  SceneJoint widened = joint;  // the film's own clearance is c + e1
  widened.transition = SceneTransition{1e-5, 2e-5};
  CHECK(reports::beyond_table_warning(widened, (limit + 0.01) * joint.clearance).empty());
  CHECK(reports::beyond_table_warning(load_scene(journal_scene_file).joints[0], joint.clearance).empty());

  const TemporaryFolder folder;
  const std::string file = (folder.path() / "heavy.toml").string();
  std::string text = SceneText(read_text(journal_scene_file)).with("joints[0].film", "\"finite_dynamic\"");
  text = SceneText(text).with("loads[0].force", "[0.0, -50000.0]");
  std::ofstream(file) << text;
  const ProgramResult heavy = lubjoint_program({"simulate", file, "--duration", "0.02"});
  REQUIRE(heavy.status == 0);
  const std::string warning = "reached eccentricity ratio";
  const std::size_t first = heavy.err.find(warning);
  CHECK(first != std::string::npos);
  CHECK(heavy.err.find(warning, first + 1) == std::string::npos);
  const ProgramResult light = lubjoint_program({"simulate", journal_scene_file, "--law", "finite_dynamic"});
  CHECK(light.status == 0);
  CHECK(light.err.find(warning) == std::string::npos);
}

TEST_CASE("finite films: a sweep over the length has a table for each point, made once, whatever the threads") {
  const TemporaryFolder cache;
  const ProgramSetting setting{.environment = {{"XDG_CACHE_HOME", cache.path().string()}}};
  const auto sweep = [&](const char* jobs) {
    return lubjoint_program({"sweep", journal_scene_file, "--law", "finite_full", "--vary",
                             "joints[0].length=0.0147,0.02,0.0245", "--duration", "0.02", "--jobs", jobs},
                            setting);
  };
  const ProgramResult serial = sweep("1");
  INFO(serial.err);
  REQUIRE(serial.status == 0);
  const fs::path films = cache.path() / "lubjoint" / "films";
  std::map<fs::path, fs::file_time_type> made;
  for (const auto& entry : fs::directory_iterator(films)) made[entry.path()] = entry.last_write_time();
  CHECK(made.size() == 3);
  CHECK(sweep("2").out == serial.out);
  for (const auto& [path, time] : made) CHECK(fs::last_write_time(path) == time);
  // A row is the single run's, and differs from its neighbour's.
  const std::string file = (cache.path() / "single.toml").string();
  std::string text = SceneText(read_text(journal_scene_file)).with("joints[0].film", "\"finite_full\"");
  std::ofstream(file) << SceneText(text).with("joints[0].length", "0.02");
  const ProgramResult single = lubjoint_program({"simulate", file, "--duration", "0.02", "--json"}, setting);
  REQUIRE(single.status == 0);
  const auto json = nlohmann::json::parse(single.out);
  const reports::CsvTable rows(serial.out, "sweep");
  const std::size_t column = rows.column("bearing.max_eccentricity_ratio");
  CHECK(rows.number(1, column) == json.at("joints").at(0).at("max_eccentricity_ratio").get<double>());
  CHECK(rows.number(0, column) > rows.number(1, column));
  CHECK(rows.number(1, column) > rows.number(2, column));
}

TEST_CASE("finite films: a sweep warns of states beyond the table once a joint, also when it continues") {
  const TemporaryFolder folder;
  const std::string warning = "reached eccentricity ratio";
  const auto sweep = [&](const std::string& loads, const Words& more) {
    Words words{"sweep", journal_scene_file, "--vary", "loads[0].force[1]=" + loads, "--duration", "0.02"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = lubjoint_program(words);
    INFO(result.err);
    REQUIRE(result.status == 0);
    return result.err;
  };
  const std::string heavy = "-60000,-30,-50000";
  const std::string said = sweep(heavy, {"--law", "finite_dynamic"});
  const std::size_t first = said.find(warning);
  REQUIRE(first != std::string::npos);
  CHECK(said.find(warning, first + 1) == std::string::npos);
  CHECK_THAT(said, Contains("joint \"bearing\"") && Contains("At point 0") && Contains("and less far at 1 more."));
  CHECK(sweep("-30,-40", {"--law", "finite_dynamic"}).find(warning) == std::string::npos);
  CHECK(sweep(heavy, {"--law", "short_dynamic"}).find(warning) == std::string::npos);
  // A film that is swept: of one point alone it is a table.
  CHECK_THAT(sweep("-50000", {"--vary", "joints[0].film=short_dynamic,finite_dynamic"}),
             Contains(warning) && Contains("At point 1"));
  // Each shard warns of its own points, and what has been merged is not gone through again.
  const Words out{"--law", "finite_dynamic", "--out", folder.path().string()};
  const auto shard = [&](const char* which) {
    Words words = out;
    words.insert(words.end(), {"--shard", which});
    return sweep(heavy, words);
  };
  CHECK(shard("2/3").find(warning) == std::string::npos);
  CHECK_THAT(shard("3/3"), Contains(warning) && Contains("At point 2"));
  CHECK_THAT(shard("1/3"), Contains(warning) && Contains("At point 0") && !Contains("less far"));
  CHECK(sweep(heavy, out).find(warning) == std::string::npos);
}

TEST_CASE("finite films: a law that is far off names the compiled law as the remedy") {
  const ProgramResult off = lubjoint_program({"simulate", journal_scene_file, "--law", "short_half"});
  CHECK_THAT(off.err, Contains("short_half") &&
                          Contains("The law finite_reynolds is the film of the real length, compiled for this L/D."));
  const ProgramResult near = lubjoint_program({"simulate", journal_scene_file, "--law", "finite_reynolds"});
  CHECK(near.status == 0);
  CHECK(near.err.find("real length") == std::string::npos);
}

}  // namespace finite_film_scene_test
