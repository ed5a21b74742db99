#!/usr/bin/env python3
"""Dry contact of a journal with its wall, for
    lubjoint verify --quantities contact --law NAME -- python3 contact.py MODE [LAW]
Reads id, clearance, contact_stiffness, restitution, impact_speed, ex, ey, vx, vy and answers id, fx, fy.
"""
import csv
import math
import sys


def gonthier(c):
    """d/c_r with (1 + d/c_r)/(1 - d) = exp(d(1 + 1/c_r)), 0 < d < 1, by halving."""
    if c == 1:
        return 0.0
    low, high = 0.0, 1.0
    while True:
        d = (low + high) / 2
        if d in (low, high):
            return high / c
        if math.log1p(d / c) - math.log1p(-d) - d * (1 + 1 / c) > 0:
            high = d
        else:
            low = d


LOSS = {"lankarani_nikravesh": lambda c: 3 * (1 - c) * (1 + c) / 4, "hunt_crossley": lambda c: 3 * (1 - c) / 2,
        "flores": lambda c: 8 * (1 - c) / (5 * c), "gonthier": gonthier}


def force(mode, law, clearance, contact_stiffness, restitution, impact_speed, ex, ey, vx, vy):
    distance = math.hypot(ex, ey)
    if distance == 0:
        return 0.0, 0.0
    rx, ry = ex / distance, ey / distance
    depth = distance - clearance
    rate = vx * rx + vy * ry
    if mode == "speed":
        rate = math.hypot(vx, vy)
    if mode == "diametral":
        depth = distance - clearance / 2
    if depth <= 0:
        return 0.0, 0.0
    loss = LOSS[law](restitution) * rate / impact_speed
    if mode == "approximate":  # d = 1 - c_r^2 in place of the root
        loss = (1 - restitution**2) / restitution * rate / impact_speed
    if mode == "elastic":
        loss = 0.0
    elif mode == "half_loss":
        loss /= 2
    elif mode == "rate_sign":
        loss = -loss
    elif mode == "no_impact_speed":
        loss *= impact_speed
    elif mode == "restitution":
        loss = 3 * (1 - restitution) / 4 * rate / impact_speed
    normal = contact_stiffness * depth**{"linear": 1, "five_halves": 2.5}.get(mode, 1.5) * (1 + loss)
    if mode != "pulls":
        normal = max(normal, 0.0)
    if mode == "outwards":
        normal = -normal
    if mode == "two_thirds":  # no known mistake
        normal = contact_stiffness * depth**1.5 * max(1 + 2 * loss / 3, 0.0)
    return -normal * rx, -normal * ry


mode = sys.argv[1]
law = sys.argv[2] if len(sys.argv) > 2 else "lankarani_nikravesh"
print("id,fx,fy")
for row in csv.DictReader(sys.stdin):
    number = row.pop("id")
    fx, fy = force(mode, law, **{name: float(value) for name, value in row.items()})
    print(f"{number},{fx!r},{fy!r}")
