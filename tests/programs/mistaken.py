"""The wrong force programs: wrong in a part of the domain, for steady running only, in a unit, in one term, in the axes, in the spins,
in several ways at once, or of another law than the one claimed. Each is one function from a Cartesian state to (fx, fy)."""
import math

from films import (capone, long_full, long_half, long_half_eq5, motion, pinkus_sternlicht, scales, short_full, short_half, to_xy)

PI = math.pi
NAN = math.nan


def sign(x):
    return 1 if x >= 0 else -1


# Wrong, or no number, in a part of the domain.

def clamped_099(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_half(min(m.eps, 0.99), m.a, m.b))


def nan_at_centre(g):
    gamma_dot = (g["ex"] * g["vy"] - g["ey"] * g["vx"]) / (g["ex"]**2 + g["ey"]**2)
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_half(m.eps, m.eps * (m.spin - 2 * gamma_dot), m.b))


def nothing_at_centre(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_full(m.eps, m.a, m.b)) if m.e > 0 else (0.0, 0.0)


def table_to_095(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_half(m.eps, m.a, m.b)) if m.eps <= 0.95 else (NAN, NAN)


def forward_wedge_only(g):
    m = motion(g)
    d = 2 + m.eps**2
    f_r = -(12 * m.eps * m.a / (d * m.q) + 6 * m.b / m.q**1.5 * (PI - 16 / (PI * d)))
    f_t = 6 * PI * m.a / (d * math.sqrt(m.q)) + 24 * m.eps * m.b / (d * m.q)
    return to_xy(m, scales(g)[1], f_r, f_t)


def closing_only(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_half(m.eps, m.a, max(m.b, 0.0)))


def pinkus_in_quotients(g):
    m = motion(g)
    gamma_dot = m.whirl / m.eps
    k = math.sqrt(m.q) * math.hypot((m.spin - 2 * gamma_dot) / (2 * m.b), 1 / m.eps)
    d = 2 + m.eps**2
    if m.b > 0:
        f_r = -6 * m.b / (d * m.q**1.5) * (4 * k * m.eps**2 + PI * d * (k + 3) / (k + 1.5))
        f_t = 6 * PI * m.a / (d * math.sqrt(m.q)) * (k + 3) / (k + 1.5)
    else:
        f_r = 6 * m.b / (d * m.q**1.5) * (4 * k * m.eps**2 - PI * d * k / (k + 1.5))
        f_t = 6 * PI * m.a / (d * math.sqrt(m.q)) * k / (k + 1.5)
    return to_xy(m, scales(g)[1], f_r, f_t)


def pinkus_opening_sign(g):
    m = motion(g)
    f_r, f_t = pinkus_sternlicht(m.eps, m.q, m.a, m.b)
    if m.b < 0:
        f_r += 48 * m.eps * math.sqrt(m.q) * math.hypot(m.a / 2, m.b) / ((2 + m.eps**2) * m.q**1.5)
    return to_xy(m, scales(g)[1], f_r, f_t)


def nan_without_journal_spin(g):
    m = motion(g)
    w = g["omega_journal"]
    f_r, f_t = short_full(m.eps, m.eps * (m.spin / w) - 2 * (m.whirl / w), m.b / w)
    return to_xy(m, scales(g)[0] * w, f_r, f_t)


def capone_size_of_spin(g):
    c = g["clearance"]
    w = abs(g["omega_journal"] + g["omega_bearing"]) + 1e-10
    x, y = g["ex"] / c, g["ey"] / c
    wx, wy = x - 2 * g["vy"] / (c * w), y + 2 * g["vx"] / (c * w)
    f = capone(x, y, wx, wy, math.atan2(-wy, -wx))
    return scales(g)[0] * w / 4 * f[0], scales(g)[0] * w / 4 * f[1]


def linear_about_centre(g):
    c = g["clearance"]
    damping = PI * scales(g)[0] / c
    cross = damping * 0.5 * (g["omega_journal"] + g["omega_bearing"])
    return -damping * g["vx"] - cross * g["ey"], -damping * g["vy"] + cross * g["ex"]


# For steady running only.

def load_and_attitude(g):
    m = motion(g)
    load = scales(g)[0] * m.relative * m.eps / (4 * m.q**2) * math.sqrt(16 * m.eps**2 + PI**2 * m.q)
    attitude = math.atan2(PI * math.sqrt(m.q), 4 * m.eps)
    return to_xy(m, load, -math.cos(attitude), math.sin(attitude))


def steady_both_spins(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_half(m.eps, m.eps * m.spin, 0.0))


def steady_sommerfeld_number(g):
    m = motion(g)
    number = 12 * PI * m.eps / ((2 + m.eps**2) * math.sqrt(m.q))
    f = g["viscosity"] * g["omega_journal"] * g["length"] * g["radius"] / (m.c / g["radius"])**2 * number
    return to_xy(m, f, 0.0, 1.0)


