#!/usr/bin/env python3
"""Small force programs of the kinds that people write, for `lubjoint verify --law LAW -- python3 programs.py MODE`.

Reads the Cartesian protocol (id, viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy) from standard
input and answers id, fx, fy. This file holds the programs that are right or right to some digits; mistaken.py holds the wrong ones.
Every program was written from the mathematics, without looking at how it is judged; what must and must not be said of each stands in
expected.csv. A division by zero, a root of a negative number or an overflow is answered by nan, as numerical environments do.
"""
import csv
import math
import sys

import mistaken
from films import capone, long_half, motion, pinkus_sternlicht, scales, short_half, to_xy

PI = math.pi


def gauss_legendre(n):
    """Nodes and weights on [-1, 1], by Newton's method on the Legendre polynomial."""
    rule = []
    for i in range(n):
        x = math.cos(PI * (i + 0.75) / (n + 0.5))
        for _ in range(20):
            p0, p1 = 1.0, x
            for k in range(2, n + 1):
                p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
            slope = n * (x * p1 - p0) / (x * x - 1)
            x -= p1 / slope
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


GAUSS_30 = gauss_legendre(30)


# Right ones, in different formulations.

def polar_angles(g):
    """short_half, with the angle of the centre line and its rate."""
    c, e = g["clearance"], math.hypot(g["ex"], g["ey"])
    s = g["viscosity"] * g["radius"] * g["length"]**3 / c**2
    if e == 0:
        return -0.5 * PI * s * g["vx"] / c, -0.5 * PI * s * g["vy"] / c
    gamma = math.atan2(g["ey"], g["ex"])
    gamma_dot = (g["ex"] / e * g["vy"] - g["ey"] / e * g["vx"]) / e
    eps = e / c
    eps_dot = (g["ex"] / e * g["vx"] + g["ey"] / e * g["vy"]) / c
    wedge = eps * (g["omega_journal"] + g["omega_bearing"] - 2 * gamma_dot)
    f_e, f_gamma = short_half(eps, wedge, eps_dot)
    return (s * (f_e * math.cos(gamma) - f_gamma * math.sin(gamma)),
            s * (f_e * math.sin(gamma) + f_gamma * math.cos(gamma)))


def vectors(g):
    """short_full, linear in the pure-squeeze velocity; no angle and no division by e."""
    c = g["clearance"]
    x, y = g["ex"] / c, g["ey"] / c
    mean = 0.5 * (g["omega_journal"] + g["omega_bearing"])
    ux, uy = g["vx"] / c + mean * y, g["vy"] / c - mean * x
    e = math.hypot(x, y)
    q = (1 - e) * (1 + e)
    k = -PI * g["viscosity"] * g["radius"] * g["length"]**3 / c**2 / q**2.5
    along = 3 * (x * ux + y * uy)
    return k * (q * ux + along * x), k * (q * uy + along * y)


def damping_matrix(g):
    """long_full, as a 2 x 2 damping matrix in the frame that turns with half the spins."""
    m = motion(g)
    mean = 0.5 * m.spin
    ux, uy = (g["vx"] + mean * g["ey"]) / m.c, (g["vy"] - mean * g["ex"]) / m.c
    radial = 12 * PI / m.q**1.5
    tangential = 24 * PI / ((2 + m.eps**2) * math.sqrt(m.q))
    cxx = radial * m.rx**2 + tangential * m.ry**2
    cyy = radial * m.ry**2 + tangential * m.rx**2
    cxy = (radial - tangential) * m.rx * m.ry
    s = scales(g)[1]
    return -s * (cxx * ux + cxy * uy), -s * (cxy * ux + cyy * uy)


def mirrored(g):
    """long_half: computed for a forward wedge, mirrored for a backward one."""
    m = motion(g)
    f_r, f_t = long_half(m.eps, abs(m.a), m.b)
    return to_xy(m, scales(g)[1], f_r, f_t if m.a >= 0 else -f_t)


def pinkus_without_quotients(g):
    """pinkus_sternlicht, multiplied through so that nothing is singular at rest of e or at the centre."""
    m = motion(g)
    return to_xy(m, scales(g)[1], *pinkus_sternlicht(m.eps, m.q, m.a, m.b))


