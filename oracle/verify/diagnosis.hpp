/// Which mistakes the wrong answers look like.
#pragma once

#include <string>
#include <vector>

#include "oracle/verify/gallery/gallery.hpp"
#include "oracle/verify/states/judgement.hpp"

namespace lubjoint::verify {

/// One mistake or a set of two or three, with what can't be told from it by these answers.
struct Suspicion {
  std::vector<const Mistake*> mistakes;             ///< one to three
  std::vector<std::vector<const Mistake*>> others;  ///< predict the same answers to every state that was looked at
  double share = 0;                                 ///< of the failing states, reproduced
  double contradicted = 0;  ///< right states at which these mistakes would have shown, over the failing ones
  double precision = 0;     ///< error over |F| of the answers, beside rounding, at which they are recognised

  bool explains_all() const { return share >= 0.98 && contradicted <= 0.005; }
  /// True if it, or what can't be told from it, is exactly this set.
  bool names(const std::vector<const Mistake*>& wanted) const;
};

/// How far the search goes: single mistakes, pairs, sets of three.
enum class SearchDepth { single = 1, pairs = 2, triples = 3 };

/// Suspicions that explain most of the failing states, contradict no right one, and are not without effect; the
/// likeliest first, at most five.
/// @param judgement   one that does not agree
/// @param precisions  errors over |F| at which answers are compared with predictions, beside rounding: the first at
/// which
///                    enough is explained decides. Sets of three are looked for at the first alone
std::vector<Suspicion> suspicions_of(const Judgement& judgement, const std::vector<State>& states,
                                     const Answers& answers, const std::vector<double>& precisions, SearchDepth depth);

}  // namespace lubjoint::verify
