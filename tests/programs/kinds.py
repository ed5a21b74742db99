#!/usr/bin/env python3
"""Small force programs of the kinds that people write, for `lubjoint verify … -- python3 kinds.py MODE`.

Reads the Cartesian protocol (id, viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy) and answers
id, fx, fy. What must be said of each stands in kinds.csv.
"""
import csv
import math
import sys


def short_half(eps, a, b):
    q = 1 - eps * eps
    s = 1 if a >= 0 else -1
    return (-0.5 * (2 * eps * abs(a) / q**2 + math.pi * b * (1 + 2 * eps * eps) / q**2.5),
            0.5 * (math.pi * a / (2 * q**1.5) + s * 4 * eps * b / q**2))


def long_half(eps, a, b, wrong=1.0):
    q, d = 1 - eps * eps, 2 + eps * eps
    s = 1 if a >= 0 else -1
    return (-(12 * eps * abs(a) / (d * q) + 6 * b / q**1.5 * (math.pi - wrong * 16 / (math.pi * d))),
            6 * math.pi * a / (d * math.sqrt(q)) + s * 24 * eps * b / (d * q))


def short_dynamic_by_midpoints(eps, a, b, n):
    fr = ft = 0.0
    d = 2 * math.pi / n
    for k in range(n):
        t = (k + 0.5) * d
        p = (a * math.sin(t) - 2 * b * math.cos(t)) / (1 + eps * math.cos(t))**3
        if p > 0:
            fr += p * math.cos(t) * d
            ft += p * math.sin(t) * d
    return fr / 2, ft / 2


def answer(mode, g):
    spin = g["omega_bearing"] + g["omega_journal"]
    relative = g["omega_journal"] - g["omega_bearing"]
    c, radius = g["clearance"], g["radius"]
    e = math.hypot(g["ex"], g["ey"])
    along = (g["ex"], g["ey"]) if e > 0 else (g["vx"], g["vy"])
    size = math.hypot(*along)
    if size == 0:
        return 0.0, 0.0
    rx, ry = along[0] / size, along[1] / size
    eps = e / c
    b = (g["vx"] * rx + g["vy"] * ry) / c
    vt = (g["vy"] * rx - g["vx"] * ry) / c if e > 0 else 0.0
    a = eps * spin - 2 * vt
    short = g["viscosity"] * radius * g["length"]**3 / c**2
    long = g["viscosity"] * g["length"] * radius**3 / c**2
    scale = short
    if mode == "right":
        f = short_half(eps, a, b)
    elif mode == "midpoints_60":
        f = short_dynamic_by_midpoints(eps, a, b, 60)
    elif mode == "midpoints_720":
        f = short_dynamic_by_midpoints(eps, a, b, 720)
    elif mode == "regularised":
        eps += 1e-10
        f = short_half(eps, eps * spin - 2 * vt, b)
    elif mode == "steady":
        f = short_half(eps, eps * relative, 0.0)
    elif mode == "squeeze_left_out":
        f = short_half(eps, a, 0.0)
    elif mode == "size_of_spin":
        f = short_half(eps, eps * abs(spin) - 2 * vt, b)
    elif mode == "nan_for_reverse":
        f = short_half(eps, a, b) if spin > 0 else (math.nan, math.nan)
    elif mode == "nan_at_rest":
        f = short_half(eps, a, b) if spin != 0 else (math.nan, math.nan)
    elif mode == "pi_lost":  # in the squeeze part of the radial force
        q = 1 - eps * eps
        f = (-0.5 * (2 * eps * abs(a) / q**2 + b * (1 + 2 * eps * eps) / q**2.5), short_half(eps, a, b)[1])
    elif mode == "not_over_omega":
        f = short_half(eps, eps * spin - 2 * vt * spin, b * spin)
    elif mode == "poise":
        f = short_half(eps, a, b)
        scale *= 10
    elif mode == "long_pi_lost":  # 8/(2+eps^2) where 8/(pi (2+eps^2)) is right
        f = long_half(eps, a, b, math.pi)
        scale = long
    elif mode == "steady_on_bearing":  # three at once: steady only, R + c, the force on the bearing
        f = short_half(eps, eps * relative, 0.0)
        scale *= -(radius + c) / radius
    elif mode == "angle_without_quadrant":  # in the turning of (F_r, F_t) into x and y alone
        f = short_half(eps, a, b)
        if e > 0 and g["ex"] < 0:
            rx, ry = -rx, -ry
    elif mode == "thin_opening_reversed":  # short dynamic film by 4000 midpoints, its sign wrong in the thinnest opening films
        f = short_dynamic_by_midpoints(eps, a, b, 4000)
        if 1 - eps < 1e-5 and b < 0:
            f = (-f[0], -f[1])
    else:
        sys.exit(f"kinds.py: there is no mode {mode}")
    fr, ft = scale * f[0], scale * f[1]
    return fr * rx - ft * ry, fr * ry + ft * rx


print("id,fx,fy")
for row in csv.DictReader(sys.stdin):
    fx, fy = answer(sys.argv[1], {k: float(v) for k, v in row.items()})
    print(f"{row['id']},{fx!r},{fy!r}")
