#include "support/include_rules.hpp"

#include <catch2/catch.hpp>

namespace include_rules_test {

using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// A made-up tree: file names and their texts.
std::vector<std::string> violations_in(const std::map<std::string, std::string>& texts) {
  IncludeGraph graph;
  for (const auto& [name, text] : texts) graph[name] = project_includes(name, text);
  return include_violations(graph);
}

}  // namespace

TEST_CASE("the sources keep the include rules: oracles see no force law, arrows run one way") {
  const IncludeGraph graph = scan_sources(LUBJOINT_SOURCE_DIR);
  CHECK(graph.contains("lubjoint/film/film_state.hpp"));
  CHECK(graph.contains("oracle/reynolds/film_integral.cpp"));
  CHECK(seen_from(graph, "oracle/reynolds/film_integral.cpp").contains("lubjoint/film/film_state.hpp"));
  for (const std::string& violation : include_violations(graph)) FAIL_CHECK(violation);
}

TEST_CASE("the include scanner reads every way to write an include, and no comment") {
  const std::string text =
      "#include \"lubjoint/film/law.hpp\"\n"
      "  #  include <lubjoint/film/extent.hpp>  // why\n"
      "// #include \"lubjoint/joint/joint.hpp\"\n"
      "#include \"sibling.hpp\"\n"
      "#include \"../verify/gallery.hpp\"\n"
      "#include <vector>\r\n"
      "const char* s = \"#include\";\n";
  const std::vector<std::string> expected = {"lubjoint/film/law.hpp", "lubjoint/film/extent.hpp",
                                             "oracle/reynolds/sibling.hpp", "oracle/verify/gallery.hpp"};
  CHECK(project_includes("oracle/reynolds/a.cpp", text) == expected);
}

TEST_CASE("the include scanner finds a force law in an oracle, also behind another header") {
  for (const std::string folder : {"quadrature", "reynolds", "proofs", "certified"}) {
    INFO(folder);
    const auto direct = violations_in({{"oracle/" + folder + "/a.hpp", "#include \"lubjoint/film/long_half.hpp\"\n"}});
    REQUIRE(direct.size() == 1);
    CHECK_THAT(direct[0], Contains(folder) && Contains("includes lubjoint/film/long_half.hpp"));
    const auto hidden = violations_in({{"oracle/" + folder + "/a.cpp", "#include \"oracle/mechanisms/map.hpp\"\n"},
                                       {"oracle/mechanisms/map.hpp", "#include \"lubjoint/film/law_list.hpp\"\n"}});
    REQUIRE(hidden.size() == 1);
    CHECK_THAT(hidden[0], Contains("through other headers"));
  }
  CHECK(violations_in({{"oracle/reynolds/a.hpp", "#include \"lubjoint/film/pressure.hpp\"\n"}}).empty());
  CHECK(violations_in({{"oracle/laws/a.hpp", "#include \"lubjoint/film/law.hpp\"\n"}}).empty());
}

TEST_CASE("the include scanner finds arrows that run the wrong way") {
  const auto count = [](const std::string& file, const std::string& includes) {
    return violations_in({{file, "#include \"" + includes + "\"\n"}}).size();
  };
  CHECK(count("lubjoint/film/a.hpp", "lubjoint/joint/b.hpp") == 1);
  CHECK(count("lubjoint/joint/a.hpp", "lubjoint/multibody/b.hpp") == 1);
  CHECK(count("lubjoint/number/a.hpp", "lubjoint/film/b.hpp") == 1);
  CHECK(count("lubjoint/multibody/a.hpp", "lubjoint/motion/b.hpp") == 1);
  CHECK(count("lubjoint/motion/a.hpp", "lubjoint/scene/b.hpp") == 1);
  CHECK(count("lubjoint/ode/a.hpp", "lubjoint/film/b.hpp") == 1);
  CHECK(count("lubjoint/ode/a.hpp", "lubjoint/number/b.hpp") == 0);
  CHECK(count("oracle/files/a.hpp", "lubjoint/number/b.hpp") == 1);
  CHECK(count("oracle/verify/states/a.hpp", "oracle/files/b.hpp") == 0);
  CHECK(count("oracle/verify/states/a.hpp", "oracle/results/b.hpp") == 1);
  CHECK(count("oracle/certified/a.hpp", "oracle/plot/b.hpp") == 1);
  CHECK(count("oracle/results/a.hpp", "oracle/measure/bench/b.hpp") == 1);
  CHECK(count("lubjoint/scene/a.hpp", "oracle/verify/b.hpp") == 1);
  CHECK(count("oracle/verify/a.hpp", "oracle/cli/b.hpp") == 1);
  CHECK(count("oracle/mechanisms/a.hpp", "lubjoint/joint/b.hpp") == 1);
  CHECK(count("oracle/mechanisms/a.hpp", "lubjoint/motion/b.hpp") == 1);
  CHECK(count("oracle/mechanisms/a.hpp", "lubjoint/film/law.hpp") == 0);
  CHECK(count("lubjoint/joint/a.hpp", "lubjoint/film/law.hpp") == 0);
  CHECK(count("oracle/cli/a.cpp", "oracle/page/b.hpp") == 0);
}

}  // namespace include_rules_test
