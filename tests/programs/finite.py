"""Reynolds' equation for the real length of a bearing by finite differences around it and a cosine series along it.

    finite.py MODE    right (the half film), full, dynamic, reynolds, coarse, or a mistake, of the dynamic and of the
                      rupturing film with "dynamic_" or "reynolds_" before it

States of `lubjoint verify --law finite_half` (or another) on standard input, forces on standard output. The film that
ruptures where it will has no series along the bearing: its pressure is relaxed on a grid and kept from being negative.
"""
import csv
import math
import sys

MODE = sys.argv[1] if len(sys.argv) > 1 else "right"
FILM = "half"
for _film in ("dynamic", "reynolds"):
    if MODE.startswith(_film):
        FILM, MODE = _film, MODE.removeprefix(_film).removeprefix("_") or "right"
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


def ruptured(shape, eps, a, b, points=180, stations=8, sweeps=2000):
    """Radial and tangential force over mu L R^3/c^2 of p >= 0 with d/dtheta(H^3 dp/dtheta) + (R/L)^2 H^3 d2p/dzeta2
    = -g wherever p > 0, g = a sin(theta) - 2b cos(theta), zeta = z/L: over-relaxed by points, from the middle to an end.
    """
    step, across = 2 * math.pi / points, 0.5 / stations
    angles = [step * i for i in range(points)]
    cube = [(1 + eps * math.cos(t + step / 2))**3 / step**2 for t in angles]  # on the way to the next angle
    along = [(1 + eps * math.cos(t))**3 / (2 * shape * across)**2 for t in angles]
    source = [a * math.sin(t) - 2 * b * math.cos(t) for t in angles]
    p = [[0.0] * (stations + 1) for _ in angles]  # the last is the end, and zero
    relax = 1.85
    for _ in range(sweeps):
        largest = change = 0.0
        for i in range(points):
            west, east, w = p[i - 1], p[(i + 1) % points], p[i]
            cw, ce, cz, g = cube[i - 1], cube[i], along[i], source[i]
            total = cw + ce + 2 * cz
            for j in range(stations):
                inner = w[j - 1] if j else w[1]
                new = w[j] + relax * ((g + cw * west[j] + ce * east[j] + cz * (inner + w[j + 1])) / total - w[j])
                if new < 0:
                    new = 0.0
                change = max(change, abs(new - w[j]))
                largest = max(largest, new)
                w[j] = new
        if change <= 1e-6 * largest:
            break
    # The trapezoid rule along the bearing, both halves; 6 mu (R/c)^2 is the pressure's unit, the equation's is that, too.
    mean = [across * (w[0] + 2 * sum(w[1:stations])) for w in p]
    return (6 * step * sum(m * math.cos(t) for m, t in zip(mean, angles)),
            6 * step * sum(m * math.sin(t) for m, t in zip(mean, angles)))


def force(shape, eps, a, b):
    """Radial and tangential force over mu L R^3/c^2."""
    if FILM == "reynolds":
        return ruptured(shape, eps, a, b)
    whole = MODE in ("full", "clipped")
    start = 0.0 if whole or a >= 0 or MODE == "not_mirrored" else math.pi
    if FILM == "dynamic":
        start = math.atan2(2 * b, a)
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
    if MODE in ("revolutions", "to_revolutions"):
        a += eps * (s["omega_bearing"] + s["omega_journal"]) * (2 * math.pi if MODE == "revolutions" else 0.5 / math.pi)
        a -= eps * (s["omega_bearing"] + s["omega_journal"])
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
