#include "array_rows.hpp"

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
    const Bearing<double> geometry = bearing_of(*bearing);
    const Lubricant<double> oil(bearing->viscosity);
    with_film_law(law, [&]<class Law>() {
      const double scale = force_scale(Law::limit, geometry, oil);
      for_rows(n, radial, tangential, [&](std::size_t i) {
        const PolarForce<double> ratio = polar_force_ratio<Law>(
            PolarFilmState<double>(at(eccentricity_ratio, i), at(slip_rate, i), at(squeeze_rate, i)));
        return Vector2<double>(scale * ratio.radial, scale * ratio.tangential);
      });
    });
  });
}
