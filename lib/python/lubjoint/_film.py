"""Films, contact and moments over NumPy arrays, through the C interface."""

from __future__ import annotations

import ctypes
import errno
import os
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy
from numpy.typing import ArrayLike, NDArray

Number = Union[float, NDArray[numpy.float64]]
"""A float where all arguments are numbers, an array of their common shape otherwise."""

_library = ctypes.CDLL(os.path.join(os.path.dirname(__file__), "liblubjoint_c.so"))


class _In(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("stride", ctypes.c_ssize_t)]


class _BearingStruct(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("viscosity", "length", "radius", "clearance")]


class _ContactStruct(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("e0", "e1", "stiffness", "restitution", "impact_speed")]


class _Motion(ctypes.Structure):
    _fields_ = [(name, _In) for name in ("ex", "ey", "vx", "vy", "omega_bearing", "omega_journal")]


class _Losses(ctypes.Structure):
    _fields_ = [(name, _In) for name in ("torque_journal", "torque_bearing", "power", "side_flow")]


class _Coefficients(ctypes.Structure):
    _fields_ = [("load", _In), ("attitude", _In), ("stiffness", 4 * _In), ("damping", 4 * _In), ("critical_mass", _In)]


class _Mobility(ctypes.Structure):
    _fields_ = [(name, _In) for name in ("ux", "uy", "other_ux", "other_uy")] + [("status", ctypes.c_void_p)]


_bearing_pointer = ctypes.POINTER(_BearingStruct)
_motion_pointer = ctypes.POINTER(_Motion)
_library.lubjoint_message.restype = ctypes.c_char_p
_library.lubjoint_version.restype = ctypes.c_char_p
_library.lubjoint_law_name.restype = ctypes.c_char_p
_library.lubjoint_law_name.argtypes = [ctypes.c_size_t]
_library.lubjoint_polar_force.argtypes = [ctypes.c_char_p, _bearing_pointer, ctypes.c_size_t] + 5 * [_In]
_library.lubjoint_journal_force.argtypes = [ctypes.c_char_p, _bearing_pointer, ctypes.c_size_t, _motion_pointer, _In, _In]
_library.lubjoint_transition_force.argtypes = [
    ctypes.c_char_p, _bearing_pointer, ctypes.POINTER(_ContactStruct), ctypes.c_size_t, _motion_pointer, _In, _In]
_library.lubjoint_film_losses.argtypes = [
    ctypes.c_char_p, _bearing_pointer, ctypes.c_char_p, ctypes.c_size_t, _motion_pointer, ctypes.POINTER(_Losses)]
_library.lubjoint_film_coefficients.argtypes = [
    ctypes.c_char_p, _bearing_pointer, ctypes.c_size_t, _In, _In, ctypes.POINTER(_Coefficients)]
_library.lubjoint_film_equilibrium.argtypes = [ctypes.c_char_p, _bearing_pointer, ctypes.c_size_t] + 4 * [_In]
_library.lubjoint_film_mobility.argtypes = [ctypes.c_char_p, _bearing_pointer, ctypes.c_size_t] + 4 * [_In] + [
    ctypes.POINTER(_Mobility)]
_library.lubjoint_joint_moments.argtypes = [ctypes.c_size_t] + 10 * [_In]


@dataclass(frozen=True)
class Bearing:
    """Bearing and oil: dynamic viscosity [Pa s], length, journal radius and radial clearance [m]."""

    viscosity: float
    length: float
    radius: float
    clearance: float

    def _struct(self):
        return _BearingStruct(self.viscosity, self.length, self.radius, self.clearance)


@dataclass(frozen=True)
class Contact:
    """Dry contact and the transition to it: 0 < e0 < e1 [m], stiffness [N/m^1.5], restitution in [0, 1], the speed at
    which the journal last crossed e = c outwards [m/s]."""

    e0: float
    e1: float
    stiffness: float
    restitution: float
    impact_speed: float

    def _struct(self):
        return _ContactStruct(self.e0, self.e1, self.stiffness, self.restitution, self.impact_speed)


def version() -> str:
    """Version of the library."""
    return _library.lubjoint_version().decode()


def laws() -> list[str]:
    """Names of the film laws.

    >>> "short_dynamic" in laws()
    True
    """
    names = []
    while (name := _library.lubjoint_law_name(len(names))) is not None:
        names.append(name.decode())
    return names


def _check(status):
    if status == 0:
        return
    message = _library.lubjoint_message().decode()
    if status == errno.ENOMEM:
        raise MemoryError(message)
    if status == errno.ERANGE:
        raise OverflowError(message)
    raise ValueError(message)


