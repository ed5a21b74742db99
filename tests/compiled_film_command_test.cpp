// `force` with the laws of finite length, `compile-film`, and the folder where compiled films are kept.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/laws/film_store.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace compiled_film_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

namespace {

const std::string states = "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,3,1\n0,1,2\n0.9,-1,-2\n0.995,1,0\n";

Words force(std::string_view law, const std::string& length) {
  return {"force",    "--law", std::string(law), "--states", "-",           "--viscosity", "0.4",
          "--length", length,  "--radius",       "0.0098",   "--clearance", "0.0002"};
}

/// The table of a film that is quick to make.
CompiledFilm quick_film() {
  static const CompiledFilm film = reports::compile_film("finite_full", 0.75);
  return film;
}

}  // namespace

TEST_CASE("force: a finite film's law answers as the oracle does, states its error, and warns beyond it") {
  const TemporaryFolder cache;
  const std::map<std::string, std::string> here = {{"XDG_CACHE_HOME", cache.path().string()}};
  for_each_film_law<CompiledLaws>([&]<class Law>() {
    INFO(Law::name);
    const ProgramResult compiled = lubjoint_program(force(Law::name, "0.04"), {.input = states, .environment = here});
    REQUIRE(compiled.status == 0);
    CHECK_THAT(compiled.err, Contains("compiled for length over diameter 2.04082: within "));
    CHECK_THAT(compiled.err, Contains("warning: 1 of the states have an eccentricity ratio above 0.9"));
    const ProgramResult solved =
        lubjoint_program({"oracle", "force", "--film", std::string(Law::name), "--states", "-", "--rtol", "1e-4",
                          "--viscosity", "0.4", "--length", "0.04", "--radius", "0.0098", "--clearance", "0.0002"},
                         {.input = states});
    REQUIRE(solved.status == 0);
    const std::vector<CsvRow> answers = parse_csv(compiled.out);
    const std::vector<CsvRow> expected = parse_csv(solved.out);
    REQUIRE(answers.size() == 4);
    REQUIRE(expected.size() == 4);
    for (std::size_t row = 0; row < 3; ++row) {  // the fourth is beyond finite_reynolds' statement
      const double radial = number(answers[row].at("radial")) - number(expected[row].at("radial"));
      const double tangential = number(answers[row].at("tangential")) - number(expected[row].at("tangential"));
      const double size = std::hypot(number(expected[row].at("radial")), number(expected[row].at("tangential")));
      CHECK(std::hypot(radial, tangential) < 3e-4 * size);  // the oracle's tolerance and the law's statement, each 1e-4
    }
    CHECK(compiled.out.starts_with(std::is_same_v<Law, FiniteDynamic>
                                       ? "eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential,theta_s,theta_e\n"
                                       : "eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential\n"));
  });
  CHECK(fs::is_empty(cache.path()));  // what ships is not made again
}

TEST_CASE("force: a film that does not ship is compiled, kept, and read the next time; a damaged one is made again") {
  const TemporaryFolder cache;
  const ProgramSetting setting{.input = states, .environment = {{"XDG_CACHE_HOME", cache.path().string()}}};
  const ProgramResult first = lubjoint_program(force("finite_full", "0.0147"), setting);
  REQUIRE(first.status == 0);
  const fs::path file = cache.path() / "lubjoint" / "films" / reports::film_file_name("finite_full", 0.0147 / 0.0196);
  REQUIRE(fs::exists(file));
  const std::string made = read_text(file);
  const auto time = fs::last_write_time(file);
  CHECK(lubjoint_program(force("finite_full", "0.0147"), setting).out == first.out);
  CHECK(fs::last_write_time(file) == time);

  std::ofstream(file) << made.substr(0, made.size() / 2);
  const ProgramResult again = lubjoint_program(force("finite_full", "0.0147"), setting);
  CHECK(again.out == first.out);
  CHECK_THAT(again.err, Contains("is refused: no compiled film: line"));
  CHECK(read_text(file) == made);

  CHECK_THAT(lubjoint_program(force("finite_full", "4"), setting).err, Contains("a number from 0.05 to 10"));
  CHECK_THAT(lubjoint_program(force("finite_ful", "0.04"), setting).err, Contains("did you mean finite_full?"));
}

