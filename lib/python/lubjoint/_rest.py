"""Losses, places of rest, coefficients and mobility over NumPy arrays, through the C interface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy
from numpy.typing import ArrayLike, NDArray

from ._library import (Array, Batch, Bearing, CoefficientsStruct, LossesStruct, MobilityStruct, MotionStruct, Number,
                       broadcast, call, library)
from ._oracle import warn_beyond


@dataclass(frozen=True)
class Losses:
    """What the oil costs: torques on journal and bearing about their own centres [N m], the power lost in the film [W],
    and the flow out of both sides [m^3/s], None for a long bearing, which has none, and for a compiled law. Numbers, or arrays of the
    arguments' common shape."""

    torque_journal: Number
    torque_bearing: Number
    power: Number
    side_flow: Optional[Number]


@dataclass(frozen=True)
class Equilibrium:
    """Where a journal rests: e/c, and the attitude angle [rad] from the load to e, positive in the sense of the spin."""

    eccentricity_ratio: Number
    attitude: Number


@dataclass(frozen=True)
class Coefficients:
    """A journal at rest on its film: load [N], attitude [rad] (from the load to e, positive in the sense of the spin),
    stiffness [N/m] and damping [N s/m] of shape (..., 2, 2), critical mass of a rigid rotor per bearing [kg]: inf where
    every mass is stable, 0 where none is; e/c. First index of a matrix: the force's direction, F = -K e - C v."""

    load: Number
    attitude: Number
    stiffness: NDArray[numpy.float64]
    damping: NDArray[numpy.float64]
    critical_mass: Number
    eccentricity_ratio: Number = float("nan")


@dataclass(frozen=True)
class Mobility:
    """The pure-squeeze velocities [1/s] that carry a force. status: "found", "none", "two" or "many"; of two, ux and uy
    are the one with a > 0 and other_ux, other_uy the one with a < 0; of many, the smallest. NaN where there is none."""

    ux: Number
    uy: Number
    status: Any
    other_ux: Number
    other_uy: Number


def losses(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
           omega_bearing: ArrayLike, omega_journal: ArrayLike, shear: str = "film") -> Losses:
    """Friction torques, power and side flow of a film.

    T_C = mu omega R^3 L/c * integral of dtheta/H with omega = omega_J - omega_B, T_J = -T_C - e x F/2,
    T_B = T_C - e x F/2, power = omega T_C - c F.u, side flow cRL |a| (half films), 2 cRL |u| (dynamic films), 0 (full).
    Source: the wall shear -+mu omega R/h - (h/2R) dp/dtheta, integrated.

    Motion as of journal_force, [m], [m/s], [rad/s]; all broadcast, and the answers have the common shape. shear: the part
    of the gap that shears, "film", "flooded" or, for half films, "striated"; finite_reynolds, whose table does not know
    where its film ends, has "flooded" alone. ValueError for an unknown law, a shear that it has not, a row without a film;
    OverflowError beyond double precision.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> cost = losses("short_dynamic", bearing, 1.46133e-5, -6.23547e-6, 0, 0, 0, 314.159)
    >>> print(f"{cost.torque_journal:.4f} N m, {cost.power:.1f} W, {1e6 * cost.side_flow:.3f} cm^3/s")
    -2.6388 N m, 829.0 W, 12.478 cm^3/s
    """
    batch = Batch([ex, ey, vx, vy, omega_bearing, omega_journal], None, 4)
    outputs = batch.outputs
    has_flow = law.removeprefix("squeeze_").startswith("short")
    if not has_flow:
        outputs[3] = Array(None, 0)
    call(library.lubjoint_film_losses, law, bearing, shear.encode(), batch.count, MotionStruct(*batch.inputs),
         LossesStruct(*outputs))
    warn_beyond(law, bearing, ex, ey)
    answers = batch.answers()
    return Losses(answers[0], answers[1], answers[2], answers[3] if has_flow else None)


