#!/usr/bin/env python3
"""Friction torques, power and side flow of the short bearing, for
    lubjoint verify --quantities losses --law short_half -- python3 losses.py MODE
with the half film, and, with the mode "summed", --law short_dynamic: wall shear, dissipation and flow as sums over the
film's angles.
"""
import csv
import math
import sys


def kinematics(s):
    distance = math.hypot(s["ex"], s["ey"])
    along = (s["ex"], s["ey"]) if distance > 0 else (s["vx"], s["vy"])
    size = math.hypot(*along) or 1.0
    rx, ry = along[0] / size, along[1] / size
    eps = distance / s["clearance"]
    slide = (s["vy"] * rx - s["vx"] * ry) / s["clearance"] if distance > 0 else 0.0
    return eps, eps * (s["omega_journal"] + s["omega_bearing"]) - 2 * slide, (s["vx"] * rx + s["vy"] * ry) / s["clearance"]


def summed(s, n=4000):
    eps, a, b = kinematics(s)
    mu, length, radius, c = s["viscosity"], s["length"], s["radius"], s["clearance"]
    spin = s["omega_journal"] - s["omega_bearing"]
    begin = math.atan2(2 * b, a) if a or b else 0.0
    h_step = math.pi / n
    couette = shear = dissipation = flow = 0.0
    for k in range(n):  # the pressure vanishes at both ends
        t = begin + (k + 0.5) * h_step
        h = 1 + eps * math.cos(t)
        g = a * math.sin(t) - 2 * b * math.cos(t)
        slope = (a * math.cos(t) + 2 * b * math.sin(t)) / h**3 + 3 * g * eps * math.sin(t) / h**4
        couette += h_step / h
        shear += h_step * h * slope
        dissipation += h_step * g * g / h**3
        flow += h_step * g
    torque = mu * spin * radius**3 * length / c * couette
    wall = -mu * radius * length**3 / (4 * c) * shear
    power = spin * torque + mu * radius * length**3 / (4 * c) * dissipation
    return wall - torque, wall + torque, power, c * radius * length / 2 * flow


def answer(mode, s):
    if mode == "summed":
        return summed(s)
    turn = {"revolutions": 2 * math.pi, "to_revolutions": 1 / (2 * math.pi)}.get(mode, 1)
    s = dict(s, omega_journal=turn * s["omega_journal"], omega_bearing=turn * s["omega_bearing"])
    eps, a, b = kinematics(s)
    mu, length, radius, c = s["viscosity"], s["length"], s["radius"], s["clearance"]
    q = (1 - eps) * (1 + eps)
    side = 1 if a >= 0 else -1
    scale = mu * radius * length**3 / c**2
    radial = -scale * (eps * abs(a) / q**2 + b * math.pi * (1 + 2 * eps * eps) / (2 * q**2.5))
    tangential = scale * (math.pi * a / (4 * q**1.5) + side * 2 * eps * b / q**2)
    moment = eps * c * tangential
    spin = s["omega_journal"] - s["omega_bearing"]
    if mode == "spin_sum":
        spin = s["omega_journal"] + s["omega_bearing"]
    if mode == "journal_spin":
        spin = s["omega_journal"]
    sheared = {"flooded": 2 * math.pi / math.sqrt(q), "petroff": 2 * math.pi}.get(mode, math.pi / math.sqrt(q))
    torque = mu * spin * radius**3 * length / c * sheared
    if mode == "friction_force":
        torque /= radius
    spin = s["omega_journal"] - s["omega_bearing"]
    journal, bearing = -torque - moment / 2, torque - moment / 2
    power = spin * torque - c * (radial * b - tangential * a / 2)
    flow = c * radius * length * abs(a)
    if mode == "shear_alone":
        journal, bearing = -torque, torque
    elif mode in ("no_pressure", "no_pressure_torque"):  # and the power made of these torques
        journal, bearing = -torque, torque
        power = -journal * s["omega_journal"] - bearing * s["omega_bearing"]
        if mode == "no_pressure_torque":
            e = math.hypot(s["ex"], s["ey"])
            along = (s["ex"], s["ey"]) if e > 0 else (s["vx"], s["vy"])
            size = math.hypot(*along) or 1.0
            rx, ry = along[0] / size, along[1] / size
            fx, fy = radial * rx - tangential * ry, radial * ry + tangential * rx
            power -= fx * s["vx"] + fy * s["vy"]
    elif mode == "half_power":
        power /= 2
    elif mode == "exchanged":
        journal, bearing = bearing, journal
    elif mode == "on_the_oil":
        journal, bearing = -journal, -bearing
    elif mode == "whole_moment":
        journal, bearing = -torque - moment, torque - moment
    elif mode == "opposite":
        bearing = -journal
    elif mode == "power_of_shear":
        power = spin * torque
    elif mode == "power_of_journal":
        power = -journal * s["omega_journal"]
    elif mode == "one_side":
        flow /= 2
    elif mode == "slope_lost":  # no known mistake: a third of the pressure's share
        journal, bearing = -torque - moment / 6, torque - moment / 6
    return journal, bearing, power, flow


mode = sys.argv[1]
print("id,torque_journal" if mode == "torque_of_journal" else "id,torque_journal,torque_bearing,power,side_flow")
for row in csv.DictReader(sys.stdin):
    values = answer(mode, {name: float(value) for name, value in row.items()})
    if mode == "torque_of_journal":
        values = values[:1]
    print(row["id"] + "," + ",".join(map(repr, values)))
