#!/usr/bin/env python3
"""Stiffness and damping of the short bearing's half film under a load, for
    lubjoint verify --quantities coefficients --law short_half -- python3 coefficients.py MODE
and, with the modes that begin with "place", --quantities equilibrium.

Reads id, viscosity, length, radius, clearance, omega, load (along -y, bearing at rest) and answers the place, e/c and
attitude, and F = -K e - C v in inertial axes. Derivatives are those of the force in x and y, by a complex step: no
formula of a coefficient stands here. Other modes do what people do.
"""
import cmath
import csv
import math
import sys


def force(s, ex, ey, vx, vy):
    """Numbers may be complex, with small imaginary parts; a keeps the sign of the spin."""
    c = s["clearance"]
    e = cmath.sqrt(ex * ex + ey * ey)
    rx, ry = ex / e, ey / e
    eps = e / c
    b = (vx * rx + vy * ry) / c
    a = eps * s["omega"] - 2 * (vy * rx - vx * ry) / c
    q = (1 - eps) * (1 + eps)
    side = 1 if s["omega"] > 0 else -1
    scale = s["viscosity"] * s["radius"] * s["length"]**3 / c**2
    radial = -scale * (eps * a * side / q**2 + b * math.pi * (1 + 2 * eps * eps) / (2 * q**2.5))
    tangential = scale * (math.pi * a / (4 * q**1.5) + side * 2 * eps * b / q**2)
    return radial * rx - tangential * ry, radial * ry + tangential * rx


def rest(s, load, radial_alone=False):
    """e/c by bisection, then the attitude angle: the force at e = (0, -eps c) has to be turned until it points up."""
    low, high = 0.0, 1.0
    while True:
        eps = (low + high) / 2
        if eps in (low, high):
            break
        fx, fy = force(s, 0.0, -eps * s["clearance"], 0.0, 0.0)
        size = abs(fy) if radial_alone else math.hypot(fx.real, fy.real)
        low, high = (eps, high) if size < load else (low, eps)
    fx, fy = force(s, 0.0, -eps * s["clearance"], 0.0, 0.0)
    return eps, math.atan2(abs(fx.real), fy.real)


def matrices(s, eps, attitude, step=None):
    c = s["clearance"]
    side = 1 if s["omega"] > 0 else -1
    at = [eps * c * math.sin(attitude) * side, -eps * c * math.cos(attitude), 0.0, 0.0]
    columns = []
    for k in range(4):
        unit = c if k < 2 else c * abs(s["omega"])
        if step is None:
            h = 1e-30 * unit
            moved = [x + (1j * h if i == k else 0) for i, x in enumerate(at)]
            columns.append([-f.imag / h for f in force(s, *moved)])
        else:
            h = step * unit
            plus = force(s, *[x + (h if i == k else 0) for i, x in enumerate(at)])
            minus = force(s, *[x - (h if i == k else 0) for i, x in enumerate(at)])
            columns.append([-(p - m).real / (2 * h) for p, m in zip(plus, minus)])
    k = [columns[0][0], columns[1][0], columns[0][1], columns[1][1]]
    d = [columns[2][0], columns[3][0], columns[2][1], columns[3][1]]
    return k, d


def turned(m, angle):
    """Components along axes that are turned by an angle."""
    c, s = math.cos(angle), math.sin(angle)
    q = [[c, -s], [s, c]]
    full = [[m[0], m[1]], [m[2], m[3]]]
    return [sum(q[k][i] * full[k][l] * q[l][j] for k in (0, 1) for l in (0, 1)) for i in (0, 1) for j in (0, 1)]


def answer(mode, s):
    load, spin, c = s["load"], s["omega"], s["clearance"]
    turn = {"half_spin": 0.5, "revolutions": 2 * math.pi, "to_revolutions": 1 / (2 * math.pi)}
    s = dict(s, omega=spin * turn.get(mode.removeprefix("place_"), 1))
    if mode == "diameter":
        s = dict(s, radius=2 * s["radius"])
    if mode in ("half_load", "place_half_load"):
        load /= 2
    eps, attitude = rest(s, load, mode in ("radial_balance", "place_radial_balance"))
    k, d = matrices(s, eps, attitude, 1e-5 if mode == "differences" else None)
    place = [eps, attitude]
    side = 1 if spin > 0 else -1
    along_e = attitude * side - math.pi / 2  # the direction of e, counter-clockwise from x
    if mode == "exchanged":
        k, d = [k[0], k[2], k[1], k[3]], [d[0], d[2], d[1], d[3]]
    elif mode == "radial_axes":
        k, d = turned(k, along_e), turned(d, along_e)
    elif mode == "load_axes":
        k, d = turned(k, -math.pi / 2), turned(d, -math.pi / 2)
    elif mode == "positive":
        k, d = [-x for x in k], [-x for x in d]
    elif mode == "mirrored":
        k, d = [k[0], -k[1], -k[2], k[3]], [d[0], -d[1], -d[2], d[3]]
    elif mode == "not_mirrored" and spin < 0:
        k, d = [k[0], -k[1], -k[2], k[3]], [d[0], -d[1], -d[2], d[3]]
    elif mode == "half_damping":
        d = [x / 2 for x in d]
    elif mode == "per_radian":
        d = [x * abs(spin) for x in d]
    elif mode == "over_load":
        k, d = [x * c / load for x in k], [x * c * abs(spin) / load for x in d]
    elif mode == "two_springs":
        k, d = [k[0], 0.0, 0.0, k[3]], [d[0], 0.0, 0.0, d[3]]
    elif mode == "attitude_held":  # e moves along its own direction alone
        rx, ry = math.cos(along_e), math.sin(along_e)
        along = k[0] * rx + k[1] * ry, k[2] * rx + k[3] * ry
        k = [along[0] * rx, along[0] * ry, along[1] * rx, along[1] * ry]
    elif mode == "one_entry":  # no known mistake: a typing error in one of eight
        k[3] *= 1.25
    elif mode == "place_degrees":
        place[1] = math.degrees(attitude)
    elif mode == "place_from_across":
        place[1] = math.pi / 2 - attitude
    elif mode == "place_counter_clockwise":
        place[1] = attitude * side
    elif mode == "place_thickness":
        place[0] = 1 - eps
    return place, k, d


mode = sys.argv[1]
names = ["eccentricity_ratio", "attitude"]
if not mode.startswith("place"):
    names += ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"]
if mode == "stiffness_alone":
    names = ["kxx", "kxy", "kyx", "kyy"]
print("id," + ",".join(names))
for row in csv.DictReader(sys.stdin):
    place, k, d = answer(mode, {name: float(value) for name, value in row.items()})
    values = dict(zip(("eccentricity_ratio", "attitude", "kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"),
                      place + k + d))
    print(row["id"] + "," + ",".join(repr(values[name]) for name in names))
