#include "array_rows.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"

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
    with_film_law(law, [&]<class Law>() {
      const LubricatedJoint<Law, double> joint(bearing_of(*bearing), Lubricant<double>(bearing->viscosity));
      for_rows(n, fx, fy,
               [&](std::size_t i) { return joint.force(film_state(motion_at(*motion, i), bearing->clearance)); });
    });
  });
}
