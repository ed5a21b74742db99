#!/usr/bin/env python3
"""The short bearing's half film for
    lubjoint verify --law short_half --quantities QUANTITIES -- python3 quantities.py QUANTITIES MODE
with QUANTITIES cartesian, polar, wrench, transition, extent, pressure or dimensionless; the mode "right", or what is
wrong.
"""
import csv
import math
import sys


def half_film(scale, eps, q, a, b, mode):
    """Radial and tangential force."""
    side = 1 if a >= 0 else -1
    if mode == "not_mirrored":
        side = 1
    wedge = abs(a) if mode != "not_mirrored" else a
    if mode == "no_squeeze":
        b = 0.0
    if mode == "squeeze_sign":
        b = -b
    root = 2.5 if mode != "squeeze_exponent" else 1.5
    radial = -scale * (eps * wedge / q**2 + b * math.pi * (1 + 2 * eps * eps) / (2 * q**root))
    tangential = scale * (math.pi * a / (4 * q**1.5) + side * 2 * eps * b / q**2)
    if mode == "clockwise":
        tangential = -tangential
    if mode == "exchanged":
        radial, tangential = tangential, radial
    return radial, tangential


def motion(s, clearance, mode):
    """The radial direction, eps, 1 - eps^2, a and b of a Cartesian state."""
    distance = math.hypot(s["ex"], s["ey"])
    along = (s["ex"], s["ey"]) if distance > 0 else (s["vx"], s["vy"])
    size = math.hypot(*along) or 1.0
    rx, ry = along[0] / size, along[1] / size
    if mode == "no_quadrant" and rx < 0:
        rx, ry = -rx, -ry
    eps = distance / clearance
    q = (clearance - distance) / clearance * (1 + eps)
    spins = s["omega_journal"] + s["omega_bearing"]
    if mode == "relative_spin":
        spins = s["omega_journal"] - s["omega_bearing"]
    slide = (s["vy"] * rx - s["vx"] * ry) / clearance
    twice = 2 if mode != "whirl_once" else 1
    a = eps * spins - twice * slide
    return rx, ry, eps, q, a, (s["vx"] * rx + s["vy"] * ry) / clearance


def force(s, mode, clearance=None):
    """On the journal, along x and y."""
    c = clearance or s["clearance"]
    radius = 2 * s["radius"] if mode == "diameter" else s["radius"]
    rx, ry, eps, q, a, b = motion(s, c, mode)
    radial, tangential = half_film(s["viscosity"] * radius * s["length"]**3 / c**2, eps, q, a, b, mode)
    fx, fy = radial * rx - tangential * ry, radial * ry + tangential * rx
    if mode == "on_bearing":
        fx, fy = -fx, -fy
    return fx, fy


def wrench(s, mode):
    fx, fy = force(s, mode)

    def cross(x, y):
        return x * fy - y * fx

    transport = cross(s["ex"], s["ey"])
    if mode == "no_transport":
        transport = 0.0
    if mode == "transport_sign":
        transport = -transport
    on_bearing = -cross(s["sx_i"], s["sy_i"]) - transport
    on_journal = cross(s["sx_j"], s["sy_j"])
    if mode == "of_action":
        on_bearing = -on_bearing
    if mode == "moments_clockwise":
        on_bearing, on_journal = -on_bearing, -on_journal
    if mode == "moments_exchanged":
        on_bearing, on_journal = on_journal, on_bearing
    if mode == "about_the_joint":
        on_journal = 0.0
    return fx, fy, on_bearing, on_journal


def transition(s, mode):
    distance = math.hypot(s["ex"], s["ey"])
    c = s["clearance"]
    share = min(max((distance - c) / s["e0"], 0.0), 1.0)
    if mode == "no_blend":
        share = 1.0 if distance > c else 0.0
    widening = {"narrow": 0.0, "e0_for_e1": s["e0"]}.get(mode, s["e1"])
    fx, fy = force(s, mode, c + widening) if share < 1 and distance < c + widening else (0.0, 0.0)
    if share == 0:
        return fx, fy
    rx, ry = s["ex"] / distance, s["ey"] / distance
    depth = distance - c - (s["e1"] if mode == "late" else s["e0"] if mode == "after_the_blend" else 0.0)
    rate = s["vx"] * rx + s["vy"] * ry
    if mode == "rate_sign":
        rate = -rate
    loss = 0.75 * (1 - s["restitution"]**2)
    if mode == "elastic":
        loss = 0.0
    power = 1.0 if mode == "linear" else 1.5
    normal = max(s["contact_stiffness"] * max(depth, 0.0)**power * (1 + loss * rate / s["impact_speed"]), 0.0)
    film = 1 - share
    if mode == "weights_swapped" and share < 1:
        film, share = share, film
    return film * fx - share * normal * rx, film * fy - share * normal * ry


