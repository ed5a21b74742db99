#include "oracle/verify/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "lubjoint/film/law_list.hpp"

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
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Reference& reference = v.judgement.references[i];
    fmt::format_to(std::back_inserter(text), "  {:<12} expected {:<25} received {:<25} tolerance {:.1e}\n", names[k],
                   static_cast<double>(reference.expected[k]), v.answers.values[i][k],
                   v.judgement.precision.tolerance(reference, k));
  }
  return text;
}

std::string headline(const Verification& v) {
  const std::string law(name_of(v.judgement.law));
  const std::size_t all = v.judgement.judged();
  const std::size_t failing = v.judgement.failing.size();
  const std::string found = v.law_was_found ? " (found among all laws)" : "";
  switch (v.verdict()) {
    case Verdict::agrees:
      return fmt::format("agrees: {}{}, {} states, in {}", law, found, all, v.judgement.precision.words());
    case Verdict::disagrees:
      return fmt::format("disagrees: {}{}, {} of {} states fail, in {}", law, found, failing, all,
                         v.judgement.precision.words());
    case Verdict::unjudged:
      break;
  }
  return fmt::format(
      "could not be judged: {} of {} answers are not numbers; the others agree with {}{}. Allowed are finite numbers "
      "(at e = 0 the radial direction is that of the velocity; at rest the force is zero)",
      failing, all, law, found);
}

/// Where an expected answer is certified.
std::string golden_place(const Verification& v, std::size_t i) {
  const GoldenAnswers::Row* row = v.judgement.references[i].golden;
  return row ? fmt::format("; certified: {}, line {}", v.states[i].golden->file, row->line) : "";
}

std::string regime_table(const Judgement& judgement) {
  std::string text =
      fmt::format("\n{:<16}{:>8}{:>9}{:>15}{:>15}\n", "regime", "states", "failing", "digits, worst", "digits, median");
  for (const RegimeResult& r : judgement.regimes) {
    fmt::format_to(std::back_inserter(text), "{:<16}{:>8}{:>9}{:>15.1f}{:>15.1f}\n",
                   regime_names[static_cast<std::size_t>(r.regime)], r.states, r.failing, r.worst_digits,
                   r.median_digits);
  }
  if (judgement.left_out > 0) {
    fmt::format_to(std::back_inserter(text), "{} golden states can't be decided in {} and are left out.\n",
                   judgement.left_out, judgement.precision.words());
  }
  return text;
}

std::string suspicion_text(const Suspicion& s) {
  std::string text = fmt::format("  {:>5.1f} %  {}\n", 100 * s.share, joined_names(s.mistakes));
  for (const Mistake* mistake : s.mistakes) {
    fmt::format_to(std::back_inserter(text), "           {}\n", mistake->description);
  }
  for (std::size_t i = 0; i < s.others.size() && i < 4; ++i) {
    fmt::format_to(std::back_inserter(text), "           or, not to be told from it: {}\n", joined_names(s.others[i]));
  }
  if (s.contradicted > 0.005) {
    text += "           but it would also have shown where the answers are right\n";
  }
  return text;
}

std::string diagnosis_text(const Diagnosis& diagnosis) {
  std::string text;
  if (diagnosis.suspicions.empty()) {
    text += "\nNo known mistake, alone or in pairs, gives these answers (lubjoint verify --list-mistakes).\n";
  } else {
    text += "\nLikely mistakes, with the share of the failing states that each explains:\n";
    for (const Suspicion& suspicion : diagnosis.suspicions) text += suspicion_text(suspicion);
  }
  if (!diagnosis.pattern.facts.empty()) text += "\nThe failing states:\n";
  for (const std::string& fact : diagnosis.pattern.facts) text += "  " + fact + '\n';
  return text;
}

nlohmann::json names_json(const std::vector<const Mistake*>& set) {
  nlohmann::json names = nlohmann::json::array();
  for (const Mistake* mistake : set) names.push_back(std::string(mistake->name));
  return names;
}

nlohmann::json state_json(const Verification& v, std::size_t i) {
  nlohmann::json inputs;
  for (const StateColumn& column : state_columns(v.judgement.quantities)) {
    inputs[std::string(column.name)] = v.states[i].*column.value;
  }
  nlohmann::json expected, received, tolerance;
  const auto& names = answer_columns(v.judgement.quantities);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name(names[k]);
    expected[name] = static_cast<double>(v.judgement.references[i].expected[k]);
    const double given = v.answers.values[i][k];
    received[name] = std::isnan(given) ? nlohmann::json() : nlohmann::json(given);
    tolerance[name] = v.judgement.precision.tolerance(v.judgement.references[i], k);
  }
  nlohmann::json certified;
  if (const GoldenAnswers::Row* row = v.judgement.references[i].golden) {
    certified = {{"file", v.states[i].golden->file}, {"line", row->line}};
  }
  return {{"id", i + 1},          {"inputs", inputs},       {"expected", expected},
          {"received", received}, {"tolerance", tolerance}, {"certified", certified}};
}

bool has_answers(Quantities quantities, Law law) {
  return quantities != Quantities::pressure || law != Law::pinkus_sternlicht;
}

}  // namespace

