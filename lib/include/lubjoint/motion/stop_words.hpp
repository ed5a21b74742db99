/// Words of the messages of runs that stopped, which every kind of run shares.
#pragma once

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

#include "lubjoint/number/vector.hpp"
#include "lubjoint/run/outcome.hpp"

namespace lubjoint::detail {

/// With the ten digits that a message needs.
inline std::string number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  text << value;
  return text.str();
}

/// 1 − |ê| without cancellation: the thinnest film in clearances.
inline double film_gap(const Vector2<double>& e_hat) {
  return one_minus_squared_norm(e_hat.x(), e_hat.y()) / (1 + std::hypot(e_hat.x(), e_hat.y()));
}

/// |ê|; near the wall as 1 less the gap, of which ten digits of |ê| would say nothing.
inline std::string eccentricity_words(const Vector2<double>& e_hat) {
  const double ratio = std::hypot(e_hat.x(), e_hat.y());
  const double gap = film_gap(e_hat);
  if (!(ratio > 0.999 && gap > 0)) return number(ratio);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << "1 - " << gap;
  return text.str();
}

/// After the name of a joint that no event leads on.
inline std::string stuck_on_jump_words() {
  return " can't leave the jump of its half film at a = 0; use a law without a jump, such as a dynamic one";
}

inline std::string step_limit_reached(std::size_t limit) {
  return "the limit of " + std::to_string(limit) + " steps is reached: ";
}

/// What would need fewer steps.
/// @param implicit  was it an implicit integrator?
/// @param gap  1 − |ê| where the run stopped; 0 or less, or 1: no film that its steps could have gone into
inline std::string remedy_words(bool implicit, double gap) {
  constexpr double thin = 1e-6;  // a film no bearing has: the steps go into following it
  if (!implicit) return "radau_iia5 needs far fewer where the film is stiff";
  if (gap > 0 && gap < thin) {
    return "a film as thin as this takes them; raise the viscosity or lower the load or the clearance";
  }
  return "a looser relative_tolerance needs fewer";
}

/// The limit, and what would need fewer steps.
inline std::string step_limit_words(std::size_t limit, bool implicit, double gap) {
  return step_limit_reached(limit) + remedy_words(implicit, gap);
}

/// Of a run that gets nowhere.
inline std::string stall_words() {
  return std::to_string(stall_limit) + " trial steps have brought less than " + number(stall_share) +
         " of the duration: ";
}

/// Of a table's knot that no step reaches.
inline std::string knot_words() { return "a knot of a table over an angle can't be located; use a tighter tolerance"; }

}  // namespace lubjoint::detail
