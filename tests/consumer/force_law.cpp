// At e = 0 and without spin every law that is isotropic there is plain damping: for Pinkus-Sternlicht F = -6 pi S v/c.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/version.hpp"

int main() {
  const lubjoint::Bearing<double> bearing(0.04, 0.0098, 0.0002);
  const lubjoint::Lubricant<double> oil(0.4);
  const lubjoint::JournalMotion<double> motion{{0, 0}, {0, 1e-3}, 0, 0};
  const auto force =
      lubjoint::film_force<lubjoint::PinkusSternlicht>(bearing, oil, lubjoint::film_state(motion, bearing.clearance()));
  const double scale = 0.4 * 0.04 * std::pow(0.0098, 3) / (0.0002 * 0.0002);
  const double expected = -6 * std::numbers::pi * scale * 1e-3 / 0.0002;
  std::printf("lubjoint %s, headers: %.17g N\n", LUBJOINT_VERSION, force.y());
  return std::abs(force.y() - expected) < 1e-14 * std::abs(expected) && force.x() == 0 ? 0 : 1;  // a dozen roundings
}