Verdict Verification::verdict() const {
  if (judgement.agrees()) return Verdict::agrees;
  return judgement.unjudged() ? Verdict::unjudged : Verdict::disagrees;
}

Verification verify_answers(Quantities quantities, const std::string& law, std::vector<State> states, Answers answers) {
  const bool find = law == "auto";
  std::vector<Law> laws;
  if (find) {
    for (std::size_t i = 0; i < law_count; ++i) {
      if (!has_answers(quantities, static_cast<Law>(i))) continue;
      laws.push_back(static_cast<Law>(i));
    }
  } else {
    laws.push_back(law_of(law));
    if (!has_answers(quantities, laws[0])) {
      throw std::invalid_argument("law " + law + " is not the integral of any pressure field: --quantities " +
                                  std::string(name_of(quantities)) + " allows every other law");
    }
  }
  std::vector<Judgement> judged;
  for (const Law candidate : laws) {
    judged.push_back(judge(quantities, candidate, states, answers));
    if (!judged.back().agrees() && !judged.back().unjudged()) continue;
    return {std::move(judged.back()), std::move(states), std::move(answers), {}, find};
  }
  // No law agrees: the one in whose mistakes the answers are recognised; a mistake that is another law does not count.
  std::optional<Diagnosis> best;
  double best_score = -1;
  std::size_t place = 0;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    Diagnosis diagnosis = diagnose(judged[i], states, answers);
    double score = 0;
    for (const Suspicion& s : diagnosis.suspicions) {
      bool changes_law = false;
      for (const Mistake* mistake : s.mistakes) changes_law = changes_law || mistake->name.starts_with("law_");
      if (find && changes_law) continue;
      // Two mistakes explain less than one that does as much.
      score = std::max(score, (s.share - s.contradicted) * (s.mistakes.size() == 1 ? 1 : 0.9));
    }
    score += 1e-3 * (1 - static_cast<double>(judged[i].failing.size()) / static_cast<double>(judged[i].judged()));
    if (score <= best_score) continue;
    best_score = score;
    best = std::move(diagnosis);
    place = i;
  }
  return {std::move(judged[place]), std::move(states), std::move(answers), std::move(best), find};
}

std::string text_report(const Verification& v) {
  std::string text = headline(v) + '\n' + regime_table(v.judgement);
  if (v.judgement.worst) {
    const std::size_t i = *v.judgement.worst;
    fmt::format_to(std::back_inserter(text), "\nWorst state ({}{}):\n{}\n{}\n{}",
                   regime_names[static_cast<std::size_t>(v.judgement.references[i].regime)], golden_place(v, i),
                   state_header(v.judgement.quantities), state_row(v.judgement.quantities, v.states[i], i + 1),
                   compared_numbers(v, i));
  }
  if (v.judgement.not_numbers > 0 && v.verdict() == Verdict::disagrees) {
    fmt::format_to(std::back_inserter(text), "\n{} answers are not numbers.\n", v.judgement.not_numbers);
  }
  if (v.diagnosis) text += diagnosis_text(*v.diagnosis);
  return text;
}

nlohmann::json json_report(const Verification& v) {
  constexpr const char* words[] = {"agrees", "disagrees", "could not be judged"};
  nlohmann::json report = {{"verdict", words[static_cast<int>(v.verdict())]},
                           {"message", headline(v)},
                           {"law", std::string(name_of(v.judgement.law))},
                           {"quantities", std::string(name_of(v.judgement.quantities))},
                           {"precision", v.judgement.precision.words()},
                           {"states", v.judgement.judged()},
                           {"left_out", v.judgement.left_out},
                           {"failing", v.judgement.failing.size()},
                           {"not_numbers", v.judgement.not_numbers},
                           {"regimes", nlohmann::json::array()},
                           {"worst", nullptr},
                           {"mistakes", nlohmann::json::array()},
                           {"pattern", nlohmann::json::array()}};
  for (const RegimeResult& r : v.judgement.regimes) {
    report["regimes"].push_back({{"regime", std::string(regime_names[static_cast<std::size_t>(r.regime)])},
                                 {"states", r.states},
                                 {"failing", r.failing},
                                 {"worst_digits", r.worst_digits},
                                 {"median_digits", r.median_digits}});
  }
  if (v.judgement.worst) report["worst"] = state_json(v, *v.judgement.worst);
  if (!v.diagnosis) return report;
  for (const Suspicion& s : v.diagnosis->suspicions) {
    nlohmann::json descriptions = nlohmann::json::array();
    for (const Mistake* mistake : s.mistakes) descriptions.push_back(std::string(mistake->description));
    nlohmann::json others = nlohmann::json::array();
    for (const auto& set : s.others) others.push_back(names_json(set));
    report["mistakes"].push_back({{"names", names_json(s.mistakes)},
                                  {"descriptions", descriptions},
                                  {"equivalent", others},
                                  {"share", s.share},
                                  {"contradicted", s.contradicted}});
  }
  report["pattern"] = v.diagnosis->pattern.facts;
  return report;
}

}  // namespace lubjoint::verify
