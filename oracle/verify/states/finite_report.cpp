#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "oracle/reynolds/film_onset.hpp"
#include "oracle/verify/report.hpp"
#include "oracle/verify/states/finite_film.hpp"

namespace lubjoint::verify {

namespace {

std::string names_of(const FiniteMistakes& mistakes) {
  std::string text;
  for (const FiniteMistake* each : mistakes) text += (text.empty() ? "" : " + ") + std::string(each->name);
  return text;
}

/// What was done, one sentence for each mistake.
std::string described(const FiniteSuspicion& suspicion) {
  std::string text;
  for (const FiniteMistake* each : suspicion.mistakes) {
    text += (text.empty() ? "" : " ") + std::string(each->description) + ".";
  }
  return text;
}

std::string suspicions_text(const std::vector<FiniteSuspicion>& suspicions) {
  std::string text =
      "\nLikely mistakes, with the share of the failing states that each explains; no right answer speaks against "
      "them:\n";
  for (const FiniteSuspicion& each : suspicions) {
    text += fmt::format("  {:5.1f} %  {}\n           {}\n", 100 * each.share, names_of(each.mistakes), described(each));
  }
  return text;
}

nlohmann::ordered_json suspicions_json(const std::vector<FiniteSuspicion>& suspicions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FiniteSuspicion& each : suspicions) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const FiniteMistake* mistake : each.mistakes) names.push_back(mistake->name);
    list.push_back({{"mistakes", names}, {"share", each.share}, {"contradicted", each.contradicted}});
  }
  return list;
}

/// "one", "one and two", "one, two and three".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::vector<std::string> words_of(const std::vector<FiniteClaim>& claims) {
  std::vector<std::string> list;
  for (const FiniteClaim& claim : claims) list.push_back(claim.words());
  return list;
}

nlohmann::ordered_json first_or_null(const std::vector<std::string>& names) {
  return names.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(names.front());
}

std::string next_step(const FiniteVerification& v) {
  if (v.verdict == Verdict::agrees) return "Nothing: every state that the solver decides is right.";
  const std::string named = v.suspicions.empty() ? std::string() : described(v.suspicions.front());
  if (v.factor) {
    return fmt::format("All answers are {:.6g} times the right ones.{}", *v.factor, named.empty() ? "" : " " + named);
  }
  if (!named.empty()) return named;
  if (!v.others.empty()) return "The answers are those of " + listed(words_of(v.others)) + ".";
  if (!v.laws.empty()) {
    return fmt::format("The answers are those of the law{} {}, not of the film of the bearing's length.",
                       v.laws.size() > 1 ? "s" : "", listed(v.laws));
  }
  if (v.verdict == Verdict::agrees_to_digits) {
    return fmt::format("Right to {:.1g} of |F|: if it is meant to be numerical, say --tolerance {:.0e}.",
                       v.worst_error(), std::pow(10.0, std::ceil(std::log10(v.worst_error()))));
  }
  if (v.count(Outcome::not_a_number) > 0) {
    return "Why some answers are no numbers: run the program on one of the states by itself.";
  }
  if (v.verdict == Verdict::undecided)
    return "The solver decides too few of these states at this tolerance: --tolerance says another one.";
  return "The worst state, step by step.";
}

/// Of those that are decided, if any is.
std::size_t worst_state(const FiniteVerification& v) {
  const bool any = std::ranges::any_of(v.comparisons, &FiniteComparison::is_decided);
  const auto worst = std::ranges::max_element(
      v.comparisons, {}, [&](const FiniteComparison& c) { return any && !c.is_decided() ? -1.0 : c.error; });
  return static_cast<std::size_t>(worst - v.comparisons.begin());
}

std::string verdict_words(const FiniteVerification& v) {
  switch (v.verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::agrees_to_digits:
      return fmt::format("agrees to {:.1g} of |F|", v.worst_error());
    case Verdict::disagrees:
      return "disagrees";
    case Verdict::undecided:
      break;
  }
  return "could not be judged";
}

std::string headline_of(const FiniteVerification& v) {
  const std::size_t failing = v.count(Outcome::wrong) + v.count(Outcome::not_a_number);
  return fmt::format("{}: {}{}, {} states, {} failing, {} undecided; right is an error of {:.0e} of |F|",
                     verdict_words(v), v.claim.words(), v.domain.empty() ? "" : " where " + v.domain,
                     v.states.size() - v.count(Outcome::left_out), failing, v.count(Outcome::undecided), v.tolerance);
}

}  // namespace

