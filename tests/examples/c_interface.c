/* A C program on the C interface; compiled as C11 by the tests. Ends with the number of the first claim that fails. */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "lubjoint.h"

static lubjoint_in all(const double* x) {
  const lubjoint_in array = {x, 0};
  return array;
}

int main(void) {
  const lubjoint_bearing bearing = {0.04, 0.04, 0.01, 2e-4};
  const double pi = 3.14159265358979323846, zero = 0, one = 1, half = 0.5;
  double radial[2], tangential[2];
  const lubjoint_out to_radial = {radial, sizeof(double)}, to_tangential = {tangential, sizeof(double)};
  const double ratios[3] = {0.5, -1, 0};
  const lubjoint_in ratio = {ratios, 2 * sizeof(double)}; /* every second one: 0.5 and 0 */

  /* short full film, wedge only: F_t = S pi a/(2 q^1.5) */
  if (lubjoint_polar_force("short_full", &bearing, 2, ratio, all(&one), all(&zero), to_radial, to_tangential)) return 1;
  const double scale = 0.04 * 0.01 * pow(0.04, 3) / (2e-4 * 2e-4);
  if (fabs(tangential[0] - scale * pi / (2 * pow(0.75, 1.5))) > 1e-14 * tangential[0]) return 2;
  if (fabs(tangential[1] - scale * pi / 2) > 1e-14 * tangential[1]) return 3;

  /* errors: number, message, and the row */
  const lubjoint_in bad = {ratios, sizeof(double)};
  if (lubjoint_polar_force("short_full", &bearing, 2, bad, all(&one), all(&zero), to_radial, to_tangential) != EDOM) {
    return 4;
  }
  if (!strstr(lubjoint_message(), "row 1") || !strstr(lubjoint_message(), "-1")) return 5;
  if (lubjoint_polar_force("short", &bearing, 0, ratio, ratio, ratio, to_radial, to_tangential) != EINVAL) return 6;
  if (!strstr(lubjoint_message(), "short_half")) return 7;
  if (lubjoint_polar_force(NULL, &bearing, 0, ratio, ratio, ratio, to_radial, to_tangential) != EINVAL) return 8;
  const lubjoint_bearing thick = {0.04, 0.04, 0.01, 0.02};
  if (lubjoint_polar_force("short_full", &thick, 0, ratio, ratio, ratio, to_radial, to_tangential) != EINVAL) return 9;
  const double huge = 1e308;
  if (lubjoint_polar_force("long_full", &bearing, 1, all(&half), all(&huge), all(&zero), to_radial, to_tangential) !=
      ERANGE) {
    return 10;
  }

  /* laws */
  size_t laws = 0;
  while (lubjoint_law_name(laws)) ++laws;
  if (laws != 8) return 11;

  /* a joint whose film and wall act, and its moments */
  const double e = 2.1e-4, arm = 0.1;
  const lubjoint_motion motion = {all(&e), all(&zero), all(&zero), all(&zero), all(&zero), all(&one)};
  const lubjoint_contact contact = {4e-6, 2e-5, 1e10, 0.9, 0.1};
  if (lubjoint_journal_force("long_half", &bearing, 1, &motion, to_radial, to_tangential) != EDOM) return 12;
  if (lubjoint_transition_force("long_half", &bearing, &contact, 1, &motion, to_radial, to_tangential)) return 13;
  if (fabs(radial[0] + 1e10 * pow(1e-5, 1.5)) > 1e-9 * fabs(radial[0]) || tangential[0] != 0) return 14;
  const double f = 3;
  if (lubjoint_joint_moments(1, all(&e), all(&zero), all(&arm), all(&zero), all(&arm), all(&zero), all(&zero), all(&f),
                             to_radial, to_tangential)) {
    return 15;
  }
  if (fabs(radial[0] + (arm + e) * f) > 1e-15 || fabs(tangential[0] - arm * f) > 1e-15) return 16;
  return 0;
}
