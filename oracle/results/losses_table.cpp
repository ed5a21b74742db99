#include "oracle/results/losses_table.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "lubjoint/film/every_law.hpp"
#include "oracle/files/files.hpp"

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

template <AnyFilmLaw Law>
LossRow loss_row(const Bearing<Wide>& bearing, const Lubricant<Wide>& oil, const JournalMotion<Wide>& motion,
                 ShearExtent shear) {
  const FilmState<Wide> film = film_state(motion, bearing.clearance());
  const Wide relative_spin = motion.journal_spin - motion.bearing_spin;
  const FilmLosses<Wide> losses = film_losses<Law, Wide>(bearing, oil, film, relative_spin, shear);
  LossRow row{losses.force.x(), losses.force.y(), {}, {}, {}, side_flow<Law>(bearing, film)};
  if (shear == ShearExtent::striated && !is_steady(film)) return row;
  row[2] = losses.torque_journal;
  row[3] = losses.torque_bearing;
  row[4] = losses.power();
  return row;
}

}  // namespace

std::string loss_columns(std::string_view law, const Bearing<double>& bearing, const Lubricant<double>& oil,
                         ShearExtent shear, const JournalMotion<double>& motion) {
  const Bearing<Wide> wide_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<Wide> wide_oil(oil.viscosity());
  const JournalMotion<Wide> wide{Vector2<Wide>(motion.eccentricity.x(), motion.eccentricity.y()),
                                 Vector2<Wide>(motion.velocity.x(), motion.velocity.y()), motion.bearing_spin,
                                 motion.journal_spin};
  const LossRow row =
      with_film_law<EveryFilmLaw>(law, [&]<class Law>() { return loss_row<Law>(wide_bearing, wide_oil, wide, shear); });
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
