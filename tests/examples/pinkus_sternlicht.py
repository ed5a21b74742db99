"""Film force of Pinkus and Sternlicht (Flores et al. 2009, eqs. 14 to 18), for
    lubjoint verify --law pinkus_sternlicht -- python3 pinkus_sternlicht.py
With the argument "wrong": the relative spin is combined with the attitude rate of the inertial frame.
"""
import csv
import math
import sys


def force(viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy, wrong=False):
    distance = math.hypot(ex, ey)
    along = (ex, ey) if distance > 0 else (vx, vy)  # at the centre: the direction of motion
    size = math.hypot(*along)
    if size == 0:
        return 0.0, 0.0
    rx, ry = along[0] / size, along[1] / size
    eps = distance / clearance
    b = (vx * rx + vy * ry) / clearance
    slide = (vy * rx - vx * ry) / clearance if distance > 0 else 0.0
    spin = omega_journal - omega_bearing if wrong else omega_journal + omega_bearing
    a = eps * spin - 2 * slide

    q = (1 - eps) * (1 + eps)
    d = 2 + eps * eps
    k = math.sqrt(q) * math.hypot(a / 2, b)
    bb = eps * abs(b)
    phi = 1.0 if k + bb == 0 else (k + (3 * bb if b >= 0 else 0.0)) / (k + 1.5 * bb)
    scale = viscosity * length * radius**3 / clearance**2
    radial = -scale * 6 / (d * q**1.5) * (4 * eps * k + math.pi * d * b * phi)
    tangential = scale * 6 * math.pi * a * phi / (d * math.sqrt(q))
    return radial * rx - tangential * ry, radial * ry + tangential * rx


def main():
    wrong = "wrong" in sys.argv[1:]
    lines = ["id,fx,fy"]
    reader = csv.reader(sys.stdin)
    next(reader)
    for row in reader:
        fx, fy = force(*map(float, row[1:]), wrong=wrong)
        lines.append(f"{row[0]},{fx!r},{fy!r}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
