/// Rows of states in arrays, and the loop over them that a compiler turns into vector instructions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "lubjoint/film/batch.hpp"
#include "lubjoint/film/dynamic_moments.hpp"
#include "lubjoint/film/law.hpp"
#include "lubjoint/film/squeeze_film.hpp"

namespace lubjoint::detail {

/// Rows are evaluated in blocks of so many, and written after all of a block are known: so outputs may be inputs, and
/// rows after one without a film stay as they are. Long enough that the loop over blocks costs nothing.
inline constexpr std::size_t block_rows = 32;

/// Numbers of one block's rows.
struct BlockColumn {
  alignas(64) double values[block_rows];

  /// Some of a column's numbers, the last of them again for the rows after them.
  void fill(const double* column, std::size_t count) {
    for (std::size_t i = 0; i < block_rows; ++i) values[i] = column[i < count ? i : count - 1];
  }
};

/// Rates whose squares and their products are far from the ends of the range; inside of in_range_of_rates.
inline bool is_ordinary_square(double x) { return (x > 1e-118) & (x < 1e118); }
inline bool is_ordinary_rate(double x) { return (x > -1e59) & (x < 1e59); }  // false for NaN

/// With an ordinary state no force over this scale leaves the range: |F/S| < 100 |u| q^{−5/2}, q ≥ 2^−106.
inline bool is_ordinary_scale(double scale) { return scale < 1e100; }

/// one_minus_squared_norm with both of its cases formed and one selected.
inline double selected_one_minus_squared_norm(double x, double y) {
  const double xx = x * x;
  const double yy = y * y;
  const double sum = xx + yy;
  const double rough = 1 - sum;
  const double fine = rough - left_out_of_square_sum(x, y, xx, yy, sum);
  return rough >= 0.5 ? rough : fine;
}

/// By numbers, not by vectors: GCC keeps a copied vector in memory, and then can't vectorise the loop.
inline FilmState<double> quick_film_state(double ex, double ey, double ux, double uy) {
  return FilmState<double>(Vector2<double>(ex, ey), Vector2<double>(ux, uy), selected_one_minus_squared_norm(ex, ey),
                           Unchecked());
}

/// Each kind of rows makes two states of row i: quickly, whatever the numbers are; and checked, with its error.
/// is_ordinary tells of the first whether force() answers it, in the bits of the functions for one state. A padded part
/// is a block that begins with some of the rows.
struct PlaneRows {
  const double* ex;
  const double* ey;
  const double* ux;
  const double* uy;

  using State = FilmState<double>;

  State quick(std::size_t i) const { return quick_film_state(ex[i], ey[i], ux[i], uy[i]); }
  State checked(std::size_t i) const { return State(Vector2<double>(ex[i], ey[i]), Vector2<double>(ux[i], uy[i])); }
  PlaneRows padded(std::size_t first, std::size_t count, BlockColumn* room) const {
    const double* const columns[] = {ex, ey, ux, uy};
    for (std::size_t k = 0; k < std::size(columns); ++k) room[k].fill(columns[k] + first, count);
    return {room[0].values, room[1].values, room[2].values, room[3].values};
  }
};

struct MotionRows {
  const double* ex;
  const double* ey;
  const double* vx;
  const double* vy;
  const double* bearing_spin;
  const double* journal_spin;
  double clearance;

  using State = FilmState<double>;

  JournalMotion<double> motion(std::size_t i) const {
    return {Vector2<double>(ex[i], ey[i]), Vector2<double>(vx[i], vy[i]), bearing_spin[i], journal_spin[i]};
  }
  State quick(std::size_t i) const {
    const JournalMotion<double> m = motion(i);
    const Vector2<double> e_hat = eccentricity_in_clearances(m, clearance);
    const Vector2<double> u = pure_squeeze_velocity(m, clearance, e_hat);
    return quick_film_state(e_hat.x(), e_hat.y(), u.x(), u.y());
  }
  State checked(std::size_t i) const { return film_state(motion(i), clearance); }
  MotionRows padded(std::size_t first, std::size_t count, BlockColumn* room) const {
    const double* const columns[] = {ex, ey, vx, vy, bearing_spin, journal_spin};
    for (std::size_t k = 0; k < std::size(columns); ++k) room[k].fill(columns[k] + first, count);
    return {room[0].values, room[1].values, room[2].values, room[3].values, room[4].values, room[5].values, clearance};
  }
};

struct PolarRows {
  const double* eccentricity_ratio;
  const double* slip_rate;
  const double* squeeze_rate;

  using State = PolarFilmState<double>;

