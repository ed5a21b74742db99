/// Numbers in the messages of runs that stopped.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "lubjoint/film/vector.hpp"

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

}  // namespace lubjoint::detail
