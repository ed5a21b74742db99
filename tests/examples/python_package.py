"""The Python package, used as a user would; run by tests/python_package.sh in a fresh environment."""

import csv
import doctest
import importlib.metadata
import inspect
import io
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
import warnings

import numpy

import lubjoint
from lubjoint import _film, _library, _oracle, _rest, _simulate, _verify

sys.path.insert(0, sys.argv[1])
import capone  # noqa: E402  examples beside this file
import pinkus_sternlicht  # noqa: E402


def force(wrong):
    return lambda **state: pinkus_sternlicht.force(*state.values(), wrong=wrong)


def short_full(viscosity, length, radius, clearance, eccentricity_ratio, squeeze_rate, omega, attitude_rate):
    q = 1 - eccentricity_ratio**2
    a = eccentricity_ratio * (omega - 2 * attitude_rate)
    scale = viscosity * radius * length**3 / clearance**2
    radial = -scale * numpy.pi * squeeze_rate * (1 + 2 * eccentricity_ratio**2) / q**2.5
    return radial, scale * numpy.pi * a / (2 * q**1.5)


assert lubjoint.__version__ == importlib.metadata.version("lubjoint")  # of the library, of the package

# Verification: scalar and vectorized functions, right and wrong, the law found.
assert lubjoint.verify(force(False), law="pinkus_sternlicht", vectorized=False)
assert lubjoint.verify(force(False), law="pinkus_sternlicht")  # for numbers alone, and so tried row by row
try:
    lubjoint.verify(lambda **state: 1 / [], law="pinkus_sternlicht")
    raise AssertionError("a function that fails for arrays and for numbers must fail")
except TypeError:
    pass
report = lubjoint.verify(force(True), law="pinkus_sternlicht", vectorized=False)
assert not report and report["mistakes"][0]["names"] == ["inertial_attitude_rate"], report
assert "Worst state" in str(report)
report = lubjoint.verify(short_full, quantities="polar")
assert report and report["law"] == "short_full", report
report = lubjoint.verify(lambda radius, **rest: short_full(radius=2 * radius, **rest), "short_full", "polar")
assert report["mistakes"][0]["names"] == ["diameter_for_radius"], report
try:
    lubjoint.verify(short_full, law="short", quantities="polar")
    raise AssertionError("an unknown law must be refused")
except ValueError as error:
    assert "short_half" in str(error)

# Batch evaluation: numbers, arrays, strided views, no copy.
bearing = lubjoint.Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
table = numpy.random.default_rng(1).uniform(0, 0.9, (3, 1000))
radial, tangential = lubjoint.polar_force("short_half", bearing, *table)
strided = numpy.ascontiguousarray(table.T)
again = lubjoint.polar_force("short_half", bearing, strided[:, 0], strided[:, 1], strided[:, 2])
assert (again[0] == radial).all() and (again[1] == tangential).all()
one = lubjoint.polar_force("short_half", bearing, *map(float, table[:, 7]))
assert one == (radial[7], tangential[7])
out = (numpy.empty(1000), numpy.empty(1000))
assert lubjoint.polar_force("short_half", bearing, *table, out=out)[0] is out[0] and (out[0] == radial).all()
fixed = lubjoint.polar_force("short_half", bearing, 0.5, table[1], 2.0)
assert fixed[0].shape == (1000,)
written = table.copy()  # forces in the place of two inputs
lubjoint.polar_force("short_half", bearing, *written, out=(written[2], written[0]))
assert (written[2] == radial).all() and (written[0] == tangential).all()
alone = lubjoint.polar_force("short_half", bearing, [0.5], table[1], [[2.0]][0])  # arrays of one number go with all rows
assert (alone[0] == fixed[0]).all() and lubjoint.polar_force("short_half", bearing, [], 1, 1)[0].shape == (0,)
# Arrays of any shape broadcast; each number is that of a call with numbers alone.
grid = lubjoint.polar_force("short_half", bearing, numpy.array([[0.1], [0.5]]), 2.0, numpy.array([-1.0, 0.0, 1.0]))
assert grid[0].shape == (2, 3)
assert grid[1][1, 2] == lubjoint.polar_force("short_half", bearing, 0.5, 2.0, 1.0)[1]
plane = (numpy.empty((2, 3)), numpy.empty((2, 3)))
assert (lubjoint.polar_force("short_half", bearing, [[0.1], [0.5]], 2.0, [-1, 0, 1], out=plane)[0] == grid[0]).all()
assert (plane[1] == grid[1]).all()
# Arrays of one length without gaps go a shorter way: the same bits, the same errors, and only if they are that.
columns = [numpy.ascontiguousarray(c) for c in numpy.random.default_rng(3).uniform(0, 0.9, (6, 100))]
broad = lubjoint.Bearing(viscosity=0.04, length=0.02, radius=0.02, clearance=2e-4)
motions = [1e-4 * columns[0], 1e-4 * columns[1], *columns[2:]]
for law in ("short_half", "long_dynamic", "finite_full"):
    short_way = lubjoint.journal_force(law, broad, *motions)
    long_way = lubjoint.journal_force(law, broad, *numpy.array(motions).T.copy().T)  # with gaps
    assert all((a == b).all() for a, b in zip(short_way, long_way)), law