def film_losses(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
                omega_bearing: ArrayLike, omega_journal: ArrayLike, shear: str = "film") -> Losses:
    """losses() by its former name: friction torques [N m], power [W] and side flow [m^3/s].

    T_J = -T_C - e x F/2, T_B = T_C - e x F/2, power = omega T_C - c F.u. Arguments, shapes, ValueError and OverflowError as
    of losses(). Source: as there.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> film_losses("short_half", bearing, [1e-5, 2e-5], 0, 0, 0, 0, 300).power.shape
    (2,)
    """
    return losses(law, bearing, ex, ey, vx, vy, omega_bearing, omega_journal, shear)


def film_coefficients(law: str, bearing: Bearing, eccentricity_ratio: ArrayLike, omega: ArrayLike) -> Coefficients:
    """Load, attitude, stiffness, damping and critical mass of a journal of spin omega [rad/s], of either sign and not 0,
    that rests at an eccentricity ratio above 0 and below 1 in a bearing that does not turn. x along the load on the
    journal, y 90 degrees counter-clockwise of it. coefficients() takes a load, too.

    load = |F(eps)| [N], K = -dF/de [N/m], C = -dF/dv [N s/m], as of coefficients(); the critical mass [kg] by Routh's
    condition on m x'' + C x' + K x = 0. Source: the derivatives of the laws' formulas, in closed form.

    Eccentricity ratio and omega broadcast; matrices are of shape (..., 2, 2). ValueError for an unknown law, one of the
    squeeze alone, which carries nothing at rest, and a row with another ratio or no spin (it is named); OverflowError
    beyond double precision.

    >>> bearing = Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    >>> rest = film_coefficients("short_half", bearing, 0.5, 50)
    >>> print(f"{bearing.clearance * rest.stiffness[0, 1] / rest.load:.12f}")  # c K_xy/W
    3.976642421316
    """
    batch = Batch([eccentricity_ratio, omega], None, 11)
    to = batch.outputs
    call(library.lubjoint_film_coefficients, law, bearing, batch.count, *batch.inputs,
         CoefficientsStruct(to[0], to[1], (4 * Array)(*to[2:6]), (4 * Array)(*to[6:10]), to[10]))
    warn_beyond(law, bearing, eccentricity_ratio)
    rows = batch.answers()
    return Coefficients(rows[0], rows[1], batch.matrices(2), batch.matrices(6), rows[10],
                        broadcast(eccentricity_ratio, batch))


def equilibrium(law: str, bearing: Bearing, load: ArrayLike, omega: ArrayLike) -> Equilibrium:
    """Where a journal of spin omega [rad/s], of either sign and not 0, rests under a load above 0 [N].

    The root of |F(eps)| = load with a = eps omega, b = 0, the bearing at rest; the attitude angle is atan2(F_t, -F_r)
    there [rad]. Source: the balance of the load with the law's force (as of polar_force), by a bracketed root.

    Load and omega broadcast; both answers have their common shape. ValueError for an unknown law, one of the squeeze
    alone, which carries nothing at rest, and for a row that has no such place (it is named). Good to a few roundings of
    the load.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> rest = equilibrium("short_dynamic", bearing, 5000, [100.0, 314.159])
    >>> print(f"{rest.eccentricity_ratio[1]:.6f}, {numpy.degrees(rest.attitude[1]):.3f} degrees")
    0.317760, 66.892 degrees
    """
    batch = Batch([load, omega])
    call(library.lubjoint_film_equilibrium, law, bearing, batch.count, *batch.inputs, *batch.outputs)
    place = Equilibrium(*batch.answers())
    warn_beyond(law, bearing, place.eccentricity_ratio)
    return place


