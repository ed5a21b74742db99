"""Force of the short bearing's film with the extent that the motion gives it, in the form without dimensions that
rotordynamics uses (Capone 1991): place in clearances, time in 1/omega, force in S omega/4, S = mu R L^3/c^2. For
    lubjoint verify --law short_dynamic --quantities dimensionless --unit 0.25 -- python3 capone.py
With the argument "wrong": velocities count once, not twice.
"""
import csv
import sys
from math import atan, hypot, pi, sqrt


def force(x, y, vx, vy, twice):
    p = x - twice * vy
    q = y + twice * vx
    size = hypot(p, q)
    if size == 0:
        return 0.0, 0.0
    cosine, sine = -p / size, -q / size  # of the angle where the film begins
    gap = (1 - hypot(x, y)) * (1 + hypot(x, y))
    along = x * cosine + y * sine
    across = y * cosine - x * sine
    g = 2 / sqrt(gap) * (pi / 2 + atan(across / sqrt(gap)))
    v = (2 + across * g) / gap
    f = along / (gap + across * across)
    scale = -size / gap
    return (scale * (3 * x * v - sine * g - 2 * cosine * f),
            scale * (3 * y * v + cosine * g - 2 * sine * f))


def main():
    twice = 1 if "wrong" in sys.argv else 2
    print("id,fx,fy")
    rows = csv.reader(sys.stdin)
    next(rows)
    for row in rows:
        fx, fy = force(*map(float, row[1:]), twice)
        print(f"{row[0]},{fx!r},{fy!r}")


if __name__ == "__main__":
    main()
