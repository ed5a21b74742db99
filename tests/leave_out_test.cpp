// A scene pays only for what it has, and a program only for what it uses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace leave_out_test {

using namespace lubjoint::test;
using Words = std::vector<std::string>;

namespace {

const std::string scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";

/// What a tool of the compiler's says about a program.
std::string looked_at(const std::string& tool, const Words& arguments) {
  Words words{"sh", "-c", "exec " + tool + " \"$@\"", tool};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ProgramResult result = run("/usr/bin/env", words);
  INFO(result.err);
  REQUIRE(result.status == 0);
  return result.out;
}

std::string symbols_of(const std::string& program) { return looked_at("nm", {"-C", program}); }

bool has(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

/// Libraries that a program asks for when it starts.
std::set<std::string> libraries_of(const std::string& program) {
  const std::string text = looked_at("readelf", {"-d", program});
  std::set<std::string> names;
  static const std::regex needed(R"(\(NEEDED\)[^\[]*\[(\w+))");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), needed); it != std::sregex_iterator(); ++it) {
    names.insert((*it)[1]);
  }
  return names;
}

/// Functions of the library that a scene's run has entered.
std::string entered_by(const std::string& scene_file) {
  const ProgramResult result = run(LUBJOINT_ENTERED_FUNCTIONS, {scene_file});
  INFO(result.err);
  REQUIRE(result.status == 0);
  return result.out;
}

std::string changed(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  std::string result = text;
  return result.replace(at, from.size(), to);
}

const Words contact_functions{"dry_contact_force", "transition_shares", "seam_margins", "next_phase",
                              "enter_phase",       "starting_memory",   "normal_speed"};

/// A program that has nearly all: `lubjoint` itself only knows who has what.
const std::string whole_program = LUBJOINT_PROGRAM "-paper";

}  // namespace

TEST_CASE("a program of film laws alone holds no oracle, no scene, no mechanics and no integrator") {
  // Compiled without inlining: what is used has its symbol.
  const std::string alone = symbols_of(LUBJOINT_FILM_LAWS_ALONE);
  const std::string all = symbols_of(whole_program);
  const std::string mechanics = symbols_of(LUBJOINT_ENTERED_FUNCTIONS);
  CHECK(has(alone, "lubjoint::film_force<lubjoint::PinkusSternlicht"));
  for (const std::string word : {"gsl_", "toml::", "CLI::", "fmt::", "nlohmann", "EVP_"}) {
    INFO(word);
    CHECK(has(all, word));  // else the search would find nothing anywhere
    CHECK_FALSE(has(alone, word));
  }
  for (const std::string word : {"PlanarSystem", "EnvelopeCholesky", "JointElement", "ConstraintRow", "PlanarFrame",
                                 "MultibodyOde", "Radau", "odeint", "Scene", "joint_kinematics"}) {
    INFO(word);
    CHECK(has(mechanics, word));
    CHECK_FALSE(has(alone, word));
  }
}

TEST_CASE("a program of film laws alone is linked with the compiler's own libraries") {
  const std::set<std::string> alone = libraries_of(LUBJOINT_FILM_LAWS_ALONE);
  const std::set<std::string> all = libraries_of(whole_program);
  for (const std::string library : {"libgsl", "libtomlplusplus"}) {
    INFO(library);
    CHECK(all.contains(library));
    CHECK_FALSE(alone.contains(library));
  }
  const std::set<std::string> compilers{"libstdc", "libm", "libgcc_s", "libc", "libc++"};
  CHECK(std::includes(compilers.begin(), compilers.end(), alone.begin(), alone.end()));
  const ProgramResult result = run(LUBJOINT_FILM_LAWS_ALONE, {});
  CHECK(result.status == 0);
  CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 8);
}

TEST_CASE("a free journal on a smooth law holds no multipliers, no contact, no ledger and no events") {
  const std::string journal = symbols_of(LUBJOINT_SMOOTH_JOURNAL_ALONE);
  const std::string mechanics = symbols_of(LUBJOINT_ENTERED_FUNCTIONS);
  CHECK(has(journal, "lubjoint::SmoothMode"));
  CHECK(has(journal, "lubjoint::RadauIIA<double, 4ul, 3, "));
  Words absent{"PlanarSystem", "EnvelopeCholesky", "ConstraintRow", "JointElement",
               "fill_powers",  "toms748",          "ContactPhase"};
  absent.insert(absent.end(), contact_functions.begin(), contact_functions.end());
  for (const std::string& word : absent) {
    INFO(word);
    CHECK(has(mechanics, word));
    CHECK_FALSE(has(journal, word));
  }
  for (const std::string word : {"SidedMode", "SlidingMode", "HalfFilmSide"}) {
    INFO(word);
    CHECK(has(symbols_of(whole_program), word));
    CHECK_FALSE(has(journal, word));
  }
}

TEST_CASE("a program that runs planar scenes holds no code of space") {
  // Its mechanics are compiled without inlining: what is used has its symbol. Radau's linear systems look at the form
  // of a Jacobian first, and take that of space only where it is not the plane's.
  const std::string plane = symbols_of(LUBJOINT_ENTERED_FUNCTIONS);
  const std::string all = symbols_of(whole_program);
  CHECK(has(plane, "PlanarSystem<double>::evaluate"));
  for (const std::string word : {"SpatialSystem", "SpatialOde", "SpatialRun", "SpatialFrame", "spatial_scene",
                                 "JournalAcross", "simulate_spatial"}) {
    INFO(word);
    CHECK(has(all, word));
    CHECK_FALSE(has(plane, word));
  }
}

