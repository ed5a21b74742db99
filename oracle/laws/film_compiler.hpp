/// Makes the tables of the laws of finite length, by solving Reynolds' equation.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint::reports {

/// How a film is compiled.
struct CompilerOptions {
  unsigned threads = 1;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called by one thread at a time; may be empty
};

/// The table of a law for one L/D.
///
/// The law's coordinates are taken at Chebyshev points, where the solver's force over the law's own mean is read:
/// finite_full, finite_half and finite_dynamic by separation along the axis (circumferential_modes.hpp),
/// finite_reynolds by the grids that carry its free boundary (cavitated_film.hpp), of which W∥ alone is used. The
/// stated error is then measured at random states off those points, in all directions and up to ratio_limit: the first
/// three against the solver of the other family, the axial cosine series (smooth_film.hpp); finite_reynolds against
/// finer grids, of which W⊥, too, is compared, though the table knows it only as a derivative. It is five times the
/// worst difference seen.
/// @param film   name of a compiled law (compiled_laws.hpp)
/// @param shape  L/D, from least_compiled_shape to largest_compiled_shape
/// @throws std::invalid_argument for another film or shape
CompiledFilm compile_film(std::string_view film, double shape, const CompilerOptions& options = {});

}  // namespace lubjoint::reports
