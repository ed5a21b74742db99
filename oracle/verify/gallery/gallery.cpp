#include "oracle/verify/gallery/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "oracle/verify/states/states.hpp"

namespace lubjoint::verify {

const std::vector<Mistake>& gallery() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> list;
    for (auto* topic : {motion_mistakes, unit_and_geometry_mistakes, film_mistakes, assembly_mistakes, contact_mistakes,
                        rest_mistakes, loss_mistakes, length_mistakes}) {
      for (Mistake& mistake : topic()) list.push_back(std::move(mistake));
    }
    return list;
  }();
  return all;
}

namespace {

/// Most mistakes about forces leave pressures and extents alone.
/// @param right  the answers without a mistake, one each state
bool shows(Quantities quantities, Law law, const std::vector<State>& states, const std::vector<Solution>& right,
           const Mistake& mistake) {
  bool changes = false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Solution wrong = solve(quantities, law, states[i], mistake.changes);
    if (std::isnan(wrong.answer[0])) return false;
    changes = changes || std::abs(wrong.answer[0] - right[i].answer[0]) > 1e-6L * size_of_terms(right[i]) ||
              std::abs(wrong.answer[1] - right[i].answer[1]) > 1e-6L * size_of_terms(right[i]);
  }
  return changes;
}

bool is_about_inputs(const Mistake& mistake) {
  return std::ranges::all_of(mistake.changes, [](const Change& change) {
    return change.step == Step::inputs || change.step == Step::shape || change.step == Step::scale;
  });
}

/// A table has mistakes of its own, and units and lengths are mistaken in it, too; what goes wrong inside a force is
/// verified by the force.
bool concerns_table(Law law, const Mistake& mistake) {
  return !mistake.applies(Quantities::cartesian, law) || is_about_inputs(mistake);
}

/// What a difference in a column of a table is small against.
Real size_of_column(const Solution& s, std::size_t k) {
  if (s.quantities == Quantities::losses) return size_of_costs(s)[k];
  const ColumnGroup group = group_of(s.quantities, k);
  Real square = 0;
  for (std::size_t i = group.begin; i < group.end; ++i) square += s.answer[i] * s.answer[i];
  return std::sqrt(square);
}

/// Without dimensions, and in tables, many mistakes leave every answer as it is. Without dimensions others are the same
/// one: the first of those stands. The answers without a mistake as above.
bool differs(Quantities quantities, Law law, const std::vector<State>& states, const std::vector<Solution>& right,
             const Mistake& mistake, const std::vector<const Mistake*>& others) {
  const auto same_answer = [&](const Solution& a, const Solution& b) {
    if (is_table(quantities)) {
      for (std::size_t k = 0; k < answer_columns(quantities).size(); ++k) {
        if (std::abs(a.answer[k] - b.answer[k]) > 1e-6L * size_of_column(b, k)) return false;
      }
      return true;
    }
    const Real size = 1e-6L * (std::abs(a.answer[0]) + std::abs(a.answer[1]) + size_of_terms(b));
    return std::abs(a.answer[0] - b.answer[0]) <= size && std::abs(a.answer[1] - b.answer[1]) <= size;
  };
  const auto same = [&](const auto& other) {  // other(i): the answer to state i
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (!same_answer(solve(quantities, law, states[i], mistake.changes), other(i))) return false;
    }
    return true;
  };
  // Neither oil nor bearing nor spin is an input.
  const bool about_inputs = std::ranges::any_of(
      mistake.changes, [](const Change& change) { return change.step == Step::inputs || change.step == Step::scale; });
  if (about_inputs && quantities == Quantities::dimensionless) return false;
  if (same([&](std::size_t i) -> const Solution& { return right[i]; })) return false;
  if (quantities != Quantities::dimensionless) return true;  // what can't be told apart is said together
  return std::ranges::none_of(others, [&](const Mistake* each) {
    return same([&](std::size_t i) { return solve(quantities, law, states[i], each->changes); });
  });
}

