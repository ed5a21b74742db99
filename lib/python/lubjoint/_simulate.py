"""Runs of scene files, through the C interface."""

from __future__ import annotations

import ctypes
import json
import os
import sys
from collections.abc import Iterator, Mapping
from functools import lru_cache, partial
from typing import Any, Optional, Union

import numpy
from numpy.typing import NDArray

from ._library import error_of, folder, show_compiling, warn

_progress = ctypes.CFUNCTYPE(None, ctypes.c_size_t, ctypes.c_size_t)
_number = ctypes.POINTER(ctypes.c_double)


class _Request(ctypes.Structure):
    _fields_ = ([(name, ctypes.c_char_p) for name in ("file", "text", "law", "integrator")] +
                [(name, _number) for name in ("rtol", "duration", "after")] +
                [("films", ctypes.c_char_p), ("progress", _progress), ("last_revolution", ctypes.c_int)])


@lru_cache(maxsize=None)
def _library():
    """The library of the runs, loaded at the first of them."""
    runs = ctypes.CDLL(os.path.join(folder, "liblubjoint_simulate_c.so"))
    run, size, text = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_char_p
    for name, result, arguments in (("simulate_message", text, []),
                                    ("simulate", ctypes.c_int, [ctypes.POINTER(_Request), ctypes.POINTER(run)]),
                                    ("simulation_rows", size, [run]), ("simulation_columns", size, [run]),
                                    ("simulation_column", text, [run, size]),
                                    ("simulation_values", None, [run, ctypes.c_void_p]),
                                    ("simulation_summary", text, [run]),
                                    ("simulation_warning", text, [run, size]), ("simulation_free", None, [run])):
        function = getattr(runs, f"lubjoint_{name}")
        function.restype, function.argtypes = result, arguments
    return runs


def _listed(function, run):
    texts = []
    while (text := function(run, len(texts))) is not None:
        texts.append(text.decode())
    return texts


class Run(Mapping[str, NDArray[numpy.float64]]):
    """What a run leaves: the columns of its trajectory by name, in the order and with the names of the CSV that
    `lubjoint simulate --out` writes, and its summary.

    run["crank.phi"] is an array over the output times run.t; list(run) are the names. SI units, angles in radians, forces
    those on the journal. NaN stands where the CSV has an empty field, for what is not defined there (the friction of oil
    in a dry contact), and nowhere else."""

    def __init__(self, names: list[str], values: NDArray[numpy.float64], summary: dict[str, Any]) -> None:
        self._places = {name: i for i, name in enumerate(names)}
        self.values_by_column: NDArray[numpy.float64] = values
        """All of the trajectory, of shape (columns, rows)."""
        self.summary: dict[str, Any] = summary
        """The summary, keys as of `lubjoint simulate --json`."""

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        return self.values_by_column[self._places[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __repr__(self) -> str:
        return (f"<Run of {self.summary['scene']}: {self.summary['status']} at {self.summary['t_end']:g} s, "
                f"{len(self.t)} rows of {len(self)} columns>")

    @property
    def t(self) -> NDArray[numpy.float64]:
        """Times [s]."""
        return self["t"]

    @property
    def finished(self) -> bool:
        """Did the run get to its end? If not, summary["message"] says why."""
        return self.summary["status"] == "finished"


def _pointer(number):
    return None if number is None else ctypes.pointer(ctypes.c_double(number))


def _bytes(name, text, encode=str.encode):
    if text is None:
        return None
    encoded = encode(text)
    if b"\0" in encoded:
        raise ValueError(f"{name} has a NUL character; allowed is text without one")
    return encoded


def simulate(scene: Union[str, os.PathLike[str], None] = None, *, text: Optional[str] = None, law: Optional[str] = None,
             integrator: Optional[str] = None, rtol: Optional[float] = None, duration: Optional[float] = None,
             after: Optional[float] = None, last_revolution: bool = False) -> Run:
    """Runs a scene: a journal in its bearing or a mechanism, in the plane or (dimension = 3) in space.

    M dv/dt = forces of films, contacts, springs and gravity, with the constraints' reactions by Lagrange multipliers; a
    free journal: m dv/dt = F_film + load. Source: Flores et al. (2009), sections 2 to 6. data/scenes.md lists a scene's
    keys. The arrays of a run are of shape (rows,), one number an output time, in SI units.

    scene       path of a scene file (TOML), or
    text        a scene's text in place of a file
    law         film law of all joints that have a film, a name of laws(); as the scene says, if left out; likewise
    integrator  radau_iia5, radau_iia9, rosenbrock4, dopri5, fehlberg78, bulirsch_stoer, adams_bashforth_moulton
                or auto
    rtol        relative tolerance, 1e-14 to below 1; also the absolute one, in clearances
    duration    [s]
    after       extremes from this time on, too [s], in the key "after" of the summary's joints and drivers; in the plane
    last_revolution  the same of the last revolution of the scene's driver, or of its journal

    The numbers are those of `lubjoint simulate`, bit for bit. What that warns of is warned of here. A run that stops
    before its end is returned, with Run.finished false. ValueError, with the message of the command, for a scene that
    can't be used (it names the line and key) and for a setting that is not allowed; after and last_revolution together
    are not. Error: that of the tolerance, at each step; a film's law or table has its own.

    >>> run = simulate(text='''
    ... name = "journal"
    ... duration = 0.02
    ... gravity = [0.0, -9.81]
    ... [[bodies]]
    ... name = "journal"
    ... mass = 2.0
    ... inertia = 1e-3
    ... position = [1e-5, 0.0]
    ... velocity = [0.0, 0.0]
    ... spin = 100.0
    ... [[joints]]
    ... name = "bearing"
    ... film = "short_dynamic"
    ... viscosity = 0.05
    ... length = 0.02
    ... journal_radius = 0.01
    ... clearance = 1e-4
    ... bearing = {body = "ground", point = [0.0, 0.0]}
    ... journal = {body = "journal", point = [0.0, 0.0]}
    ... [integrator]
    ... name = "radau_iia5"
    ... relative_tolerance = 1e-8
    ... absolute_tolerance = 1e-8
    ... [output]
    ... interval = 0.01
    ... ''')
    >>> run.finished, run.t.shape, "bearing.eccentricity_ratio" in run
    (True, (3,), True)
    """
    if (scene is None) == (text is None):
        raise ValueError("required is one of scene and text")
    on_terminal = sys.stderr is not None and sys.stderr.isatty()
    progress = _progress(partial(show_compiling, "the table of a film")) if on_terminal else _progress()
    numbers = [_pointer(number) for number in (rtol, duration, after)]
    request = _Request(_bytes("scene", scene, os.fsencode), _bytes("text", text), _bytes("law", law),
                       _bytes("integrator", integrator), *numbers, os.fsencode(os.path.join(folder, "films")), progress,
                       bool(last_revolution))
    runs = _library()
    run = ctypes.c_void_p()
    status = runs.lubjoint_simulate(request, run)
    if status:
        raise error_of(status, runs.lubjoint_simulate_message())
    try:
        values = numpy.empty((runs.lubjoint_simulation_columns(run), runs.lubjoint_simulation_rows(run)))
        runs.lubjoint_simulation_values(run, values.ctypes.data)
        summary = json.loads(runs.lubjoint_simulation_summary(run))
        warnings = _listed(runs.lubjoint_simulation_warning, run)
        names = _listed(runs.lubjoint_simulation_column, run)
    finally:
        runs.lubjoint_simulation_free(run)
    for warning in warnings:
        warn(warning.removeprefix("warning: "))
    return Run(names, values, summary)
