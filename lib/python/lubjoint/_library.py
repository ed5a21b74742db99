"""The C interface: its structures, its errors, and arrays as it takes them."""

from __future__ import annotations

import ctypes
import errno
import math
import os
import sys
import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Union

import numpy
from numpy.typing import NDArray

Number = Union[float, NDArray[numpy.float64]]
"""A float where all arguments are numbers, an array of their common shape otherwise."""

folder = os.path.dirname(__file__)
library = ctypes.CDLL(os.path.join(folder, "liblubjoint_c.so"))


class Array(ctypes.Structure):
    """lubjoint_in and lubjoint_out."""

    _fields_ = [("data", ctypes.c_void_p), ("stride", ctypes.c_ssize_t)]


class BearingStruct(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("viscosity", "length", "radius", "clearance")]


class ContactStruct(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("e0", "e1", "stiffness", "restitution", "impact_speed")]


class MotionStruct(ctypes.Structure):
    _fields_ = [(name, Array) for name in ("ex", "ey", "vx", "vy", "omega_bearing", "omega_journal")]


class JacobianStruct(ctypes.Structure):
    _fields_ = [("fx", Array), ("fy", Array), ("by_place", 4 * Array), ("by_velocity", 4 * Array)]


class LossesStruct(ctypes.Structure):
    _fields_ = [(name, Array) for name in ("torque_journal", "torque_bearing", "power", "side_flow")]


class CoefficientsStruct(ctypes.Structure):
    _fields_ = [("load", Array), ("attitude", Array), ("stiffness", 4 * Array), ("damping", 4 * Array),
                ("critical_mass", Array)]


class MobilityStruct(ctypes.Structure):
    _fields_ = [(name, Array) for name in ("ux", "uy", "other_ux", "other_uy")] + [("status", ctypes.c_void_p)]


class FilmStruct(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("length_to_diameter", "ratio_limit", "error")]


def _declare():
    name, size, pointer = ctypes.c_char_p, ctypes.c_size_t, ctypes.POINTER
    bearing, motion, address = pointer(BearingStruct), pointer(MotionStruct), ctypes.c_void_p
    arguments = {
        "law_name": [size],
        "use_film": [name],
        "film_of": [name, bearing, pointer(FilmStruct)],
        "polar_force": [name, bearing, size] + 5 * [Array],
        "journal_force": [name, bearing, size, motion, Array, Array],
        "polar_force_gapless": [name, address, size] + 5 * [address],
        "journal_force_gapless": [name, address, size] + 8 * [address],
        "force_jacobian": [name, bearing, size, motion, pointer(JacobianStruct)],
        "transition_force": [name, bearing, pointer(ContactStruct), size, motion, Array, Array],
        "film_losses": [name, bearing, name, size, motion, pointer(LossesStruct)],
        "film_coefficients": [name, bearing, size, Array, Array, pointer(CoefficientsStruct)],
        "film_equilibrium": [name, bearing, size] + 4 * [Array],
        "film_mobility": [name, bearing, size] + 4 * [Array] + [pointer(MobilityStruct)],
        "joint_moments": [size] + 10 * [Array],
    }
    for function, types in arguments.items():
        getattr(library, f"lubjoint_{function}").argtypes = types
    for function in ("message", "version", "law_name"):
        getattr(library, f"lubjoint_{function}").restype = name


_declare()


@dataclass(frozen=True)
class Bearing:
    """Bearing and oil: dynamic viscosity [Pa s], length, journal radius and radial clearance [m]."""

    viscosity: float
    length: float
    radius: float
    clearance: float

    @cached_property
    def _struct(self) -> BearingStruct:
        return BearingStruct(self.viscosity, self.length, self.radius, self.clearance)

    @cached_property
    def _address(self) -> int:
        return ctypes.addressof(self._struct)

    def __getstate__(self) -> tuple[float, ...]:
        return self.viscosity, self.length, self.radius, self.clearance

    def __setstate__(self, state: tuple[float, ...]) -> None:
        self.__dict__.update(zip(("viscosity", "length", "radius", "clearance"), state))


@dataclass(frozen=True)
class Contact:
    """Dry contact and the transition to it: 0 < e0 < e1 [m], stiffness [N/m^1.5], restitution in [0, 1], the speed at
    which the journal last crossed e = c outwards [m/s]."""

    e0: float
    e1: float
    stiffness: float
    restitution: float
    impact_speed: float

    def _struct(self) -> ContactStruct:
        return ContactStruct(self.e0, self.e1, self.stiffness, self.restitution, self.impact_speed)


