/* As force_law.cpp, through the C interface: at e = 0, F = -6 pi S v/c. */
#include <lubjoint.h>
#include <math.h>
#include <stdio.h>

int main(void) {
  const lubjoint_bearing bearing = {0.4, 0.04, 0.0098, 0.0002};
  const double zero = 0, vy = 1e-3, pi = acos(-1.0);
  double fx = -1, fy = -1;
  const lubjoint_in none = {&zero, 0}, rate = {&vy, 0};
  const lubjoint_motion motion = {none, none, none, rate, none, none};
  const lubjoint_out out_x = {&fx, 0}, out_y = {&fy, 0};
  const double expected = -6 * pi * (0.4 * 0.04 * pow(0.0098, 3) / (0.0002 * 0.0002)) * vy / 0.0002;
  if (lubjoint_journal_force("pinkus_sternlicht", &bearing, 1, &motion, out_x, out_y) != 0) {
    fprintf(stderr, "%s\n", lubjoint_message());
    return 1;
  }
  printf("lubjoint %s, C: %.17g N\n", lubjoint_version(), fy);
  return fabs(fy - expected) < 1e-14 * fabs(expected) && fx == 0 ? 0 : 1; /* a dozen roundings */
}
