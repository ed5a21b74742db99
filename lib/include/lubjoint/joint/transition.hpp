/// From the film to the dry contact and back.
#pragma once

#include <stdexcept>

#include "lubjoint/number/vector.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// Widths of the transition: it is over at |e| = c + e₀; inside F_film the film's clearance is c + e₁. 0 < e₀ < e₁ [m].
template <class R>
struct TransitionTolerances {
  R e0;  ///< width of the blend [m]
  R e1;  ///< what the film's clearance is widened by [m]

  /// @throws std::invalid_argument unless 0 < e0 < e1
  TransitionTolerances(const R& blend, const R& widening) : e0(blend), e1(widening) {
    if (e0 > 0 && e1 > e0) return;
    Message message;
    message << "transition e0 is " << e0 << " m and e1 is " << e1 << " m; allowed are 0 < e0 < e1";
    throw std::invalid_argument(message.str());
  }
};

/// Where a joint with a transition is.
enum class ContactPhase {
  film,   ///< |e| ≤ c
  blend,  ///< c ≤ |e| ≤ c + e₀
  dry     ///< |e| ≥ c + e₀
};

/// "film", "blend" or "dry".
inline const char* contact_phase_name(ContactPhase phase) {
  return phase == ContactPhase::film ? "film" : phase == ContactPhase::blend ? "blend" : "dry";
}

/// The phase of a distance |e|. On a seam, the inner one.
template <class R>
ContactPhase contact_phase(const R& distance, const R& clearance, const TransitionTolerances<R>& tolerances) {
  if (!(distance > clearance)) return ContactPhase::film;
  return distance > clearance + tolerances.e0 ? ContactPhase::dry : ContactPhase::blend;
}

/// What film and contact count for in the blend; together 1.
template <class T>
struct TransitionShares {
  T film;     ///< (c + e₀ − |e|)/e₀
  T contact;  ///< (|e| − c)/e₀
};

/// Shares of film and contact in F = ((c + e₀ − |e|) F_film + (|e| − c) F_dry)/e₀, where c ≤ |e| ≤ c + e₀.
/// Source: Flores et al. (2009), eq. 20.
template <class T>
TransitionShares<T> transition_shares(const T& distance, const RealOf<T>& clearance,
                                      const TransitionTolerances<RealOf<T>>& tolerances) {
  const T contact = (distance - clearance) / tolerances.e0;
  return {T(1 - contact), contact};
}

}  // namespace lubjoint