outside = columns[0].copy()
outside[7] = 1.5
unwritten = (numpy.full(100, -1.0), numpy.full(100, -1.0))
try:
    lubjoint.polar_force("short_half", bearing, outside, columns[1], columns[2], out=unwritten)
    raise AssertionError("a row without a film must be refused")
except ValueError as error:
    assert "row 7" in str(error) and (unwritten[0][:7] != -1).all() and (unwritten[0][7:] == -1).all(), error
read_only = columns[0].copy()
read_only.flags.writeable = False  # goes the longer way
assert (lubjoint.polar_force("short_half", bearing, read_only, columns[1], columns[2])[0] ==
        lubjoint.polar_force("short_half", bearing, columns[0], columns[1], columns[2])[0]).all()
whole = lubjoint.polar_force("short_half", bearing, numpy.array([0, 0]), numpy.array([1, 2]), numpy.array([0, 0]))
assert whole[1].dtype == numpy.float64 and whole[1][1] == 2 * whole[1][0] > 0  # integers
try:
    lubjoint.polar_force("short_half", bearing, *columns[:3], out=(read_only, columns[1]))
    raise AssertionError("an output that can't be written must be refused")
except ValueError as error:
    assert "writeable" in str(error)
for wrong in ({"law": "short"}, {"eccentricity_ratio": 1.5}, {"slip_rate": [1, 2], "squeeze_rate": [1, 2, 3]},
              {"eccentricity_ratio": numpy.zeros((2, 2)), "out": (numpy.empty(4), numpy.empty(4))}):
    arguments = {"law": "short_half", "bearing": bearing, "eccentricity_ratio": 0.5, "slip_rate": 1, "squeeze_rate": 1}
    try:
        lubjoint.polar_force(**{**arguments, **wrong})
        raise AssertionError(f"{wrong} must be refused")
    except ValueError:
        pass