def polar(s, mode):
    eps = s["eccentricity_ratio"]
    whirl = s["attitude_rate"]
    spin = s["omega"]
    twice = 1 if mode == "whirl_once" else 0 if mode == "no_whirl" else 2
    radius = 2 * s["radius"] if mode == "diameter" else s["radius"]
    scale = s["viscosity"] * radius * s["length"]**3 / s["clearance"]**2
    return half_film(scale, eps, (1 - eps) * (1 + eps), eps * (spin - twice * whirl), s["squeeze_rate"], mode)


def rates(s, mode):
    twice = {"whirl_once": 1, "no_whirl": 0, "whirl_sign": -2}.get(mode, 2)
    a = s["eccentricity_ratio"] * (s["omega"] - twice * s["attitude_rate"])
    b = s["squeeze_rate"]
    if mode == "no_squeeze":
        b = 0.0
    if mode == "half_squeeze":
        b = b / 2
    if mode == "double_squeeze":
        b = 2 * b
    if mode == "squeeze_sign":
        b = -b
    if mode == "slip_sign":
        a = -a
    return a, b


def extent(s, mode):
    """Where the dynamic film begins and ends."""
    a, b = rates(s, mode)
    begin = math.atan2(2 * b, a) if a or b else 0.0
    if mode == "no_quadrant" and a < 0:
        begin = math.atan(2 * b / a)
    end = begin + math.pi
    if mode == "reduced" and end > math.pi:
        end -= 2 * math.pi
    return begin, end


def pressure(s, mode):
    """Of the half film at (theta, z)."""
    a, b = rates(s, mode)
    eps, length, z = s["eccentricity_ratio"], s["length"], s["z"]
    theta = s["theta"] + (math.pi if mode == "from_minimum" else 0.0)
    if mode == "from_the_end":
        z -= length / 2
    turned = math.remainder(theta if a >= 0 else theta + math.pi, 2 * math.pi)
    if mode == "not_mirrored":
        turned = math.remainder(theta, 2 * math.pi)
    if not 0 <= turned <= math.pi:
        return (0.0,)
    h = (1 - eps) + 2 * eps * math.cos(theta / 2)**2
    if mode == "thickness_sign":
        h = 1 - eps * math.cos(theta)
    c = 2 * s["clearance"] if mode == "diametral" else s["clearance"]
    source = a * math.sin(theta) - 2 * b * math.cos(theta)
    return (3 * s["viscosity"] / (c * c * h**3) * (length / 2 - z) * (length / 2 + z) * source,)


def dimensionless(s, mode):
    """A journal that turns in a bearing at rest: clearances, 1/omega, S omega."""
    state = {"ex": s["x"], "ey": s["y"], "vx": s["vx"], "vy": s["vy"], "omega_bearing": 0.0, "omega_journal": 1.0,
             "viscosity": 1.0, "length": 1.0, "radius": 1.0, "clearance": 1.0}
    unit = {"quarter": 4.0, "half": 2.0, "twice": 0.5}.get(mode, 1.0)
    if mode == "velocity_halved":
        state["vx"], state["vy"] = state["vx"] / 2, state["vy"] / 2
    fx, fy = force(state, mode)
    return unit * fx, unit * fy


ANSWERS = {"cartesian": (force, "fx,fy"), "polar": (polar, "radial,tangential"),
           "wrench": (wrench, "fx,fy,mz_bearing,mz_journal"), "transition": (transition, "fx,fy"),
           "extent": (extent, "theta_s,theta_e"), "pressure": (pressure, "pressure"),
           "dimensionless": (dimensionless, "fx,fy")}

TURNS = {"revolutions": 2 * math.pi, "to_revolutions": 1 / (2 * math.pi)}  # spins of another unit


def main():
    answer, columns = ANSWERS[sys.argv[1]]
    mode = sys.argv[2]
    print("id," + columns)
    for row in csv.DictReader(sys.stdin):
        state = {name: float(value) for name, value in row.items() if name != "id"}
        for name in ("omega", "omega_bearing", "omega_journal"):
            if name in state:
                state[name] *= TURNS.get(mode, 1)
        values = answer(state, mode)
        print(",".join([row["id"]] + [repr(value) for value in values]))


if __name__ == "__main__":
    main()
