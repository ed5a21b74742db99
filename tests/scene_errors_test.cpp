// What a scene file may not say, field by field: the table of fields is read from the scene that ships.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scene_text.hpp"

namespace scene_errors_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

/// What the reference says of a field, besides its kind.
struct Rule {
  bool required;
  bool positive;  ///< numbers: 0 and less are refused
};

const std::map<std::string, Rule> rules = {
    {"name", {true, false}},
    {"duration", {true, true}},
    {"gravity", {false, false}},
    {"bodies[0].name", {true, false}},
    {"bodies[0].mass", {true, true}},
    {"bodies[0].inertia", {true, true}},
    {"bodies[0].position", {false, false}},
    {"bodies[0].velocity", {false, false}},
    {"bodies[0].spin", {false, false}},
    {"loads[0].body", {true, false}},
    {"loads[0].force", {true, false}},
    {"joints[0].name", {true, false}},
    {"joints[0].film", {true, false}},
    {"joints[0].viscosity", {true, true}},
    {"joints[0].length", {true, true}},
    {"joints[0].journal_radius", {true, true}},
    {"joints[0].clearance", {true, true}},
    {"joints[0].bearing", {true, false}},
    {"joints[0].bearing.body", {true, false}},
    {"joints[0].bearing.point", {false, false}},
    {"joints[0].journal", {true, false}},
    {"joints[0].journal.body", {true, false}},
    {"joints[0].journal.point", {false, false}},
    {"integrator.name", {false, false}},
    {"integrator.relative_tolerance", {false, true}},
    {"integrator.absolute_tolerance", {false, true}},
    {"output.interval", {false, true}},
};

std::vector<std::string> refused_values(const SceneField& field) {
  switch (field.kind) {
    case FieldKind::number: {
      std::vector<std::string> values{"\"0.5\"", "true", "nan", "inf", "-inf", "[1.0]", "{a = 1}", "1979-05-27"};
      if (rules.at(field.path).positive) values.insert(values.end(), {"0", "0.0", "-0.0", "-1", "-1e-300", "1e-400"});
      return values;
    }
    case FieldKind::vector:
      return {"1.0",        "\"0, 0\"",   "true",        "[]",           "[1.0]",       "[0.0, 0.0, 0.0]", "[nan, 0.0]",
              "[0.0, nan]", "[inf, 0.0]", "[0.0, -inf]", "[0.0, \"0\"]", "[true, 0.0]", "{x = 0, y = 0}"};
    case FieldKind::text:
      return {"1", "1.5", "true", "\"\"", "[\"ground\"]", "{a = 1}", "nan", "\"nobody's name\""};
    case FieldKind::table:
      return {"1.0", "\"ground\"", "true", "[]", "[{body = \"ground\"}]", "{}"};
  }
  return {};
}

/// The message of a scene text's refusal; nothing if it is accepted.
std::optional<std::string> refusal(const std::string& text) {
  static const TemporaryFolder folder;
  const std::string file = folder.write("scene.toml", text);
  try {
    load_scene(file);
    return std::nullopt;
  } catch (const SceneError& error) {
    const std::string message = error.what();
    REQUIRE(message.starts_with(file + ":"));
    CHECK(message.find('\n') == std::string::npos);
    return message.substr(file.size());
  }
}

void check_refused(const std::string& text, std::size_t line, const std::vector<std::string>& words) {
  const std::optional<std::string> message = refusal(text);
  REQUIRE(message);
  CHECK_THAT(*message, Catch::Matchers::StartsWith(":" + std::to_string(line) + ": "));
  for (const std::string& word : words) CHECK_THAT(*message, Contains(word));
}

}  // namespace

TEST_CASE("Scene: the scene that ships is accepted, and every field of it has a rule here") {
  CHECK_FALSE(refusal(read_text(journal_scene_file)));
  CHECK(journal_text().fields().size() == rules.size());
  for (const SceneField& field : journal_text().fields()) {
    INFO(field.path);
    CHECK(rules.count(field.path) == 1);
    CHECK_FALSE(refusal(journal_text().with(field, field.value)));
  }
}

