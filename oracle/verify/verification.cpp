#include "oracle/verify/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lubjoint/film/law_list.hpp"

namespace lubjoint::verify {

namespace {

bool has_answers(Quantities quantities, Law law) {
  if (is_solved_film(law)) {
    if (quantities == Quantities::extent) return law != "finite_reynolds"_law;
    return is_table(quantities) || quantities == Quantities::wrench || quantities == Quantities::transition ||
           quantities == Quantities::pressure;
  }
  if (is_contact_law(law) || quantities == Quantities::contact) {
    return is_contact_law(law) && quantities == Quantities::contact;
  }
  if (is_of_load(quantities)) return !facts_of(law).squeeze_only;
  return quantities != Quantities::pressure || law != "pinkus_sternlicht"_law;
}

/// Error over |F| of the worst number; infinite for NaN, none where nothing moves or the precision says nothing.
std::optional<double> relative_error(const Judgement& judgement, const Answers& answers, std::size_t i) {
  const Reference& r = judgement.references[i];
  if (judgement.comparisons[i].left_out() || !(r.size[judgement.first_column()] > 0)) return {};
  if (judgement.comparisons[i].outcome == Outcome::not_a_number) return INFINITY;
  double error = 0;
  for (const std::size_t k : judgement.columns) {
    if (r.size[k] > 0)
      error = std::max(error, static_cast<double>(std::abs(answers.values[i][k] - r.expected[k])) / r.size[k]);
  }
  return error;
}

double median_distance(const Judgement& judgement, const Answers& answers) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < judgement.references.size(); ++i) {
    const auto error = relative_error(judgement, answers, i);
    if (error && std::isfinite(*error)) errors.push_back(*error);
  }
  if (errors.empty()) return INFINITY;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::ranges::nth_element(errors, middle);
  return *middle;
}

/// The error below which a numerical program's answers count as right: the least that leaves nearly as many as two
/// digits do; 0 where enough are right to rounding.
double error_of_right_answers(const Judgement& judgement, const Answers& answers) {
  std::size_t right = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < judgement.references.size(); ++i) {
    const auto error = relative_error(judgement, answers, i);
    if (!error || judgement.references[i].gap < 0.1) continue;
    if (judgement.comparisons[i].right()) ++right;
    errors.push_back(*error);
  }
  const auto within = [&](double limit) { return std::ranges::count_if(errors, [=](double e) { return e <= limit; }); };
  const auto two_digits = within(1e-2);
  if (2 * static_cast<std::ptrdiff_t>(right) >= two_digits) return 0;
  for (const double limit : {1e-8, 1e-6, 1e-5, 1e-4, 1e-3}) {
    if (10 * within(limit) >= 9 * two_digits) return limit;
  }
  return 1e-2;
}

void locate(Verification& v) {
  const double right_error = error_of_right_answers(v.judgement, v.answers);
  std::vector<int> right, wrong, none;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    const Comparison& c = v.judgement.comparisons[i];
    const auto error = relative_error(v.judgement, v.answers, i);
    // Where a state's own tolerance is coarse, a wrong answer may be right by chance.
    constexpr double sharp = 1e-7;
    const Reference& reference = v.judgement.references[i];
    const std::size_t first = v.judgement.first_column();
    const bool decides = error && v.judgement.precision.tolerance(reference, first) <=
                                      std::max({sharp, 1e3 * v.judgement.precision.roundoff, v.judgement.accepted}) *
                                          reference.size[first];
    const bool matters =
        decides && c.outcome != Outcome::undecided &&
        (right_error == 0 || c.outcome == Outcome::not_a_number || v.judgement.references[i].gap >= 0.1);
    const bool is_none = c.outcome == Outcome::not_a_number;
    const bool is_right = matters && !is_none && (c.right() || *error <= right_error);
    right.push_back(!matters ? -1 : is_right);
    none.push_back(!error ? -1 : is_none);
    wrong.push_back(!matters || is_none ? -1 : !is_right);
  }
  v.right_where = domain_of(v.judgement.quantities, v.states, right);
  v.wrong_where = domain_of(v.judgement.quantities, v.states, wrong);
  v.not_a_number_where = domain_of(v.judgement.quantities, v.states, none);
  if (v.group && !v.group->where.empty() && v.wrong_where.empty()) v.wrong_where = v.group->where;
}

bool off_by_a_factor(const Term& term) {
  return term.verdict == TermVerdict::factor || term.verdict == TermVerdict::function ||
         term.verdict == TermVerdict::absent;
}

/// A group that can't be chance: it has a place, or most of what is off belongs to it.
bool is_meant(const FactorGroup& group, const Judgement& judgement) {
  return !group.where.empty() || 2 * group.members.size() >= judgement.failing.size() + judgement.undecided;
}

