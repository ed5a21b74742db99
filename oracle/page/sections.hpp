/// The page's sections, one file each, in the order of the page.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "oracle/page/html.hpp"
#include "oracle/page/page.hpp"
#include "oracle/results/check.hpp"

namespace lubjoint::reports::page {

struct Section {
  std::string id;
  std::string title;
  std::string html;
};

Section verdict_section(const Content& content);
Section motion_section(const Content& content);
Section journal_section(const Content& content);
Section equilibrium_section(const Content& content);
Section losses_section(const Content& content);
Section slider_crank_section(const Content& content);
Section space_section(const Content& content);
Section laws_section(const Content& content);
Section model_error_section(const Content& content);
Section proofs_section(const Content& content);
Section run_time_section(const Content& content);
Section stability_section(const Content& content);
Section verify_section(const Content& content);
Section provenance_section(const Content& content);

/// The page from top to bottom.
inline constexpr std::array sections = {
    verdict_section,      motion_section,    journal_section, equilibrium_section, losses_section,
    slider_crank_section, space_section,     laws_section,    model_error_section, proofs_section,
    run_time_section,     stability_section, verify_section,  provenance_section,
};

/// A law in words: "long bearing, full film".
std::string law_words(std::string_view law);

/// A verdict as a cell: the letters of what it rests on, what failed, or a dash where nothing was checked.
Cell agreement(const Verdict& verdict);

/// What the letters stand for: a table with a row for each check of the verdicts, which have the same checks.
std::string checks_table(const std::string& caption, const std::vector<const Verdict*>& verdicts);

/// The paragraph "Checked: …" of a figure: some of the verdicts' checks, by what they judge.
/// @throws std::logic_error for a check that the verdicts do not have
std::string checked_words(const std::vector<const Verdict*>& verdicts, const std::vector<std::string>& whats);

/// The paper's conclusions with its films and with that of the bearing's real length: a table whose last column says
/// which of them stand. Nothing where that film was not run. What the paper concludes is no check of this program.
std::string paper_conclusions(const Content& content);

/// What the runs of the animation look like, as JSON for animation.js (described there).
std::string animation_json(const Example1& journal, const Example2& slider_crank);

/// The run in space as JSON for space.js (described in space_section.cpp); "null" if it has no samples.
std::string space_animation_json(const SpaceExample& example);

}  // namespace lubjoint::reports::page