  State quick(std::size_t i) const {
    const double epsilon = eccentricity_ratio[i];
    return State(epsilon, slip_rate[i], squeeze_rate[i], one_minus_square(epsilon), Unchecked());
  }
  State checked(std::size_t i) const { return State(eccentricity_ratio[i], slip_rate[i], squeeze_rate[i]); }
  PolarRows padded(std::size_t first, std::size_t count, BlockColumn* room) const {
    const double* const columns[] = {eccentricity_ratio, slip_rate, squeeze_rate};
    for (std::size_t k = 0; k < std::size(columns); ++k) room[k].fill(columns[k] + first, count);
    return {room[0].values, room[1].values, room[2].values};
  }
};
inline constexpr std::size_t most_columns = 6;

/// Forces of one block's rows.
struct ForceBlock {
  BlockColumn first, second;
};

template <FilmLaw Law>
bool is_ordinary(const FilmState<double>& film) {
  const bool moves = is_ordinary_square(dot(film.velocity, film.velocity));
  const bool has_direction = !PolarLaw<Law> || is_ordinary_square(dot(film.eccentricity, film.eccentricity));
  return (film.q > 0) & moves & has_direction;
}

template <FilmLaw Law>
bool is_ordinary(const PolarFilmState<double>& state) {
  const bool inside = (state.q > 0) & (state.eccentricity_ratio >= 0);
  if constexpr (PolarLaw<Law>) {
    const bool slips = is_ordinary_rate(state.slip_rate);
    const bool squeezes = is_ordinary_rate(state.squeeze_rate);
    return inside & slips & squeezes;
  } else {
    const bool moves = is_ordinary<Law>(state.in_own_frame());
    return inside & moves;
  }
}

/// A law of two forms, one of which is selected.
template <class Law>
concept DynamicLaw = requires(const DynamicFrame<double>& frame) {
  Law::narrow(frame);
};

/// Likewise one of the squeeze alone.
template <class Law>
concept OneSidedSqueezeLaw = requires(const PolarFilmState<double>& state) {
  Law::narrow_resistance(state);
};

/// F/S of an ordinary state: no branch on where it lies.
template <FilmLaw Law>
Vector2<double> quick_ratio(const FilmState<double>& film) {
  if constexpr (PolarLaw<Law>) {
    const PolarView<double> view = polar_view_along(direction_in_range(film.eccentricity), film);
    if constexpr (OneSidedSqueezeLaw<Law>) return in_plane(selected_squeeze_force<Law>(view.state), view.radial);
    return polar_law_in_plane<Law>(view, side_of(film));
  } else if constexpr (DynamicLaw<Law>) {
    return selected_resistance_of<Law>(film);
  } else {
    return Law::force_ratio(film);
  }
}

template <FilmLaw Law>
Vector2<double> quick_ratio(const PolarFilmState<double>& state) {
  if constexpr (PolarLaw<Law>) {
    if constexpr (OneSidedSqueezeLaw<Law>) {
      const PolarForce<double> ratio = selected_squeeze_force<Law>(state);
      return Vector2<double>(ratio.radial, ratio.tangential);
    }
    const PolarForce<double> ratio = Law::force_ratio(state, side_of(state));
    return Vector2<double>(ratio.radial, ratio.tangential);
  } else {
    return quick_ratio<Law>(state.in_own_frame());
  }
}

/// Forces of whole blocks of rows, until one has a row that is not ordinary; that one is not written.
/// @param block  takes the forces of that one, right for its ordinary rows
/// @returns the row at which it ended, end − begin being a multiple of block_rows
template <FilmLaw Law, class Rows>
[[gnu::always_inline]] inline std::size_t evaluate_blocks(const Rows& rows, std::size_t begin, std::size_t end,
                                                          double scale, double* first, double* second,
                                                          ForceBlock& block) {
  for (; begin < end; begin += block_rows) {
    ForceBlock here;       // not the caller's: nobody else looks at it while the loop runs
    std::int64_t odd = 0;  // as wide as a double, so that its lanes are the rows'
    for (std::size_t i = 0; i < block_rows; ++i) {
      const auto state = rows.quick(begin + i);
      odd |= is_ordinary<Law>(state) ? 0 : 1;
      const Vector2<double> ratio = quick_ratio<Law>(state);
      here.first.values[i] = scale * ratio.x();
      here.second.values[i] = scale * ratio.y();
    }
    if (odd != 0) {
      block = here;
      break;
    }
    for (std::size_t i = 0; i < block_rows; ++i) first[begin + i] = here.first.values[i];
    for (std::size_t i = 0; i < block_rows; ++i) second[begin + i] = here.second.values[i];
  }
  return begin;
}

}  // namespace lubjoint::detail
