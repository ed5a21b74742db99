/// What wrong answers of a program of finite length look like.
#pragma once

#include <string>
#include <vector>

#include "oracle/verify/states/finite_film.hpp"

namespace lubjoint::verify {

/// Mistakes of the gallery, alone or, where none is enough, two together, that explain the failing states and
/// contradict no right one; those that predict the same answers are all in it. The likeliest
/// first, and among equals in the gallery's order.
std::vector<FiniteSuspicion> finite_suspicions(const FiniteVerification& verification);

/// The laws of a short or a long bearing whose forces all answers are: more than one where they don't differ at the
/// states.
std::vector<std::string> laws_of_answers(const FiniteVerification& verification);

}  // namespace lubjoint::verify