TEST_CASE("Scene: a value of the wrong type or range is refused with file, line, key and what is allowed") {
  for (const SceneField& field : journal_text().fields()) {
    for (const std::string& value : refused_values(field)) {
      INFO(field.path << " = " << value);
      const bool any_name = field.key == "name" && field.table != "integrator";
      if (value == "\"nobody's name\"" && any_name) {  // an apostrophe is as bad in a file name
        check_refused(journal_text().with(field, value), field.line, {field.path, "; allowed is a name without"});
        continue;
      }
      const std::string allowed = value == "{}" ? "; required is" : "; allowed is";
      check_refused(journal_text().with(field, value), field.line, {field.path, allowed});
    }
  }
}

TEST_CASE("Scene: the message shows the value that was given") {
  const auto shown = [](const std::string& path, const std::string& value, const std::string& words) {
    INFO(path << " = " << value);
    check_refused(journal_text().with(path, value), journal_text().field(path).line, {path, " is " + words});
  };
  shown("bodies[0].mass", "-0.13", "-0.13");
  shown("bodies[0].mass", "nan", "nan");
  shown("bodies[0].mass", "-inf", "-inf");
  shown("bodies[0].mass", "\"heavy\"", "'heavy'");
  shown("bodies[0].mass", "{a = 1}", "a table");
  shown("joints[0].film", "\"short\"", "\"short\"");
  shown("loads[0].body", "\"shaft\"", "\"shaft\"");
  shown("output.interval", "0", "0");
}

TEST_CASE("Scene: a missing field is refused if it is required, with the line of its table, and else has a default") {
  for (const SceneField& field : journal_text().fields()) {
    INFO(field.path << " is missing");
    const std::string text = journal_text().without(field);
    if (rules.at(field.path).required) {
      check_refused(text, field.table_line, {field.path + " is missing", "; required is"});
    } else {
      CHECK_FALSE(refusal(text));
    }
  }
}

TEST_CASE("Scene: an unknown key is refused, and the nearest known one named") {
  for (const SceneField& field : journal_text().fields()) {
    const std::string misspelt = field.key.substr(0, field.key.size() - 1) + "x";
    const std::string path = field.table.empty() ? misspelt : field.table + "." + misspelt;
    INFO(path);
    const std::optional<std::string> message = refusal(journal_text().replaced(field, misspelt + " = " + field.value));
    REQUIRE(message);
    CHECK_THAT(*message, Contains(path));
    CHECK_THAT(*message, Contains("did you mean"));
    CHECK_THAT(*message, Contains(std::to_string(field.line)));
    CHECK_THAT(*message, Contains("required is") || Contains("allowed are"));
  }
  check_refused(
      journal_text().replaced(journal_text().field("gravity"), "colour = 1"), 6,
      {"unknown key colour; allowed are dimension, name, gravity, duration, bodies, loads, joints, constraints, "
       "springs, sensors, coordinates, integrator, output"});
}

TEST_CASE("Scene: a law or an integrator that is not there is refused with the list and the nearest") {
  const std::size_t film = journal_text().field("joints[0].film").line;
  check_refused(
      journal_text().with("joints[0].film", "\"short_hal\""), film,
      {"\"short_hal\"; allowed is one of short_full, short_half, short_dynamic, long_full, long_half, "
       "long_half_eq5, long_dynamic, pinkus_sternlicht, squeeze_long_full, squeeze_short_full, squeeze_long, "
       "squeeze_short, moes_impedance, butenschoen, finite_full, finite_half, finite_dynamic, finite_reynolds, none; "
       "did you mean short_half?"});
  check_refused(journal_text().with("joints[0].film", "\"Short_Half\""), film, {"did you mean short_half?"});
  const std::size_t integrator = journal_text().field("integrator.name").line;
  check_refused(journal_text().with("integrator.name", "\"radau\""), integrator,
                {"allowed is one of radau_iia5, radau_iia9, rosenbrock4, dopri5, fehlberg78"});
  check_refused(journal_text().with("integrator.name", "\"dopri\""), integrator, {"did you mean dopri5?"});
}

TEST_CASE("Scene: a clearance of the journal's radius or more is refused, one just below is accepted") {
  const std::size_t line = journal_text().field("joints[0].clearance").line;
  for (const char* value : {"0.0098", "0.01", "1e300"}) {
    check_refused(journal_text().with("joints[0].clearance", value), line,
                  {"joints[0].clearance", "allowed is less than journal_radius, 0.0098 m"});
  }
  CHECK_FALSE(refusal(journal_text().with("joints[0].clearance", "0.0097999999999999")));
}

