/// Laws whose films carry a journal at rest, formulas and tables alike.
#pragma once

#include "film_tables.hpp"
#include "lubjoint/film/compiled_coefficients.hpp"

namespace lubjoint::c {

/// As with_law, for laws whose film carries a journal at rest and has coefficients there.
/// @throws as table_of; std::invalid_argument that says what keeps a law from it
template <class Visitor>
void with_law_at_rest(std::string_view name, const Bearing<double>& bearing, const Visitor& visitor) {
  if (const auto table = table_of(name, bearing)) {
    std::visit(visitor, table->law);
  } else {
    require_law_at_rest(name);
    with_film_law(name, [&]<class Law>() { visitor(Law{}); });
  }
}

/// F/S of a steady film.
template <class Law>
PolarForce<double> ratio_at_rest([[maybe_unused]] const Law& law, const PolarFilmState<double>& film) {
  if constexpr (CompiledLaw<Law>) {
    return compiled_polar_force_ratio(law, film);
  } else {
    return polar_force_ratio<Law>(film);
  }
}

/// K and C over their units, in (r, t).
template <class Law>
CoefficientRatios<double> coefficients_at_rest([[maybe_unused]] const Law& law, const SteadyPlace<double>& place,
                                               int spin_sign) {
  if constexpr (CompiledLaw<Law>) {
    return coefficient_ratios(law, place, spin_sign);
  } else {
    return coefficient_ratios<Law>(place, spin_sign);
  }
}

}  // namespace lubjoint::c
