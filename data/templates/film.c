/* Adapter for lubjoint verify: put your film force into `film` below, and run
 *     cc -O2 film.c -o film -lm && lubjoint verify --law LAW -- ./film
 * As it stands it has the short bearing's full film, --law short_full. SI units throughout. */
#include <math.h>
#include <stdio.h>

/* Radial and tangential force on the journal [N]: along r, from the bearing's centre to the journal's, and along t, r
 * turned by 90 degrees counter-clockwise. eps = e/c, eps_dot its rate [1/s], gamma_dot the rate of the direction of r
 * [rad/s] (0 where e = 0). */
static void film(double viscosity, double length, double radius, double clearance, double omega_bearing,
                 double omega_journal, double eps, double eps_dot, double gamma_dot, double* radial,
                 double* tangential) {
  /* ---- yours from here ---- */
  const double pi = 3.14159265358979323846;
  const double a = eps * (omega_journal + omega_bearing - 2 * gamma_dot);
  const double q = (1 - eps) * (1 + eps);
  const double scale = viscosity * radius * pow(length, 3) / (clearance * clearance);
  *radial = -scale * pi * eps_dot * (1 + 2 * eps * eps) / pow(q, 2.5);
  *tangential = scale * pi * a / (2 * pow(q, 1.5));
  /* ---- to here ---- */
}

int main(void) {
  char line[1024];
  long id;
  double viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy;
  if (!fgets(line, sizeof line, stdin)) return 1; /* the columns' names */
  puts("id,fx,fy");
  while (fgets(line, sizeof line, stdin)) {
    if (sscanf(line, "%ld,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &id, &viscosity, &length, &radius, &clearance,
               &omega_bearing, &omega_journal, &ex, &ey, &vx, &vy) != 11) {
      return 1;
    }
    const double e = hypot(ex, ey);
    /* At the centre r is the direction of the motion; at rest there any will do. */
    const double x = e > 0 ? ex : vx, y = e > 0 ? ey : vy;
    const double size = hypot(x, y);
    const double rx = size > 0 ? x / size : 1, ry = size > 0 ? y / size : 0;
    const double eps_dot = (vx * rx + vy * ry) / clearance;
    const double gamma_dot = e > 0 ? (vy * rx - vx * ry) / e : 0;
    double radial, tangential;
    film(viscosity, length, radius, clearance, omega_bearing, omega_journal, e / clearance, eps_dot, gamma_dot, &radial,
         &tangential);
    printf("%ld,%.17g,%.17g\n", id, radial * rx - tangential * ry, radial * ry + tangential * rx);
  }
  return 0;
}
