"""The pressure of the half film of a bearing of real length at a place, for
    lubjoint verify --law finite_half --quantities pressure -- python3 finite_half_pressure.py
Reynolds' equation by harmonics along the axis and differences around the film. --l-over-r takes L/R for L/D in the axial
term, which is wrong.
"""
import csv
import math
import sys

INTERVALS = 400
STEP = math.pi / INTERVALS


def pressure(shape, ratio, a, b, theta, zeta):
    """p over mu (R/c)^2 at theta in (0, pi), zeta = z/R, where the film lies there: a >= 0."""
    middle = [(1 + ratio * math.cos((i + 0.5) * STEP)) ** 3 / STEP**2 for i in range(INTERVALS)]
    cube = [(1 + ratio * math.cos(i * STEP)) ** 3 for i in range(INTERVALS + 1)]
    source = [a * math.sin(i * STEP) - 2 * b * math.cos(i * STEP) for i in range(INTERVALS + 1)]
    here = int(theta / STEP)
    result = 0.0
    for n in range(1, 48, 2):  # P = sum of p(theta) cos(k z/R); p = 6 mu (R/c)^2 P
        k = n * math.pi / (2 * shape)
        weight = 2 * math.sin(n * math.pi / 2) / (k * shape)  # of 1 in cos(k z/R)
        diagonal, right = [0.0], [0.0]
        for i in range(1, INTERVALS):  # elimination
            factor = middle[i - 1] / diagonal[-1] if i > 1 else 0.0
            diagonal.append(-middle[i - 1] - middle[i] - cube[i] * k * k - factor * middle[i - 1])
            right.append(-weight * source[i] - factor * right[-1])
        p = [0.0] * (INTERVALS + 1)
        for i in range(INTERVALS - 1, here - 1, -1):
            if i > 0:
                p[i] = (right[i] - middle[i] * p[i + 1]) / diagonal[i]
        part = theta / STEP - here
        result += 6 * math.cos(k * zeta) * ((1 - part) * p[here] + part * p[here + 1])
    return result


WRONG_SHAPE = "--l-over-r" in sys.argv[1:]
print("id,pressure")
reader = csv.reader(sys.stdin)
next(reader)
for row in reader:
    viscosity, length, radius, clearance, e, squeeze, omega, attitude_rate, theta, z = map(float, row[1:])
    slip = e * (omega - 2 * attitude_rate)
    if slip < 0:  # the mirror image
        slip, theta = -slip, -theta
    theta = math.remainder(theta, 2 * math.pi)
    shape = length / radius if WRONG_SHAPE else length / (2 * radius)
    inside = 0 < theta < math.pi and abs(z) < length / 2
    p = pressure(shape, e, slip, squeeze, theta, z / radius) if inside else 0.0
    print(row[0], p * viscosity * (radius / clearance) ** 2, sep=",", flush=True)
