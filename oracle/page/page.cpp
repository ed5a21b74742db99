#include "oracle/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/files/files.hpp"
#include "oracle/page/html.hpp"
#include "oracle/page/resources.hpp"
#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

bool Content::passed() const {
  const bool proved = !proofs || proofs->closes();
  const bool real = !real_films || real_films->passed();
  return journal.passed() && slider_crank.passed() && space.verdict.agrees() && laws.passed() && real && proved;
}

bool Content::stored_runs_are_right() const {
  return !stability || std::none_of(stability->rows.begin(), stability->rows.end(),
                                    [](const auto& row) { return row.status == RowStatus::wrong; });
}

std::string report_page(const Content& content) {
  std::string contents;
  std::string html;
  for (const auto make : sections) {
    const Section section = make(content);
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, escaped(section.title));
    html += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
        section.id, escaped(section.title), section.html);
  }
  std::string scripts;
  for (const char* script : {"page.js", "run_time.js", "stability.js", "player.js", "animation.js", "space.js"})
    scripts += resource(script);
  return filled("page.html", {{"style", std::string(resource("page.css"))},
                              {"version", escaped(content.provenance.version)},
                              {"contents", contents},
                              {"sections", html},
                              {"scripts", scripts}});
}

std::string write_page(const Content& content, const std::filesystem::path& folder) {
  prepare_folder(folder);
  std::string name = "report.html";
  write_file(folder / name, report_page(content));
  return name;
}

}  // namespace lubjoint::reports::page