# Joint: inside the clearance the film, and its moments about the two mass centres.
fx, fy = lubjoint.journal_force("long_half", bearing, 1e-4, 0, 0, 1e-3, 0, 50)
moments = lubjoint.joint_moments(1e-4, 0, 0.1, 0, -0.1, 0, fx, fy)
assert numpy.allclose(moments, (-(0.1 + 1e-4) * fy, -0.1 * fy), rtol=1e-15)  # rounding
contact = lubjoint.Contact(e0=4e-6, e1=2e-5, stiffness=1e10, restitution=0.9, impact_speed=0.1)
assert lubjoint.transition_force("long_half", bearing, contact, 3e-4, 0, 0, 0, 0, 0)[0] < 0
assert len(lubjoint.laws()) == 18
closing, across = lubjoint.polar_force("squeeze_long_full", bearing, 0.5, 3, 1.0)  # the wedge is left out
scale = bearing.viscosity * bearing.length * bearing.radius**3 / bearing.clearance**2
assert abs(closing / (-12 * numpy.pi * scale / 0.75**1.5) - 1) < 1e-14 and across == 0
assert lubjoint.film_losses("squeeze_short", bearing, 0, 0, 1e-3, 0, 0, 50).side_flow > 0
squat = lubjoint.Bearing(bearing.viscosity, bearing.radius, bearing.radius, bearing.clearance)  # L/D = 1/2
assert lubjoint.journal_force("butenschoen", squat, 1e-5, 0, 1e-3, 0, 0, 50)[0] < 0
losses = lubjoint.film_losses("short_dynamic", bearing, 0, 0, [1e-3, 0], 0, 0, 50)
assert losses.power.shape == (2,) and losses.power[0] > losses.power[1] > 0 and losses.side_flow[1] == 0
assert lubjoint.film_losses("long_half", bearing, 0, 0, 0, 0, 0, 50).side_flow is None
half, flooded = (lubjoint.film_losses("long_half", bearing, 0, 0, 0, 0, 0, 50, shear=s) for s in ("film", "flooded"))
assert abs(flooded.power - 2 * half.power) < 1e-13 * flooded.power  # a concentric film, half of it sheared
rest = lubjoint.film_coefficients("short_half", bearing, [0.5, 0.8], 50)
assert rest.stiffness.shape == (2, 2, 2) and numpy.isinf(rest.critical_mass[1])
assert abs(bearing.clearance * rest.stiffness[0, 0, 1] / rest.load[0] - 3.9766424213158496574) < 1e-14
backward = lubjoint.film_coefficients("short_half", bearing, 0.5, -50)
assert backward.damping[0, 1] == -rest.damping[0, 0, 1] and backward.critical_mass == rest.critical_mass[0]
# A load and the place that carries it; in inertial axes as verify asks for it; a velocity and the force that it answers.
place = lubjoint.equilibrium("short_half", bearing, rest.load, 50)
assert numpy.allclose(place.eccentricity_ratio, [0.5, 0.8], rtol=1e-14)  # a root of few roundings
assert numpy.allclose(place.attitude, rest.attitude, rtol=1e-14)
table = lubjoint.coefficients("short_half", bearing, [[50.0], [-50.0]], load=rest.load)
assert table.stiffness.shape == (2, 2, 2, 2) and table.load.shape == (2, 2)
assert numpy.allclose(table.stiffness[0], rest.stiffness, rtol=1e-13)
for law in ("short_dynamic", "long_full", "pinkus_sternlicht", "moes_impedance"):
    u = lubjoint.mobility(law, squat, 0.3, [0.1, -0.1], -30.0, 12.0)
    back = lubjoint.journal_force(law, squat, 0.3 * squat.clearance, numpy.array([0.1, -0.1]) * squat.clearance,
                                  u.ux * squat.clearance, u.uy * squat.clearance, 0, 0)
    assert list(u.status) == ["found", "found"], (law, u)
    assert numpy.allclose(back, [[-30.0, -30.0], [12.0, 12.0]], rtol=1e-12), (law, back)
two = lubjoint.mobility("short_half", bearing, 0.5, 0, 40, 0)
assert two.status == "two" and two.uy == -two.other_uy != 0
assert lubjoint.losses("long_half", bearing, numpy.zeros((2, 2)), 0, 0, 0, 0, 50).power.shape == (2, 2)