def sommerfeld_variable(g):
    """short_dynamic, by 30 Gauss points in Sommerfeld's variable, in which the integrand is a short trigonometric polynomial."""
    m = motion(g)
    start = math.atan2(2 * m.b, m.a)
    psi = 2 * math.atan2(math.sqrt(1 - m.eps) * math.sin(start / 2), math.sqrt(1 + m.eps) * math.cos(start / 2))
    half = math.atan2(math.sqrt(m.q), -m.eps * math.sin(start))
    f_r = f_t = 0.0
    root = math.sqrt(m.q)
    for x, w in GAUSS_30:
        t = psi + half * (1 + x)
        sine, cosine = root * math.sin(t), (1 - m.eps) - 2 * math.sin(t / 2)**2
        p = w * half * (m.a * sine - 2 * m.b * cosine)
        f_r += p * cosine
        f_t += p * sine
    return to_xy(m, 0.5 * scales(g)[0] / m.q**2.5, f_r, f_t)


# Numerical ones, right to some digits.

def simpson_200(g):
    """short_half: Simpson's rule with 200 intervals over the half that carries."""
    m = motion(g)
    n, first = 200, 0.0 if m.a >= 0 else PI
    f_r = f_t = 0.0
    for k in range(n + 1):
        t = first + PI * k / n
        w = 1 if k in (0, n) else 4 if k % 2 else 2
        p = w * (m.a * math.sin(t) - 2 * m.b * math.cos(t)) / (1 + m.eps * math.cos(t))**3
        f_r += p * math.cos(t)
        f_t += p * math.sin(t)
    return to_xy(m, 0.5 * scales(g)[0] * PI / n / 3, f_r, f_t)


def clipped_360(g):
    """short_dynamic: negative pressure clipped to zero, one sum over 360 degrees."""
    m = motion(g)
    f_r = f_t = 0.0
    for degree in range(360):
        t = math.radians(degree)
        p = max(0.0, (m.a * math.sin(t) - 2 * m.b * math.cos(t)) / (1 + m.eps * math.cos(t))**3)
        f_r += p * math.cos(t)
        f_t += p * math.sin(t)
    return to_xy(m, 0.5 * scales(g)[0] * 2 * PI / 360, f_r, f_t)


def periodic_64(g):
    """short_full: 64 equally spaced angles, which for a smooth periodic pressure converges very quickly away from the wall."""
    m = motion(g)
    f_r = f_t = 0.0
    for k in range(64):
        t = 2 * PI * k / 64
        p = (m.a * math.sin(t) - 2 * m.b * math.cos(t)) / (1 + m.eps * math.cos(t))**3
        f_r += p * math.cos(t)
        f_t += p * math.sin(t)
    return to_xy(m, 0.5 * scales(g)[0] * 2 * PI / 64, f_r, f_t)


def tridiagonal_180(g):
    """long_half: finite differences for the pressure, 180 intervals over pi, solved by elimination."""
    m = motion(g)
    n = 180
    d, a = PI / n, abs(m.a)
    face = [(1 + m.eps * math.cos((k + 0.5) * d))**3 for k in range(n)]
    upper, right = [0.0] * n, [0.0] * n
    for k in range(1, n):
        source = -6 * (a * math.sin(k * d) - 2 * m.b * math.cos(k * d)) * d * d
        pivot = -(face[k - 1] + face[k]) - face[k - 1] * upper[k - 1]
        upper[k] = face[k] / pivot
        right[k] = (source - face[k - 1] * right[k - 1]) / pivot
    p = [0.0] * (n + 1)
    for k in range(n - 1, 0, -1):
        p[k] = right[k] - upper[k] * p[k + 1]
    f_r = sum(p[k] * math.cos(k * d) for k in range(n)) * d
    f_t = sum(p[k] * math.sin(k * d) for k in range(n)) * d
    return to_xy(m, scales(g)[1], f_r, f_t if m.a >= 0 else -f_t)


def cumulative_pressure_720(g):
    """long_full: the pressure added up from its slope by the trapezoidal rule at 720 angles, then integrated."""
    m = motion(g)
    n = 720
    d = 2 * PI / n
    angles = [k * d for k in range(n + 1)]
    h3 = [(1 + m.eps * math.cos(t))**3 for t in angles]
    flow = [6 * (m.a * math.cos(t) + 2 * m.b * math.sin(t)) for t in angles]
    closing = -sum(f / h for f, h in zip(flow[:n], h3)) / sum(1 / h for h in h3[:n])
    slope = [(f + closing) / h for f, h in zip(flow, h3)]
    p = f_r = f_t = 0.0
    for k in range(n):
        f_r += p * math.cos(angles[k]) * d
        f_t += p * math.sin(angles[k]) * d
        p += 0.5 * (slope[k] + slope[k + 1]) * d
    return to_xy(m, scales(g)[1], f_r, f_t)


