"""Film force of the short bearing where its pressure is positive, summed over 720 angles, for
    lubjoint verify --law short_dynamic -- python3 numerical_short_dynamic.py
"""
import csv
import math
import sys

ANGLES = [(k + 0.5) * 2 * math.pi / 720 for k in range(720)]
COSINES = [math.cos(theta) for theta in ANGLES]
SINES = [math.sin(theta) for theta in ANGLES]


def force(viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy):
    distance = math.hypot(ex, ey)
    along = (ex, ey) if distance > 0 else (vx, vy)
    size = math.hypot(*along)
    if size == 0:
        return 0.0, 0.0
    rx, ry = along[0] / size, along[1] / size
    eps = distance / clearance
    b = (vx * rx + vy * ry) / clearance
    slide = (vy * rx - vx * ry) / clearance if distance > 0 else 0.0
    a = eps * (omega_journal + omega_bearing) - 2 * slide
    radial = tangential = 0.0
    for c, s in zip(COSINES, SINES):
        pressure = a * s - 2 * b * c
        if pressure > 0:
            pressure /= (1 + eps * c) ** 3
            radial += pressure * c
            tangential += pressure * s
    scale = viscosity * radius * length**3 / clearance**2 * math.pi / 720
    return scale * (radial * rx - tangential * ry), scale * (radial * ry + tangential * rx)


print("id,fx,fy")
reader = csv.reader(sys.stdin)
next(reader)
for row in reader:
    fx, fy = force(*map(float, row[1:]))
    print(f"{row[0]},{fx!r},{fy!r}")
