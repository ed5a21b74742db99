/// On which side of the jump of a half film, at a = 0, a journal is.
#pragma once

namespace lubjoint {

/// Sine of the angle between ê and u beyond which a journal is on the other side of a = 0, whatever the errors of its
/// run: a thousandth of the motion's rates, as far above the one as below the other.
/// @param pace  |u| [1/s];  @param mean_spin  |ω̄| [rad/s]
template <class R>
R wrong_side(const R& pace, const R& mean_spin) {
  return pace > 0 ? R((1 + mean_spin / pace) / 1000) : R(1);
}

}  // namespace lubjoint
