"""Film force of the short bearing with a half (Gümbel) film (Flores et al. 2009, eqs. 8 and 9), for
    lubjoint verify --law short_half -- python3 short_half.py
With the argument "steady": as textbooks have it, for a steadily loaded bearing. With "pi": a factor pi is lost.
"""
import csv
import math
import sys


def force(viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy, variant=""):
    distance = math.hypot(ex, ey)
    along = (ex, ey) if distance > 0 else (vx, vy)  # at the centre: the direction of motion
    size = math.hypot(*along)
    if size == 0:
        return 0.0, 0.0
    rx, ry = along[0] / size, along[1] / size
    eps = distance / clearance
    b = (vx * rx + vy * ry) / clearance
    slide = (vy * rx - vx * ry) / clearance if distance > 0 else 0.0
    a = eps * (omega_journal + omega_bearing) - 2 * slide
    if variant == "steady":
        a, b = eps * (omega_journal - omega_bearing), 0.0

    q = (1 - eps) * (1 + eps)
    side = 1 if a >= 0 else -1
    squeeze = b * (1 + 2 * eps * eps) / (2 * q**2.5) * (1 if variant == "pi" else math.pi)
    scale = viscosity * radius * length**3 / clearance**2
    radial = -scale * (eps * abs(a) / q**2 + squeeze)
    tangential = scale * (math.pi * a / (4 * q**1.5) + side * 2 * eps * b / q**2)
    return radial * rx - tangential * ry, radial * ry + tangential * rx


def main():
    print("id,fx,fy")
    reader = csv.reader(sys.stdin)
    next(reader)
    for row in reader:
        fx, fy = force(*map(float, row[1:]), variant="".join(sys.argv[1:]))
        print(f"{row[0]},{fx!r},{fy!r}")


if __name__ == "__main__":
    main()
