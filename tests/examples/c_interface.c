/* A C program on the C interface; compiled as C11 by the tests. Ends with the number of the first claim that fails. */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "lubjoint.h"

static lubjoint_in all(const double* x) {
  const lubjoint_in array = {x, 0};
  return array;
}

/* A law that is a table: none at first, then the file's, then a law like the others. Returns 0 or the claim that fails. */
static int finite_film(const char* file) {
  const double pi = 3.14159265358979323846, zero = 0, one = 1, half = 0.5, load = 5000, spin = 300;
  const lubjoint_bearing bearing = {0.4, 0.04, 0.04, 2e-4}; /* L/D = 1/2 */
  double a[2], b[2], c[2];
  const lubjoint_out to_a = {a, 8}, to_b = {b, 8}, to_c = {c, 8};
  if (lubjoint_polar_force("finite_full", &bearing, 1, all(&half), all(&zero), all(&one), to_a, to_b) != ENOENT) return 60;
  if (!strstr(lubjoint_message(), "finite_full") || !strstr(lubjoint_message(), "0.5")) return 61;
  if (lubjoint_load_film("/dev/null") != EINVAL || lubjoint_use_film("no table") != EINVAL) return 62;
  if (lubjoint_load_film(file)) return 63;
  lubjoint_film said;
  if (lubjoint_film_of("finite_full", &bearing, &said)) return 64;
  if (said.length_to_diameter != 0.5 || !(said.error < 1e-6) || !(said.ratio_limit > 0.9)) return 65;
  if (lubjoint_film_of("short_full", &bearing, &said) != EINVAL) return 66;

  /* at the centre: softer than the short bearing's film, whose force is pi S b at L/D = 1/2 */
  if (lubjoint_polar_force("finite_full", &bearing, 1, all(&zero), all(&zero), all(&one), to_a, to_b)) return 67;
  const double scale = 0.4 * 0.04 * pow(0.04, 3) / (2e-4 * 2e-4);
  if (!(-a[0] > 0.5 * pi * scale && -a[0] < pi * scale) || b[0] != 0) return 68;

  /* the force is that of its motion, and minus its derivatives by e and v are the coefficients */
  double ratio, attitude, k[4], d[4], jacobian[10], more[3];
  if (lubjoint_film_equilibrium("finite_full", &bearing, 1, all(&load), all(&spin), (lubjoint_out){&ratio, 8},
                                (lubjoint_out){&attitude, 8})) {
    return 69;
  }
  if (fabs(attitude - pi / 2) > 1e-12) return 70; /* a full film answers at a right angle */
  const lubjoint_coefficients rest = {{&more[0], 8},
                                      {&more[1], 8},
                                      {{&k[0], 8}, {&k[1], 8}, {&k[2], 8}, {&k[3], 8}},
                                      {{&d[0], 8}, {&d[1], 8}, {&d[2], 8}, {&d[3], 8}},
                                      {&more[2], 8}};
  if (lubjoint_film_coefficients("finite_full", &bearing, 1, all(&ratio), all(&spin), &rest)) return 71;
  if (fabs(more[0] - load) > 1e-12 * load) return 72;
  const double ex = bearing.clearance * ratio * cos(attitude), ey = bearing.clearance * ratio * sin(attitude);
  const lubjoint_motion motion = {all(&ex), all(&ey), all(&zero), all(&zero), all(&zero), all(&spin)};
  lubjoint_jacobian to = {{&jacobian[0], 8}, {&jacobian[1], 8}, {{0}}, {{0}}};
  for (int i = 0; i < 4; ++i) {
    to.by_place[i] = (lubjoint_out){&jacobian[2 + i], 8};
    to.by_velocity[i] = (lubjoint_out){&jacobian[6 + i], 8};
  }
  if (lubjoint_force_jacobian("finite_full", &bearing, 1, &motion, &to)) return 73;
  if (fabs(jacobian[0] + load) > 1e-9 * load || fabs(jacobian[1]) > 1e-9 * load) return 74; /* x along the load */
  for (int i = 0; i < 4; ++i) {
    if (fabs(jacobian[2 + i] + k[i]) > 1e-9 * fabs(k[1]) || fabs(jacobian[6 + i] + d[i]) > 1e-9 * fabs(d[0])) return 75;
  }

  /* its velocity gives the force back; losses without side flow; what its table is not made for */
  int status[1];
  const double pull = -40;
  const lubjoint_mobility moving = {to_a, to_b, {NULL, 0}, {NULL, 0}, status};
  if (lubjoint_film_mobility("finite_full", &bearing, 1, all(&half), all(&zero), all(&pull), all(&zero), &moving)) return 76;
  const double slip = -2 * b[0], squeeze = a[0];
  if (lubjoint_polar_force("finite_full", &bearing, 1, all(&half), all(&slip), all(&squeeze), to_a, to_b)) return 77;
  if (fabs(a[0] - pull) > 1e-12 * fabs(pull) || fabs(b[0]) > 1e-12 * fabs(pull)) return 78;
  lubjoint_losses losses = {to_a, to_b, to_c, {NULL, 0}};
  if (lubjoint_film_losses("finite_full", &bearing, "film", 1, &motion, &losses) || !(c[0] > 0)) return 79;
  losses.side_flow = (lubjoint_out){&more[0], 8};
  if (lubjoint_film_losses("finite_full", &bearing, "film", 1, &motion, &losses) != EINVAL) return 80;
  const lubjoint_bearing endless = {0.4, 4, 0.04, 2e-4};
  if (lubjoint_polar_force("finite_full", &endless, 1, all(&half), all(&zero), all(&one), to_a, to_b) != EINVAL) return 81;
  const lubjoint_bearing longer = {0.4, 0.05, 0.04, 2e-4};
  if (lubjoint_journal_force("finite_full", &longer, 1, &motion, to_a, to_b) != ENOENT) return 82;
  return 0;
}

