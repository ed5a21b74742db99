#include "oracle/results/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "oracle/files/quoted_csv.hpp"

namespace lubjoint::reports {

namespace {

constexpr const char* dash = "–";

std::string with_unit(std::string number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

/// Words into lines of a width, all but the first indented. Counted in bytes: the few letters beyond ASCII make a line
/// shorter than it could be.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string word;
  std::string result;
  std::size_t column = 0;
  while (words >> word) {
    if (column > 0 && column + 1 + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result + "\n";
}

const char* outcome_word(CheckOutcome outcome) {
  switch (outcome) {
    case CheckOutcome::passed:
      return "passed";
    case CheckOutcome::failed:
      return "failed";
    case CheckOutcome::not_checked:
      break;
  }
  return "not checked";
}

}  // namespace

Check Check::at_most(std::string what, std::string against, double value, double limit, std::string unit,
                     std::string reason) {
  const bool good = std::abs(value) <= limit;  // false for a value that is not a number
  return {std::move(what),
          std::move(against),
          value,
          limit,
          std::move(unit),
          "",
          std::move(reason),
          good ? CheckOutcome::passed : CheckOutcome::failed};
}

Check Check::holds(std::string what, std::string against, bool good, std::string found, std::string reason) {
  return {std::move(what),
          std::move(against),
          {},
          {},
          "",
          std::move(found),
          std::move(reason),
          good ? CheckOutcome::passed : CheckOutcome::failed};
}

Check Check::not_checked(std::string what, std::string reason) {
  return {std::move(what), "", {}, {}, "", "", std::move(reason), CheckOutcome::not_checked};
}

std::string Check::words() const {
  if (outcome == CheckOutcome::not_checked) return what + ": not checked, " + reason;
  if (!value) return what + ": " + found;
  return fmt::format("{}: {}, allowed {:.0e}", what, with_unit(fmt::format("{:.1e}", *value), unit), limit.value_or(0));
}

std::size_t Verdict::count(CheckOutcome outcome) const {
  return static_cast<std::size_t>(
      std::count_if(checks.begin(), checks.end(), [&](const Check& check) { return check.outcome == outcome; }));
}

std::vector<std::string> Verdict::failures() const {
  std::vector<std::string> words;
  for (const Check& check : checks) {
    if (check.outcome == CheckOutcome::failed) words.push_back(check.words());
  }
  return words;
}

std::string check_letter(std::size_t i) {
  if (i >= 26) throw std::logic_error("more checks than letters");
  return std::string(1, static_cast<char>('A' + i));
}

std::string Verdict::in_letters() const {
  if (failed()) {
    std::string text = "NO:";
    for (std::size_t i = 0; i < checks.size(); ++i) {
      if (checks[i].outcome == CheckOutcome::failed) text += fmt::format(" {} {};", check_letter(i), checks[i].words());
    }
    return text;
  }
  if (!agrees()) return dash;
  std::string letters;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    letters += checks[i].outcome == CheckOutcome::passed ? check_letter(i) : dash;
  }
  return "yes " + letters;
}

std::string Verdict::in_a_word() const {
  if (failed()) return "no";
  return agrees() ? "yes" : "-";
}

std::vector<CheckSummary> summary_of_checks(const std::vector<const Verdict*>& verdicts) {
  std::vector<CheckSummary> legend;
  if (verdicts.empty()) return legend;
  const std::size_t count = verdicts.front()->checks.size();
  for (std::size_t i = 0; i < count; ++i) {
    CheckSummary line;
    line.letter = check_letter(i);
    const Check* worst = nullptr;
    double least_limit = 0;
    double most_limit = 0;
    for (const Verdict* verdict : verdicts) {
      if (verdict->checks.size() != count) throw std::logic_error("items of a table with different checks");
      const Check& check = verdict->checks[i];
      if (line.what.empty()) line.what = check.what;
      if (check.what != line.what) throw std::logic_error("items of a table with different checks");
      line.passed += check.outcome == CheckOutcome::passed;
      line.failed += check.outcome == CheckOutcome::failed;
      line.not_checked += check.outcome == CheckOutcome::not_checked;
      if (check.outcome == CheckOutcome::not_checked) {
        if (line.reason.empty()) line.reason = check.reason;
        continue;
      }
      if (line.against.empty()) line.against = check.against;
      if (!check.value) {
        line.reason = check.reason;
        continue;
      }
      const bool first = worst == nullptr;
      least_limit = first ? *check.limit : std::min(least_limit, *check.limit);
      most_limit = first ? *check.limit : std::max(most_limit, *check.limit);
      // What is not a number is the worst there is.
      if (first || std::isnan(*check.value) || std::abs(*check.value) > std::abs(*worst->value)) worst = &check;
      line.reason = worst->reason;
    }
    line.largest = worst ? with_unit(fmt::format("{:.1e}", std::abs(*worst->value)), worst->unit) : dash;
    line.allowed = dash;
    if (worst && least_limit == most_limit) line.allowed = with_unit(fmt::format("{:.0e}", most_limit), worst->unit);
    if (worst && least_limit != most_limit) {
      line.allowed = with_unit(fmt::format("{:.0e} to {:.0e}", least_limit, most_limit), worst->unit);
    }
    legend.push_back(std::move(line));
  }
  return legend;
}

std::string check_legend(const std::vector<const Verdict*>& verdicts) {
  std::string text;
  for (const CheckSummary& line : summary_of_checks(verdicts)) {
    std::string words = line.what;
    if (line.passed + line.failed > 0) words += ", against " + line.against;
    if (line.largest != dash) {
      words += fmt::format(": at most {}; allowed {}, {}", line.largest, line.allowed, line.reason);
    } else {
      words += ": " + line.reason;
    }
    if (line.not_checked > 0 && line.passed + line.failed > 0) {
      words += fmt::format(" (not checked for {} of {})", line.not_checked, verdicts.size());
    }
    text += line.letter + "  " + wrapped(words, 115, 3);
  }
  return text;
}

std::string checks_csv(const std::vector<std::string>& items, const std::vector<const Verdict*>& verdicts) {
  if (items.size() != verdicts.size()) throw std::logic_error("checks_csv: as many items as verdicts");
  std::string csv = "item,check,what,outcome,value,limit,unit,found,against,reason\n";
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; };
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (std::size_t i = 0; i < verdicts[k]->checks.size(); ++i) {
      const Check& check = verdicts[k]->checks[i];
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", items[k], check_letter(i), quoted_field(check.what),
                         outcome_word(check.outcome), number(check.value), number(check.limit), check.unit,
                         quoted_field(check.found), quoted_field(check.against), quoted_field(check.reason));
    }
  }
  return csv;
}

}  // namespace lubjoint::reports
