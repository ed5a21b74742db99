/// Programs for films of the bearing's real length: what they are asked, judged, and every mistake of theirs.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "oracle/verify/report.hpp"
#include "oracle/verify/states/finite_film.hpp"
#include "oracle/verify/states/solved_film_states.hpp"
#include "support/verify_answers.hpp"

namespace lubjoint::test {

/// All states of a film whose onset is free.
inline std::vector<verify::State> states_of(verify::Law law, verify::Quantities quantities,
                                            ShearExtent shear = ShearExtent::film) {
  return verify::solved_film_states({oracle::finite_film_of(name_of(law))}, quantities, {}, shear, 2);
}

/// Every so many of them; the steps that are used share no factor with the numbers of ratios, spins and motions.
inline std::vector<verify::State> some_states(verify::Law law, verify::Quantities quantities, std::size_t step) {
  const std::vector<verify::State> all = states_of(law, quantities);
  std::vector<verify::State> some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

inline verify::Verification judged(verify::Law law, verify::Quantities quantities,
                                   const std::vector<verify::State>& states, const verify::Answers& answers) {
  return verify::verify_answers(quantities, std::string(name_of(law)), states, answers, {verify::finite_tolerance, ""});
}

/// Each mistake that shows is the first suspicion.
/// @param at_least  of which so many show
inline void check_every_mistake(verify::Law law, verify::Quantities quantities, std::size_t step,
                                std::size_t at_least) {
  using verify::Verdict;
  const std::vector<verify::State> states = some_states(law, quantities, step);
  std::size_t tried = 0;
  for (const verify::Mistake* mistake : verify::mistakes_for(quantities, law)) {
    if (mistake->name == "shear_of_film_alone") continue;  // is right where the film is asked for
    const verify::Answers answers = mistaken_answers(quantities, law, states, {mistake});
    const verify::Verification v = judged(law, quantities, states, answers);
    if (v.verdict == Verdict::agrees || v.verdict == Verdict::undecided) continue;  // without effect, or no number
    // R + c for R is half a percent: a few of the tolerances to which a film that ruptures is solved.
    if (law == verify::law_of("finite_reynolds") && v.verdict == Verdict::agrees_to_digits && v.digits.digits > 2)
      continue;
    INFO(name_of(law) << ", " << name_of(quantities) << ", " << mistake->name << ":\n" << text_report(v));
    REQUIRE(!v.suspicions.empty());
    CHECK(v.suspicions[0].names({mistake}));
    ++tried;
  }
  INFO(name_of(law) << ", " << name_of(quantities));
  CHECK(tried >= at_least);
}

}  // namespace lubjoint::test