class _Batch:
    """Arrays of one shape, and the places where the answers go."""

    def __init__(self, inputs, out):
        arrays = [numpy.asarray(x, dtype=numpy.float64) for x in inputs]
        self._kept = arrays
        shapes = {a.shape for a in arrays}
        self.shape = shapes.pop() if len(shapes) == 1 else numpy.broadcast_shapes(*shapes)
        self.count = self.shape[0] if len(self.shape) == 1 else int(numpy.prod(self.shape))
        if len(self.shape) > 1:  # row after row; what has as many numbers and no gaps is read where it is
            arrays = [a.reshape(()) if a.size == 1 else numpy.broadcast_to(a, self.shape).reshape(-1) for a in arrays]
            self._kept = arrays
            out = self._flat(out)
            self.inputs = [_In(a.ctypes.data, a.strides[0] if a.shape else 0) for a in arrays]
            self._out = out
            self.outputs = [_In(a.ctypes.data, a.strides[0]) for a in out]
            return
        # Stride 0 for one number that goes with all rows.
        self.inputs = [_In(a.ctypes.data, a.strides[0] if a.shape == self.shape and self.shape else 0) for a in arrays]
        if out is None:
            # One block: the allocator keeps it for the next call. Of two it gives the memory back each time, and
            # getting it anew costs more than the forces.
            out = tuple(numpy.empty((2, self.count)))
        for array in out:
            if array.dtype != numpy.float64 or array.shape != (self.count,) or not array.flags.writeable:
                raise ValueError(f"out is of shape {array.shape} and type {array.dtype}; "
                                 f"required are writeable float64 arrays of shape {(self.count,)}")
        self._out = out
        self.outputs = [_In(a.ctypes.data, a.strides[0]) for a in out]

    def _flat(self, out):
        """The arrays that are written as one row each, which must be views."""
        if out is None:
            return tuple(numpy.empty((2, self.count)))
        for array in out:
            if array.dtype != numpy.float64 or array.shape != self.shape or not array.flags.writeable or \
                    not array.flags.c_contiguous:
                raise ValueError(f"out is of shape {array.shape} and type {array.dtype}; required are writeable "
                                 f"float64 arrays of shape {self.shape} without gaps")
        return tuple(array.reshape(-1) for array in out)

    def answers(self):
        return tuple(self.shaped(a) for a in self._out)

    def shaped(self, row):
        """A row of answers in the shape of the arguments."""
        if not self.shape:
            return float(row[0])
        return row if len(self.shape) == 1 else row.reshape(self.shape)


def polar_force(law: str, bearing: Bearing, eccentricity_ratio: ArrayLike, slip_rate: ArrayLike,
                squeeze_rate: ArrayLike, out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Radial and tangential force of the film on the journal [N].

    short_half, for one: F_r/S = -(eps |a|/q^2 + pi b (1 + 2 eps^2)/(2 q^(5/2))), S = mu R L^3/c^2, q = 1 - eps^2
    (Flores et al. 2009, eqs. 8 and 9); every law's formula stands in its header.

    law                 a name of laws()
    eccentricity_ratio  eps = e/c, from 0 to below 1
    slip_rate           a = eps (omega_J + omega_B - 2 attitude rate) [1/s]
    squeeze_rate        b, the rate of eps [1/s]
    out                 two float64 arrays to be written, of the common shape; made anew if left out

    The three broadcast against each other. Returns the pair (radial, tangential): along the eccentricity, and 90
    degrees counter-clockwise of it. ValueError for an unknown law or a row without a film (it is named), OverflowError
    beyond double precision. The error is a few roundings (README, "How accurate").

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> radial, tangential = polar_force("short_dynamic", bearing, 0.5, 2, 1)
    >>> print(f"{radial:.10f} {tangential:.10f}")
    -58.0961230514 22.2900063156
    >>> polar_force("short_half", bearing, [[0.1], [0.2]], 1, [0, 1, 2])[0].shape
    (2, 3)
    """
    batch = _Batch([eccentricity_ratio, slip_rate, squeeze_rate], out)
    _check(_library.lubjoint_polar_force(law.encode(), bearing._struct(), batch.count, *batch.inputs, *batch.outputs))
    return batch.answers()


def journal_force(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
                  omega_bearing: ArrayLike, omega_journal: ArrayLike,
                  out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Force of the film on the journal [N]: fx, fy, in the inertial frame of the motion.

    ex, ey   the journal's centre minus the bearing's [m];  vx, vy  its inertial rate [m/s]
    omega_bearing, omega_journal  absolute spins [rad/s]

    All broadcast. At e = 0 the radial direction is that of v. Errors as of polar_force. Source: Flores et al. (2009),
    eq. 19, of the law's radial and tangential force.

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> fx, fy = journal_force("short_half", bearing, 1e-4, 0, 0, 0, 0, 50)  # steady, at half the clearance
    >>> fx < 0 < fy
    True
    """
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    _check(_library.lubjoint_journal_force(law.encode(), bearing._struct(), batch.count, _Motion(*batch.inputs),
                                           *batch.outputs))
    return batch.answers()


def transition_force(law: str, bearing: Bearing, contact: Contact, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike,
                     vy: ArrayLike, omega_bearing: ArrayLike, omega_journal: ArrayLike,
                     out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Force on a journal that may touch the wall [N]: film up to e = c, a blend over e0, dry contact beyond.

    Flores et al. (2009), eq. 20, with the film's clearance c + e1 and F_N = K delta^(3/2) (1 + 3(1 - c_r^2) rate/(4
    impact speed)), never pulling. Arguments and errors as of journal_force; defined for any eccentricity.

    >>> bearing = Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    >>> contact = Contact(e0=4e-6, e1=2e-5, stiffness=1e10, restitution=0.9, impact_speed=0.1)
    >>> fx, fy = transition_force("long_half", bearing, contact, 3e-4, 0, 0, 0, 0, 0)
    >>> print(f"{fx:.1f} N")
    -10000.0 N
    """
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    _check(_library.lubjoint_transition_force(law.encode(), bearing._struct(), contact._struct(), batch.count,
                                              _Motion(*batch.inputs), *batch.outputs))
    return batch.answers()


def joint_moments(ex: ArrayLike, ey: ArrayLike, sx_i: ArrayLike, sy_i: ArrayLike, sx_j: ArrayLike, sy_j: ArrayLike,
                  fx: ArrayLike, fy: ArrayLike,
                  out: Optional[Sequence[NDArray[numpy.float64]]] = None) -> tuple[Number, Number]:
    """Moments [N m] about the mass centres of the bearing's body i and the journal's body j, of a force on the journal.

    -s_i x F - e x F and s_j x F: -F acts on body i at the journal's centre. sx_i ... sy_j are the arms from the mass
    centres to the joint's centres [m]. All broadcast.

    >>> joint_moments(0, 0, 0.1, 0, -0.1, 0, 0, 3)
    (-0.30000000000000004, -0.30000000000000004)
    """
    batch = _Batch([ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy], out)
    _check(_library.lubjoint_joint_moments(batch.count, *batch.inputs, *batch.outputs))
    return batch.answers()


@dataclass(frozen=True)
class Losses:
    """What the oil costs: torques on journal and bearing about their own centres [N m], the power lost in the film [W],
    and the flow out of both sides [m^3/s], None for a long bearing, which has none. Numbers, or arrays of the
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


