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
    const auto table = table_of(law, geometry);
    const std::array in = {motion->ex,           motion->ey, motion->vx, motion->vy, motion->omega_bearing,
                           motion->omega_journal};
    for_blocks(n, in, fx, fy, [&](const auto& m, const ForceArrays& forces) {
      const JournalMotionArrays motions{m[0], m[1], m[2], m[3], m[4], m[5]};
      if (table == nullptr) return film_forces(law, geometry, oil, motions, forces);
      film_forces(table->law, geometry, oil, motions, forces);
    });
  });
}