/// A sum or an integral by some rule errs everywhere; or, where it is spectral, everywhere but in thick films: the gap
/// of a wrong answer is smaller than that of a right one. A program that is right to rounding at most states and wrong
/// at some others has a defect there.
bool errs_like_a_rule(const Judgement& j) {
  std::vector<double> right, wrong;
  for (std::size_t i = 0; i < j.comparisons.size(); ++i) {
    const Comparison& c = j.comparisons[i];
    if (j.references[i].ratio < 0.05 || !(j.references[i].size[j.first_column()] > 0)) continue;
    if (c.right()) right.push_back(j.references[i].gap);
    if (c.fails()) wrong.push_back(j.references[i].gap);
  }
  const auto thick = [](const std::vector<double>& gaps) {
    return std::ranges::count_if(gaps, [](double x) { return x >= 0.1; });
  };
  if (2 * thick(wrong) > thick(wrong) + thick(right)) return true;
  std::ranges::sort(right);
  double thicker = 0;
  for (const double gap : wrong) thicker += static_cast<double>(right.end() - std::ranges::upper_bound(right, gap));
  return wrong.size() >= 5 && thicker >= 0.95 * static_cast<double>(right.size()) * static_cast<double>(wrong.size());
}

/// A constant factor that is no number one would expect, and hardly one: that of a trapezoidal rule, say.
bool may_be_of_a_rule(const Term& term) {
  constexpr double largest = 1e-3;
  return term.verdict == TermVerdict::factor && term.factor && term.factor_text.empty() &&
         std::abs(*term.factor - 1) <= largest;
}

/// Right to some digits, as a sum or an integral by some rule is, and nothing else is the matter.
bool is_numerical(const Verification& v) {
  const Judgement& j = v.judgement;
  if (!(v.digits.digits >= 1) || !v.digits.steady || j.not_numbers > 0 || v.group || !v.suspicions.empty())
    return false;
  if (v.settings.tolerance == 0 && !errs_like_a_rule(j)) return false;
  if (std::ranges::any_of(v.columns, [](const ColumnResult& c) { return c.is_off_as_a_whole(); })) return false;
  return std::ranges::none_of(v.terms, [](const Term& t) { return off_by_a_factor(t) && !may_be_of_a_rule(t); });
}

Verdict verdict_of(const Verification& v) {
  const Judgement& j = v.judgement;
  if (j.judged() == 0 || j.not_numbers == j.judged()) return Verdict::undecided;
  if (j.failing.empty()) return j.enough_decided() ? Verdict::agrees : Verdict::undecided;
  return is_numerical(v) ? Verdict::agrees_to_digits : Verdict::disagrees;
}

/// Errors over |F| at which mistakes are looked for: that of rounding; in a program that is right to rounding nowhere,
/// the less precise ones, too, as long as they leave states that are wrong.
std::vector<double> precisions_to_try(const Verification& v) {
  std::vector<double> list = {0};
  if (error_of_right_answers(v.judgement, v.answers) == 0) return list;
  for (const double precision : {1e-8, 1e-6, 1e-4, 1e-3, 1e-2}) {
    if (v.digits.digits < 1 || precision < std::pow(10.0, -v.digits.digits)) list.push_back(precision);
  }
  return list;
}

/// All that can be said against one law.
void analyse(Verification& v, SearchDepth depth) {
  v.digits = digit_profile(v.judgement);
  v.law_distance = median_distance(v.judgement, v.answers);
  const bool numbers = v.judgement.not_numbers < v.judgement.judged();
  if (v.judgement.failing.empty() || !numbers) {
    v.group = factor_group(v.judgement, v.states, v.answers, v.digits.digits);
    if (v.group && !is_meant(*v.group, v.judgement)) v.group.reset();
    if (v.group) {  // what rounding was thought to do is done by a factor
      for (const std::size_t i : v.group->members) v.judgement.comparisons[i].outcome = Outcome::wrong;
      summarise(v.judgement);
    }
    v.verdict = verdict_of(v);
    if (v.verdict == Verdict::agrees || !numbers) return;
  }
  v.suspicions = suspicions_of(v.judgement, v.states, v.answers, precisions_to_try(v), depth);
  v.terms = terms_of(v.judgement, v.states, v.answers);
  v.columns = columns_of(v.judgement, v.answers);
  if (v.suspicions.empty()) {
    v.group = factor_group(v.judgement, v.states, v.answers, v.digits.digits);
    if (v.group && !is_meant(*v.group, v.judgement)) v.group.reset();
    if (v.group) {
      for (const std::size_t i : v.group->members) v.judgement.comparisons[i].outcome = Outcome::wrong;
      summarise(v.judgement);
    }
  }
  locate(v);
  v.verdict = verdict_of(v);
  if (v.verdict == Verdict::agrees_to_digits) v.right_where.clear();
}