def _rows(count, width):
    block = numpy.empty((width, count))
    return block, [_In(row.ctypes.data, row.strides[0]) for row in block]


def losses(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
           omega_bearing: ArrayLike, omega_journal: ArrayLike, shear: str = "film") -> Losses:
    """Friction torques, power and side flow of a film.

    T_C = mu omega R^3 L/c * integral of dtheta/H with omega = omega_J - omega_B, T_J = -T_C - e x F/2,
    T_B = T_C - e x F/2, power = omega T_C - c F.u, side flow cRL |a| (half films), 2 cRL |u| (dynamic films), 0 (full).
    Source: the wall shear -+mu omega R/h - (h/2R) dp/dtheta, integrated.

    Motion as of journal_force; all broadcast. shear: the part of the gap that shears, "film", "flooded" or, for half
    films, "striated". ValueError for an unknown law, a shear that it has not, a row without a film.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> cost = losses("short_dynamic", bearing, 1.46133e-5, -6.23547e-6, 0, 0, 0, 314.159)
    >>> print(f"{cost.torque_journal:.4f} N m, {cost.power:.1f} W, {1e6 * cost.side_flow:.3f} cm^3/s")
    -2.6388 N m, 829.0 W, 12.478 cm^3/s
    """
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], None)
    block, outputs = _rows(batch.count, 4)
    has_flow = law.removeprefix("squeeze_").startswith("short")
    if not has_flow:
        outputs[3] = _In(None, 0)
    _check(_library.lubjoint_film_losses(law.encode(), bearing._struct(), shear.encode(), batch.count,
                                         _Motion(*batch.inputs), _Losses(*outputs)))
    answers = [batch.shaped(row) for row in block]
    return Losses(answers[0], answers[1], answers[2], answers[3] if has_flow else None)


def film_losses(law: str, bearing: Bearing, ex: ArrayLike, ey: ArrayLike, vx: ArrayLike, vy: ArrayLike,
                omega_bearing: ArrayLike, omega_journal: ArrayLike, shear: str = "film") -> Losses:
    """losses() by its former name."""
    return losses(law, bearing, ex, ey, vx, vy, omega_bearing, omega_journal, shear)