TEST_CASE("compile-film: writes the table it measured, or says why not") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "film.txt").string();
  const Words command = {"compile-film", "--film", "finite_full", "--length-to-diameter", "0.75", "--out", out};
  const ProgramResult made = lubjoint_program(command);
  REQUIRE(made.status == 0);
  CHECK_THAT(made.out, Contains("finite_full, compiled for length over diameter 0.75: within "));
  CHECK(read_compiled_film(read_text(out)).coefficients == quick_film().coefficients);

  Words strict = {"compile-film", "--film",      "finite_full", "--length", "0.015",  "--radius",
                  "0.01",         "--tolerance", "1e-15",       "--out",    out + "2"};
  const ProgramResult refused = lubjoint_program(strict);
  CHECK(refused.status == 1);
  CHECK_FALSE(fs::exists(out + "2"));
  CHECK(lubjoint_program({"compile-film", "--film", "finite_full"}).status == 2);
  CHECK(lubjoint_program({"compile-film", "--film", "short_full", "--length-to-diameter", "1"}).status == 2);
  CHECK(lubjoint_program({"compile-film", "--film", "finite_full", "--length-to-diameter", "1", "--length", "1"})
            .status == 2);
}

TEST_CASE("compiled films: the cache refuses what is another film's, and stays within its size") {
  const TemporaryFolder folder;
  reports::FilmStore store;
  CHECK(store.size_limit == 4 * 1024 * 1024);
  CHECK_THAT(read_text(LUBJOINT_SOURCE_DIR "/README.md"), Contains("at most 4 MiB"));
  store.cache = folder.path() / "films";
  const CompiledFilm film = quick_film();
  const fs::path kept = reports::keep_film(film, store);
  CHECK(reports::read_film_file(kept, "finite_full", 0.75).coefficients == film.coefficients);
  CHECK_THROWS_WITH(reports::read_film_file(kept, "finite_half", 0.75), Contains("of finite_full, not of finite_half"));
  CHECK_THROWS_WITH(reports::read_film_file(kept, "finite_full", 0.5), Contains("made for length over diameter 0.75"));

  // A foreign film under this one's name is refused with a message, and made again.
  CompiledFilm foreign = film;
  foreign.shape = 0.8;
  std::ofstream(kept) << compiled_film_text(foreign);
  std::string said;
  const CompiledFilm again =
      reports::film_at_hand("finite_full", 0.75, store, {}, [&](const std::string& text) { said += text; });
  CHECK_THAT(said, Contains("made for length over diameter 0.8, not for 0.75"));
  CHECK(again.coefficients == film.coefficients);
  CHECK(reports::read_film_file(kept, "finite_full", 0.75).shape == 0.75);

  store.size_limit = 2 * fs::file_size(kept) + 100;
  for (int n = 0; n < 4; ++n) {
    CompiledFilm other = film;
    other.shape = 1 + n / 8.0;
    const fs::path newest = reports::keep_film(other, store);
    fs::last_write_time(newest, fs::file_time_type::clock::now() + std::chrono::seconds(n + 1));
    CHECK(fs::exists(newest));
  }
  std::uintmax_t total = 0;
  for (const auto& entry : fs::directory_iterator(store.cache)) total += entry.file_size();
  CHECK(total <= store.size_limit);
  CHECK_FALSE(fs::exists(kept));  // the oldest went first

  store.cache = "/proc/nothing-can-be-kept-here";
  said.clear();
  CHECK(reports::film_at_hand("finite_full", 0.75, store, {}, [&](const std::string& text) {
          said += text;
        }).coefficients == film.coefficients);
  CHECK_THAT(said, Contains("is not kept"));
}

TEST_CASE("compile-film --states: the table that ships is held against the solver, and what it is not for is refused") {
  const Words check = {"compile-film", "--film", "finite_dynamic", "--length-to-diameter", "0.5", "--states"};
  const auto with = [&check](Words more) {
    Words words = check;
    words.insert(words.end(), more.begin(), more.end());
    return lubjoint_program(words);
  };
  const ProgramResult made = with({"30"});
  REQUIRE(made.status == 0);
  const std::vector<CsvRow> rows = parse_csv(made.out);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].at("film") == "finite_dynamic");
  CHECK(rows[0].at("states") == "30");
  CHECK(rows[0].at("beyond") == "0");
  CHECK(number(rows[0].at("worst")) > 0);
  CHECK(number(rows[0].at("worst")) <= number(rows[0].at("stated_error")) + number(rows[0].at("solver_bound")));
  CHECK_THAT(with({"0"}).err, Contains("--states is 0; allowed is a whole number from 1"));
  CHECK(with({"0"}).status == 2);
  CHECK_THAT(with({"30", "--tolerance", "0.1"}).err, Contains("--states is given beside --out or --tolerance"));
}

}  // namespace compiled_film_command_test