# Films of the bearing's own length: each table within its stated error of the solver, in every call that takes a law.
half_as_long = lubjoint.Bearing(viscosity=0.4, length=0.04, radius=0.04, clearance=2e-4)  # L/D = 1/2
ratios, slips, squeezes = numpy.random.default_rng(2).uniform([[0.05], [-1], [-1]], [[0.9], [1], [1]], (3, 6))
for law in ("finite_full", "finite_half", "finite_dynamic", "finite_reynolds"):
    table = lubjoint.film_table(law, half_as_long)
    solved = lubjoint.oracle_force(law, half_as_long, ratios, slips, squeezes,
                                   tolerance=1e-3 if law == "finite_reynolds" else 1e-8)
    radial, tangential = lubjoint.polar_force(law, half_as_long, ratios, slips, squeezes)
    size = numpy.hypot(radial, tangential)
    allowed = table.error * size + numpy.hypot(solved.radial_error, solved.tangential_error)
    assert (numpy.hypot(radial - solved.radial, tangential - solved.tangential) <= allowed).all(), law
    # The same state as a motion, turned by 1 rad and seen from a frame in which both bodies spin.
    r, t = numpy.array([numpy.cos(1), numpy.sin(1)]), numpy.array([-numpy.sin(1), numpy.cos(1)])
    e = half_as_long.clearance * numpy.outer(r, ratios)
    v = half_as_long.clearance * (numpy.outer(r, squeezes) + numpy.outer(t, 20 * ratios - slips / 2))
    fx, fy = lubjoint.journal_force(law, half_as_long, *e, *v, 10, 30)
    assert numpy.allclose(fx, r[0] * radial + t[0] * tangential, atol=1e-11 * size.max())
    assert numpy.allclose(fy, r[1] * radial + t[1] * tangential, atol=1e-11 * size.max())
    assert lubjoint.polar_force(law, half_as_long, [[0.1], [0.2]], 1, [0, 1, 2])[0].shape == (2, 3)
    slopes = lubjoint.force_jacobian(law, half_as_long, *e, *v, 10, 30)
    assert slopes.by_place.shape == (6, 2, 2) and numpy.allclose(slopes.fx, fx, rtol=1e-12)
    step = 1e-6 * half_as_long.clearance
    ahead, behind = (lubjoint.journal_force(law, half_as_long, e[0] + d, e[1], *v, 10, 30) for d in (step, -step))
    measured = numpy.transpose(numpy.subtract(ahead, behind) / (2 * step))
    assert numpy.allclose(slopes.by_place[..., 0], measured, atol=1e-6 * abs(measured).max()), law  # differences
    assert lubjoint.losses(law, half_as_long, *e, *v, 10, 30, shear="flooded").side_flow is None
    rest = lubjoint.coefficients(law, half_as_long, 300.0, load=[50.0, 5000.0])
    assert numpy.allclose(rest.load, [50, 5000], rtol=1e-12) and rest.damping.shape == (2, 2, 2)
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    for _ in range(2):  # once a table
        lubjoint.polar_force("finite_reynolds", half_as_long, 0.97, 1, 0)
assert len(said) == 1 and "0.95" in str(said[0].message), said
# Integrals of the pressure, without a force law: each law within the bound that is stated and its own roundings.
for law in ("short_full", "short_half", "short_dynamic", "long_full", "long_half", "long_half_eq5", "long_dynamic"):
    solved = lubjoint.oracle_force(law, half_as_long, ratios, slips, squeezes)
    radial, tangential = lubjoint.polar_force(law, half_as_long, ratios, slips, squeezes)
    size = numpy.hypot(radial, tangential)
    bound = numpy.hypot(solved.radial_error, solved.tangential_error)
    off = numpy.hypot(radial - solved.radial, tangential - solved.tangential)
    assert (off <= bound + 2e-14 * size).all(), (law, off / size)  # README, "How accurate": laws to 1.3e-14
    assert (bound < 1e-12 * size).all(), (law, bound / size)
    other = lubjoint.polar_force("long_half" if law != "long_half" else "long_full", half_as_long, ratios, slips, squeezes)
    assert (numpy.hypot(other[0] - solved.radial, other[1] - solved.tangential) > bound).any(), law  # it can say no
assert lubjoint.oracle_force("short_full", half_as_long, [[0.1], [0.2]], 1, [0, 1, 2]).radial.shape == (2, 3)
# A table that does not ship is compiled, and kept where it is found again; a damaged one is made again, with a word.
with tempfile.TemporaryDirectory() as cache:
    os.environ["XDG_CACHE_HOME"] = cache
    odd = lubjoint.Bearing(viscosity=0.4, length=0.06, radius=0.04, clearance=2e-4)
    assert lubjoint.film_table("finite_full", odd).error < 1e-6
    (kept,) = pathlib.Path(cache).rglob("finite_full-0.75-*.txt")
    kept.write_text(kept.read_text()[:-9])
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        _oracle.provide("finite_full", odd)
    assert "refused" in str(said[0].message) and kept.read_text().endswith("\n"), said

