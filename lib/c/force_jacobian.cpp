#include <array>

#include "array_rows.hpp"
#include "film_tables.hpp"
#include "lubjoint/joint/chosen_film.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

namespace {

constexpr std::size_t width = 10;

std::array<lubjoint_out, width> outputs_of(const lubjoint_jacobian& j) {
  return {j.fx,
          j.fy,
          j.by_place[0],
          j.by_place[1],
          j.by_place[2],
          j.by_place[3],
          j.by_velocity[0],
          j.by_velocity[1],
          j.by_velocity[2],
          j.by_velocity[3]};
}

}  // namespace

int lubjoint_force_jacobian(const char* law, const lubjoint_bearing* bearing, size_t n, const lubjoint_motion* motion,
                            const lubjoint_jacobian* jacobian) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("motion", motion);
    require("jacobian", jacobian);
    const std::array<lubjoint_out, width> outputs = outputs_of(*jacobian);
    if (n > 0) {
      require(*motion);
      for (const lubjoint_out& output : outputs) require("an array of the Jacobian", output.data);
    }
    const Bearing<double> geometry = bearing_of(*bearing);
    const auto table = c::table_of(law, geometry);
    const FilmFunctions<double>& functions = film_functions<double>(law);
    const FilmShape<double> shape{length_to_diameter(geometry), table == nullptr ? nullptr : &table->law};
    const double clearance = geometry.clearance();
    const double scale = force_scale(functions.limit, geometry, Lubricant<double>(bearing->viscosity));
    std::size_t i = 0;
    try {
      for (; i < n; ++i) {
        const JournalMotion<double> m = motion_at(*motion, i);
        const FilmSlopes<double> film = functions.slopes(film_state(m, clearance), shape);
        // ê = e/c and u = (v − ½(ω_J + ω_B) e⊥)/c
        const double mean_spin = 0.5 * (m.bearing_spin + m.journal_spin);
        const double unit = scale / clearance;
        std::array<double, width> row{scale * film.ratio.x(), scale * film.ratio.y()};
        for (Eigen::Index k = 0; k < 2; ++k) {
          const auto slope = film.by_state.row(k);
          const auto at = static_cast<std::size_t>(2 * k);
          row[2 + at] = unit * (slope(0) - mean_spin * slope(3));
          row[3 + at] = unit * (slope(1) + mean_spin * slope(2));
          row[6 + at] = unit * slope(2);
          row[7 + at] = unit * slope(3);
        }
        for (const double value : row) {
          if (!std::isfinite(value)) throw ForceRowError(i);
        }
        for (std::size_t k = 0; k < width; ++k) put(outputs[k], i, row[k]);
      }
    } catch (const FilmDomainError& error) {
      throw FilmRowError(i, error.what());
    }
  });
}
