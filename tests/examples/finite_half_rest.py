"""Where a journal rests on the half film of its bearing's real length, and the film's stiffness and damping there, for
    lubjoint verify --law finite_half --quantities coefficients -- python3 finite_half_rest.py
Reynolds' equation by harmonics along the axis and differences around the film, on two grids, extrapolated. --load-axes
gives the matrices with x along the load, which is not what is asked for.
"""
import csv
import math
import sys

HARMONICS = [2 * n + 1 for n in range(8)]


def force_on_grid(shape, ratio, a, b, intervals):
    """Radial and tangential force over mu L R^3/c^2, of the film from 0 to pi where a > 0."""
    step = math.pi / intervals
    places = range(1, intervals)
    cosine = [math.cos(i * step) for i in range(intervals + 1)]
    sine = [math.sin(i * step) for i in range(intervals + 1)]
    middle = [(1 + ratio * math.cos((i + 0.5) * step)) ** 3 / step**2 for i in range(intervals)]
    cube = [(1 + ratio * c) ** 3 for c in cosine]
    radial = tangential = 0.0
    for n in HARMONICS:  # P = sum of p(theta) cos(k z/R); p = 6 mu (R/c)^2 P
        k = n * math.pi / (2 * shape)
        weight = 2 * math.sin(n * math.pi / 2) / (k * shape)  # of 1 in cos(k z/R)
        diagonal, right = [0.0], [0.0]
        for i in places:  # elimination
            factor = middle[i - 1] / diagonal[-1] if i > 1 else 0.0
            diagonal.append(-middle[i - 1] - middle[i] - cube[i] * k * k - factor * middle[i - 1])
            right.append(-weight * (a * sine[i] - 2 * b * cosine[i]) - factor * right[-1])
        p = 0.0
        for i in reversed(places):
            p = (right[i] - middle[i] * p) / diagonal[i]
            radial += 3 * weight * p * cosine[i] * step  # weight/2: the mean of cos(k z/R) over the axis
            tangential += 3 * weight * p * sine[i] * step
    return radial, tangential


def force(shape, ratio, a, b):
    coarse, fine = (force_on_grid(shape, ratio, a, b, n) for n in (100, 200))
    return [y + (y - x) / 3 for x, y in zip(coarse, fine)]


def rest(shape, wanted):
    """The ratio at which a = ratio, b = 0 carries this load: the secant rule in log(ratio/(1 - ratio))."""
    def off(x):
        ratio = 1 / (1 + math.exp(-x))
        return math.log(math.hypot(*force(shape, ratio, ratio, 0)) / wanted)

    last, x = 0.0, 0.5
    off_last = off(last)
    while abs(x - last) > 1e-7:
        off_x = off(x)
        last, off_last, x = x, off_x, x - off_x * (x - last) / (off_x - off_last)
    return 1 / (1 + math.exp(-x))


def turned(m, sine, cosine):
    """A matrix in r, t, row by row, in axes in which r is (sine, -cosine) and t is (cosine, sine)."""
    q = ((sine, cosine), (-cosine, sine))
    return [sum(q[i][k] * m[2 * k + l] * q[j][l] for k in (0, 1) for l in (0, 1)) for i in (0, 1) for j in (0, 1)]


def coefficients(viscosity, length, radius, clearance, omega, load):
    scale = viscosity * length * radius**3 / clearance**2
    shape, side = length / (2 * radius), math.copysign(1, omega)
    e = rest(shape, load / (scale * abs(omega)))
    f = force(shape, e, e, 0)
    h = 1e-3 * min(e, 1 - e)
    far, near = force(shape, e + h, e + h, 0), force(shape, e - h, e - h, 0)
    outward = [(x - y) / (2 * h) for x, y in zip(far, near)]
    squeezed = [x - y for x, y in zip(force(shape, e, e, 1), f)]  # linear in b
    k = [-outward[0], side * f[1] / e, -side * outward[1], -f[0] / e]
    c = [-squeezed[0], side * 2 * f[0] / e, -side * squeezed[1], 2 * f[1] / e]
    attitude = math.atan2(f[1], -f[0])
    angle = side * attitude + (math.pi / 2 if LOAD_AXES else 0)  # from -y to e
    stiffness, damping = (turned(m, math.sin(angle), math.cos(angle)) for m in (k, c))
    unit = scale / clearance
    return [e, attitude, *(x * unit * abs(omega) for x in stiffness), *(x * unit for x in damping)]


LOAD_AXES = "--load-axes" in sys.argv[1:]
print("id,eccentricity_ratio,attitude,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy")
reader = csv.reader(sys.stdin)
next(reader)
for row in reader:
    print(row[0], *coefficients(*map(float, row[1:])), sep=",", flush=True)