std::string text_report(const FiniteVerification& v) {
  std::string text = headline_of(v) + "\n\n";
  text += "L/D     states  failing  undecided  error, median  error, worst\n";
  for (const double shape : finite_shapes) {
    std::vector<double> errors;
    std::size_t states = 0, wrong = 0, undecided = 0;
    for (std::size_t i = 0; i < v.states.size(); ++i) {
      if (std::abs(v.states[i].length / (2 * v.states[i].radius) - shape) > 1e-9) continue;
      const FiniteComparison& c = v.comparisons[i];
      if (c.outcome == Outcome::left_out) continue;
      ++states;
      undecided += c.outcome == Outcome::undecided ? 1 : 0;
      wrong += c.outcome == Outcome::wrong || c.outcome == Outcome::not_a_number ? 1 : 0;
      if (c.is_decided()) errors.push_back(c.error);
    }
    if (states == 0) continue;
    std::ranges::sort(errors);
    const auto shown = [&](std::size_t i) {
      return errors.empty() ? std::string("-") : fmt::format("{:.1e}", errors[i]);
    };
    text += fmt::format("{:<8g}{:6d}{:9d}{:11d}{:>15}{:>14}\n", shape, states, wrong, undecided,
                        shown(errors.size() / 2), shown(errors.size() - 1));
  }
  if (const std::size_t left_out = v.count(Outcome::left_out)) {
    text += fmt::format("{} states are left out: rounding decides on which side of the half film's jump they lie.\n",
                        left_out);
  }
  if (v.verdict != Verdict::agrees) {
    const std::size_t i = worst_state(v);
    const FiniteComparison& c = v.comparisons[i];
    text += "\nWorst state:\n" + state_header(v.quantities) + "\n" + state_row(v.quantities, v.states[i], i + 1) + "\n";
    for (std::size_t k = 0; k < 2; ++k) {
      text += fmt::format("  {:<11} expected {:<22.9g} received {:<22.9g} solver's bound {:.0e} of |F|\n",
                          answer_columns(v.quantities)[k], c.expected[static_cast<Eigen::Index>(k)],
                          v.answers.values[i][k], c.bound);
    }
  }
  text += domains_text(v.right_where, v.wrong_where, v.not_a_number_where);
  if (!v.terms.empty()) text += terms_text(v.terms);
  if (!v.suspicions.empty()) text += suspicions_text(v.suspicions);
  return text + "\nNext: " + next_step(v) + "\n";
}

nlohmann::ordered_json json_report(const FiniteVerification& v) {
  const double worst = v.worst_error();
  return {{"verdict", verdict_name(v.verdict)},
          {"message", headline_of(v)},
          {"accepted", v.accepted()},
          {"law", oracle::name_of(v.claim.film)},
          {"onset", oracle::name_of(v.claim.onset)},
          {"quantities", name_of(v.quantities)},
          {"domain", v.domain},
          {"digits", worst > 0 ? nlohmann::ordered_json(-std::log10(worst)) : nlohmann::ordered_json(nullptr)},
          {"tolerance", v.tolerance},
          {"states", v.states.size() - v.count(Outcome::left_out)},
          {"failing", v.count(Outcome::wrong) + v.count(Outcome::not_a_number)},
          {"undecided", v.count(Outcome::undecided)},
          {"left_out", v.count(Outcome::left_out)},
          {"not_numbers", v.count(Outcome::not_a_number)},
          {"right_where", domain_json(v.right_where)},
          {"wrong_where", domain_json(v.wrong_where)},
          {"not_a_number_where", domain_json(v.not_a_number_where)},
          {"terms", terms_json(v.terms)},
          {"columns", nlohmann::ordered_json::array()},
          {"factor", v.factor ? nlohmann::ordered_json(*v.factor) : nlohmann::ordered_json(nullptr)},
          {"other", first_or_null(words_of(v.others))},
          {"other_films", words_of(v.others)},
          {"law_of_answers", first_or_null(v.laws)},
          {"laws_of_answers", v.laws},
          {"suspects", suspicions_json(v.suspicions)},
          {"next", next_step(v)}};
}

}  // namespace lubjoint::verify