TEST_CASE("Scene: a journal that starts on or outside its bearing is refused, one just inside is accepted") {
  const std::size_t line = journal_text().field("joints[0].journal").line;
  for (const char* value : {"[2e-4, 0.0]", "[0.0, -2e-4]", "[1.5e-4, 1.5e-4]", "[1.0, 0.0]", "[1e300, 1e300]"}) {
    INFO(value);
    check_refused(journal_text().with("bodies[0].position", value), line,
                  {"joints[0].journal is at eccentricity ratio", "in its bearing; allowed is", "[0, 1)"});
  }
  check_refused(journal_text().with("joints[0].bearing.point", "[3e-4, 0.0]"), line, {"eccentricity ratio 1.5"});
  check_refused(journal_text().with("joints[0].journal.point", "[0.0, 3e-4]"), line, {"eccentricity ratio 1.5"});
  CHECK_FALSE(refusal(journal_text().with("bodies[0].position", "[1.99999999999999e-4, 0.0]")));
}

TEST_CASE("Scene: tolerances, limits and intervals are refused outside their range and accepted at its ends") {
  const std::string tolerance = "integrator.relative_tolerance";
  const std::size_t line = journal_text().field(tolerance).line;
  for (const char* value : {"1.0", "2", "0.9e-14", "1e300"}) {
    check_refused(journal_text().with(tolerance, value), line,
                  {tolerance, "allowed is a number from 1e-14 to below 1"});
  }
  CHECK_FALSE(refusal(journal_text().with(tolerance, "1e-14")));
  CHECK_FALSE(refusal(journal_text().with(tolerance, "0.999")));
  const auto steps = [](const std::string& value) {
    return journal_text().replaced(journal_text().field("integrator.name"), "max_steps = " + value);
  };
  for (const char* value : {"0", "-1", "0.5", "1.5", "1e13", "nan", "\"many\""}) {
    check_refused(steps(value), journal_text().field("integrator.name").line, {"integrator.max_steps", "allowed is"});
  }
  CHECK_FALSE(refusal(steps("1")));
  CHECK_FALSE(refusal(steps("1e12")));
  check_refused(journal_text().with("output.interval", "0.9e-7"), journal_text().field("output.interval").line,
                {"output.interval", "allowed is at least a ten-millionth of the duration"});
  CHECK_FALSE(refusal(journal_text().with("output.interval", "1e-7")));
  CHECK_FALSE(refusal(journal_text().with("output.interval", "5")));  // more than the run: its ends are written
}

TEST_CASE("Scene: every finite number in range is accepted, whole ones and tiny ones too") {
  for (const SceneField& field : journal_text().fields()) {
    if (field.kind != FieldKind::number || field.table == "integrator" || field.table == "output") continue;
    INFO(field.path);
    CHECK_FALSE(refusal(journal_text().with(field, "1e-3")));
    if (!rules.at(field.path).positive) {
      for (const char* value : {"0", "-1", "-1e300"}) CHECK_FALSE(refusal(journal_text().with(field, value)));
    }
  }
  for (const char* value : {"1", "9223372036854775807", "1e300", "1_000.5"}) {
    CHECK_FALSE(refusal(journal_text().with("bodies[0].mass", value)));
  }
}

TEST_CASE("Scene: bodies and joints are refused if they are missing, called alike, or not there") {
  const std::string text = read_text(journal_scene_file);
  const std::string body = "\n[[bodies]]\nname = \"NAME\"\nmass = 1\ninertia = 1\n";
  const auto with_body = [&](const std::string& name) {
    std::string all = text;
    std::string other = body;
    other.replace(other.find("NAME"), 4, name);
    return all.insert(all.find("# Constant forces"), other);
  };
  const std::size_t line = 1 + journal_text().field("loads[0].body").line - 3 + 2;
  for (const char* name : {"journal", "ground"}) {
    const auto message = refusal(with_body(name));
    REQUIRE(message);
    INFO(*message << line);
    CHECK_THAT(*message, Contains("bodies[1].name is \"" + std::string(name) + "\"; allowed is a name that no other"));
  }
  CHECK_FALSE(refusal(with_body("shaft")));
  check_refused(journal_text().with("loads[0].body", "\"ground\""), journal_text().field("loads[0].body").line,
                {"loads[0].body", "\"journal\""});
  check_refused(journal_text().with("joints[0].journal.body", "\"ground\""),
                journal_text().field("joints[0].journal").line,
                {"joints[0].journal", "same body", "allowed is another body"});
  const std::size_t joint = text.find("[[joints]]");
  std::string twice = text;
  twice.insert(text.find("[integrator]"), text.substr(joint, text.find("[integrator]") - joint));
  REQUIRE(refusal(twice));
  CHECK_THAT(*refusal(twice), Contains("joints[1].name is \"bearing\"; allowed is a name that no other joint has"));
  REQUIRE(refusal("name = \"empty\"\nduration = 1\n"));
  CHECK_THAT(*refusal("name = \"empty\"\nduration = 1\n"), Contains("bodies") && Contains("at least one [[bodies]]"));
}

