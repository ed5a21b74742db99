/// Pressure of the long bearing with a free constant: (H³p′)′ = −(a sinθ − 2b cosθ), over 6μ(R/c)².
#pragma once

#include "oracle/proofs/sommerfeld.hpp"

namespace lubjoint::proofs {

/// p′ = (a cosθ + 2b sinθ + C)/H³.
ex long_slope(const ex& constant);

/// J_lm as an antiderivative in ψ: ∫ sinˡθ cosᵐθ/H³ dθ.
ex moment_antiderivative(int l, int m);
/// Its value between two ends.
ex moment(int l, int m, const FilmEnd& from, const FilmEnd& to);

/// A pressure that vanishes at `from` and `to`, and its C.
struct LongFilm {
  ex pressure;  ///< contains θ and ψ
  ex constant;
};
LongFilm long_film_between(const FilmEnd& from, const FilmEnd& to);

}  // namespace lubjoint::proofs