def coefficients(law: str, bearing: Bearing, omega: ArrayLike, load: Optional[ArrayLike] = None,
                 eccentricity_ratio: Optional[ArrayLike] = None, axes: str = "load") -> Coefficients:
    """Stiffness K = -dF/de and damping C = -dF/dv of a film, at the load [N] or at the eccentricity ratio that is given.

    In radial and tangential axes K = (-F_r', F_t/eps; -F_t', -F_r/eps)/c with ' = d/d eps along a = eps omega, and
    C = (-dF_r/db, 2 dF_r/da; -dF_t/db, 2 dF_t/da)/c, turned into x and y. Source: the derivatives of the laws' formulas
    in closed form, held against dual numbers; short_half's also in Friswell et al., Dynamics of Rotating Machines (2010).

    omega  spin of the journal [rad/s], of either sign and not 0; the bearing is at rest
    axes   "load": x along the load on the journal, y 90 degrees counter-clockwise of it;
           "inertial": the load along -y, as `lubjoint verify --quantities coefficients` has it

    Arguments broadcast; matrices are of shape (..., 2, 2), K in N/m and C in N s/m. ValueError as of equilibrium, and
    unless one of load and eccentricity_ratio is given; OverflowError beyond double precision.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> rest = coefficients("short_dynamic", bearing, 314.159, load=5000)
    >>> print(f"{rest.eccentricity_ratio:.6f}, critical mass {rest.critical_mass:.2f} kg")
    0.317760, critical mass 6811.79 kg
    >>> turned = coefficients("short_dynamic", bearing, 314.159, load=5000, axes="inertial")
    >>> bool(turned.stiffness[0, 0] == rest.stiffness[1, 1] and turned.stiffness[0, 1] == -rest.stiffness[1, 0])
    True
    """
    if (load is None) == (eccentricity_ratio is None):
        raise ValueError("required is one of load and eccentricity_ratio")
    if axes not in ("load", "inertial"):
        raise ValueError(f"axes is {axes!r}; allowed are 'load' and 'inertial'")
    if eccentricity_ratio is None:
        eccentricity_ratio = equilibrium(law, bearing, load, omega).eccentricity_ratio
    rest = film_coefficients(law, bearing, eccentricity_ratio, omega)
    if axes == "load":
        return rest

    def turned(m):  # x = the old y, y = minus the old x
        return numpy.stack([numpy.stack([m[..., 1, 1], -m[..., 1, 0]], -1),
                            numpy.stack([-m[..., 0, 1], m[..., 0, 0]], -1)], -2)

    return Coefficients(rest.load, rest.attitude, turned(rest.stiffness), turned(rest.damping), rest.critical_mass,
                        rest.eccentricity_ratio)


_mobility_status = numpy.array(["found", "none", "two", "many"])


def mobility(law: str, bearing: Bearing, ex_over_c: ArrayLike, ey_over_c: ArrayLike, fx: ArrayLike,
             fy: ArrayLike) -> Mobility:
    """The pure-squeeze velocity u [1/s] at which the film's force on the journal is (fx, fy) [N]: the inverse of a law.

    Full films: closed, u = -(q^(3/2)/(pi S)) [F - 3 (e.F) e/(1 + 2 eps^2)] (short); short_dynamic: one equation for the
    direction, with one solution; others: Newton's method with exact derivatives. A journal moves at
    c u + (omega_J + omega_B)/2 e_perp. Half films have no velocity for some forces and two for others (status). Source:
    Booker (1965), J. Basic Eng. 87, 537-546; Childs, Moes and van Leeuwen (1977), J. Lubr. Technol. 99, 198-210.

    e/c [-] and force [N] in the same axes; all broadcast, and the answers have the common shape. ValueError for an unknown
    law, for butenschoen, which has no inverse, and for rows with e/c >= 1 or no finite force (they are named).

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> u = mobility("short_dynamic", bearing, 0.5, 0, [-40, 40], 0)
    >>> print(u.status[0], f"{u.ux[0]:.10f}", f"{u.ux[1]:.10f}")
    found 0.6996203562 -11.4320577345
    """
    batch = Batch([ex_over_c, ey_over_c, fx, fy], None, 4)
    status = numpy.empty(batch.count, dtype=numpy.intc)
    call(library.lubjoint_film_mobility, law, bearing, batch.count, *batch.inputs,
         MobilityStruct(*batch.outputs, status.ctypes.data))
    warn_beyond(law, bearing, numpy.multiply(bearing.clearance, ex_over_c),
                numpy.multiply(bearing.clearance, ey_over_c))
    rows = batch.answers()
    names = _mobility_status[status]
    return Mobility(rows[0], rows[1], names.reshape(batch.shape) if batch.shape else str(names[0]), rows[2], rows[3])
