"""Films, contact and moments over NumPy arrays, through the C interface."""

import ctypes
import errno
import os
from dataclasses import dataclass

import numpy

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


def version():
    return _library.lubjoint_version().decode()


def laws():
    """Names of the film laws."""
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
        if len(self.shape) > 1:
            raise ValueError(f"arrays of shape {self.shape}; allowed are numbers and one-dimensional arrays")
        self.count = self.shape[0] if self.shape else 1
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

    def answers(self):
        return tuple(self._out) if self.shape else tuple(float(a[0]) for a in self._out)


def polar_force(law, bearing, eccentricity_ratio, slip_rate, squeeze_rate, out=None):
    """Radial and tangential force of the film on the journal [N]; slip rate a and squeeze rate b in 1/s."""
    batch = _Batch([eccentricity_ratio, slip_rate, squeeze_rate], out)
    _check(_library.lubjoint_polar_force(law.encode(), bearing._struct(), batch.count, *batch.inputs, *batch.outputs))
    return batch.answers()


def journal_force(law, bearing, ex, ey, vx, vy, omega_bearing, omega_journal, out=None):
    """Force of the film on the journal [N]: fx, fy. Motion in one inertial frame, absolute spins."""
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    _check(_library.lubjoint_journal_force(law.encode(), bearing._struct(), batch.count, _Motion(*batch.inputs),
                                           *batch.outputs))
    return batch.answers()


def transition_force(law, bearing, contact, ex, ey, vx, vy, omega_bearing, omega_journal, out=None):
    """Force on a journal that may touch the wall [N]: film, blend, dry contact."""
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], out)
    _check(_library.lubjoint_transition_force(law.encode(), bearing._struct(), contact._struct(), batch.count,
                                              _Motion(*batch.inputs), *batch.outputs))
    return batch.answers()


def joint_moments(ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy, out=None):
    """Moments [N m] about the mass centres of the bearing's and the journal's body, of a force on the journal."""
    batch = _Batch([ex, ey, sx_i, sy_i, sx_j, sy_j, fx, fy], out)
    _check(_library.lubjoint_joint_moments(batch.count, *batch.inputs, *batch.outputs))
    return batch.answers()


@dataclass(frozen=True)
class Losses:
    """What the oil costs: torques on journal and bearing about their own centres [N m], the power lost in the film [W],
    and the flow out of both sides [m^3/s], None for a long bearing, which has none."""

    torque_journal: object
    torque_bearing: object
    power: object
    side_flow: object


@dataclass(frozen=True)
class Coefficients:
    """A journal at rest on its film; x along the load on the journal, y 90 degrees counter-clockwise of it: load [N],
    attitude [rad] (from the load to e, positive in the sense of the spin), stiffness [N/m] and damping [N s/m] of shape
    (2, 2) or (n, 2, 2), critical mass of a rigid rotor per bearing [kg]: inf where every mass is stable, 0 where none is."""

    load: object
    attitude: object
    stiffness: object
    damping: object
    critical_mass: object


def _rows(count, width):
    block = numpy.empty((width, count))
    return block, [_In(row.ctypes.data, row.strides[0]) for row in block]


def film_losses(law, bearing, ex, ey, vx, vy, omega_bearing, omega_journal, shear="film"):
    """Friction torques, power and side flow; shear is "film", "flooded" or, for half films, "striated"."""
    batch = _Batch([ex, ey, vx, vy, omega_bearing, omega_journal], None)
    block, outputs = _rows(batch.count, 4)
    has_flow = law.removeprefix("squeeze_").startswith("short")
    if not has_flow:
        outputs[3] = _In(None, 0)
    _check(_library.lubjoint_film_losses(law.encode(), bearing._struct(), shear.encode(), batch.count,
                                         _Motion(*batch.inputs), _Losses(*outputs)))
    answers = list(block) if batch.shape else [float(row[0]) for row in block]
    return Losses(answers[0], answers[1], answers[2], answers[3] if has_flow else None)


def film_coefficients(law, bearing, eccentricity_ratio, omega):
    """Load, attitude, stiffness, damping and critical mass of a journal of spin omega [rad/s], of either sign and not 0,
    that rests at an eccentricity ratio above 0 and below 1 in a bearing that does not turn."""
    batch = _Batch([eccentricity_ratio, omega], None)
    block, outputs = _rows(batch.count, 11)
    struct = _Coefficients(outputs[0], outputs[1], (4 * _In)(*outputs[2:6]), (4 * _In)(*outputs[6:10]), outputs[10])
    _check(_library.lubjoint_film_coefficients(law.encode(), bearing._struct(), batch.count, *batch.inputs, struct))
    stiffness, damping = (block[first:first + 4].T.reshape(-1, 2, 2) for first in (2, 6))
    if batch.shape:
        return Coefficients(block[0], block[1], stiffness, damping, block[10])
    return Coefficients(float(block[0, 0]), float(block[1, 0]), stiffness[0], damping[0], float(block[10, 0]))
