/* Film force of the short bearing, half film (Flores et al. 2009, eqs. 8 and 9), for
 *     cc -O2 short_half.c -o short_half -lm && lubjoint verify --law short_half -- ./short_half
 * With the argument "wrong": the forms are used as printed, for a >= 0, also where a < 0. */
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

int main(int argc, char** argv) {
  const int wrong = argc > 1 && strcmp(argv[1], "wrong") == 0;
  char line[1024];
  if (!fgets(line, sizeof line, stdin)) return 1; /* header */
  puts("id,fx,fy");
  long id;
  double mu, length, radius, c, wb, wj, ex, ey, vx, vy;
  while (fgets(line, sizeof line, stdin)) {
    if (sscanf(line, "%ld,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &id, &mu, &length, &radius, &c, &wb, &wj, &ex, &ey,
               &vx, &vy) != 11) {
      return 1;
    }
    const int centred = ex == 0 && ey == 0;
    const double rx0 = centred ? vx : ex, ry0 = centred ? vy : ey; /* at the centre: the direction of motion */
    const double size = hypot(rx0, ry0);
    const double rx = size > 0 ? rx0 / size : 1, ry = size > 0 ? ry0 / size : 0;
    const double eps = hypot(ex, ey) / c;
    const double b = (vx * rx + vy * ry) / c;
    const double a = eps * (wj + wb) - (centred ? 0 : 2 * (vy * rx - vx * ry) / c);
    const double side = a < 0 && !wrong ? -1 : 1;
    const double q = (1 - eps) * (1 + eps);
    const double scale = mu * radius * pow(length, 3) / (c * c);
    const double radial = -scale / 2 * (side * 2 * eps * a / (q * q) + pi * b * (1 + 2 * eps * eps) / pow(q, 2.5));
    const double tangential = scale / 2 * (pi * a / (2 * pow(q, 1.5)) + side * 4 * eps * b / (q * q));
    printf("%ld,%.17g,%.17g\n", id, radial * rx - tangential * ry, radial * ry + tangential * rx);
  }
  return 0;
}
