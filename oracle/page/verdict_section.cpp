#include <fmt/format.h>

#include <algorithm>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

template <class Items>
Cell count_agreeing(const Items& items) {
  const auto good = std::count_if(items.begin(), items.end(), [](const auto& item) { return item.verdict.agrees(); });
  return verdict_cell(static_cast<std::size_t>(good) == items.size(),
                      fmt::format("{} of {} agree", good, items.size()));
}

template <class Items, class Value>
double largest(const Items& items, const Value& value) {
  double result = 0;
  for (const auto& item : items) result = std::max(result, value(item));
  return result;
}

/// The largest difference that a check has found, with its unit.
std::string difference_of(const std::vector<const Verdict*>& verdicts, const std::string& what) {
  for (const CheckSummary& line : summary_of_checks(verdicts)) {
    if (line.what == what) return with_powers(line.largest);
  }
  return "–";
}

void proofs_row(Table& table, const std::optional<ProofLedger>& proofs) {
  const char* what = "the formulas themselves";
  const char* how = "computer algebra: identities that normalise to zero, and mistakes that do not";
  if (!proofs) {
    table.row({what, how, "–", "no stored ledger: ./lubjoint prove"});
    return;
  }
  const auto good = std::count_if(proofs->statements.begin(), proofs->statements.end(),
                                  [](const ProofEntry& each) { return each.as_expected; });
  const std::string words = fmt::format("{} of {} as they should be", good, proofs->statements.size());
  // Ticked only for the formulas that this program was built beside.
  table.row({what, how, "exact",
             proofs->is_of_these_sources() ? verdict_cell(proofs->closes(), words)
                                           : Cell{"– " + words + ", proved of other sources: ./lubjoint prove", ""}});
}

void stability_row(Table& table, const std::optional<Stability>& stability) {
  if (!stability) return;
  const auto count = [&](RowStatus status) {
    return std::count_if(stability->rows.begin(), stability->rows.end(),
                         [&](const StabilityRow& row) { return row.status == status; });
  };
  const auto wrong = count(RowStatus::wrong);
  const auto finished = count(RowStatus::finished);
  const std::string words =
      fmt::format("{} finished, {} too coarse and said so, {} finished without a reference, {} stopped, {} wrong",
                  finished, count(RowStatus::coarse), count(RowStatus::unreferenced), count(RowStatus::stopped), wrong);
  // Where no run was held against a reference to its end, none could have been found wrong.
  const Cell verdict = wrong == 0 && finished == 0 ? Cell("– " + words) : verdict_cell(wrong == 0, words);
  table.row({"extreme cases",
             "every run ends: finished as near to a stored motion of other methods as its tolerance lets one expect "
             "(places, velocities, forces), or with a warning that it may not be, or stopped with a reason",
             "–", verdict});
}

/// What a user must know before believing any of the laws for this bearing.
std::string model_note(const Content& content) {
  const auto& loaded = content.model_error.loaded;
  const auto ratio = [&](std::string_view name) {
    const auto found = std::find_if(loaded.begin(), loaded.end(), [&](const auto& s) { return s.name == name; });
    return found == loaded.end() ? std::string("?") : fmt::format("{:.3f}", found->eccentricity_ratio);
  };
  if (loaded.empty()) return {};
  return fmt::format(
      "<div class=\"note\"><p>Right formulas are not yet the right film. At L/D = {:.2f} no closed form is close to a "
      "film of the bearing’s real length: under the load of example 1 the journal rests at ε = {} (short half film), "
      "{} (long half film, Pinkus–Sternlicht), but {} with the Reynolds equation solved around and along the bearing "
      "(Swift–Stieber, free onset; {} with the onset at the maximum film). See <a href=\"#model-error\">model "
      "error</a>.</p></div>\n",
      content.model_error.length_to_diameter, ratio("short_half"), ratio("pinkus_sternlicht"), ratio("finite_reynolds"),
      ratio("finite_reynolds, onset at the maximum film"));
}

}  // namespace

Section verdict_section(const Content& content) {
  Table table("What was checked, against what, and the verdict",
              {{"what", {}, false}, {"against", {}, false}, {"largest difference"}, {"verdict", {}, false}});
  const Example1& journal = content.journal;
  const Example2& crank = content.slider_crank;
  table.row(
      {"example 1: journal under a load, each law",
       "a second integrator, the film’s pressure, the eigenvalue, the paper’s words: checks A to Q under “Equilibria”",
       difference_of(journal.verdicts(), "e/c"), count_agreeing(journal.laws)});
  table.row({"example 2: slider-crank, each parameter set",
             "the mechanism in minimal coordinates; the energy ledger: its checks A to K",
             difference_of(crank.verdicts(), "e/c"), count_agreeing(crank.cases)});
  table.row({"slider-crank with ideal joints", "closed form of reactions and moment; energy under a constant torque",
             difference_of({&crank.ideal_verdict}, "gudgeon pin's force"), agreement(crank.ideal_verdict)});
  table.row({"slider-crank in space", "the mechanism in minimal coordinates; its constraints; the energy ledger",
             difference_of({&content.space.verdict}, "e/c"), agreement(content.space.verdict)});
  std::size_t integrals = 0;
  std::size_t good_integrals = 0;
  std::size_t good_digits = 0;
  double largest_integral = 0;
  for (const LawCheck& law : content.laws.laws) {
    good_digits += law.rounding <= law.allowed;
    if (!law.quadrature) continue;
    ++integrals;
    good_integrals += law.quadrature->largest <= law.allowed;
    largest_integral = std::max(largest_integral, law.quadrature->largest);
  }
  table.row({"force laws", "quadrature of the pressure that each claims to integrate", scientific(largest_integral),
             verdict_cell(good_integrals == integrals, fmt::format("{} of {} agree", good_integrals, integrals))});
  table.row({"force laws in double precision", "the published formulas in 100 digits",
             scientific(largest(content.laws.laws, [](const LawCheck& law) { return law.rounding; })),
             verdict_cell(good_digits == content.laws.laws.size(),
                          fmt::format("{} of {} agree", good_digits, content.laws.laws.size()))});
  proofs_row(table, content.proofs);
  stability_row(table, content.stability);
  const bool good = content.passed() && content.stored_runs_are_right();
  return {"verdict", "What was checked, and the verdict",
          filled("verdict.html",
                 {{"look", good ? "good" : "bad"},
                  {"headline",
                   good ? "✓ Everything that was checked agrees. What was not checked is a dash."
                   : content.passed()
                       ? "✗ Everything that this run checked agrees, but some of the stored runs of stress are wrong: "
                         "see the table."
                       : "✗ Not everything agrees: see the table."},
                  {"checks", table.as_cards().html()},
                  {"ideal", checks_table("Ideal joints: what the letters stand for", {&crank.ideal_verdict})},
                  {"model", model_note(content)}})};
}

}  // namespace lubjoint::reports::page
