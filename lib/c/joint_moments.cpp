#include <array>

#include "array_rows.hpp"
#include "lubjoint/joint/wrench.hpp"

using namespace lubjoint;
using namespace lubjoint::c;

int lubjoint_joint_moments(size_t n, lubjoint_in ex, lubjoint_in ey, lubjoint_in sx_i, lubjoint_in sy_i,
                           lubjoint_in sx_j, lubjoint_in sy_j, lubjoint_in fx, lubjoint_in fy, lubjoint_out mz_bearing,
                           lubjoint_out mz_journal) {
  return guarded([&] {
    if (n == 0) return;
    const std::array<lubjoint_in, 8> inputs = {ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy};
    constexpr std::array<const char*, 8> names = {"ex", "ey", "sx_i", "sy_i", "sx_j", "sy_j", "fx", "fy"};
    for (std::size_t k = 0; k < inputs.size(); ++k) require(names[k], inputs[k].data);
    require("mz_bearing", mz_bearing.data);
    require("mz_journal", mz_journal.data);
    for_rows(n, mz_bearing, mz_journal, [&](std::size_t i) {
      const JournalMotion<double> motion{{at(ex, i), at(ey, i)}, {0, 0}, 0, 0};
      const JointKinematics<double> joint{{at(sx_i, i), at(sy_i, i)}, {at(sx_j, i), at(sy_j, i)}, motion};
      const JointWrenches<double> wrenches = joint_wrenches(joint, Vector2<double>(at(fx, i), at(fy, i)));
      return Vector2<double>(wrenches.bearing.moment, wrenches.journal.moment);
    });
  });
}
