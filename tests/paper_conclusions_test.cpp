// What the page says of the paper's conclusions with the film of the bearing's real length.
#include <catch2/catch.hpp>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/page/sections.hpp"
#include "support/compiled_films.hpp"
#include "support/page_content.hpp"
#include "support/scene_text.hpp"

namespace paper_conclusions_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

RealFilms quick_real_films() {
  RealFilms films;
  for (const char* film : {"finite_full", "finite_half", "finite_dynamic", "finite_reynolds"}) {
    RealFilmJournal journal;
    journal.scene = with_compiled_film(load_scene(journal_scene_file), film);
    journal.scene.run.duration = 0.02;
    journal.run = simulate_journal(journal.scene);
    journal.rest = journal_equilibrium(journal.scene);
    films.journal.push_back(std::move(journal));
  }
  for (const char* pair : slider_crank_pairs) {
    RealFilmCrank crank;
    Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + pair);
    scene.joints.front().journal_radius = 0.0098;  // of the table that ships; the others' are a hundredth larger
    crank.scene = with_compiled_film(scene, "finite_reynolds");
    crank.scene.run.relative_tolerance = crank.scene.run.absolute_tolerance = 1e-6;
    crank.scene.run.output_interval = 1e-3;
    crank.run = simulate_multibody(crank.scene);
    REQUIRE(crank.run.outcome.status == RunStatus::finished);
    films.crank.push_back(std::move(crank));
  }
  return films;
}

/// The last cell of the row that begins with these words.
std::string stands(const std::string& html, const std::string& words) {
  const std::size_t row = html.find(words);
  REQUIRE(row != std::string::npos);
  const std::string cells = html.substr(row, html.find("</tr>", row) - row);
  const std::size_t yes = cells.find(">yes<"), no = cells.find(">no<");
  REQUIRE((yes == std::string::npos) != (no == std::string::npos));
  return yes == std::string::npos ? "no" : "yes";
}

}  // namespace

TEST_CASE("page: the paper's conclusions stand with the real film, or do not, by the numbers of both") {
  page::Content content = quick_page_content();
  CHECK(page::paper_conclusions(content).empty());  // nothing was run: nothing is said
  content.real_films = quick_real_films();
  const std::string html = page::paper_conclusions(content);
  INFO(html);
  CHECK(stands(html, "With Sommerfeld") == "yes");
  CHECK(stands(html, "With G") == "yes");
  CHECK(stands(html, "Pinkus and Sternlicht’s film says where") == "no");  // 0.167 in place of 0.241
  CHECK_THAT(html, Contains("ε = 0.1673") && Contains("ε = 0.2413"));      // as the solver of the model error has it
  CHECK(stands(html, "A thinner oil") == "yes");
  CHECK(stands(html, "The driving moment") == "yes");
  // The words follow the numbers: with a film that never comes to rest, and films that are thick, others stand.
  RealFilms other = *content.real_films;
  other.journal[3].rest.eigenvalues[0] = {5.0, 100.0};
  for (RealFilmCrank& crank : other.crank) crank.run.joints[0].eccentricity.value = 0;
  content.real_films = other;
  const std::string changed = page::paper_conclusions(content);
  CHECK(stands(changed, "With Pinkus") == "no");
  CHECK(stands(changed, "A thinner oil") == "no");
  CHECK(stands(changed, "c = 0.2 mm") == "yes");
  CHECK_THAT(changed, Contains("moves away at 5"));
}

}  // namespace paper_conclusions_test