/// Share of the decided answers that are numbers which neither being right nor a set of mistakes explains.
double unexplained(const Verification& v) {
  double answered = 0, right = 0;
  for (std::size_t i = 0; i < v.states.size(); ++i) {
    const Comparison& c = v.judgement.comparisons[i];
    if (c.left_out() || c.outcome == Outcome::not_a_number || c.outcome == Outcome::undecided) continue;
    if (!(v.judgement.references[i].size[v.judgement.first_column()] > 0)) continue;
    ++answered;
    if (c.right()) ++right;
  }
  if (answered == 0) return 1;
  if (v.verdict == Verdict::agrees) return 0;
  if (v.verdict == Verdict::agrees_to_digits) return 0.01 + 0.001 * (17 - v.digits.digits);
  double best = 0;
  for (const Suspicion& s : v.suspicions) {
    const bool changes_law = std::ranges::any_of(s.mistakes, [](const Mistake* m) {
      return m->name.starts_with("law_") || m->name.starts_with("contact_law_");
    });
    if (changes_law) continue;
    // Two mistakes explain less than one that does as much.
    best = std::max(best, s.share - s.contradicted - 0.05 * static_cast<double>(s.mistakes.size()));
  }
  double terms = 0, decided = 0;
  for (const Term& term : v.terms) {
    if (term.verdict == TermVerdict::undecided || term.vanishes) continue;
    decided += 1;
    if (term.is_right()) terms += 1;
    if (off_by_a_factor(term)) terms += 0.5;
  }
  const double share_of_terms = decided == 0 ? 0 : terms / decided;
  const double open = (answered - right) / answered;
  // Terms say less than a set of mistakes that predicts the answers.
  return open * (1 - std::max(best, 0.5 * share_of_terms)) + 1e-6;
}

Verification made(Quantities quantities, Law law, const std::vector<State>& states, const Answers& answers,
                  const VerifySettings& settings, SearchDepth depth) {
  Verification v;
  v.settings = settings;
  v.states = states;
  v.answers = answers;
  v.judgement = judge(quantities, law, states, answers, settings.tolerance);
  if (is_of_load(quantities)) {  // where the law puts the journal
    for (std::size_t i = 0; i < states.size(); ++i) v.states[i].eccentricity_ratio = v.judgement.references[i].ratio;
  }
  analyse(v, depth);
  return v;
}

Verification best_law(Quantities quantities, const std::vector<State>& states, const Answers& answers,
                      const VerifySettings& settings) {
  std::vector<Verification> all;
  for (std::size_t i = 0; i < every_law_count; ++i) {
    if (has_answers(quantities, Law{i})) {
      all.push_back(made(quantities, Law{i}, states, answers, settings, SearchDepth::single));
    }
  }
  // A hundredth more or less explained is no difference: laws that are alike where the program moves are ties.
  const auto hundredths = [](const Verification& v) { return std::round(100 * unexplained(v)); };
  const auto best = [&] { return std::ranges::min_element(all, {}, hundredths); };
  for (const SearchDepth depth : {SearchDepth::pairs, SearchDepth::triples}) {
    constexpr double explained = 0.1;
    if (unexplained(*best()) < explained) break;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < all.size(); ++i) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return unexplained(all[i]); });
    // Sets of three take longest: the likeliest laws alone.
    if (depth == SearchDepth::triples) {
      // A steady or a partial program is more likely one of a law with a wedge than three mistakes in a squeeze law.
      std::erase_if(order, [&](std::size_t i) { return facts_of(all[i].judgement.law).squeeze_only; });
      order.resize(std::min<std::size_t>(order.size(), 4));
    }
    for (const std::size_t i : order) {
      all[i] = made(quantities, all[i].judgement.law, states, answers, settings, depth);
    }
  }
  const auto chosen = best();
  Verification result = *chosen;
  result.law_was_found = true;
  constexpr double too_much = 0.5;
  if (unexplained(*chosen) > too_much) {
    const auto nearest = std::ranges::min_element(all, {}, &Verification::law_distance);
    result = *nearest;
    result.law_was_found = true;
    result.law_is_doubtful = true;
  }
  for (const Verification& other : all) {
    if (other.judgement.law == result.judgement.law || result.law_is_doubtful) continue;
    if (hundredths(other) <= hundredths(result)) result.other_laws.push_back(other.judgement.law);
  }
  return result;
}

}  // namespace

bool Verification::accepted() const {
  if (verdict == Verdict::agrees) return true;
  return verdict == Verdict::agrees_to_digits && settings.tolerance > 0 &&
         std::pow(10.0, -digits.digits) <= settings.tolerance;
}

