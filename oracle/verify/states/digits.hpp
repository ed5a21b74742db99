/// How many digits a numerical program has, and where it loses them.
#pragma once

#include <string>
#include <vector>

#include "oracle/verify/states/condition.hpp"
#include "oracle/verify/states/judgement.hpp"

namespace lubjoint::verify {

/// States of one decade of 1 − ε, or of ε towards the centre.
struct DigitDecade {
  std::string where;  ///< "0.01 <= 1 - e/c < 0.1"
  std::size_t states = 0;
  std::size_t failing = 0;
  std::size_t undecided = 0;
  double least = 17;   ///< digits that 99 % of the decided states have
  double median = 17;  ///< of the decided states
};

/// Digits of agreement over the whole domain.
struct DigitProfile {
  /// Digits that 99 % of the decided states with 1 − ε ≥ 0.1 have; without those near the centre where it loses digits
  /// steadily towards it. Of a film that a solver knows, the fewest of any: its states lie where a numerical program has
  /// its digits, and none is excused.
  double digits = 17;
  std::vector<DigitDecade> decades;  ///< from 1 − ε ≥ 0.1 to the wall, then from ε < 0.05 to the centre
  bool steady = true;                ///< digits get fewer from decade to decade, never by a cliff
};

DigitProfile digit_profile(const Judgement& judgement);

/// Answers that are the right ones times one number: a sign, a factor of a branch. Rounding and discretisation make
/// none.
struct FactorGroup {
  double factor = 0;
  std::vector<std::size_t> members;  ///< states
  Domain where;                      ///< empty if no simple condition holds for them alone
};

/// The largest group of states that are off by a factor in both components alike; none if fewer than three are.
/// @param digits  that the program has elsewhere
std::optional<FactorGroup> factor_group(const Judgement& judgement, const std::vector<State>& states,
                                        const Answers& answers, double digits);

}  // namespace lubjoint::verify
