/// A quadrature rule applied to integrals over the film of one state.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "oracle/quadrature/estimate.hpp"
#include "oracle/quadrature/integrand.hpp"
#include "oracle/reynolds/narrow_gap.hpp"

namespace lubjoint::oracle {

/// How the pressure is integrated. The dip of the gap is a spike of the pressure, of width √(2(1 − ε)); each rule meets
/// it in its own way.
///   gauss_legendre  fixed rules in the stretched angle t (narrow_gap.hpp), on either side of the minimum film; default
///   qag             adaptive Gauss–Kronrod in t
///   qags            the same with extrapolation
///   qagp            adaptive in φ itself, break points around the spike
///   cquad           doubly adaptive in t
///   trapezoid       periodic trapezoid in Sommerfeld's angle χ, tan(φ/2) = √((1−ε)/(1+ε)) tan(χ/2); full films only
enum class FilmQuadratureRule { gauss_legendre, qag, qags, qagp, cquad, trapezoid };

inline constexpr std::array<std::string_view, 6> film_quadrature_rule_names = {"gauss_legendre", "qag",   "qags",
                                                                               "qagp",           "cquad", "trapezoid"};

/// Places φ and weights (with dφ/dt in them) of a Gauss–Legendre rule on a window.
struct FilmNodes {
  std::vector<double> phi;
  std::vector<double> weight;
};

/// The rule of one rung of the ladder (gauss_legendre.hpp) on each side of the minimum film.
void place_film_nodes(const NarrowGap& gap, const FilmWindow& window, std::size_t rung, FilmNodes& nodes);

/// ∫ f(φ) dφ over the window by one of GSL's rules or the trapezoid rule.
/// @param tolerance  relative to the integral, or absolute
/// @throws QuadratureError if the rule has no answer; std::invalid_argument for gauss_legendre, which is not scalar,
///         and for trapezoid on a window that is not a whole turn
Estimate integrate_over_film(FilmQuadratureRule rule, const NarrowGap& gap, const FilmWindow& window,
                             const Integrand& f, const Tolerance& tolerance);

/// A rule with what applies it. gauss_legendre alone needs no integrator: without one, no GSL is linked.
struct FilmRule {
  FilmQuadratureRule rule = FilmQuadratureRule::gauss_legendre;
  decltype(&integrate_over_film) integrator = nullptr;
};

}  // namespace lubjoint::oracle