/// Those of mistakes_for, worked out. Of films that a solver knows no state is solved: what has no effect is passed
/// over where mistakes are looked for.
std::vector<const Mistake*> find_mistakes_for(Quantities quantities, Law law) {
  std::vector<const Mistake*> list;
  const bool of_film_only =
      quantities == Quantities::extent || (quantities == Quantities::pressure && !is_solved_film(law));
  const bool of_few_numbers = quantities == Quantities::dimensionless ||
                              (is_table(quantities) && !is_solved_film(law)) || quantities == Quantities::contact;
  const bool may_be_blind = of_film_only || (facts_of(law).squeeze_only &&
                                             !is_table(quantities));  // a law without a wedge hides mistakes in it
  std::vector<State> states = may_be_blind || of_few_numbers ? designed_states(quantities) : std::vector<State>();
  if (quantities == Quantities::losses && of_few_numbers) {  // some show only where more than the film is asked for
    const std::size_t asked_of_film = states.size();
    for (std::size_t i = 0; i < asked_of_film; ++i) {
      states.push_back(states[i]);
      states.back().shear = ShearExtent::flooded;
    }
  }
  std::vector<Solution> right;
  for (const State& state : states) right.push_back(solve(quantities, law, state));
  for (const Mistake& mistake : gallery()) {
    if (!mistake.applies(quantities, law)) continue;
    if (is_table(quantities) && !concerns_table(law, mistake)) continue;
    if (may_be_blind && !shows(quantities, law, states, right, mistake)) continue;
    if (of_few_numbers && !differs(quantities, law, states, right, mistake, list)) continue;
    list.push_back(&mistake);
  }
  // Of mistakes that do the same, those of a table, and of a film of real length, are named first.
  if (is_table(quantities) || is_solved_film(law))
    std::stable_partition(list.begin(), list.end(), [&](const Mistake* m) {
      return !is_about_inputs(*m) || !m->applies(Quantities::cartesian, law);
    });
  return list;
}

}  // namespace

const std::vector<const Mistake*>& mistakes_for(Quantities quantities, Law law) {
  // Asked for with every set of answers, and worked out from hundreds of states.
  static std::map<std::pair<Quantities, std::size_t>, std::vector<const Mistake*>> found;
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto [place, is_new] = found.try_emplace({quantities, law.place});
  if (is_new) place->second = find_mistakes_for(quantities, law);
  return place->second;
}

const Mistake& mistake_of(std::string_view name) {
  std::string list;
  for (const Mistake& mistake : gallery()) {
    if (mistake.name == name) return mistake;
    list += (list.empty() ? "" : ", ") + std::string(mistake.name);
  }
  throw std::invalid_argument("there is no mistake \"" + std::string(name) + "\" in the gallery; allowed are " + list);
}

std::vector<Change> changes_of(const std::vector<const Mistake*>& mistakes) {
  std::vector<Change> changes;
  for (const Mistake* mistake : mistakes) {
    changes.insert(changes.end(), mistake->changes.begin(), mistake->changes.end());
  }
  return changes;
}

Solution solve_with(Quantities quantities, Law law, const State& state, const std::vector<const Mistake*>& mistakes) {
  return solve(quantities, law, state, changes_of(mistakes));
}

std::string described_gallery() {
  std::string text;
  for (const Mistake& mistake : gallery()) {
    fmt::format_to(std::back_inserter(text), "{}\n    {}\n    How it shows: {}\n", mistake.name, mistake.description,
                   mistake.symptom);
  }
  return text;
}

std::string gallery_markdown() {
  std::string text =
      "# What people get wrong, and how it shows\n\n"
      "Written by `lubjoint verify --list-mistakes --markdown`. `lubjoint verify` recognises each of these, and sets "
      "of\nup to three, in the answers of a program. Symbols: ε eccentricity ratio, a = ε(ω − 2γ̇) slip rate, b = ε̇ "
      "squeeze "
      "rate,\nr and t the radial and tangential directions, θ from the maximum film.\n\n"
      "| name | mistake | how it shows |\n|---|---|---|\n";
  for (const Mistake& mistake : gallery()) {
    std::string cells[2] = {std::string(mistake.description), std::string(mistake.symptom)};
    for (std::string& cell : cells) {
      for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) cell.insert(at, "\\");
    }
    fmt::format_to(std::back_inserter(text), "| `{}` | {} | {} |\n", mistake.name, cells[0], cells[1]);
  }
  return text;
}

}  // namespace lubjoint::verify
