#include "array_blocks.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

int lubjoint_polar_force(const char* law, const lubjoint_bearing* bearing, size_t n, lubjoint_in eccentricity_ratio,
                         lubjoint_in slip_rate, lubjoint_in squeeze_rate, lubjoint_out radial,
                         lubjoint_out tangential) {
  return guarded([&] {
    require("law", law);
    require("bearing", bearing);
    if (n > 0) {
      require("eccentricity_ratio", eccentricity_ratio.data);
      require("slip_rate", slip_rate.data);
      require("squeeze_rate", squeeze_rate.data);
      require("radial", radial.data);
      require("tangential", tangential.data);
    }
    require_film_law<NamedFilmLaws>(law);
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    const auto table = table_of(law, geometry);
    for_blocks(n, std::array{eccentricity_ratio, slip_rate, squeeze_rate}, radial, tangential,
               [&](const auto& s, const ForceArrays& forces) {
                 const PolarStateArrays states{s[0], s[1], s[2]};
                 if (table == nullptr) return film_forces(law, geometry, oil, states, forces);
                 film_forces(table->law, geometry, oil, states, forces);
               });
  });
}