def trapezoid_2000(g):
    """long_dynamic: the film from its start to its start + pi by the trapezoidal rule, pressure zero at both ends."""
    m = motion(g)
    n, start = 2000, math.atan2(2 * m.b, m.a)
    one = sine = flow = flow_sine = cosine = flow_cosine = 0.0
    for k in range(n + 1):
        t = start + PI * k / n
        w = (0.5 if k in (0, n) else 1.0) * PI / n / (1 + m.eps * math.cos(t))**3
        f = w * (m.a * math.cos(t) + 2 * m.b * math.sin(t))
        one, sine, cosine = one + w, sine + w * math.sin(t), cosine + w * math.cos(t)
        flow, flow_sine, flow_cosine = flow + f, flow_sine + f * math.sin(t), flow_cosine + f * math.cos(t)
    c = -flow / one
    return to_xy(m, 6 * scales(g)[1], -(flow_sine + c * sine), flow_cosine + c * cosine)


def axial_trapezoid_50(g):
    """short_half in closed form around, with the axial parabola added up over 50 strips: (1 - 1/50^2) of the force, everywhere."""
    m = motion(g)
    n, length = 50, g["length"]
    axial = sum(length**2 / 4 - (length * (k / n - 0.5))**2 for k in range(1, n)) * length / n
    return to_xy(m, 6 * g["viscosity"] * g["radius"] / m.c**2 * axial, *short_half(m.eps, m.a, m.b))


def series_40(g):
    """short_full with the powers of 1 - eps^2 as binomial series of 40 terms."""
    m = motion(g)

    def power(exponent):
        term = total = 1.0
        for k in range(1, 40):
            term *= (exponent + k - 1) / k * m.eps**2
            total += term
        return total
    return to_xy(m, PI * scales(g)[0], -m.b * (1 + 2 * m.eps**2) * power(2.5), m.a / 2 * power(1.5))


def wall_softened(g):
    """long_half with 1e-8 added to 1 - eps^2 against division by zero."""
    m = motion(g)
    eps = m.eps
    q, d, s = 1 - eps**2 + 1e-8, 2 + eps**2, 1 if m.a >= 0 else -1
    f_r = -(12 * eps * abs(m.a) / (d * q) + 6 * m.b / q**1.5 * (PI - 16 / (PI * d)))
    f_t = 6 * PI * m.a / (d * math.sqrt(q)) + s * 24 * eps * m.b / (d * q)
    return to_xy(m, scales(g)[1], f_r, f_t)


def differenced_rates(g):
    """short_half with both rates from a small step along the velocity instead of derivatives."""
    m = motion(g)
    speed = math.hypot(g["vx"], g["vy"])
    a, b = m.eps * m.spin, m.b
    if m.e > 0 and speed > 0:
        dt = 1e-6 * m.e / speed
        x, y = g["ex"] + g["vx"] * dt, g["ey"] + g["vy"] * dt
        b = (math.hypot(x, y) - m.e) / dt / m.c
        turned = math.atan2(m.rx * y - m.ry * x, m.rx * x + m.ry * y)
        a -= 2 * m.eps * turned / dt
    return to_xy(m, scales(g)[0], *short_half(m.eps, a, b))


def capone_form(g):
    """short_dynamic in Capone's closed form: exact, but the terms cancel towards the wall where the film opens."""
    c = g["clearance"]
    x, y = g["ex"] / c, g["ey"] / c
    spin = g["omega_journal"] + g["omega_bearing"]
    wx, wy = spin * x - 2 * g["vy"] / c, spin * y + 2 * g["vx"] / c
    f = capone(x, y, wx, wy, math.atan2(-wy, -wx))
    s = scales(g)[0] / 4
    return s * f[0], s * f[1]


HERE = (polar_angles, vectors, damping_matrix, mirrored, pinkus_without_quotients, sommerfeld_variable, simpson_200, clipped_360,
        periodic_64, tridiagonal_180, cumulative_pressure_720, trapezoid_2000, axial_trapezoid_50, series_40, wall_softened,
        differenced_rates, capone_form)


def main():
    programs = {f.__name__: f for f in HERE} | mistaken.PROGRAMS
    if len(sys.argv) != 2 or sys.argv[1] not in programs:
        sys.exit("usage: programs.py MODE, with MODE one of " + " ".join(programs))
    program = programs[sys.argv[1]]
    print("id,fx,fy")
    for row in csv.DictReader(sys.stdin):
        try:
            fx, fy = program({name: float(text) for name, text in row.items()})
        except (ValueError, ZeroDivisionError, OverflowError):
            fx = fy = math.nan
        print(f"{row['id']},{fx!r},{fy!r}")


if __name__ == "__main__":
    main()