def warn(message: str) -> None:
    """Warns at the line outside of this package that has called it, through however many functions."""
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == folder:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


def show_compiling(law: str, done: int, everything: int) -> None:
    """Progress on a terminal: a table that is not at hand takes a minute or two."""
    print(f"\rcompiling {law}: {done} of {everything}", end="\n" if done == everything else "", file=sys.stderr, flush=True)


def error_of(status: int, message: bytes) -> Exception:
    """What an error number stands for."""
    return {errno.ENOMEM: MemoryError, errno.ERANGE: OverflowError}.get(status, ValueError)(message.decode())


def check(status: int) -> None:
    """Raises what an error number stands for, with the message."""
    if status:
        raise error_of(status, library.lubjoint_message())


def call(function: Any, law: str, bearing: Bearing, *arguments: Any) -> None:
    """Calls a function of a law in a bearing; a table that it lacks is found, or compiled, and given to it."""
    status = function(law.encode(), bearing._struct, *arguments)
    if status == errno.ENOENT:
        from . import _oracle

        _oracle.provide(law, bearing)
        status = function(law.encode(), bearing._struct, *arguments)
    if status:
        check(status)


address_of = ctypes.addressof
buffer_of = ctypes.c_char.from_buffer
"""What refuses arrays that are read-only, with gaps, or empty; the two together take a third of array.ctypes.data."""
no_buffer = (AttributeError, TypeError, ValueError)
float64 = numpy.dtype(numpy.float64)


def _address(array):
    try:
        return address_of(buffer_of(array))
    except no_buffer:
        return array.ctypes.data


class Batch:
    """Arrays of one shape, and the places where the answers go: rows of one block, or the caller's own arrays."""

    __slots__ = ("shape", "count", "inputs", "outputs", "_arrays", "_rows")

    def __init__(self, inputs, out=None, width=2):
        arrays = [numpy.asarray(x, numpy.float64) for x in inputs]
        shape = arrays[0].shape
        for a in arrays:
            if a.shape != shape:
                shape = numpy.broadcast_shapes(*[a.shape for a in arrays])
                break
        self.shape = shape
        self.count = count = shape[0] if len(shape) == 1 else math.prod(shape)
        if len(shape) > 1:  # row after row; what has as many numbers and no gaps is read where it is
            arrays = [a.reshape(()) if a.size == 1 else numpy.broadcast_to(a, shape).reshape(-1) for a in arrays]
        self._arrays = arrays  # read until the call is over
        flat = (count,)  # stride 0 for one number that goes with all rows
        self.inputs = [Array(_address(a), a.strides[0] if a.shape == flat else 0) for a in arrays]
        if out is None:
            self._rows = block = numpy.empty((width, count))
            first = _address(block)
            self.outputs = [Array(first + 8 * count * k, 8) for k in range(width)]
        else:
            self._rows = self._given(out)
            self.outputs = [Array(_address(a), a.strides[0]) for a in self._rows]

    def _given(self, out):
        """The caller's arrays as one row each, which must be views."""
        shape = self.shape or (1,)
        gaps_go = len(shape) == 1
        for array in out:
            if array.dtype != numpy.float64 or array.shape != shape or not array.flags.writeable or \
                    not (gaps_go or array.flags.c_contiguous):
                raise ValueError(f"out is of shape {array.shape} and type {array.dtype}; required are writeable "
                                 f"float64 arrays of shape {shape}" + ("" if gaps_go else " without gaps"))
        return out if gaps_go else tuple(array.reshape(-1) for array in out)

    def answers(self):
        """All rows of answers in the shape of the arguments."""
        return tuple([self.shaped(row) for row in self._rows])

    def shaped(self, row):
        """A row of answers in the shape of the arguments."""
        if not self.shape:
            return float(row[0])
        return row if len(self.shape) == 1 else row.reshape(self.shape)

    def matrices(self, first):
        """Four rows of answers as matrices of shape (..., 2, 2)."""
        return self._rows[first:first + 4].T.reshape(self.shape + (2, 2))


def broadcast(x, batch):
    """An argument in the common shape."""
    full = numpy.broadcast_to(numpy.asarray(x, dtype=numpy.float64), batch.shape)
    return full if batch.shape else float(full)