for bad in ((lambda: lubjoint.equilibrium("short_half", bearing, -1, 50)),
            (lambda: lubjoint.equilibrium("short_half", bearing, 1, 0)),
            (lambda: lubjoint.coefficients("short_half", bearing, 50)),
            (lambda: lubjoint.coefficients("short_half", bearing, 50, load=1, axes="mine")),
            (lambda: lubjoint.mobility("butenschoen", squat, 0.5, 0, 1, 0)),
            (lambda: lubjoint.mobility("short_full", bearing, 1.5, 0, 1, 0)),
            (lambda: lubjoint.verify(short_full, "short_full", "polar", domain="omega_sum > 0")),
            (lambda: lubjoint.verify(short_full, "short_full", "polar", tolerance=0.5)),
            (lambda: lubjoint.verify(short_full, "short_full", "polar", unit=0.25)),
            (lambda: lubjoint.verify(short_full, "short_full", "polar", shear="flooded")),
            (lambda: lubjoint.polar_force("finite_full", lubjoint.Bearing(0.4, 4, 0.04, 2e-4), 0.5, 0, 1)),  # L/D 50
            (lambda: lubjoint.losses("finite_reynolds", half_as_long, 0, 0, 1e-3, 0, 0, 1)),  # where it ends: unknown
            (lambda: lubjoint.film_table("short_full", bearing)),
            (lambda: lubjoint.oracle_force("finite_half", squat, 0.5, 1, 1, onset="free")),
            (lambda: lubjoint.oracle_force("finite_half", squat, [0.5, 1.5], 1, 1)),
            (lambda: lubjoint.oracle_force("short_quarter", squat, 0.5, 1, 1)),
            (lambda: lubjoint.oracle_force("short_half", squat, 0.5, 1, 1, onset="free")),
            (lambda: lubjoint.oracle_force("short_half", squat, 1.5, 1, 1)),
            (lambda: lubjoint.oracle_force("short_half", squat, 0.5, 1, 1, tolerance=1e-16)),
            (lambda: lubjoint.oracle_force("finite_half", squat, 0.5, 1, 1, tolerance=0)),
            (lambda: lubjoint.oracle_force("finite_half", squat, 0.5, 1, 1, tolerance=1)),
            (lambda: lubjoint.film_losses("long_full", bearing, 0, 0, 0, 0, 0, 1, shear="striated")),
            (lambda: lubjoint.film_coefficients("long_full", bearing, 0, 1)),
            (lambda: lubjoint.film_coefficients("squeeze_long", bearing, 0.5, 1)),
            (lambda: lubjoint.journal_force("butenschoen", lubjoint.Bearing(0.4, 0.04, 0.0098, 2e-4), 0, 0, 1, 0, 0, 0))):
    try:
        bad()
        raise SystemExit("not refused")
    except ValueError:
        pass


# Tables through the package: the library itself, in verify's axes; an exchange; a domain; a numerical function.
def stiffness_and_damping(viscosity, length, radius, clearance, omega, load):
    oil = lubjoint.Bearing(viscosity, length, radius, clearance)
    found = lubjoint.coefficients("long_dynamic", oil, omega, load=load, axes="inertial")
    names = [m + i + j for m in "kc" for i in "xy" for j in "xy"]
    return dict(zip(names, [*found.stiffness.ravel(), *found.damping.ravel()]))


def exchanged(**state):
    given = stiffness_and_damping(**state)
    given["kxy"], given["kyx"], given["cxy"], given["cyx"] = (given[n] for n in ("kyx", "kxy", "cyx", "cxy"))
    return given


assert lubjoint.verify(stiffness_and_damping, "long_dynamic", "coefficients", random=50, vectorized=False)
report = lubjoint.verify(exchanged, "long_dynamic", "coefficients", random=50, vectorized=False)
assert not report and report.suspects[0]["mistakes"] == ["coefficients_transposed"], report
assert [c["column"] for c in report.columns if c["verdict"] == "other"] == ["kxy", "kyx", "cxy", "cyx"], report.columns
report = lubjoint.verify(lambda **s: short_full(**{**s, "omega": abs(s["omega"])}), "short_full", "polar")
assert report.verdict == "disagrees" and report.terms
assert lubjoint.verify(lambda **s: short_full(**{**s, "omega": abs(s["omega"])}), "short_full", "polar",
                       domain=["omega >= 0"])
nearly = lubjoint.verify(lambda **s: [x * (1 + 1e-7) for x in short_full(**s)], "short_full", "polar", tolerance=1e-6)
assert nearly and nearly["accepted"], nearly
assert len(lubjoint.states("cartesian", at_most=12)["ex"]) == 12
try:
    lubjoint.states("cartesian", law="foo")
    raise AssertionError("states of a law that is not there")
except ValueError as error:
    assert "foo" in str(error), error


