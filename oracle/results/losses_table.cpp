#include "oracle/results/losses_table.hpp"

#include <array>
#include <cmath>
#include <optional>

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

template <FilmLaw Law>
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

std::string losses_csv(const CsvTable& states, std::string_view law, const Bearing<double>& bearing,
                       const Lubricant<double>& oil, ShearExtent shear) {
  const std::array<std::size_t, 6> columns = {states.column("ex"),
                                              states.column("ey"),
                                              states.column("vx"),
                                              states.column("vy"),
                                              states.column("omega_bearing"),
                                              states.column("omega_journal")};
  const Bearing<Wide> wide_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<Wide> wide_oil(oil.viscosity());
  std::string csv = states.header() + ",fx,fy,torque_journal,torque_bearing,power,side_flow\n";
  for (std::size_t number = 0; number < states.rows(); ++number) {
    std::array<Wide, 6> given{};
    for (std::size_t i = 0; i < columns.size(); ++i) given[i] = states.number(number, columns[i]);
    const JournalMotion<Wide> motion{Vector2<Wide>(given[0], given[1]), Vector2<Wide>(given[2], given[3]), given[4],
                                     given[5]};
    csv += states.line(number);
    try {
      const LossRow row =
          with_every_film_law(law, [&]<class Law>() { return loss_row<Law>(wide_bearing, wide_oil, motion, shear); });
      for (const std::optional<Wide>& value : row) {
        csv += ',';
        if (!value) continue;
        const auto rounded = static_cast<double>(*value);
        if (!std::isfinite(rounded)) {
          states.refuse(number, "a loss is beyond the range of double precision; allowed are smaller speeds");
        }
        csv += reports::number(rounded);
      }
    } catch (const FilmDomainError& error) {
      states.refuse(number, error.what());
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace lubjoint::reports