int main(int count, char** arguments) {
  if (count > 1) {
    const int failed = finite_film(arguments[1]);
    if (failed) return failed;
  }

  const lubjoint_bearing bearing = {0.04, 0.04, 0.01, 2e-4};
  const double pi = 3.14159265358979323846, zero = 0, one = 1, half = 0.5, minus = -1;
  double radial[2], tangential[2];
  const lubjoint_out to_radial = {radial, sizeof(double)}, to_tangential = {tangential, sizeof(double)};
  const double ratios[3] = {0.5, -1, 0};
  const lubjoint_in ratio = {ratios, 2 * sizeof(double)}; /* every second one: 0.5 and 0 */

  /* short full film, wedge only: F_t = S pi a/(2 q^1.5) */
  if (lubjoint_polar_force("short_full", &bearing, 2, ratio, all(&one), all(&zero), to_radial, to_tangential)) return 1;
  const double scale = 0.04 * 0.01 * pow(0.04, 3) / (2e-4 * 2e-4);
  if (fabs(tangential[0] - scale * pi / (2 * pow(0.75, 1.5))) > 1e-14 * tangential[0]) return 2;
  if (fabs(tangential[1] - scale * pi / 2) > 1e-14 * tangential[1]) return 3;

  /* arrays without gaps: the same numbers, the same errors */
  const double dense[2] = {0.5, 0}, ones[2] = {1, 1}, none[2] = {0, 0};
  double again_radial[2], again[2];
  if (lubjoint_polar_force_gapless("short_full", &bearing, 2, dense, ones, none, again_radial, again)) return 90;
  if (again[0] != tangential[0] || again[1] != tangential[1] || again_radial[0] != radial[0]) return 91;
  const double places[2] = {1e-4, 0};
  if (lubjoint_journal_force_gapless("short_full", &bearing, 2, places, none, none, none, none, ones, again_radial,
                                     again) ||
      fabs(again[0] - 0.5 * tangential[0]) > 1e-14 * tangential[0]) { /* along x, in a bearing at rest: a = 0.5 */
    return 92;
  }
  if (lubjoint_polar_force_gapless("short_full", &bearing, 2, ratios, ones, none, again_radial, again) != EDOM)
    return 93;
  if (lubjoint_polar_force_gapless("short_full", &bearing, 2, NULL, ones, none, again_radial, again) != EINVAL)
    return 94;
  if (!strstr(lubjoint_message(), "eccentricity_ratio is a null pointer")) return 95;

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
  if (laws != 18) return 11;

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

  /* a concentric journal: Petroff's torque, half of it on the half film */
  const double spin = 50;
  double torque[2], power[1], flow[1];
  const lubjoint_motion turning = {all(&zero), all(&zero), all(&zero), all(&zero), all(&zero), all(&spin)};
  const lubjoint_losses losses = {{&torque[0], 8}, {&torque[1], 8}, {power, 8}, {flow, 8}};
  const double petroff = 2 * pi * 0.04 * spin * pow(0.01, 3) * 0.04 / 2e-4;
  if (lubjoint_film_losses("short_half", &bearing, "film", 1, &turning, &losses)) return 30;
  if (fabs(torque[0] + petroff / 2) > 1e-14 * petroff || fabs(power[0] - spin * petroff / 2) > 1e-12) return 31;
  if (lubjoint_film_losses("short_half", &bearing, "flooded", 1, &turning, &losses)) return 32;
  if (fabs(torque[1] - petroff) > 1e-14 * petroff || flow[0] != 0) return 33;
  if (lubjoint_film_losses("long_half", &bearing, "film", 1, &turning, &losses) != EINVAL) return 34;
  if (!strstr(lubjoint_message(), "side_flow")) return 35;
  if (lubjoint_film_losses("short_full", &bearing, "striated", 1, &turning, &losses) != EINVAL) return 36;
  if (lubjoint_film_losses("short_full", &bearing, "wet", 1, &turning, &losses) != EINVAL) return 37;

  /* stiffness and damping of the short half film at 0.5, dimensionless: known to 20 digits */
  double number[11];
  lubjoint_coefficients rest;
  for (int k = 0; k < 4; ++k) {
    rest.stiffness[k] = (lubjoint_out){&number[2 + k], 8};
    rest.damping[k] = (lubjoint_out){&number[6 + k], 8};
  }
  rest.load = (lubjoint_out){&number[0], 8};
  rest.attitude = (lubjoint_out){&number[1], 8};
  rest.critical_mass = (lubjoint_out){&number[10], 8};
  if (lubjoint_film_coefficients("short_half", &bearing, 1, all(&half), all(&spin), &rest)) return 38;
  const double unit = 2e-4 / number[0];
  if (fabs(unit * number[2] - 2.9232504981753439929) > 1e-14) return 39;
  if (fabs(unit * spin * number[7] - 2.244955497755921797) > 1e-14) return 40;
  if (fabs(unit * spin * spin * number[10] - 6.4603957523295151749) > 1e-13) return 41;
  if (lubjoint_film_coefficients("short_half", &bearing, 1, all(&zero), all(&spin), &rest) != EDOM) return 42;
  if (lubjoint_film_coefficients("short_half", &bearing, 1, all(&half), all(&zero), &rest) != EDOM) return 43;
  if (!strstr(lubjoint_message(), "row 0") || !strstr(lubjoint_message(), "spin 0")) return 44;

  /* the place of rest is the one whose load it is; a velocity gives back its force */
  double place[2];
  const lubjoint_out to_ratio = {&place[0], 8}, to_attitude = {&place[1], 8};
  if (lubjoint_film_coefficients("short_half", &bearing, 1, all(&half), all(&spin), &rest)) return 45;
  if (lubjoint_film_equilibrium("short_half", &bearing, 1, all(&number[0]), all(&spin), to_ratio, to_attitude)) return 46;
  if (fabs(place[0] - 0.5) > 1e-14 || fabs(place[1] - number[1]) > 1e-14) return 47;
  if (lubjoint_film_equilibrium("short_half", &bearing, 1, all(&minus), all(&spin), to_ratio, to_attitude) != EDOM) {
    return 48;
  }
  if (!strstr(lubjoint_message(), "load of -1 N")) return 49;
  if (lubjoint_film_equilibrium("squeeze_short", &bearing, 1, all(&one), all(&spin), to_ratio, to_attitude) != EINVAL) {
    return 50;
  }
  const double pull = -40;
  double velocity[4];
  int status[1];
  lubjoint_mobility moving = {{&velocity[0], 8}, {&velocity[1], 8}, {NULL, 0}, {NULL, 0}, status};
  if (lubjoint_film_mobility("short_dynamic", &bearing, 1, all(&half), all(&zero), all(&pull), all(&zero), &moving)) {
    return 51;
  }
  if (status[0] != LUBJOINT_MOBILITY_FOUND) return 52;
  const double slip = -2 * velocity[1];
  if (lubjoint_polar_force("short_dynamic", &bearing, 1, all(&half), all(&slip), all(&velocity[0]), to_radial,
                           to_tangential)) {
    return 53;
  }
  if (fabs(radial[0] - pull) > 1e-13 * fabs(pull) || fabs(tangential[0]) > 1e-13 * fabs(pull)) return 54;
  moving.other_ux = (lubjoint_out){&velocity[2], 8};
  if (lubjoint_film_mobility("short_half", &bearing, 1, all(&half), all(&zero), all(&pull), all(&zero), &moving) !=
      EINVAL) {
    return 55;
  }
  moving.other_uy = (lubjoint_out){&velocity[3], 8};
  const double push = 40; /* the film opens: a of either sign */
  if (lubjoint_film_mobility("short_half", &bearing, 1, all(&half), all(&zero), all(&push), all(&zero), &moving)) return 56;
  if (status[0] != LUBJOINT_MOBILITY_TWO || velocity[0] != velocity[2] || velocity[1] != -velocity[3]) return 57;
  if (lubjoint_film_mobility("butenschoen", &bearing, 1, all(&half), all(&zero), all(&push), all(&zero), &moving) !=
      EINVAL) {
    return 58;
  }

  /* many rows: columns of a table, answered in its own columns, have the bits of arrays without gaps */
  enum { rows = 1500 };
  static double table[rows][3], column[3][rows], answer[2][rows];
  for (int i = 0; i < rows; ++i) {
    table[i][0] = column[0][i] = 0.97 * i / rows;
    table[i][1] = column[1][i] = cos(i);
    table[i][2] = column[2][i] = sin(i);
  }
  lubjoint_in in[3], gaps[3];
  lubjoint_out out[2], into[2];
  for (int k = 0; k < 3; ++k) {
    in[k] = (lubjoint_in){column[k], sizeof(double)};
    gaps[k] = (lubjoint_in){&table[0][k], sizeof table[0]};
  }
  for (int k = 0; k < 2; ++k) {
    out[k] = (lubjoint_out){answer[k], sizeof(double)};
    into[k] = (lubjoint_out){&table[0][k + 1], sizeof table[0]};
  }
  if (lubjoint_polar_force("pinkus_sternlicht", &bearing, rows, in[0], in[1], in[2], out[0], out[1])) return 17;
  if (lubjoint_polar_force("pinkus_sternlicht", &bearing, rows, gaps[0], gaps[1], gaps[2], into[0], into[1])) return 18;
  for (int i = 0; i < rows; ++i) {
    if (table[i][1] != answer[0][i] || table[i][2] != answer[1][i]) return 19;
  }

  /* a bad row far inside: named, those before it answered, the others untouched */
  column[0][1200] = 1;
  answer[0][1199] = answer[0][1200] = -7;
  const lubjoint_in gap = {&table[0][0], sizeof table[0]};
  table[1200][0] = 1;
  if (lubjoint_polar_force("pinkus_sternlicht", &bearing, rows, in[0], in[1], in[2], out[0], out[1]) != EDOM) return 20;
  if (!strstr(lubjoint_message(), "row 1200:") || answer[0][1199] == -7 || answer[0][1200] != -7) return 21;
  answer[0][1199] = answer[0][1200] = -7;
  if (lubjoint_polar_force("pinkus_sternlicht", &bearing, rows, gap, in[1], in[2], out[0], out[1]) != EDOM) return 22;
  if (!strstr(lubjoint_message(), "row 1200:") || answer[0][1199] == -7 || answer[0][1200] != -7) return 23;

  /* a force that is the next row's eccentricity ratio: row by row, in order; the film of the third row is the second's
   */
  double chain[3] = {0.5, 0.5, 0.5};
  const lubjoint_bearing weak = {1e-9, 0.04, 0.01, 2e-4};
  const lubjoint_out next = {chain + 1, sizeof(double)};
  if (lubjoint_polar_force("short_full", &weak, 2, (lubjoint_in){chain, sizeof(double)}, all(&zero), all(&minus), next,
                           to_tangential)) {
    return 24;
  }
  double second, first;
  const lubjoint_out to_first = {&first, 0}, to_second = {&second, 0};
  lubjoint_polar_force("short_full", &weak, 1, all(&half), all(&zero), all(&minus), to_first, to_tangential);
  lubjoint_polar_force("short_full", &weak, 1, all(&first), all(&zero), all(&minus), to_second, to_tangential);
  if (chain[1] != first || chain[2] != second || first == second) return 25;
  return 0;
}