# A film of the bearing's real length: where a load comes to rest by the solver's own force; and with half of the load.
def place_of_rest(viscosity, length, radius, clearance, omega, load):
    oil = lubjoint.Bearing(viscosity, length, radius, clearance)
    low, high = 0.0, 0.99
    while high - low > 1e-6:
        ratio = (low + high) / 2
        force = lubjoint.oracle_force("finite_full", oil, ratio, ratio * abs(omega), 0.0)
        low, high = (low, ratio) if math.hypot(force.radial, force.tangential) > load else (ratio, high)
    return {"eccentricity_ratio": low, "attitude": math.pi / 2}


of_length = {"law": "finite_full", "quantities": "equilibrium", "vectorized": False}
assert lubjoint.verify(place_of_rest, **of_length)
report = lubjoint.verify(lambda load, **s: place_of_rest(load=load / 2, **s), **of_length)
assert not report and "load_halved" in report.suspects[0]["mistakes"], report
assert list(lubjoint.states("losses", law="finite_half"))[:4] == ["viscosity", "length", "radius", "clearance"]

# Without dimensions, in the program's own unit, S omega/4; and a mistake in it.
own_unit = {"law": "short_dynamic", "quantities": "dimensionless", "unit": 0.25, "vectorized": False, "random": 100}
assert lubjoint.verify(lambda **s: capone.force(*s.values(), 2), **own_unit)
report = lubjoint.verify(lambda **s: capone.force(*s.values(), 1), **own_unit)
assert not report and report.suspects[0]["mistakes"] == ["time_over_mean_spin"], report


# Programs for the film of the bearing's real length: one by differences, which shares nothing with the judge.
sys.path.insert(0, str(pathlib.Path(sys.argv[1]).parent / "programs"))
stdin, sys.stdin, stdout, sys.stdout = sys.stdin, io.StringIO("id\n"), sys.stdout, io.StringIO()
try:
    import finite  # noqa: E402  a program that reads states: of none here
finally:
    sys.stdin, sys.stdout = stdin, stdout


def differences(mode):
    def answer(**state):
        finite.MODE = mode
        return finite.answer(state)
    return answer


finite_half = {"law": "finite_half", "tolerance": 1e-2, "vectorized": False}
right = lubjoint.verify(differences("right"), **finite_half)
assert right and right.verdict == "agrees" and right["states"] == 80 and right["law"] == "finite_half", right
for mode, name in (("half_length", "half_bearing_not_doubled"), ("length_over_radius", "length_over_radius"),
                   ("no_squeeze", "squeeze_left_out"), ("half_squeeze", "squeeze_rate_halved"),
                   ("not_mirrored", "film_not_mirrored"), ("diametral", "diametral_clearance"), ("steady", "steady_only")):
    report = lubjoint.verify(differences(mode), **finite_half)
    assert not report and report.suspects[0]["mistakes"] == [name], (mode, report)
assert report.right_where == [["squeeze_rate == 0"]], report.right_where  # of the steady one
assert {(t["component"], t["states"]): t["verdict"] for t in report.terms}[("radial", "wedge")] == "right", report.terms
assert "Term by term" in str(report)
steady = lubjoint.verify(differences("steady"), steady=True, **finite_half)
assert steady and steady["domain"] and steady["states"] == 40, steady
few = lubjoint.verify(differences("right"), at_most=12, **finite_half)
assert few and few["states"] + few["left_out"] == 12, few  # some of them on the half film's jump
assert len(lubjoint.states("polar", law="finite_reynolds")["squeeze_rate"]) == 120
film = lubjoint.verify(differences("full"), **finite_half)
assert film["other"] == "finite_full" and film["other_films"] == ["finite_full"], film


def with_moments(carried):
    """Both moments about the mass centres; -F acts on the bearing's body at the journal's centre."""
    def answer(sx_i, sy_i, sx_j, sy_j, **state):
        fx, fy = finite.answer(state)
        x, y = (sx_i + state["ex"], sy_i + state["ey"]) if carried else (sx_i, sy_i)
        return fx, fy, y * fx - x * fy, sx_j * fy - sy_j * fx
    return answer