def film_coefficients(law: str, bearing: Bearing, eccentricity_ratio: ArrayLike, omega: ArrayLike) -> Coefficients:
    """Load, attitude, stiffness, damping and critical mass of a journal of spin omega [rad/s], of either sign and not 0,
    that rests at an eccentricity ratio above 0 and below 1 in a bearing that does not turn. x along the load on the
    journal, y 90 degrees counter-clockwise of it. coefficients() takes a load, too.

    >>> bearing = Bearing(viscosity=0.04, length=0.04, radius=0.01, clearance=2e-4)
    >>> rest = film_coefficients("short_half", bearing, 0.5, 50)
    >>> print(f"{bearing.clearance * rest.stiffness[0, 1] / rest.load:.12f}")  # c K_xy/W
    3.976642421316
    """
    batch = _Batch([eccentricity_ratio, omega], None)
    block, outputs = _rows(batch.count, 11)
    struct = _Coefficients(outputs[0], outputs[1], (4 * _In)(*outputs[2:6]), (4 * _In)(*outputs[6:10]), outputs[10])
    _check(_library.lubjoint_film_coefficients(law.encode(), bearing._struct(), batch.count, *batch.inputs, struct))
    stiffness, damping = (block[first:first + 4].T.reshape(batch.shape + (2, 2)) for first in (2, 6))
    ratio = numpy.broadcast_to(numpy.asarray(eccentricity_ratio, dtype=numpy.float64), batch.shape)
    return Coefficients(batch.shaped(block[0]), batch.shaped(block[1]), stiffness, damping, batch.shaped(block[10]),
                        ratio if batch.shape else float(ratio))


def equilibrium(law: str, bearing: Bearing, load: ArrayLike, omega: ArrayLike) -> Equilibrium:
    """Where a journal of spin omega [rad/s], of either sign and not 0, rests under a load above 0 [N].

    The root of |F(eps)| = load with a = eps omega, b = 0, the bearing at rest; the attitude angle is atan2(F_t, -F_r)
    there. Load and omega broadcast. ValueError for a law of the squeeze alone, which carries nothing at rest, and for a
    row that has no such place. Good to a few roundings of the load.

    >>> bearing = Bearing(viscosity=0.02, length=0.05, radius=0.05, clearance=5e-5)
    >>> rest = equilibrium("short_dynamic", bearing, 5000, [100.0, 314.159])
    >>> print(f"{rest.eccentricity_ratio[1]:.6f}, {numpy.degrees(rest.attitude[1]):.3f} degrees")
    0.317760, 66.892 degrees
    """
    batch = _Batch([load, omega], None)
    _check(_library.lubjoint_film_equilibrium(law.encode(), bearing._struct(), batch.count, *batch.inputs,
                                              *batch.outputs))
    return Equilibrium(*batch.answers())


def coefficients(law: str, bearing: Bearing, omega: ArrayLike, load: Optional[ArrayLike] = None,
                 eccentricity_ratio: Optional[ArrayLike] = None, axes: str = "load") -> Coefficients:
    """Stiffness K = -dF/de and damping C = -dF/dv of a film, at the load [N] or at the eccentricity ratio that is given.

    In radial and tangential axes K = (-F_r', F_t/eps; -F_t', -F_r/eps)/c with ' = d/d eps along a = eps omega, and
    C = (-dF_r/db, 2 dF_r/da; -dF_t/db, 2 dF_t/da)/c, turned into x and y; closed forms, held against exact derivatives.

    omega  spin of the journal [rad/s], of either sign and not 0; the bearing is at rest
    axes   "load": x along the load on the journal, y 90 degrees counter-clockwise of it;
           "inertial": the load along -y, as `lubjoint verify --quantities coefficients` has it

    Arguments broadcast; matrices are of shape (..., 2, 2). ValueError as of equilibrium, and unless one of load and
    eccentricity_ratio is given.

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
    c u + (omega_J + omega_B)/2 e_perp. Half films have no velocity for some forces and two for others (status).

    All broadcast. ValueError for butenschoen, which has no inverse, and for rows with e/c >= 1 or no finite force.

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.0098, clearance=2e-4)
    >>> u = mobility("short_dynamic", bearing, 0.5, 0, [-40, 40], 0)
    >>> print(u.status[0], f"{u.ux[0]:.10f}", f"{u.ux[1]:.10f}")
    found 0.6996203562 -11.4320577345
    """
    batch = _Batch([ex_over_c, ey_over_c, fx, fy], None)
    block, outputs = _rows(batch.count, 4)
    status = numpy.empty(batch.count, dtype=numpy.intc)
    _check(_library.lubjoint_film_mobility(law.encode(), bearing._struct(), batch.count, *batch.inputs,
                                           _Mobility(*outputs, status.ctypes.data)))
    rows = [batch.shaped(row) for row in block]
    names = _mobility_status[status]
    return Mobility(rows[0], rows[1], names.reshape(batch.shape) if batch.shape else str(names[0]), rows[2], rows[3])
