/// Is an implementation right, and if not, where and why: the whole judgement.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/verify/diagnosis.hpp"
#include "oracle/verify/states/digits.hpp"
#include "oracle/verify/terms/columns.hpp"
#include "oracle/verify/terms/terms.hpp"

namespace lubjoint::verify {

enum class Verdict {
  agrees,            ///< every decided state, to its conditioning at the answers' precision
  agrees_to_digits,  ///< a numerical program: right to some digits, fewer where the film is thin
  disagrees,
  undecided  ///< nothing can be said: no numbers, or too few states that the answers' precision decides
};

/// What the user declares.
struct VerifySettings {
  double tolerance = 0;     ///< error over |F| that is accepted; 0: that of rounding
  std::string domain = {};  ///< the declared domain in words, for the report
};

/// The whole result of a verification.
struct Verification {
  Judgement judgement;
  std::vector<State> states;
  Answers answers;
  VerifySettings settings;
  Verdict verdict = Verdict::undecided;
  DigitProfile digits;
  std::optional<FactorGroup> group;   ///< off by one factor, where a mistake is not recognised
  std::vector<Term> terms;            ///< where the answers are not simply right
  std::vector<ColumnResult> columns;  ///< of a table, where the answers are not simply right
  std::vector<Suspicion> suspicions;
  Domain right_where, wrong_where, not_a_number_where;
  bool law_was_found = false;    ///< by --law auto
  std::vector<Law> other_laws;   ///< that the answers fit as well
  bool law_is_doubtful = false;  ///< none of the laws; `judgement` is against the nearest
  double law_distance = 0;       ///< median of the error over |F|, of the answers that are numbers
  bool accepted() const;         ///< exit status 0
};

/// What is judged of a film of the bearing's real length.
inline constexpr std::string_view quantities_of_solved_films =
    "cartesian, polar, wrench, transition, extent, pressure, coefficients, equilibrium and losses";

/// @throws std::invalid_argument for a law that is not there, or that has no such quantities; "auto" is any
void require_law(Quantities quantities, const std::string& law);

/// Judges answers against a law, or against every law for "auto": the one that domain, terms and mistakes leave least
/// unexplained. Against a film that a solver knows: all but its forces alone, of states that have it
/// (solved_film_states).
/// @throws std::invalid_argument for a law that is not there, or that has no such quantities
Verification verify_answers(Quantities quantities, const std::string& law, std::vector<State> states, Answers answers,
                            const VerifySettings& settings = {});

/// The sentence that ends the report: what to look at next.
std::string next_step(const Verification& verification);

}  // namespace lubjoint::verify
