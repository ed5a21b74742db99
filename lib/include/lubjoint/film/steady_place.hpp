/// Where a journal comes to rest under a constant load.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <optional>

#include "lubjoint/film/coefficients.hpp"

namespace lubjoint {

namespace detail {

/// ε and q of a logistic variable: 1 − ε keeps its digits on the whole line.
template <class R>
SteadyPlace<R> place_at_logit(const R& logit) {
  using std::exp;
  const R epsilon = 1 / (1 + exp(R(-logit)));
  const R gap = 1 / (1 + exp(logit));
  return {epsilon, R(gap * (1 + epsilon))};
}

inline constexpr double lowest_logit = -690;   ///< ε = 1e-300
inline constexpr double highest_logit = 34.5;  ///< ε = 1 − 1e-15

}  // namespace detail

/// The place at which a film carries a load, by a bracketed root of |F(ε)| = W, which grows from 0 to infinity with ε
/// for every law.
/// @param force_ratio  F/S of a PolarFilmState<R>;  @param load_ratio  W/(S|ω_J + ω_B|) > 0
/// @returns nothing unless 1e-300 < ε < 1 − 1e-15
template <class R, class Force>
std::optional<SteadyPlace<R>> steady_place_of(const Force& force_ratio, const R& load_ratio) {
  using std::log;
  using std::sqrt;
  const auto excess = [&](const R& logit) {
    const PolarForce<R> f = force_ratio(detail::place_at_logit(logit).film(1));
    using std::hypot;
    return R(log(R(hypot(f.radial, f.tangential))) - log(load_ratio));
  };
  const R lowest(detail::lowest_logit);
  const R highest(detail::highest_logit);
  if (!(excess(lowest) < 0 && excess(highest) > 0)) return std::nullopt;
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<R> tolerance(std::numeric_limits<R>::digits - 1);
  const auto bracket = boost::math::tools::toms748_solve(excess, lowest, highest, tolerance, iterations);
  return detail::place_at_logit(R((bracket.first + bracket.second) / 2));
}

/// The same of a law.
template <FilmLaw Law, class R>
std::optional<SteadyPlace<R>> steady_place(const R& load_ratio) {
  return steady_place_of([](const PolarFilmState<R>& film) { return polar_force_ratio<Law>(film); }, load_ratio);
}

}  // namespace lubjoint
