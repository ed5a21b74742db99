// Adapter for lubjoint verify: put your film force into `film` below, and run
//     c++ -O2 film.cpp -o film && lubjoint verify --law LAW -- ./film
// As it stands it has the short bearing's full film, --law short_full. SI units throughout.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

struct State {
  double viscosity, length, radius, clearance, omega_bearing, omega_journal;
  double eps, eps_dot;  // e/c and its rate [1/s]
  double gamma_dot;     // rate of the direction of r [rad/s]; 0 where e = 0
};

// On the journal [N].
struct Force {
  double radial;      // along r, from the bearing's centre to the journal's
  double tangential;  // along t, r turned by 90 degrees counter-clockwise
};

Force film(const State& s) {
  // ---- yours from here ----
  const double pi = 3.14159265358979323846;
  const double a = s.eps * (s.omega_journal + s.omega_bearing - 2 * s.gamma_dot);
  const double q = (1 - s.eps) * (1 + s.eps);
  const double scale = s.viscosity * s.radius * std::pow(s.length, 3) / (s.clearance * s.clearance);
  return {-scale * pi * s.eps_dot * (1 + 2 * s.eps * s.eps) / std::pow(q, 2.5),
          scale * pi * a / (2 * std::pow(q, 1.5))};
  // ---- to here ----
}

int main() {
  std::string line;
  std::getline(std::cin, line);  // the columns' names
  std::puts("id,fx,fy");
  while (std::getline(std::cin, line)) {
    long id = 0;
    State s{};
    double ex, ey, vx, vy;
    if (std::sscanf(line.c_str(), "%ld,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &id, &s.viscosity, &s.length,
                    &s.radius, &s.clearance, &s.omega_bearing, &s.omega_journal, &ex, &ey, &vx, &vy) != 11) {
      return 1;
    }
    const double e = std::hypot(ex, ey);
    // At the centre r is the direction of the motion; at rest there any will do.
    const double x = e > 0 ? ex : vx, y = e > 0 ? ey : vy;
    const double size = std::hypot(x, y);
    const double rx = size > 0 ? x / size : 1, ry = size > 0 ? y / size : 0;
    s.eps = e / s.clearance;
    s.eps_dot = (vx * rx + vy * ry) / s.clearance;
    s.gamma_dot = e > 0 ? (vy * rx - vx * ry) / e : 0;
    const Force f = film(s);
    std::printf("%ld,%.17g,%.17g\n", id, f.radial * rx - f.tangential * ry, f.radial * ry + f.tangential * rx);
  }
}
