"""Adapter for lubjoint verify: put your film force into `film` below, and run
    lubjoint verify --law LAW -- python3 THIS_FILE
As it stands it has the short bearing's full film, --law short_full. SI units throughout.
"""
import csv
import math
import sys


def film(viscosity, length, radius, clearance, omega_bearing, omega_journal, eps, eps_dot, gamma_dot):
    """Radial and tangential force on the journal [N]: along r, from the bearing's centre to the journal's, and along t,
    r turned by 90 degrees counter-clockwise. eps = e/c, eps_dot its rate [1/s], gamma_dot the rate of the direction of
    r [rad/s] (0 where e = 0)."""
    # ---- yours from here ----
    a = eps * (omega_journal + omega_bearing - 2 * gamma_dot)
    q = (1 - eps) * (1 + eps)
    scale = viscosity * radius * length**3 / clearance**2
    radial = -scale * math.pi * eps_dot * (1 + 2 * eps * eps) / q**2.5
    tangential = scale * math.pi * a / (2 * q**1.5)
    # ---- to here ----
    return radial, tangential


def main():
    print("id,fx,fy")
    rows = csv.reader(sys.stdin)
    next(rows)  # the columns' names
    for row in rows:
        viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy = map(float, row[1:])
        e = math.hypot(ex, ey)
        # At the centre r is the direction of the motion; at rest there any will do.
        x, y = (ex, ey) if e > 0 else (vx, vy)
        size = math.hypot(x, y)
        rx, ry = (x / size, y / size) if size > 0 else (1.0, 0.0)
        eps_dot = (vx * rx + vy * ry) / clearance
        gamma_dot = (vy * rx - vx * ry) / e if e > 0 else 0.0
        radial, tangential = film(viscosity, length, radius, clearance, omega_bearing, omega_journal, e / clearance,
                                  eps_dot, gamma_dot)
        print(f"{row[0]},{radial * rx - tangential * ry!r},{radial * ry + tangential * rx!r}")


if __name__ == "__main__":
    main()