void require_law(Quantities quantities, const std::string& law) {
  if (law == "auto") return;
  const Law named = law_of(law);
  if (has_answers(quantities, named)) return;
  if (is_solved_film(named)) {
    throw std::invalid_argument("--quantities " + std::string(name_of(quantities)) + " is not judged for " + law +
                                "; allowed are " + std::string(quantities_of_solved_films));
  }
  if (is_contact_law(named) || quantities == Quantities::contact) {
    throw std::invalid_argument("law " + law + " and --quantities " + std::string(name_of(quantities)) +
                                " do not go together; allowed with contact are auto, lankarani_nikravesh, "
                                "hunt_crossley, flores, gonthier, and these with contact alone");
  }
  if (is_of_load(quantities)) {
    throw std::invalid_argument("a journal in a film of the squeeze alone, such as " + law +
                                ", carries no load at rest: --quantities " + std::string(name_of(quantities)) +
                                " allows every other law");
  }
  throw std::invalid_argument("law " + law + " is not the integral of any pressure field: --quantities " +
                              std::string(name_of(quantities)) + " allows every other law");
}

namespace {

/// Every set of mistakes about a film that a solver knows is solved for; one with a free boundary takes a second.
SearchDepth depth_for(Law law) {
  if (law == "finite_reynolds"_law) return SearchDepth::single;
  return is_solved_film(law) ? SearchDepth::pairs : SearchDepth::triples;
}

}  // namespace

Verification verify_answers(Quantities quantities, const std::string& law, std::vector<State> states, Answers answers,
                            const VerifySettings& settings) {
  require_law(quantities, law);
  if (law == "auto") return best_law(quantities, states, answers, settings);
  const Law named = law_of(law);
  const bool is_known =
      !is_solved_film(named) || std::ranges::all_of(states, [](const State& s) { return s.films != nullptr; });
  if (!is_known) {
    throw std::invalid_argument("states that no solver stands behind are not judged for " + law +
                                "; allowed are those of solved_film_states");
  }
  return made(quantities, named, states, answers, settings, depth_for(named));
}

std::string next_step(const Verification& v) {
  const Judgement& j = v.judgement;
  const std::string law(name_of(j.law));
  switch (v.verdict) {
    case Verdict::agrees:
      if (j.undecided > 0) {
        return fmt::format(
            "Nothing: all that these answers' precision decides is right; the {} undecided states need more digits "
            "than "
            "{} has.",
            j.undecided, j.precision.words());
      }
      return "Nothing: every state is right.";
    case Verdict::agrees_to_digits: {
      const int digits = static_cast<int>(std::floor(v.digits.digits + 0.05));
      if (v.accepted()) return fmt::format("Nothing: right to {} digits, which the tolerance given accepts.", digits);
      return fmt::format("Right to {} digits: if it is meant to be numerical, say --tolerance {:.0e}.", digits,
                         std::pow(10.0, -digits));
    }
    case Verdict::undecided:
      if (j.not_numbers > 0) return "Why no answer is a number: run the program on one of the states by itself.";
      return "The precision of the answers: print more digits, or compute in double.";
    case Verdict::disagrees:
      break;
  }
  if (v.law_is_doubtful) {
    return fmt::format("Which law it is: none of these; the nearest is {}, {:.2g} % off in the median.", law,
                       100 * v.law_distance);
  }
  if (!v.suspicions.empty()) {
    std::string text;
    for (const Mistake* m : v.suspicions[0].mistakes)
      text += (text.empty() ? "" : " And: ") + std::string(m->description) + ".";
    return text;
  }
  if (v.group && !v.group->where.empty()) {
    return fmt::format("The branch where {}: there the answers are {:g} times the right ones.", words(v.group->where),
                       v.group->factor);
  }
  if (!v.not_a_number_where.empty())
    return "Where the answer is not a number: where " + words(v.not_a_number_where) + ".";
  for (const ColumnResult& column : v.columns) {
    if (column.is_off_as_a_whole()) return fmt::format("The column {}: it is {}.", column.name, column.words());
  }
  for (const Term& term : v.terms) {
    if (off_by_a_factor(term)) {
      return fmt::format("The {} force in {} states: it is {}.",
                         component_names[static_cast<std::size_t>(term.component)],
                         motion_kind_names[static_cast<std::size_t>(term.states)], term.words());
    }
  }
  if (!v.wrong_where.empty()) return "The states where " + words(v.wrong_where) + ": the others are right.";
  for (const Term& term : v.terms) {
    if (term.verdict == TermVerdict::wrong) {
      return fmt::format("The {} force in {} states: it is wrong there, and no known mistake makes it so.",
                         component_names[static_cast<std::size_t>(term.component)],
                         motion_kind_names[static_cast<std::size_t>(term.states)]);
    }
  }
  return "The worst state, step by step: no known mistake gives these answers.";
}

}  // namespace lubjoint::verify