finite.MODE = "right"
of_joint = {**finite_half, "quantities": "wrench"}
assert lubjoint.verify(with_moments(True), **of_joint)
report = lubjoint.verify(with_moments(False), **of_joint)
assert not report and report.suspects[0]["mistakes"] == ["transport_moment_left_out"], report
for wrong in ({"random": 5}, {"seed": 2}, {"quantities": "dimensionless"}, {"unit": 0.25}, {"shear": "film"},
              {"onset": "free"}, {"domain": "speed > 1e9"}, {"tolerance": 0.5}):
    try:
        lubjoint.verify(differences("right"), **{**finite_half, **wrong})
        raise AssertionError(f"{wrong} must be refused")
    except ValueError:
        pass

# Runs: the numbers of the command, bit for bit, and its summary and warnings.
scenes = pathlib.Path(sys.argv[1]).parents[1] / "data" / "scenes"
program = os.path.join(os.environ["LUBJOINT_BUILT"], "lubjoint")


def commanded(scene, *options):
    """Columns and summary of `lubjoint simulate`, and what it warns of."""
    with tempfile.TemporaryDirectory() as folder:
        ran = subprocess.run([program, "simulate", scene, "--out", folder, "--json", *options], capture_output=True,
                             text=True)
        assert ran.returncode in (0, 1), ran.stderr
        (file,) = pathlib.Path(folder).glob("*.csv")
        rows = list(csv.reader(file.read_text().splitlines()))
    warned = [line.removeprefix("warning: ") for line in ran.stderr.splitlines() if line.startswith("warning: ")]
    return dict(zip(rows[0], zip(*rows[1:]))), json.loads(ran.stdout), warned


for scene, given in (("journal.toml", {"duration": 0.2, "law": "long_half", "after": 0.05}),
                     ("journal.toml", {"duration": 0.1, "law": "finite_full", "rtol": 1e-7}),
                     ("slider-crank.toml", {"duration": 2e-3, "integrator": "dopri5"}),
                     ("slider-crank.toml", {"law": "short_half", "last_revolution": True}),
                     ("impact.toml", {}), ("space/spatial-slider-crank.toml", {"duration": 2e-3})):
    options = []
    for name, value in given.items():
        options += ["--" + name.replace("_", "-")] + ([] if value is True else [str(value)])
    columns, summary, warned = commanded(scenes / scene, *options)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        run = lubjoint.simulate(scenes / scene, **given)
    assert [str(w.message) for w in said] == warned and all(w.filename == __file__ for w in said), (scene, said, warned)
    assert list(run) == list(columns) and run.t is not None and len(run.t) == len(columns["t"]) > 1, scene
    for name, texts in columns.items():
        numbers = numpy.array([float(text) if text else numpy.nan for text in texts])
        assert numpy.array_equal(run[name], numbers, equal_nan=True), (scene, name)
        assert (numpy.isnan(run[name]) == [not text for text in texts]).all(), (scene, name)
    assert run.summary.pop("wall_s") >= 0 and summary.pop("wall_s") >= 0
    assert run.summary == summary and run.finished == (summary["status"] == "finished"), scene
    assert ("after" in summary["joints"][0]) == ("after" in given or "last_revolution" in given), scene
