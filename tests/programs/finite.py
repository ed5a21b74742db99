"""Reynolds' equation for the real length of a bearing by finite differences around it and a cosine series along it.

    finite.py MODE    right (the half film), full, coarse, or a mistake

States of `lubjoint verify --law finite_half` (or finite_full) on standard input, forces on standard output.
"""
import csv
import math
import sys

MODE = sys.argv[1] if len(sys.argv) > 1 else "right"
POINTS = {"coarse": 64, "clipped": 120}.get(MODE, 240)  # around half of the bearing
HARMONICS = {"coarse": 8, "clipped": 8}.get(MODE, 14)
STATIONS = 16  # along the bearing, where a pressure is clipped


def tridiagonal(below, middle, above, right):
    """Solves a tridiagonal system (Thomas)."""
    n = len(middle)
    c, d = [0.0] * n, [0.0] * n
    c[0], d[0] = above[0] / middle[0], right[0] / middle[0]
    for i in range(1, n):
        m = middle[i] - below[i] * c[i - 1]
        c[i], d[i] = above[i] / m, (right[i] - below[i] * d[i - 1]) / m
    for i in range(n - 2, -1, -1):
        d[i] -= c[i] * d[i + 1]
    return d


def periodic(below, middle, above, right):
    """The same with its ends joined (Sherman and Morrison)."""
    n, gamma = len(middle), -middle[0]
    changed = middle[:]
    changed[0] -= gamma
    changed[-1] -= below[0] * above[-1] / gamma
    x = tridiagonal(below, changed, above, right)
    corner = [gamma] + [0.0] * (n - 2) + [above[-1]]
    y = tridiagonal(below, changed, above, corner)
    factor = (x[0] + below[0] * x[-1] / gamma) / (1 + y[0] + below[0] * y[-1] / gamma)
    return [xi - factor * yi for xi, yi in zip(x, y)]


def sign(k):
    return 1 if MODE == "one_end" else (-1)**(k - 1)


def modes(shape, eps, a, b, start, whole):
    """Angles, and at each the amplitudes P_k of p = 6 mu (R/c)^2 sum of P_k cos((2k - 1) pi z/L) with their signs.

    d/dtheta(H^3 dP_k/dtheta) - Lambda_k^2 H^3 P_k = -g 4(-1)^(k-1)/((2k - 1) pi), g = a sin(theta) - 2b cos(theta)
    With one end closed: of sin((2k - 1) pi z/(2L)), z from the open one, all signs +.
    """
    n = 2 * POINTS if whole else POINTS
    step = (2 * math.pi if whole else math.pi) / n
    inner = [start + step * i for i in (range(n) if whole else range(1, n))]

    def cube(theta):
        return (1 + eps * math.cos(theta))**3

    west = [cube(t - step / 2) / step**2 for t in inner]
    east = [cube(t + step / 2) / step**2 for t in inner]
    found = []
    for k in range(1, HARMONICS + 1):
        wave = (2 * k - 1) * math.pi / ((4 if MODE == "one_end" else 2) * shape)
        share = 4 / ((2 * k - 1) * math.pi) * sign(k)
        middle = [-w - e - wave**2 * cube(t) for w, e, t in zip(west, east, inner)]
        right = [-share * (a * math.sin(t) - 2 * b * math.cos(t)) for t in inner]
        solve = periodic if whole else tridiagonal
        found.append(solve(west, middle, east, right))
    return inner, step, found


def force(shape, eps, a, b):
    """Radial and tangential force over mu L R^3/c^2."""
    whole = MODE in ("full", "clipped")
    start = 0.0 if whole or a >= 0 or MODE == "not_mirrored" else math.pi
    angles, step, found = modes(shape, eps, a, b, start, whole)
    radial = tangential = 0.0
    for i, theta in enumerate(angles):
        if MODE == "clipped":
            mean = 0.0
            for j in range(STATIONS):
                zeta = (j + 0.5) / (2 * STATIONS)  # z/L from 0 to 1/2
                p = sum(column[i] * math.cos((2 * k + 1) * math.pi * zeta) for k, column in enumerate(found))
                mean += max(p, 0.0) / STATIONS
        else:
            mean = sum(column[i] * 2 * sign(k) / ((2 * k - 1) * math.pi) for k, column in enumerate(found, 1))
        radial += 6 * mean * math.cos(theta) * step
        tangential += 6 * mean * math.sin(theta) * step
    return radial, tangential


def answer(s):
    c = s["clearance"] * (2 if MODE == "diametral" else 1)
    e = math.hypot(s["ex"], s["ey"])
    rx, ry = s["ex"] / e, s["ey"] / e
    eps = e / c
    b = (s["vx"] * rx + s["vy"] * ry) / c
    a = eps * (s["omega_bearing"] + s["omega_journal"]) - 2 * (s["vy"] * rx - s["vx"] * ry) / c
    if MODE in ("no_squeeze", "steady"):
        b = 0.0
    if MODE == "steady":
        a = eps * (s["omega_bearing"] + s["omega_journal"])
    if MODE == "half_squeeze":
        b /= 2
    shape = s["length"] / (2 * s["radius"])
    if MODE == "length_over_radius":
        shape *= 2
    radial, tangential = force(shape, eps, a, b)
    scale = s["viscosity"] * s["length"] * s["radius"]**3 / c**2
    if MODE == "half_length":
        scale /= 2
    return scale * (radial * rx - tangential * ry), scale * (radial * ry + tangential * rx)


print("id,fx,fy")
for row in csv.DictReader(sys.stdin):
    state = {name: float(value) for name, value in row.items() if name != "id"}
    print(row["id"], *map(repr, answer(state)), sep=",")