TEST_CASE(
    "a planar run makes no instruction of space, in the integrator either, in absolute or independent coordinates") {
  if (run("/usr/bin/env", {"sh", "-c", "command -v valgrind"}).status != 0) {
    WARN("skipped: Valgrind is not installed");
    return;
  }
  const TemporaryFolder folder;
  const auto functions_of_run = [&](const std::string& scene, const std::string& from, const std::string& to) {
    std::string text = changed(read_text(scenes + scene), from, to);
    if (const std::size_t at = text.find("\nduration = "); at != std::string::npos)
      text.replace(at, text.find('\n', at + 1) - at, "\nduration = 0.01");
    const std::string counts = folder.path() / "counts";
    const ProgramResult result =
        run("/usr/bin/env", {"valgrind", "--tool=callgrind", "--callgrind-out-file=" + counts,
                             LUBJOINT_PROGRAM "-scenes", "simulate", folder.write("scene.toml", text)});
    INFO(result.err);
    REQUIRE(result.status == 0);
    return read_text(counts);  // every function that was entered is named there
  };
  const Words of_space{"SpatialSystem", "spatial_joint_kinematics", "KinematicSolver", "bodies_of_kinematic_form"};
  const std::string as_it_is = "coordinates = \"auto\"";
  const std::string space = functions_of_run("space/spatial-slider-crank.toml", as_it_is, "coordinates = \"absolute\"");
  for (const std::string coordinates : {"auto", "absolute"}) {
    const std::string plane = functions_of_run("slider-crank.toml", as_it_is, "coordinates = \"" + coordinates + "\"");
    CHECK(has(plane, "PlanarSystem"));
    for (const std::string& name : of_space) {
      INFO(coordinates << ": " << name);
      CHECK(has(space, name));
      CHECK_FALSE(has(plane, name));
    }
  }
}

TEST_CASE("a run without contact enters no function of contact or of event location, one with contact all") {
  const std::string without = entered_by(scenes + "slider-crank.toml");
  const std::string with = entered_by(scenes + "impact.toml");
  for (const std::string& name : contact_functions) {
    INFO(name);
    CHECK(has(with, name));
    CHECK_FALSE(has(without, name));
  }
  CHECK(has(without, "PlanarSystem<double>::evaluate"));
}

TEST_CASE("a run without a ledger enters no function of it, one without constraints no solve") {
  const TemporaryFolder folder;
  const std::string impact = read_text(scenes + "impact.toml");
  const std::string with = entered_by(scenes + "impact.toml");
  const std::string without =
      entered_by(folder.write("no-ledger.toml", changed(impact, "energy_ledger = true", "energy_ledger = false")));
  for (const std::string name : {"fill_powers", "film_power", "contact_power"}) {
    INFO(name);
    CHECK(has(with, name));
    CHECK_FALSE(has(without, name));
  }
  const std::string constrained = entered_by(scenes + "slider-crank.toml");
  for (const std::string name : {"EnvelopeCholesky<double>::factorise", "EnvelopeCholesky<double>::solve",
                                 "wanted_acceleration", "PlanarSystem<double>::solve"}) {
    INFO(name);
    CHECK(has(constrained, name));
    CHECK_FALSE(has(with, name));
  }
}

TEST_CASE("a run without a half film enters no function of its jump, one with enters them") {
  const TemporaryFolder folder;
  const std::string text = read_text(scenes + "slider-crank.toml");
  const std::string without = entered_by(scenes + "slider-crank.toml");
  const std::string with =
      entered_by(folder.write("half.toml", changed(text, "film = \"pinkus_sternlicht\"", "film = \"long_half\"")));
  for (const std::string name :
       {"slip_of_placed", "hold_slides", "differentiate_slides", "project_onto_slides", "::on_jump", "::margins"}) {
    INFO(name);
    CHECK(has(with, name));
    CHECK_FALSE(has(without, name));
  }
}

TEST_CASE("a run without springs, moving loads and sensors enters no function of them, one with enters all") {
  const std::string with = entered_by(LUBJOINT_SOURCE_DIR "/data/examples/lever.toml");
  const std::string without = entered_by(scenes + "slider-crank.toml");
  for (const std::string name :
       {"apply_elements", "TranslationalSpring<double>::state", "RotationalSpring<double>::torque",
        "PointLoad<double>::apply", "damper_power", "load_power", "read_sensors"}) {
    INFO(name);
    CHECK(has(with, name));
    CHECK_FALSE(has(without, name));
  }
}

TEST_CASE("a run projects its steps onto the constraints only if its scene asks for it") {
  const TemporaryFolder folder;
  const std::string text = read_text(scenes + "slider-crank.toml");
  const std::string baumgarte = entered_by(scenes + "slider-crank.toml");
  const std::string projecting = changed(changed(text, "# [stabilisation]", "[stabilisation]"),
                                         "# method = \"baumgarte\"", "method = \"projection\"");
  const std::string projection = entered_by(folder.write("projection.toml", projecting));
  CHECK(has(projection, "project_onto_constraints"));
  CHECK_FALSE(has(baumgarte, "project_onto_constraints"));
}

}  // namespace leave_out_test
