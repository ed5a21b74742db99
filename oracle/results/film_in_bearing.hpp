/// A law in a bearing, and what it says of a journal at rest on its film.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lubjoint/film/coefficients.hpp"
#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint::reports {

/// A bearing with a law: what does not change from row to row.
struct FilmInBearing {
  std::string law;
  Bearing<double> bearing;
  Lubricant<double> oil;
  std::shared_ptr<const CompiledFilm> table = nullptr;  ///< of a law that is compiled for the bearing's L/D
};

/// What a law says of steady films, in extended precision.
struct SteadyLaw {
  using Wide = long double;

  BearingLimit limit;
  std::function<PolarForce<Wide>(const PolarFilmState<Wide>&)> force_ratio;  ///< F/S
  /// K and C over their units, for a spin of that sign: closed forms where there are some. A compiled law has them for
  /// K_rt and K_tt alone, which its force is enough for.
  std::function<CoefficientRatios<Wide>(const SteadyPlace<Wide>&, int spin_sign)> coefficients;
  /// The same by differentiation throughout.
  std::function<CoefficientRatios<Wide>(const SteadyPlace<Wide>&, int spin_sign)> differentiated;
};

/// @param table  of a law that is compiled; no other law asks
/// @throws std::invalid_argument for a law whose film carries no journal at rest, and for a table that is not the law's
SteadyLaw steady_law(std::string_view law, const CompiledFilm* table);

}  // namespace lubjoint::reports
