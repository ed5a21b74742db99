#include "oracle/results/losses_table.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lubjoint/joint/chosen_film.hpp"
#include "oracle/files/files.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::reports {

namespace {

using Wide = long double;

/// What is added to a row, in its order.
using LossRow = std::array<std::optional<Wide>, 6>;

/// Does the journal move at a right angle to e, so that oil leaves the gap where it is narrowest and no place fills up?
bool is_steady(const FilmState<Wide>& film) {
  const Wide along = dot(film.eccentricity, film.velocity);
  const Wide terms =
      std::abs(film.eccentricity.x() * film.velocity.x()) + std::abs(film.eccentricity.y() * film.velocity.y());
  return std::abs(along) <= 8 * Wide(std::numeric_limits<double>::epsilon()) * terms;  // rounding of the given doubles
}

/// Force on the journal [N].
template <class Law>
Vector2<Wide> force_on_journal(const Bearing<Wide>& bearing, const Lubricant<Wide>& oil, const FilmState<Wide>& film,
                               [[maybe_unused]] const CompiledFilm* table) {
  if constexpr (CompiledLaw<Law>) {
    return film_force(Law(table_of<Law>(table)), bearing, oil, film);
  } else {
    return film_force<Law>(bearing, oil, film);
  }
}

FilmState<double> in_double(const FilmState<Wide>& film) {
  const auto both = [](const Vector2<Wide>& v) {
    return Vector2<double>(static_cast<double>(v.x()), static_cast<double>(v.y()));
  };
  return {both(film.eccentricity), both(film.velocity)};
}

/// Out of both sides [m³/s].
template <class Law>
std::optional<Wide> side_flow_of(const Bearing<Wide>& bearing, const FilmState<Wide>& film) {
  if constexpr (CompiledLaw<Law>) {
    const double tolerance = solved_flow_tolerance(FreeBoundaryLaw<Law>);
    const oracle::FiniteFlow flow = oracle::finite_side_flow(
        oracle::finite_film_of(Law::name), static_cast<double>(length_to_diameter(bearing)), in_double(film),
        {tolerance, oracle::FilmOnset::free, oracle::SmoothFilmMethod::circumferential_modes});
    if (!flow.tolerance_met) return std::nullopt;
    return Wide(flow.ratio) * bearing.clearance() * bearing.radius() * bearing.length();
  } else {
    return side_flow<Law>(bearing, film);
  }
}

/// I₁ of what is sheared.
template <class Law>
std::optional<Wide> couette_integral_of(const Bearing<Wide>& bearing, const FilmState<Wide>& film, ShearExtent shear) {
  if (!has_solved_couette<Law>(shear)) return couette_integral<Law>(film, shear);
  const oracle::FiniteCouette couette = oracle::finite_couette_integral(
      static_cast<double>(length_to_diameter(bearing)), in_double(film), solved_couette_tolerance);
  if (!couette.tolerance_met) return std::nullopt;
  return couette.integral;
}

template <class Law>
LossRow loss_row(const Bearing<Wide>& bearing, const Lubricant<Wide>& oil, const JournalMotion<Wide>& motion,
                 ShearExtent shear, const CompiledFilm* table) {
  const FilmState<Wide> film = film_state(motion, bearing.clearance());
  const Wide relative_spin = motion.journal_spin - motion.bearing_spin;
  const Vector2<Wide> force = force_on_journal<Law>(bearing, oil, film, table);
  LossRow row{force.x(), force.y(), {}, {}, {}, side_flow_of<Law>(bearing, film)};
  if (shear == ShearExtent::striated && !is_steady(film)) return row;
  const std::optional<Wide> integral = couette_integral_of<Law>(bearing, film, shear);
  if (!integral) return row;
  const Wide rate = couette_scale(bearing, oil) * *integral;
  const FilmLosses<Wide> losses = losses_of<Wide>(force, film, bearing.clearance(), rate, relative_spin);
  row[2] = losses.torque_journal;
  row[3] = losses.torque_bearing;
  row[4] = losses.power();
  return row;
}

}  // namespace

std::string loss_columns(const FilmInBearing& film, ShearExtent shear, const JournalMotion<double>& motion) {
  const Bearing<Wide> wide_bearing(film.bearing.length(), film.bearing.radius(), film.bearing.clearance());
  const Lubricant<Wide> wide_oil(film.oil.viscosity());
  const JournalMotion<Wide> wide{Vector2<Wide>(motion.eccentricity.x(), motion.eccentricity.y()),
                                 Vector2<Wide>(motion.velocity.x(), motion.velocity.y()), motion.bearing_spin,
                                 motion.journal_spin};
  const LossRow row = with_film_law<NamedFilmLaws>(
      film.law, [&]<class Law>() { return loss_row<Law>(wide_bearing, wide_oil, wide, shear, film.table.get()); });
  std::string fields;
  for (const std::optional<Wide>& value : row) {
    fields += ',';
    if (!value) continue;
    const auto rounded = static_cast<double>(*value);
    if (!std::isfinite(rounded)) {
      throw std::range_error("a loss is beyond the range of double precision; allowed are smaller speeds");
    }
    fields += number(rounded);
  }
  return fields;
}

}  // namespace lubjoint::reports
