"""What the programs share: the motion of the journal in polar components, the scales of force, and the force laws as published."""
import math
from types import SimpleNamespace

PI = math.pi


def motion(g):
    """Radial and tangential directions, eccentricity ratio, squeeze rate b and slip rate a of a Cartesian state.

    At the centre the radial direction is that of the velocity.
    """
    c, e, speed = g["clearance"], math.hypot(g["ex"], g["ey"]), math.hypot(g["vx"], g["vy"])
    if e > 0:
        rx, ry = g["ex"] / e, g["ey"] / e
    elif speed > 0:
        rx, ry = g["vx"] / speed, g["vy"] / speed
    else:
        rx, ry = 1.0, 0.0
    eps = e / c
    b = (g["vx"] * rx + g["vy"] * ry) / c
    whirl = (g["vy"] * rx - g["vx"] * ry) / c if e > 0 else 0.0
    spin = g["omega_journal"] + g["omega_bearing"]
    return SimpleNamespace(c=c, e=e, eps=eps, q=(1 - eps) * (1 + eps), rx=rx, ry=ry, b=b, whirl=whirl, spin=spin,
                           relative=g["omega_journal"] - g["omega_bearing"], a=eps * spin - 2 * whirl)


def scales(g):
    """The scales of force of the short and of the long bearing."""
    k = g["viscosity"] * g["length"] * g["radius"] / g["clearance"]**2
    return k * g["length"]**2, k * g["radius"]**2


def to_xy(m, scale, f_r, f_t):
    return scale * (f_r * m.rx - f_t * m.ry), scale * (f_r * m.ry + f_t * m.rx)


def short_full(eps, a, b):
    q = (1 - eps) * (1 + eps)
    return -PI * b * (1 + 2 * eps**2) / q**2.5, PI * a / (2 * q**1.5)


def short_half(eps, a, b):
    q, s = (1 - eps) * (1 + eps), 1 if a >= 0 else -1
    return (-0.5 * (2 * eps * abs(a) / q**2 + PI * b * (1 + 2 * eps**2) / q**2.5),
            0.5 * (PI * a / (2 * q**1.5) + s * 4 * eps * b / q**2))


def long_full(eps, a, b):
    q = (1 - eps) * (1 + eps)
    return -12 * PI * b / q**1.5, 12 * PI * a / ((2 + eps**2) * math.sqrt(q))


def long_half(eps, a, b):
    q, d, s = (1 - eps) * (1 + eps), 2 + eps**2, 1 if a >= 0 else -1
    return (-(12 * eps * abs(a) / (d * q) + 6 * b / q**1.5 * (PI - 16 / (PI * d))),
            6 * PI * a / (d * math.sqrt(q)) + s * 24 * eps * b / (d * q))


def long_half_eq5(eps, a, b):
    q, d, s = (1 - eps) * (1 + eps), 2 + eps**2, 1 if a >= 0 else -1
    return (-(12 * eps * abs(a) / (d * q) + 6 * PI * b / q**1.5),
            6 * PI * a / (d * math.sqrt(q)) + s * 24 * b / ((1 + eps) * q))


def pinkus_sternlicht(eps, q, a, b):
    d, k, squeeze = 2 + eps**2, math.sqrt(q) * math.hypot(a / 2, b), eps * abs(b)
    phi = 1.0
    if k + squeeze > 0:
        phi = (k + (3 * squeeze if b >= 0 else 0)) / (k + 1.5 * squeeze)
    return -6 / (d * q**1.5) * (4 * eps * k + PI * d * b * phi), 6 * PI * a / (d * math.sqrt(q)) * phi


def capone(x, y, wx, wy, alpha):
    """Capone's short dynamic film for the eccentricity (x, y) in clearances; (wx, wy) is the wedge and squeeze velocity."""
    q = 1 - x * x - y * y
    across, along = y * math.cos(alpha) - x * math.sin(alpha), x * math.cos(alpha) + y * math.sin(alpha)
    g = 2 / math.sqrt(q) * (PI / 2 + math.atan(across / math.sqrt(q)))
    v = (2 + across * g) / q
    s = along / (1 - along**2)
    k = -math.hypot(wx, wy) / q
    return (k * (3 * x * v - math.sin(alpha) * g - 2 * math.cos(alpha) * s),
            k * (3 * y * v + math.cos(alpha) * g - 2 * math.sin(alpha) * s))
