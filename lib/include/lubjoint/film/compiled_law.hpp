/// Laws of a film of finite length that are computed once for a bearing's L/D, as tables.
#pragma once

#include <cmath>
#include <concepts>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/film/shaped_law.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// What a compiled law is made of. Read from a file by compiled_film_file.hpp, made by `lubjoint compile-film`.
struct CompiledFilm {
  std::string film;                  ///< name of the law: finite_full, …
  double shape = 0;                  ///< L/D that it was made for
  double ratio_limit = 0;            ///< ε up to which the error was measured
  double error = 0;                  ///< bound of |F − F_solver|/|F| there, measured off the table's own places
  std::vector<double> coefficients;  ///< of the law's series, in its order
};

/// The least L/D for which films are compiled: beyond, no table was held against the solvers.
inline constexpr double least_compiled_shape = 0.05;
inline constexpr double largest_compiled_shape = 10;  ///< and the largest

/// A law that is an object, made for one L/D: it gives F/S as a law of law.hpp does.
template <class Law>
concept CompiledLaw = std::constructible_from<Law, const CompiledFilm&> && requires(const Law& law) {
  { law.force_ratio(std::declval<const FilmState<double>&>()) } -> std::same_as<Vector2<double>>;
  { law.shape() } -> std::convertible_to<double>;
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::limit } -> std::convertible_to<BearingLimit>;
};

/// A compiled law that depends on the direction of e at ε = 0, as half films do: it has polar components, too.
template <class Law>
concept CompiledPolarLaw = CompiledLaw<Law> && requires(const Law& law, const PolarFilmState<double>& state) {
  { law.force_ratio(state, HalfFilmSide::converging) } -> std::same_as<PolarForce<double>>;
};

/// A compiled half film: its force jumps where a changes sign, and what it does on either side can be asked for.
template <class Law>
concept CompiledHalfFilmLaw = CompiledPolarLaw<Law> && requires {
  requires Law::extent == FilmExtent::half;
};

namespace detail {

/// @throws std::invalid_argument if a table is not one of this law
inline void require_table(const CompiledFilm& table, std::string_view law, std::size_t coefficients) {
  std::ostringstream reason;
  reason.precision(10);
  if (table.film != law) {
    reason << "is one of \"" << table.film << "\"";
  } else if (!(table.shape > 0 && std::isfinite(table.shape))) {
    reason << "has length over diameter " << table.shape << "; allowed is a finite number above 0";
  } else if (!(table.ratio_limit > 0 && table.ratio_limit < 1)) {
    reason << "has the eccentricity ratio " << table.ratio_limit << " for its limit; allowed is a number in (0, 1)";
  } else if (!(table.error >= 0 && std::isfinite(table.error))) {
    reason << "has the error " << table.error << "; allowed is a finite number, 0 or more";
  } else if (table.coefficients.size() != coefficients) {
    reason << "has " << table.coefficients.size() << " coefficients; allowed are " << coefficients;
  } else {
    for (const double c : table.coefficients) {
      if (std::isfinite(c)) continue;
      reason << "has a coefficient that is not finite";
      break;
    }
  }
  if (reason.str().empty()) return;
  throw std::invalid_argument("the table given to the law " + std::string(law) + " " + reason.str());
}

/// Columns of a table, one series after the other.
template <class Matrix>
Matrix series_of(const CompiledFilm& table, Eigen::Index place) {
  return Eigen::Map<const Matrix>(table.coefficients.data() + place * Matrix::SizeAtCompileTime);
}

}  // namespace detail

/// L/(2R) of the bearing is the law's, to rounding of its dimensions.
/// @throws std::invalid_argument if not
template <CompiledLaw Law, class R>
void require_shape_of(const Law& law, const Bearing<R>& bearing) {
  using std::abs;
  const R shape = length_to_diameter(bearing);
  if (abs(R(shape - law.shape())) <= R(1e-12) * shape) return;  // four roundings of doubles, many times
  Message message;
  message << "the law " << Law::name << " is compiled for length over diameter " << law.shape() << ", the bearing has "
          << shape;
  throw std::invalid_argument(message.str());
}

/// F/S of a compiled law at any state of the film [1/s]; at u = 0 its value is zero, and its derivatives are those of
/// the limit that law.hpp takes for every law.
template <CompiledLaw Law, class T>
Vector2<T> compiled_force_ratio(const Law& law, const FilmState<T>& film) {
  const auto in_motion = [&law]<class S>(const FilmState<S>& state) {
    return detail::in_range_of_rates(state, [&law](const FilmState<S>& scaled) { return law.force_ratio(scaled); });
  };
  return is_zero(film.velocity) ? detail::force_ratio_at_rest(film, in_motion) : in_motion(film);
}

/// The same in polar components; the radial direction is the caller's, also at ε = 0.
template <CompiledLaw Law, class T>
PolarForce<T> compiled_polar_force_ratio(const Law& law, const PolarFilmState<T>& state) {
  if constexpr (CompiledPolarLaw<Law>) {
    return law.force_ratio(state, side_of(state));
  } else {
    const Vector2<T> ratio = compiled_force_ratio(law, state.in_own_frame());
    return {ratio.x(), ratio.y()};
  }
}

/// Force of the film on the journal [N], in the frame of the state.
/// @throws std::invalid_argument if the law was compiled for another L/D
template <CompiledLaw Law, class T>
Vector2<T> film_force(const Law& law, const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                      const FilmState<T>& film) {
  require_shape_of(law, bearing);
  const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
  const Vector2<T> ratio = compiled_force_ratio(law, film);
  return Vector2<T>(T(scale * ratio.x()), T(scale * ratio.y()));
}

/// Force of the film on the journal in polar components [N]; the radial direction is the caller's, also at ε = 0.
/// @throws std::invalid_argument as above
template <CompiledLaw Law, class T>
PolarForce<T> film_force(const Law& law, const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                         const PolarFilmState<T>& state) {
  require_shape_of(law, bearing);
  const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
  const PolarForce<T> ratio = compiled_polar_force_ratio(law, state);
  return {T(scale * ratio.radial), T(scale * ratio.tangential)};
}

}  // namespace lubjoint
