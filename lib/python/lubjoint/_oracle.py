"""Forces that come from no law: the solvers and integrals that laws are held against, and the tables of the compiled
laws."""

from __future__ import annotations

import ctypes
import os
import sys
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Optional

import numpy
from numpy.typing import ArrayLike

from ._library import (Batch, Bearing, FilmStruct, Number, call, check, error_of, folder, library, show_compiling, warn)

_progress = ctypes.CFUNCTYPE(None, ctypes.c_size_t, ctypes.c_size_t)


@lru_cache(maxsize=None)
def _solvers():
    """The library of the solvers, loaded at the first call that needs one."""
    solvers = ctypes.CDLL(os.path.join(folder, "liblubjoint_oracle_c.so"))
    name, array = ctypes.c_char_p, ctypes.c_void_p
    solvers.lubjoint_oracle_message.restype = name
    solvers.lubjoint_oracle_film.argtypes = [name, ctypes.c_double, name, _progress, ctypes.POINTER(ctypes.c_void_p),
                                             ctypes.POINTER(ctypes.c_void_p)]
    solvers.lubjoint_oracle_free.argtypes = [ctypes.c_void_p]
    solvers.lubjoint_oracle_force.argtypes = [name, 4 * ctypes.c_double, name, ctypes.c_double,
                                              ctypes.c_size_t] + 7 * [array]
    return solvers


def _solved(status):
    if status:
        raise error_of(status, _solvers().lubjoint_oracle_message())


def provide(law: str, bearing: Bearing) -> None:
    """Gives the library the table of a compiled law for a bearing: one of the package's, of the user's cache
    (XDG_CACHE_HOME, else ~/.cache), or compiled now and kept there."""
    shape = bearing.length / (2 * bearing.radius)
    on_terminal = sys.stderr is not None and sys.stderr.isatty()
    progress = _progress(partial(show_compiling, f"{law}, L/D {shape:.6g}")) if on_terminal else _progress()
    text, notes = ctypes.c_void_p(), ctypes.c_void_p()
    solvers = _solvers()
    _solved(solvers.lubjoint_oracle_film(law.encode(), shape, os.fsencode(os.path.join(folder, "films")), progress,
                                         text, notes))
    try:
        for note in ctypes.string_at(notes).decode().splitlines():
            warn(note)
        check(library.lubjoint_use_film(ctypes.string_at(text)))
    finally:
        solvers.lubjoint_oracle_free(text)
        solvers.lubjoint_oracle_free(notes)


@dataclass(frozen=True)
class FilmTable:
    """What the table of a compiled law says of itself: the bearing's L/D, the eccentricity ratio up to which its error
    was measured, and a bound of |F - F_solved|/|F| there."""

    law: str
    length_to_diameter: float
    ratio_limit: float
    error: float


def film_table(law: str, bearing: Bearing) -> FilmTable:
    """The table that answers for a compiled law in a bearing; where there is none yet it is compiled.

    law  finite_full, finite_half, finite_dynamic or finite_reynolds; L/D = length/(2 radius) from 0.05 to 10

    Its numbers are those of one bearing and without a unit; error = the bound of |F - F_solved|/|F|. Source: the solvers
    of oracle_force, at the table's places and, for its error, between them.

    Tables for L/D 1/4, 1/2, 1 and 2.04 ship. Others are made by the solvers of Reynolds' equation at the first call, on
    all cores (finite_reynolds takes a minute or two, the others seconds), and kept in the user's cache. The error is
    measured against a solver of another family, or a finer one, at states off the table's places. ValueError for a law
    that is no table and for another L/D.

    >>> table = film_table("finite_reynolds", Bearing(viscosity=0.4, length=0.04, radius=0.04, clearance=2e-4))
    >>> table.length_to_diameter, table.ratio_limit, table.error < 1e-3
    (0.5, 0.95, True)
    """
    said = FilmStruct()
    call(library.lubjoint_film_of, law, bearing, said)
    return FilmTable(law, said.length_to_diameter, said.ratio_limit, said.error)


_warned: set[tuple[str, float]] = set()


def warn_beyond(law: str, bearing: Bearing, *place: ArrayLike) -> None:
    """Warns once of each table that a state lies beyond what its error was measured at; place: ratios, or ex and ey."""
    if not law.startswith("finite_"):
        return
    farthest = float(numpy.max(place[0] if len(place) == 1 else numpy.hypot(*place) / bearing.clearance, initial=0))
    table = film_table(law, bearing)
    if farthest <= table.ratio_limit or (law, table.length_to_diameter) in _warned:
        return
    _warned.add((law, table.length_to_diameter))
    warn(f"the error of {law}, {table.error:.1e} of |F|, was measured up to eccentricity ratio {table.ratio_limit:g}, and "
         f"is not known at {farthest:g}")