def whirl_left_out(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_full(m.eps, m.eps * m.spin, m.b))


# In a unit or an input.

def millimetres(g):
    g = dict(g, **{name: 1e3 * g[name] for name in ("length", "radius", "clearance", "ex", "ey", "vx", "vy")})
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_half(m.eps, m.a, m.b))


def spins_in_rpm(g):
    m = motion(g)
    a = m.eps * m.spin * 2 * PI / 60 - 2 * m.whirl
    return to_xy(m, scales(g)[0], *short_full(m.eps, a, m.b))


def diameter_for_radius(g):
    m = motion(g)
    return to_xy(m, scales(dict(g, radius=2 * g["radius"]))[1], *long_full(m.eps, m.a, m.b))


def diametral_clearance(g):
    g = dict(g, clearance=2 * g["clearance"])
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_half(m.eps, m.a, m.b))


def half_length(g):
    m = motion(g)
    return to_xy(m, scales(dict(g, length=g["length"] / 2))[0], *short_half(m.eps, m.a, m.b))


def long_scale_for_short(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *short_half(m.eps, m.a, m.b))


# One term wrong.

def wedge_exponent(g):
    m = motion(g)
    f_r, _ = short_half(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[0], f_r, 0.5 * (PI * m.a / (2 * m.q) + sign(m.a) * 4 * m.eps * m.b / m.q**2))


def eccentricity_forgotten(g):
    m = motion(g)
    f_r, _ = short_half(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[0], f_r, 0.5 * (PI * m.a / (2 * m.q**1.5) + sign(m.a) * 4 * m.b / m.q**2))


def one_plus_square(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], -PI * m.b * (1 + m.eps**2) / m.q**2.5, short_full(m.eps, m.a, m.b)[1])


def two_plus_eccentricity(g):
    m = motion(g)
    f_r, _ = long_full(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[1], f_r, 12 * PI * m.a / ((2 + m.eps) * math.sqrt(m.q)))


def squeeze_doubled(g):
    m = motion(g)
    d = 2 + m.eps**2
    f_r = -12 * (m.eps * abs(m.a) / (d * m.q) + m.b / m.q**1.5 * (PI - 16 / (PI * d)))
    return to_xy(m, scales(g)[1], f_r, long_half(m.eps, m.a, m.b)[1])


def negative_damping(g):
    m = motion(g)
    f_r, f_t = short_full(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[0], -f_r, f_t)


def half_forgotten(g):
    m = motion(g)
    f_r, f_t = short_half(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[0], f_r, f_t + PI * m.a / (4 * m.q**1.5))


def denominator_forgotten(g):
    m = motion(g)
    d = 2 + m.eps**2
    f_r = -(12 * m.eps * abs(m.a) / m.q + 6 * m.b / m.q**1.5 * (PI - 16 / (PI * d)))
    return to_xy(m, scales(g)[1], f_r, long_half(m.eps, m.a, m.b)[1])


def parenthesis_lost(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], -PI * m.b * 1 + 2 * m.eps**2 / m.q**2.5, short_full(m.eps, m.a, m.b)[1])


# In the axes.

def rotation_transposed(g):
    m = motion(g)
    f_r, f_t = short_half(m.eps, m.a, m.b)
    s = scales(g)[0]
    return s * (f_r * m.rx + f_t * m.ry), s * (f_t * m.rx - f_r * m.ry)


def tangent_clockwise(g):
    m = motion(g)
    tx, ty = m.ry, -m.rx
    a = m.eps * m.spin - 2 * ((g["vx"] * tx + g["vy"] * ty) / m.c if m.e > 0 else 0.0)
    f_r, f_t = short_full(m.eps, a, m.b)
    s = scales(g)[0]
    return s * (f_r * m.rx + f_t * tx), s * (f_r * m.ry + f_t * ty)


def tangential_reversed(g):
    m = motion(g)
    f_r, f_t = long_half(m.eps, m.a, m.b)
    return to_xy(m, scales(g)[1], f_r, -f_t)


def angle_from_y(g):
    m = motion(g)
    f_r, f_t = short_half(m.eps, m.a, m.b)
    angle = math.atan2(m.rx, m.ry)
    s = scales(g)[0]
    return (s * (f_r * math.cos(angle) - f_t * math.sin(angle)), s * (f_r * math.sin(angle) + f_t * math.cos(angle)))


def angle_by_arccos(g):
    m = motion(g)
    f_r, f_t = long_full(m.eps, m.a, m.b)
    angle = math.acos(max(-1.0, min(1.0, m.rx)))
    s = scales(g)[1]
    return (s * (f_r * math.cos(angle) - f_t * math.sin(angle)), s * (f_r * math.sin(angle) + f_t * math.cos(angle)))


