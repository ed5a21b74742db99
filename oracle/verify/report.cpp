#include "oracle/verify/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace lubjoint::verify {

namespace {

std::string joined_names(const std::vector<const Mistake*>& set) {
  std::string names;
  for (const Mistake* mistake : set) names += (names.empty() ? "" : " + ") + std::string(mistake->name);
  return names;
}

/// What a state's numbers should have been and were.
std::string compared_numbers(const Verification& v, std::size_t i) {
  std::string text;
  const auto& names = answer_columns(v.judgement.quantities);
  for (const std::size_t k : v.judgement.columns) {
    const Reference& reference = v.judgement.references[i];
    fmt::format_to(std::back_inserter(text), "  {:<{}} expected {:<25} received {:<25} tolerance {:.1e}\n", names[k],
                   is_table(v.judgement.quantities) ? 18 : 12, static_cast<double>(reference.expected[k]),
                   v.answers.values[i][k], tolerance_of(v.judgement, i, k));
  }
  return text;
}

/// Where an expected answer is certified.
std::string golden_place(const Verification& v, std::size_t i) {
  const GoldenAnswers::Row* row = v.judgement.references[i].golden;
  return row ? fmt::format("; certified: {}, line {}", v.states[i].golden->file, row->line) : "";
}

/// A dash where no state was decided.
std::string digits_text(double digits, bool any) { return any ? fmt::format("{:.1f}", digits) : "-"; }

std::string regime_table(const Judgement& judgement) {
  std::string text = fmt::format("\n{:<16}{:>8}{:>9}{:>11}{:>15}{:>15}\n", "regime", "states", "failing", "undecided",
                                 "digits, worst", "digits, median");
  for (const RegimeResult& r : judgement.regimes) {
    const bool decided = r.states > r.undecided;
    fmt::format_to(std::back_inserter(text), "{:<16}{:>8}{:>9}{:>11}{:>15}{:>15}\n",
                   regime_names[static_cast<std::size_t>(r.regime)], r.states, r.failing, r.undecided,
                   digits_text(r.worst_digits, decided), digits_text(r.median_digits, decided));
  }
  if (judgement.undecided > 0) {
    fmt::format_to(std::back_inserter(text),
                   "{} states are undecided: their inputs' rounding, or that of a published form's terms, leaves less "
                   "than two\ndigits of the answer in {}. They count neither as right nor as wrong.\n",
                   judgement.undecided, judgement.precision.words());
  }
  if (judgement.left_out > 0) {
    fmt::format_to(std::back_inserter(text),
                   "{} states are left out: in {} rounding decides on which side of the law's jump they lie, or can't "
                   "hold them.\n",
                   judgement.left_out, judgement.precision.words());
  }
  return text;
}

std::string decade_table(const DigitProfile& profile) {
  std::string text = fmt::format("\n{:<24}{:>8}{:>9}{:>11}{:>15}{:>15}\n", "film", "states", "failing", "undecided",
                                 "digits of 99 %", "digits, median");
  for (const DigitDecade& d : profile.decades) {
    const bool decided = d.states > d.undecided;
    fmt::format_to(std::back_inserter(text), "{:<24}{:>8}{:>9}{:>11}{:>15}{:>15}\n", d.where, d.states, d.failing,
                   d.undecided, digits_text(d.least, decided), digits_text(d.median, decided));
  }
  return text;
}

std::string columns_text(const Verification& v) {
  std::string text = "\nColumn by column:\n";
  for (const ColumnResult& column : v.columns) {
    fmt::format_to(std::back_inserter(text), "  {:<18} {}\n", column.name, column.words());
  }
  return text;
}

std::string domains_text(const Verification& v) {
  std::string text = domains_text(v.right_where, v.wrong_where, v.not_a_number_where);
  if (v.group && !v.group->where.empty()) {
    if (text.empty()) text = "\nWhere:\n";
    fmt::format_to(std::back_inserter(text), "  {:g} times the right answer where {}\n", v.group->factor,
                   words(v.group->where));
  }
  return text;
}

std::string suspicion_text(const Suspicion& s) {
  std::string text = fmt::format("  {:>5.1f} %  {}\n", 100 * s.share, joined_names(s.mistakes));
  for (const Mistake* mistake : s.mistakes) {
    fmt::format_to(std::back_inserter(text), "           {}\n", mistake->description);
  }
  if (s.precision > 0) {
    fmt::format_to(std::back_inserter(text), "           recognised to {:.0f} digits, as many as the answers have\n",
                   -std::log10(s.precision));
  }
  for (std::size_t i = 0; i < s.others.size() && i < 4; ++i) {
    fmt::format_to(std::back_inserter(text), "           or, not to be told from it: {}\n", joined_names(s.others[i]));
  }
  return text;
}

std::string suspicions_text(const Verification& v) {
  if (v.suspicions.empty()) {
    return "\nNo known mistake, alone or in a set of up to three, gives these answers (lubjoint verify "
           "--list-mistakes).\n";
  }
  std::string text =
      "\nLikely mistakes, with the share of the failing states that each explains; no right answer speaks "
      "against them:\n";
  for (const Suspicion& suspicion : v.suspicions) text += suspicion_text(suspicion);
  return text;
}

/// What a tolerance is a share of.
std::string_view what_is_a_share_of(const Judgement& j) {
  if (is_table(j.quantities)) return "each number's size";
  if (j.quantities == Quantities::extent) return "the angles' size";
  if (j.quantities != Quantities::pressure) return "the force";
  return is_solved_film(j.law) ? "the film's largest pressure" : "the size of the pressure's terms";
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  constexpr std::string_view names[] = {"agrees", "agrees_to_digits", "disagrees", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string headline(const Verification& v) {
  const Judgement& j = v.judgement;
  std::string law(name_of(j.law));
  for (const Law other : v.other_laws) law += ", or as well " + std::string(name_of(other));
  if (v.law_was_found) law += v.law_is_doubtful ? " (the nearest of all laws)" : " (found among all laws)";
  const std::string domain = v.settings.domain.empty() ? "" : " where " + v.settings.domain;
  const std::string precision = v.settings.tolerance > 0
                                    ? fmt::format("within {:g} of {}", v.settings.tolerance, what_is_a_share_of(j))
                                    : "in " + j.precision.words();
  const std::string open = j.undecided > 0 ? fmt::format(", {} undecided", j.undecided) : "";
  switch (v.verdict) {
    case Verdict::agrees:
      return fmt::format("agrees{}: {}, {} states{}, {}", domain, law, j.judged(), open, precision);
    case Verdict::agrees_to_digits:
      return fmt::format("agrees to {} digits{}{}: {}, {} states{}",
                         static_cast<int>(std::floor(v.digits.digits + 0.05)),
                         is_solved_film(j.law) ? "" : " where 1 - e/c >= 0.1", domain, law, j.judged(), open);
    case Verdict::disagrees:
      return fmt::format("disagrees{}: {}, {} of {} states fail{}, {}", domain, law, j.failing.size(), j.judged(), open,
                         precision);
    case Verdict::undecided:
      break;
  }
  if (j.judged() > 0 && j.not_numbers == j.judged()) {
    return fmt::format(
        "could not be judged: none of the {} answers is a number. Allowed are finite numbers (at e = 0 the "
        "radial direction is that of the velocity; at rest the force is zero)",
        j.judged());
  }
  return fmt::format("could not be judged: {}; {} of {} states are undecided in {}, more than {:g} %", law, j.undecided,
                     j.judged(), j.precision.words(), 100 * largest_undecided_share);
}

std::string terms_text(const std::vector<Term>& terms) {
  std::string text = "\nTerm by term (wedge: steady rotation in a bearing at rest; closing, opening: pure squeeze):\n";
  for (const Term& term : terms) {
    fmt::format_to(std::back_inserter(text), "  {:<11} {:<8} {}\n",
                   component_names[static_cast<std::size_t>(term.component)],
                   motion_kind_names[static_cast<std::size_t>(term.states)], term.words());
  }
  return text;
}

std::string domains_text(const Domain& right, const Domain& wrong, const Domain& not_a_number) {
  std::string text;
  if (!right.empty()) text += "  right where " + words(right) + '\n';
  if (!wrong.empty()) text += "  wrong where " + words(wrong) + '\n';
  if (!not_a_number.empty()) text += "  not a number where " + words(not_a_number) + '\n';
  return text.empty() ? "" : "\nWhere:\n" + text;
}

std::string text_report(const Verification& v) {
  std::string text = headline(v) + '\n' + regime_table(v.judgement);
  const bool simple = v.verdict == Verdict::agrees || v.verdict == Verdict::undecided;
  if (!simple) text += decade_table(v.digits);
  if (v.judgement.worst) {
    const std::size_t i = *v.judgement.worst;
    fmt::format_to(std::back_inserter(text), "\nWorst state ({}{}):\n{}\n{}\n{}",
                   regime_names[static_cast<std::size_t>(v.judgement.references[i].regime)], golden_place(v, i),
                   state_header(v.judgement.quantities), state_row(v.judgement.quantities, v.states[i], i + 1),
                   compared_numbers(v, i));
  }
  if (v.judgement.not_numbers > 0) {
    fmt::format_to(std::back_inserter(text), "\n{} of {} answers are not numbers.\n", v.judgement.not_numbers,
                   v.judgement.judged());
  }
  if (v.verdict == Verdict::disagrees) {
    text += domains_text(v);
    if (!v.terms.empty()) text += terms_text(v.terms);
    if (!v.columns.empty()) text += columns_text(v);
    text += suspicions_text(v);
  }
  return text + "\nNext: " + next_step(v) + '\n';
}

}  // namespace lubjoint::verify
