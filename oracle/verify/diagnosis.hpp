/// Which mistakes the wrong answers look like.
#pragma once

#include <string>
#include <vector>

#include "oracle/verify/gallery.hpp"
#include "oracle/verify/judgement.hpp"

namespace lubjoint::verify {

/// One mistake or a pair, with what can't be told from it by these answers.
struct Suspicion {
  std::vector<const Mistake*> mistakes;             ///< one or two
  std::vector<std::vector<const Mistake*>> others;  ///< predict the same answers to every state that was looked at
  double share = 0;                                 ///< of the failing states, reproduced
  double contradicted = 0;  ///< passing states at which these mistakes would have shown, over the failing ones

  bool explains_all() const { return share >= 0.995 && contradicted <= 0.005; }
  /// True if it, or what can't be told from it, is exactly this set.
  bool names(const std::vector<const Mistake*>& wanted) const;
};

/// What the failing states have in common, where no mistake of the gallery is seen in them.
struct Pattern {
  std::vector<std::string> facts;
};

struct Diagnosis {
  std::vector<Suspicion> suspicions;  ///< the likeliest first; at most five
  Pattern pattern;
};

/// @param judgement  one that does not agree; its precision may be changed to the one at which a mistake is recognised
Diagnosis diagnose(Judgement& judgement, const std::vector<State>& states, const Answers& answers);

}  // namespace lubjoint::verify