def capone_without_quadrant(g):
    c = g["clearance"]
    x, y = g["ex"] / c, g["ey"] / c
    spin = g["omega_journal"] + g["omega_bearing"]
    wx, wy = spin * x - 2 * g["vy"] / c, spin * y + 2 * g["vx"] / c
    f = capone(x, y, wx, wy, math.atan(wy / wx) if wx != 0 else PI / 2)
    return scales(g)[0] / 4 * f[0], scales(g)[0] / 4 * f[1]


def film_from_minimum(g):
    m = motion(g)
    n, f_r, f_t = 720, 0.0, 0.0
    for k in range(n):
        t = 2 * PI * (k + 0.5) / n
        p = max(0.0, (m.a * math.sin(t) - 2 * m.b * math.cos(t)) / (1 - m.eps * math.cos(t))**3)
        f_r, f_t = f_r + p * math.cos(t), f_t + p * math.sin(t)
    return to_xy(m, 0.5 * scales(g)[0] * 2 * PI / n, f_r, f_t)


# In the spins.

def relative_spin(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_half(m.eps, m.eps * m.relative - 2 * m.whirl, m.b))


def journal_spin_only(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_full(m.eps, m.eps * g["omega_journal"] - 2 * m.whirl, m.b))


def whirl_once(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_half(m.eps, m.eps * m.spin - m.whirl, m.b))


def half_spin(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_full(m.eps, m.eps * m.spin / 2 - 2 * m.whirl, m.b))


# Several at once.

def on_bearing_relative_spin(g):
    fx, fy = relative_spin(g)
    return -fx, -fy


def steady_diameter_clockwise(g):
    m = motion(g)
    f_r, f_t = long_half(m.eps, m.eps * m.spin, 0.0)
    return to_xy(m, scales(dict(g, radius=2 * g["radius"]))[1], f_r, -f_t)


def two_terms(g):
    m = motion(g)
    f_r = -(2 * m.eps * abs(m.a) / m.q**2 + 0.5 * PI * m.b * (1 + 2 * m.eps**2) / m.q**2.5)
    f_t = 0.5 * (PI * m.a / (2 * m.q) + sign(m.a) * 4 * m.eps * m.b / m.q**2)
    return to_xy(m, scales(g)[0], f_r, f_t)


def rpm_and_centipoise(g):
    fx, fy = spins_in_rpm(g)
    return fx / 1000, fy / 1000


# Another law than the one claimed, and no answer at all.

def full_for_half(g):
    m = motion(g)
    return to_xy(m, scales(g)[0], *short_full(m.eps, m.a, m.b))


def dynamic_for_half(g):
    c = g["clearance"]
    x, y = g["ex"] / c, g["ey"] / c
    spin = g["omega_journal"] + g["omega_bearing"]
    wx, wy = spin * x - 2 * g["vy"] / c, spin * y + 2 * g["vx"] / c
    f = capone(x, y, wx, wy, math.atan2(-wy, -wx))
    return scales(g)[0] / 4 * f[0], scales(g)[0] / 4 * f[1]


def cut_at_pi(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *long_half_eq5(m.eps, m.a, m.b))


def pinkus_for_dynamic(g):
    m = motion(g)
    return to_xy(m, scales(g)[1], *pinkus_sternlicht(m.eps, m.q, m.a, m.b))


def sign_under_root(g):
    m = motion(g)
    root = math.sqrt(m.eps**2 - 1)
    return to_xy(m, scales(g)[1], -12 * PI * m.b / root**3, 12 * PI * m.a / ((2 + m.eps**2) * root))


PROGRAMS = {f.__name__: f for f in (
    clamped_099, nan_at_centre, nothing_at_centre, table_to_095, forward_wedge_only, closing_only, pinkus_in_quotients,
    pinkus_opening_sign, nan_without_journal_spin, capone_size_of_spin, linear_about_centre, load_and_attitude, steady_both_spins,
    steady_sommerfeld_number, whirl_left_out, millimetres, spins_in_rpm, diameter_for_radius, diametral_clearance, half_length,
    long_scale_for_short, wedge_exponent, eccentricity_forgotten, one_plus_square, two_plus_eccentricity, squeeze_doubled,
    negative_damping, half_forgotten, denominator_forgotten, parenthesis_lost, rotation_transposed, tangent_clockwise,
    tangential_reversed, angle_from_y, angle_by_arccos, capone_without_quadrant, film_from_minimum, relative_spin, journal_spin_only,
    whirl_once, half_spin, on_bearing_relative_spin, steady_diameter_clockwise, two_terms, rpm_and_centipoise, full_for_half,
    dynamic_for_half, cut_at_pi, pinkus_for_dynamic, sign_under_root)}