warnings.simplefilter("ignore")  # they were looked at above
assert numpy.isfinite(lubjoint.simulate(scenes / "journal.toml", duration=0.01).values_by_column).all()
journal = (scenes / "journal.toml").read_text()
again = lubjoint.simulate(text=journal, duration=0.01)
assert (again["bearing.fx"] == lubjoint.simulate(scenes / "journal.toml", duration=0.01)["bearing.fx"]).all()
other = lubjoint.simulate(text=journal.replace("viscosity = 0.4", "viscosity = 0.5"), duration=0.01)
assert (again["bearing.fx"] != other["bearing.fx"]).any() and "bearing.torque_journal" not in other
limited = lubjoint.simulate(text=journal.replace("[integrator]", "[integrator]\nmax_steps = 60"))
assert not limited.finished and limited.summary["status"] == "stopped", limited
assert "60 steps" in limited.summary["message"] and limited.t[-1] == limited.summary["t_end"] < 1, limited
for words, wrong in (("no_such.toml", {"scene": "no_such.toml"}), ("text:", {"text": "duration = -1"}),
                     ("film", {"text": journal.replace("pinkus_sternlicht", "pinkus")}),
                     ("short_half", {"scene": scenes / "journal.toml", "law": "short"}),
                     ("radau_iia5", {"scene": scenes / "journal.toml", "integrator": "euler"}),
                     ("rtol is 2", {"scene": scenes / "journal.toml", "rtol": 2}),
                     ("duration is -1", {"scene": scenes / "journal.toml", "duration": -1}),
                     ("after is 9", {"scene": scenes / "journal.toml", "duration": 0.1, "after": 9}),
                     ("plane", {"scene": scenes / "space" / "top.toml", "after": 0.1}),
                     ("last_revolution is for scenes in the plane",
                      {"scene": scenes / "space" / "top.toml", "last_revolution": True}),
                     ("after and last_revolution are given; allowed is one of them",
                      {"scene": scenes / "slider-crank.toml", "after": 0.01, "last_revolution": True}),
                     ("last_revolution: the scene ends before one revolution",
                      {"scene": scenes / "slider-crank.toml", "duration": 1e-3, "last_revolution": True}),
                     ("last_revolution: nothing in the scene is driven round; allowed is after",
                      {"text": journal.replace("spin = ", "spin = 0.0 # "), "last_revolution": True}),
                     ("no effect", {"scene": scenes / "slider-crank-ideal.toml", "law": "short_half"}),
                     ("one of scene and text", {}), ("NUL", {"text": "duration = 1\0"}), ("NUL", {"scene": "a\0b.toml"}),
                     ("eccentricity ratio 5000", {"text": journal.replace("position = [0.0, 0.0]", "position = [1.0, 0.0]")})):
    try:
        lubjoint.simulate(**wrong)
        raise AssertionError(f"{wrong} must be refused")
    except ValueError as error:
        assert words in str(error) and "--" not in str(error), (wrong, error)

# The examples in the documentation, what each public function says, and that every public name has one sentence at least.
for module in (_film, _oracle, _rest, _simulate, _verify):
    outcome = doctest.testmod(module)
    assert outcome.attempted >= 2 and outcome.failed == 0, (module, outcome)
assert all(getattr(lubjoint, name).__doc__ for name in lubjoint.__all__)
sections = {"shapes": r"\bshapes?\b|list of", "units": r"\[(N|m|rad|kg|W|-|s|1/s|N m)\]|SI units|without a unit",
            "errors": r"\bValueError\b", "source": r"\bSource:", "formula": r" = | <= ", "example": ">>> "}
left_out = {"laws": {"units", "errors", "source", "formula"}, "states": {"formula"}, "film_table": {"shapes"}}  # have none
for name, function in inspect.getmembers(lubjoint, inspect.isfunction):
    if name in lubjoint.__all__:
        described, example, _ = function.__doc__.partition(">>> ")  # what an example does is no description
        missing = {section for section, words in sections.items() if not re.search(words, described + example)}
        assert missing <= left_out.get(name, set()), (name, missing)
assert os.path.exists(os.path.join(os.path.dirname(lubjoint.__file__), "py.typed"))


def medians(calls, repeats=31):
    """Median seconds of each call; the calls take turns."""
    times = [[] for _ in calls]
    for _ in range(repeats):
        for column, call in zip(times, calls):
            begin = time.perf_counter()
            call()
            column.append(time.perf_counter() - begin)
    return [statistics.median(column) for column in times]


if "--cost" in sys.argv:  # NumPy against the batch function alone, its arguments made beforehand
    print("law                      rows  function    NumPy  NumPy, out=   [ns a row], ratios")
    for law in lubjoint.laws():
        for rows in (1_000, 10_000, 100_000, 1_000_000):
            many = numpy.random.default_rng(1).uniform(0, 0.9, (3, rows))
            out = tuple(numpy.empty((2, rows)))
            made = _library.Batch(many, out)
            oil = squat if law == "butenschoen" else bearing  # whose fit ends at L/D = 1
            given = (law.encode(), oil._struct, rows, *made.inputs, *made.outputs)
            times = medians((lambda: _library.library.lubjoint_polar_force(*given),
                             lambda: lubjoint.polar_force(law, oil, *many),
                             lambda: lubjoint.polar_force(law, oil, *many, out=out)))
            print(f"{law:18} {rows:10}" + "".join(f"{t / rows * 1e9:9.2f}" for t in times) +
                  f"   {times[1] / times[0]:.2f} {times[2] / times[0]:.2f}")