@dataclass(frozen=True)
class SolvedForce:
    """A force that comes from no law, radial and tangential [N], with estimated bounds of its errors [N]."""

    radial: Number
    tangential: Number
    radial_error: Number
    tangential_error: Number


def oracle_force(film: str, bearing: Bearing, eccentricity_ratio: ArrayLike, slip_rate: ArrayLike,
                 squeeze_rate: ArrayLike, onset: Optional[str] = None, tolerance: Optional[float] = None) -> SolvedForce:
    """Force of a film on the journal [N] without any force law, and no table is asked: films of finite length by solving
    Reynolds' equation, the limits of short and long bearings by integrating their pressure. Source: Reynolds (1886); for
    the limits Flores et al. (2009), eqs. 3 and 5.

    finite_*: (1/R^2) d/dtheta(H^3 dp/dtheta) + H^3 d2p/dz2 = -(6 mu/c^2)(a sin theta - 2b cos theta), H = 1 + eps cos
    theta, p = 0 at |z| = L/2; F = R double integral of p (cos theta, sin theta).
    short_*: p = 3 mu/(c^2 H^3) (L^2/4 - z^2)(a sin theta - 2b cos theta) (Flores et al. 2009, eq. 3).
    long_full, long_half_eq5: p of eq. 5. long_half, long_dynamic: the equation above without its second term, p = 0 at
    both ends of the film.

    film       finite_full (periodic, negative pressure kept), finite_half (p = 0 at theta = 0 and pi, mirrored for a < 0),
               finite_dynamic (p = 0 at atan2(2b, a) and pi further) or finite_reynolds (p >= 0, p = dp/dn = 0 where the
               film ruptures and reforms: Swift and Stieber); short_full, short_half, short_dynamic, long_full, long_half,
               long_half_eq5 or long_dynamic, integrated over the same extents
    eccentricity_ratio, slip_rate, squeeze_rate  as of polar_force, [-] and [1/s]; they broadcast, and all four answers
               have their common shape
    onset      where the film of finite_reynolds starts: "free" (default), or "maximum_film" in a steady wedge
    tolerance  of the error over |F|: 1e-12 to 0.1, by default 1e-3; of the integrals 1e-15 to 0.1, by default 1e-13

    The errors are bounds that the solvers state, also where they don't reach the tolerance: finite_reynolds, meant for
    eps up to 0.99, to about 1e-5; the other solutions to 1e-10; the integrals to a few roundings of the two terms that a
    half film's force is the sum of. A solution takes from a millisecond to seconds, an integral 3 to 15 microseconds.
    ValueError for another film, an onset without effect, a row without a film; OverflowError for a force beyond the range
    of double.

    >>> bearing = Bearing(viscosity=0.4, length=0.04, radius=0.04, clearance=2e-4)
    >>> solved = oracle_force("finite_dynamic", bearing, [0.3, 0.6], 2, 1, tolerance=1e-8)
    >>> table = film_table("finite_dynamic", bearing)
    >>> from lubjoint import polar_force
    >>> radial, tangential = polar_force("finite_dynamic", bearing, [0.3, 0.6], 2, 1)
    >>> off = numpy.hypot(radial - solved.radial, tangential - solved.tangential) / numpy.hypot(radial, tangential)
    >>> bool((off < table.error).all())
    True
    >>> integral = oracle_force("short_dynamic", bearing, 0.5, 2, 1)
    >>> law = polar_force("short_dynamic", bearing, 0.5, 2, 1)
    >>> rounding = 1e-15 * numpy.hypot(*law)  # of the law
    >>> abs(law[0] - integral.radial) <= integral.radial_error + rounding
    True
    """
    if tolerance is not None and not tolerance > 0:
        raise ValueError(f"tolerance is {tolerance}; allowed is a number above 0, to 0.1")
    batch = Batch([eccentricity_ratio, slip_rate, squeeze_rate], None, 4)
    inputs = [numpy.ascontiguousarray(numpy.broadcast_to(x, batch.shape), dtype=numpy.float64)
              for x in (eccentricity_ratio, slip_rate, squeeze_rate)]
    numbers = (4 * ctypes.c_double)(bearing.viscosity, bearing.length, bearing.radius, bearing.clearance)
    _solved(_solvers().lubjoint_oracle_force(film.encode(), numbers, None if onset is None else onset.encode(),
                                             tolerance or 0.0, batch.count, *[a.ctypes.data for a in inputs],
                                             *[to.data for to in batch.outputs]))
    return SolvedForce(*batch.answers())
