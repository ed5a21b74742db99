#include "lubjoint.h"

namespace {

constexpr ptrdiff_t gapless = sizeof(double);

lubjoint_in in(const double* array) { return {array, gapless}; }
lubjoint_out out(double* array) { return {array, gapless}; }

}  // namespace

int lubjoint_polar_force_gapless(const char* law, const lubjoint_bearing* bearing, size_t n,
                                 const double* eccentricity_ratio, const double* slip_rate, const double* squeeze_rate,
                                 double* radial, double* tangential) {
  return lubjoint_polar_force(law, bearing, n, in(eccentricity_ratio), in(slip_rate), in(squeeze_rate), out(radial),
                              out(tangential));
}

int lubjoint_journal_force_gapless(const char* law, const lubjoint_bearing* bearing, size_t n, const double* ex,
                                   const double* ey, const double* vx, const double* vy, const double* omega_bearing,
                                   const double* omega_journal, double* fx, double* fy) {
  const lubjoint_motion motion{in(ex), in(ey), in(vx), in(vy), in(omega_bearing), in(omega_journal)};
  return lubjoint_journal_force(law, bearing, n, &motion, out(fx), out(fy));
}