TEST_CASE("Scene: names that can't be part of a file name or a CSV column are refused") {
  for (const char* path : {"name", "bodies[0].name", "joints[0].name"}) {
    for (const char* value : {"\"a/b\"", "\"../a\"", "\"a,b\"", "\"a\\nb\"", "\"a\\\"b\"", "\"a\\\\b\"", "\".\""}) {
      INFO(path << " = " << value);
      check_refused(journal_text().with(path, value), journal_text().field(path).line,
                    {path, "allowed is a name without"});
    }
  }
  CHECK_FALSE(refusal(journal_text().with("joints[0].name", "\"gudgeon-pin_2.b é\"")));
}

TEST_CASE("Scene: a file that can't be read, is a folder, empty, binary or cut off is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(load_scene(folder / "absent.toml"),
                    Contains("absent.toml: can't be read; allowed is a scene file"));
  CHECK_THROWS_WITH(load_scene(folder.path()), Contains(folder.path().string() + ": is a folder; allowed is"));
  CHECK_THROWS_WITH(load_scene("/proc/self/mem"), Contains("can't be read; allowed is"));
  CHECK_THROWS_AS(load_scene(""), SceneError);
  check_refused("", 1, {"name is missing", "required is"});
  check_refused("\n\n", 1, {"name is missing", "required is"});
  check_refused(std::string("\x7f"
                            "ELF\x02\x01\0\0\xff\xfe",
                            10),
                1, {"beyond ASCII", "allowed in keys are"});
  check_refused(
      "\xff\xfe"
      "n\0a\0m\0e\0",
      1, {"beyond ASCII"});
  check_refused("name = \"c\"\nduratna\u048con =", 2, {"beyond ASCII"});
  // In strings and comments any letter may stand, also after quotes that are escaped or within the other kind.
  for (const char* line : {"# µ, \"ö", "name = \"Käfig \\\" ß\"", "name = 'Käfig \" ß'", "name = \"\"\"K'\"ä\"\"\""}) {
    const auto message = refusal(std::string("\xEF\xBB\xBF") + line + "\n");
    REQUIRE(message);
    CHECK_THAT(*message, !Catch::Contains("beyond ASCII"));
  }
  // Cut after any byte: refused, or a whole scene up to there; never a crash, never another kind of error.
  const std::string text = read_text(journal_scene_file);
  std::size_t accepted = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    INFO("the first " << length << " bytes");
    const auto message = refusal(text.substr(0, length));
    if (!message) {
      ++accepted;
      continue;
    }
    CHECK_THAT(*message, Contains("allowed") || Contains("required"));
  }
  CHECK(accepted > 0);
}

TEST_CASE("Scene: what is no free journal is refused by simulation and equilibrium, with file and line") {
  const TemporaryFolder folder;
  const std::string text = read_text(journal_scene_file);
  // Nothing holds this body; what the file says of joints stands before its first table.
  const std::string no_joint = folder.write("no-joint.toml", "joints = []\n" + text.substr(0, text.find("[[joints]]")));
  const std::string off_centre =
      folder.write("off-centre.toml", journal_text().with("joints[0].journal.point", "[1e-5, 0.0]"));
  const std::string no_spin = folder.write("no-spin.toml", journal_text().with("bodies[0].spin", "0"));
  for (const std::string& file : {no_joint, off_centre}) {
    const Scene scene = load_scene(file);
    CHECK_THROWS_AS(simulate_journal(scene), SceneError);
    CHECK_THROWS_WITH(simulate_journal(scene), Contains(file + ":") && Contains("joints") && Contains("allowed is"));
    CHECK_THROWS_WITH(journal_equilibrium(scene), Contains(file + ":") && Contains("allowed is"));
  }
  CHECK_THROWS_WITH(journal_equilibrium(load_scene(no_spin)),
                    Contains(no_spin + ":9: bodies[0].spin is 0; allowed is a spin other than 0"));
}

}  // namespace scene_errors_test
