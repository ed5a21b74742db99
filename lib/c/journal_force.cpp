#include "array_blocks.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

int lubjoint_journal_force(const char* law, const lubjoint_bearing* bearing, size_t n, const lubjoint_motion* motion,
                           lubjoint_out fx, lubjoint_out fy) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    require("motion", motion);
    if (n > 0) {
      require(*motion);
      require("fx", fx.data);
      require("fy", fy.data);
    }
    require_film_law<NamedFilmLaws>(law);
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    if (const auto table = table_of(law, geometry)) {
      std::visit(
          [&]<class Law>(const Law& compiled) {
            const double scale = force_scale(Law::limit, geometry, oil);
            for_rows(n, fx, fy, [&](std::size_t i) {
              const FilmState<double> film = film_state(motion_at(*motion, i), geometry.clearance());
              return Vector2<double>(scale * compiled_force_ratio(compiled, film));
            });
          },
          table->law);
      return;
    }
    const std::array in = {motion->ex,           motion->ey, motion->vx, motion->vy, motion->omega_bearing,
                           motion->omega_journal};
    for_blocks(n, in, fx, fy, [&](const auto& m, const ForceArrays& forces) {
      film_forces(law, geometry, oil, JournalMotionArrays{m[0], m[1], m[2], m[3], m[4], m[5]}, forces);
    });
  });
}
