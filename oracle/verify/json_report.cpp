#include <cmath>
#include <nlohmann/json.hpp>

#include "oracle/verify/report.hpp"

namespace lubjoint::verify {

using nlohmann::json;

namespace {

json names_json(const std::vector<const Mistake*>& set) {
  json names = json::array();
  for (const Mistake* mistake : set) names.push_back(std::string(mistake->name));
  return names;
}

json number_or_null(double x) { return std::isfinite(x) ? json(x) : json(); }

json state_json(const Verification& v, std::size_t i) {
  json inputs;
  for (const StateColumn& column : state_columns(v.judgement.quantities)) {
    inputs[std::string(column.name)] = v.states[i].*column.value;
  }
  json expected, received, tolerance;
  const auto& names = answer_columns(v.judgement.quantities);
  for (const std::size_t k : v.judgement.columns) {
    const std::string name(names[k]);
    expected[name] = static_cast<double>(v.judgement.references[i].expected[k]);
    received[name] = number_or_null(v.answers.values[i][k]);
    tolerance[name] = tolerance_of(v.judgement, i, k);
  }
  json certified;
  if (const GoldenAnswers::Row* row = v.judgement.references[i].golden) {
    certified = {{"file", v.states[i].golden->file}, {"line", row->line}};
  }
  return {{"id", i + 1},          {"inputs", inputs},       {"expected", expected},
          {"received", received}, {"tolerance", tolerance}, {"certified", certified}};
}

json regimes_json(const Judgement& judgement) {
  json list = json::array();
  for (const RegimeResult& r : judgement.regimes) {
    const bool decided = r.states > r.undecided;
    list.push_back({{"regime", std::string(regime_names[static_cast<std::size_t>(r.regime)])},
                    {"states", r.states},
                    {"failing", r.failing},
                    {"undecided", r.undecided},
                    {"worst_digits", decided ? json(r.worst_digits) : json()},
                    {"median_digits", decided ? json(r.median_digits) : json()}});
  }
  return list;
}

json decades_json(const DigitProfile& profile) {
  json list = json::array();
  for (const DigitDecade& d : profile.decades) {
    const bool decided = d.states > d.undecided;
    list.push_back({{"where", d.where},
                    {"states", d.states},
                    {"failing", d.failing},
                    {"undecided", d.undecided},
                    {"digits", decided ? json(d.least) : json()},
                    {"median_digits", decided ? json(d.median) : json()}});
  }
  return list;
}

json columns_json(const std::vector<ColumnResult>& columns) {
  json list = json::array();
  for (const ColumnResult& column : columns) {
    list.push_back({{"column", std::string(column.name)},
                    {"verdict", std::string(column_verdict_names[static_cast<std::size_t>(column.verdict)])},
                    {"states", column.states},
                    {"failing", column.failing},
                    {"digits", column.states > 0 ? json(column.digits) : json()},
                    {"factor", column.factor ? number_or_null(*column.factor) : json()},
                    {"factor_text", column.factor_text},
                    {"other", column.other.empty() ? json() : json(std::string(column.other))}});
  }
  return list;
}

/// The columns that were judged.
json judged_json(const Judgement& judgement) {
  json names = json::array();
  for (const std::size_t k : judgement.columns) names.push_back(std::string(answer_columns(judgement.quantities)[k]));
  return names;
}

/// What the failing states have in common, in words.
json pattern_json(const Verification& v) {
  json facts = json::array();
  if (v.verdict != Verdict::disagrees) return facts;
  if (!v.right_where.empty()) facts.push_back("right where " + words(v.right_where));
  if (!v.wrong_where.empty()) facts.push_back("wrong where " + words(v.wrong_where));
  if (!v.not_a_number_where.empty()) facts.push_back("not a number where " + words(v.not_a_number_where));
  for (const ColumnResult& column : v.columns) {
    if (column.verdict != ColumnVerdict::undecided) facts.push_back(std::string(column.name) + ": " + column.words());
  }
  for (const Term& term : v.terms) {
    if (term.verdict == TermVerdict::undecided) continue;
    facts.push_back(std::string(component_names[static_cast<std::size_t>(term.component)]) + " force, " +
                    std::string(motion_kind_names[static_cast<std::size_t>(term.states)]) + ": " + term.words());
  }
  return facts;
}

}  // namespace

json domain_json(const Domain& domain) {
  json list = json::array();
  for (const Conjunction& conjunction : domain) {
    json all = json::array();
    for (const Condition& condition : conjunction) all.push_back(condition.words());
    list.push_back(all);
  }
  return list;
}

json terms_json(const std::vector<Term>& terms) {
  json list = json::array();
  for (const Term& term : terms) {
    list.push_back({{"component", std::string(component_names[static_cast<std::size_t>(term.component)])},
                    {"states", std::string(motion_kind_names[static_cast<std::size_t>(term.states)])},
                    {"verdict", std::string(term_verdict_names[static_cast<std::size_t>(term.verdict)])},
                    {"digits", term.digits},
                    {"part", term.part.empty() ? json() : json(term.part)},
                    {"factor", term.factor && std::isfinite(*term.factor) ? json(*term.factor) : json()},
                    {"factor_text", term.factor_text},
                    {"exponents", term.exponents.empty() ? json() : json(term.exponents)}});
  }
  return list;
}

json json_report(const Verification& v) {
  const Judgement& j = v.judgement;
  json other_laws = json::array();
  for (const Law law : v.other_laws) other_laws.push_back(std::string(name_of(law)));
  json report = {{"verdict", std::string(verdict_name(v.verdict))},
                 {"message", headline(v)},
                 {"accepted", v.accepted()},
                 {"digits", v.verdict == Verdict::undecided ? json() : json(v.digits.digits)},
                 {"law", std::string(name_of(j.law))},
                 {"law_was_found", v.law_was_found},
                 {"law_is_doubtful", v.law_is_doubtful},
                 {"other_laws", other_laws},
                 {"law_distance", number_or_null(v.law_distance)},
                 {"quantities", std::string(name_of(j.quantities))},
                 {"domain", v.settings.domain},
                 {"tolerance", v.settings.tolerance},
                 {"precision", j.precision.words()},
                 {"states", j.judged()},
                 {"left_out", j.left_out},
                 {"undecided", j.undecided},
                 {"failing", j.failing.size()},
                 {"not_numbers", j.not_numbers},
                 {"regimes", regimes_json(j)},
                 {"decades", decades_json(v.digits)},
                 {"right_where", domain_json(v.right_where)},
                 {"wrong_where", domain_json(v.wrong_where)},
                 {"not_a_number_where", domain_json(v.not_a_number_where)},
                 {"factor_group", nullptr},
                 {"terms", terms_json(v.terms)},
                 {"judged", judged_json(j)},
                 {"columns", columns_json(v.columns)},
                 {"suspects", json::array()},
                 {"worst", nullptr},
                 {"mistakes", json::array()},
                 {"pattern", pattern_json(v)},
                 {"next", next_step(v)}};
  if (v.group) {
    report["factor_group"] = {
        {"factor", v.group->factor}, {"states", v.group->members.size()}, {"where", domain_json(v.group->where)}};
  }
  if (j.worst) report["worst"] = state_json(v, *j.worst);
  for (const Suspicion& s : v.suspicions) {
    json descriptions = json::array(), others = json::array();
    for (const Mistake* mistake : s.mistakes) descriptions.push_back(std::string(mistake->description));
    for (const auto& set : s.others) others.push_back(names_json(set));
    report["suspects"].push_back({{"mistakes", names_json(s.mistakes)},
                                  {"equivalent", others},
                                  {"share", s.share},
                                  {"contradicted", s.contradicted},
                                  {"precision", s.precision}});
    report["mistakes"].push_back({{"names", names_json(s.mistakes)},
                                  {"descriptions", descriptions},
                                  {"equivalent", others},
                                  {"share", s.share},
                                  {"contradicted", s.contradicted}});
  }
  return report;
}

}  // namespace lubjoint::verify
