#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "oracle/page/sections.hpp"

namespace lubjoint::reports::page {

Cell agreement(const Verdict& verdict) {
  if (verdict.failed()) {
    std::string words;
    for (const std::string& failure : verdict.failures()) words += (words.empty() ? "" : "; ") + failure;
    return verdict_cell(false, words);
  }
  if (!verdict.agrees()) return {"–"};
  return verdict_cell(true, verdict.in_letters().substr(std::string_view("yes ").size()));
}

std::string checks_table(const std::string& caption, const std::vector<const Verdict*>& verdicts) {
  Table table(caption, {{"", {}, false},
                        {"what", {}, false},
                        {"against", {}, false},
                        {"largest difference"},
                        {"allowed"},
                        {"because", {}, false},
                        {"outcome", {}, false}});
  for (const CheckSummary& line : summary_of_checks(verdicts)) {
    std::string outcome;
    const auto add = [&](std::size_t count, const char* words) {
      if (count > 0) outcome += fmt::format("{}{} {}", outcome.empty() ? "" : ", ", count, words);
    };
    add(line.failed, "failed");
    add(line.passed, "passed");
    add(line.not_checked, "not checked");
    const bool checked = line.passed + line.failed > 0;
    table.row({line.letter, line.what, checked ? with_powers(line.against) : "–", with_powers(line.largest),
               with_powers(line.allowed), with_powers(line.reason),
               checked ? verdict_cell(line.failed == 0, outcome) : Cell("–")});
  }
  return table.as_cards().html();
}

std::string checked_words(const std::vector<const Verdict*>& verdicts, const std::vector<std::string>& whats) {
  const std::vector<CheckSummary> lines = summary_of_checks(verdicts);
  std::string words;
  bool good = true;
  for (const std::string& what : whats) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& each) { return each.what == what; });
    if (line == lines.end()) throw std::logic_error("no check is called \"" + what + "\"");
    if (line->passed + line->failed == 0) {
      words += fmt::format("{}{} not at all: {}", words.empty() ? "" : "; ", what, line->reason);
      continue;
    }
    good = good && line->failed == 0;
    words += fmt::format("{}{} against {}", words.empty() ? "" : "; ", what, with_powers(line->against));
    if (line->largest != "–") {  // words were compared
      words += fmt::format(", at most {} (allowed {})", with_powers(line->largest), with_powers(line->allowed));
    }
  }
  return fmt::format("<p class=\"{}\"><span class=\"who\">Checked:</span> {}. {}</p>\n",
                     good ? "checked" : "checked bad", escaped(words), good ? "✓" : "✗");
}

}  // namespace lubjoint::reports::page
