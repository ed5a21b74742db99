"""Is a Python function of a film right, and if not, what is its mistake?"""

from __future__ import annotations

import ctypes
import json
import os
from typing import Any, Callable, Iterable, Mapping, Optional, Union

import numpy
from numpy.typing import NDArray

_library = ctypes.CDLL(os.path.join(os.path.dirname(__file__), "liblubjoint_verify_c.so"))
_name = ctypes.c_char_p
_size = ctypes.c_size_t


class _Request(ctypes.Structure):
    _fields_ = [("quantities", _name), ("law", _name), ("onset", _name), ("golden", _name), ("random", _size), ("seed", ctypes.c_uint64),
                ("only", _name), ("steady", ctypes.c_int), ("shear", _name), ("at_most", _size)]


_request = ctypes.POINTER(_Request)
_library.lubjoint_verify_message.restype = _name
_library.lubjoint_verify_state_columns.restype = _name
_library.lubjoint_verify_state_columns.argtypes = [_name]
_library.lubjoint_verify_answer_columns.restype = _name
_library.lubjoint_verify_answer_columns.argtypes = [_name]
_library.lubjoint_verify_count.argtypes = [_request, ctypes.POINTER(_size)]
_library.lubjoint_verify_states.argtypes = [_request, ctypes.c_void_p]
_library.lubjoint_verify_judge.argtypes = [_request, ctypes.c_void_p, ctypes.c_double, ctypes.c_double,
                                           ctypes.POINTER(ctypes.c_int),
                                           ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(ctypes.c_void_p)]
_library.lubjoint_verify_free.argtypes = [ctypes.c_void_p]


def _check(status):
    if status != 0:
        raise ValueError(_library.lubjoint_verify_message().decode())


Domain = Union[str, Iterable[str], None]


def _asked(quantities, law, onset, random, seed, domain, steady, shear, at_most):
    golden = os.path.join(os.path.dirname(__file__), "golden")
    if law.startswith("finite_"):  # whose states are always the same
        for name, given in (("random", random), ("seed", seed)):
            if given is not None:
                raise ValueError(f"{name} does nothing with law {law}; allowed without it")
    if domain is not None and not isinstance(domain, str):
        domain = ", ".join(domain)
    if at_most is not None and at_most < 1:
        raise ValueError(f"at_most is {at_most}; allowed is a number from 1 on")
    for name, given in (("random", random), ("seed", seed)):
        if given is not None and given < 0:
            raise ValueError(f"{name} is {given}; allowed is a number from 0 on")

    def text(given):
        return given.encode() if given else None

    return _Request(quantities.encode(), law.encode(), text(onset), os.fsencode(golden),
                    1000 if random is None else random, 1 if seed is None else seed, text(domain), bool(steady),
                    text(shear), at_most or 0)


def _columns(function, quantities):
    names = function(quantities.encode())
    if names is None:
        raise ValueError(_library.lubjoint_verify_message().decode())
    return names.decode().split(",")


class Report(dict):
    """The report as a dictionary (keys as in `lubjoint verify --json`); true if the function is right, to the tolerance
    that was given; prints as text. What is asked for most is there by name, too."""

    def __init__(self, content, text):
        super().__init__(content)
        self.text = text

    def __bool__(self) -> bool:
        return self["accepted"]

    def __str__(self) -> str:
        return self.text

    @property
    def verdict(self) -> str:
        """ "agrees", "agrees_to_digits", "disagrees" or "undecided"."""
        return self["verdict"]

    @property
    def digits(self) -> Optional[float]:
        """Digits that 99 % of the decided states have, films thinner than a tenth of the clearance aside."""
        return self["digits"]

    @property
    def terms(self) -> list[dict[str, Any]]:
        """Of a force: its components, each in one kind of motion, with verdict, factor and exponents."""
        return self["terms"]

    @property
    def columns(self) -> list[dict[str, Any]]:
        """Of coefficients, equilibrium and losses: each column with verdict, factor, or the column that it is; of others
        none."""
        return self["columns"]

    @property
    def suspects(self) -> list[dict[str, Any]]:
        """Sets of known mistakes, the first being the one to look at."""
        return self["suspects"]

    @property
    def right_where(self) -> list[list[str]]:
        """Where the function is right: any of several lists of conditions; empty if nowhere or everywhere."""
        return self["right_where"]

    def _repr_pretty_(self, printer, cycle):  # notebooks
        printer.text(self.text)


def states(quantities: str = "cartesian", random: Optional[int] = None, seed: Optional[int] = None,
           domain: Domain = None, steady: bool = False, shear: Optional[str] = None, at_most: Optional[int] = None,
           law: str = "auto", onset: Optional[str] = None) -> dict[str, NDArray[numpy.float64]]:
    """The states that functions are asked about, as a dictionary of arrays: the golden ones, designed ones, random ones;
    of a film of finite length (law="finite_...") 120 of its own, or 56 loads. Arguments as of verify(). SI units; one array a column,
    all of shape (states,). Source: the golden ones are those of data/golden. ValueError for unknown quantities, a domain
    that can't be read or holds no state, and an argument without effect.

    >>> list(states("coefficients", random=0))
    ['viscosity', 'length', 'radius', 'clearance', 'omega', 'load']
    """
    names = _columns(_library.lubjoint_verify_state_columns, quantities)
    asked = _asked(quantities, law, onset, random, seed, domain, steady, shear, at_most)
    count = _size()
    _check(_library.lubjoint_verify_count(asked, count))
    table = numpy.empty((len(names), count.value))
    _check(_library.lubjoint_verify_states(asked, table.ctypes.data))
    return dict(zip(names, table))


def _named(answers, names):
    """A dictionary of some columns as all of them; those that are not given are NaN."""
    unknown = [name for name in answers if name not in names]
    if unknown or not answers:
        raise ValueError(f"the function gave the columns {list(answers)}; allowed are any of {', '.join(names)}")
    return [answers.get(name, numpy.nan) for name in names]


def _answers(function, given, names, vectorized):
    count = len(next(iter(given.values())))

    def listed(answers):
        return _named(answers, names) if isinstance(answers, Mapping) else answers

    def row_by_row():
        rows = (function(**{name: float(column[i]) for name, column in given.items()}) for i in range(count))
        return zip(*(listed(row) for row in rows))

    if vectorized:
        try:
            answers = listed(function(**given))
        except (TypeError, ValueError):  # what math.sqrt, float() and `if` make of an array
            answers = list(row_by_row())  # where that fails, too, both errors are shown
    else:
        answers = row_by_row()
    columns = [numpy.asarray(column) for column in answers]
    if len(columns) != len(names):
        raise ValueError(f"the function gave {len(columns)} arrays; required are {len(names)}: {', '.join(names)}")
    for name, column in zip(names, columns):
        if column.shape not in ((count,), ()):
            raise ValueError(f"{name} is of shape {column.shape}; required is ({count},), one number a state")
    return numpy.array([numpy.broadcast_to(column, count) for column in columns], dtype=numpy.float64)


def verify(function: Callable[..., Any], law: str = "auto", quantities: str = "cartesian",
           random: Optional[int] = None, seed: Optional[int] = None, vectorized: bool = True, domain: Domain = None,
           steady: bool = False, tolerance: float = 0.0, unit: float = 1.0, shear: Optional[str] = None,
           at_most: Optional[int] = None, onset: Optional[str] = None) -> Report:
    """Compares a function with a film law, and names its likely mistake if it disagrees.

    function   called with keyword arguments named as the states' columns (see states()), one array each; gives the
               columns of the answer, e.g. (fx, fy): the force on the journal; for coefficients, equilibrium and losses
               also a dictionary of any of them. One that fails with arrays, as math.sqrt does, is called with the
               numbers of one state at a time, which takes longer; vectorized=False does so from the start
    law        a name of laws(), or "auto": find out which; of "contact" lankarani_nikravesh, hunt_crossley, flores or
               gonthier. finite_full, finite_half, finite_dynamic and finite_reynolds are judged by the solver of Reynolds'
               equation, with the bound that it states; they are not among those that "auto" looks at
    quantities "cartesian", "polar", "wrench", "transition", "extent", "pressure", "dimensionless", "coefficients",
               "equilibrium", "losses" or "contact"; of a film of finite length any but "dimensionless" and "contact",
               and "extent" not of finite_reynolds
    random     random states beside the golden and the designed ones, by default 1000
    seed       of the random states, by default 1
    domain     what the function is meant for: "omega_sum > 0, eccentricity_ratio > 0" or a list of such conditions
    steady     steady rotation in a bearing at rest alone
    tolerance  error over the answer's size that is right for a numerical function; 0: that of rounding, of a film of
               finite length 1e-3
    unit       of forces without dimensions, over S omega; Capone's is 0.25
    shear      of losses: the part of the gap that shears
    at_most    states in all, chosen to cover the regimes, for a slow function
    onset      of finite_reynolds: where the film begins in a steady wedge, "free" (default) or "maximum_film"

    States and answers are in SI units. ValueError for an unknown law or quantities, an argument without effect, or answers
    of another shape. A state is right where |answer - right| <= what the rounding of its inputs does to the right answer,
    or tolerance times its size. Source: oracle/verify/README.md says what a verdict rests on.

    >>> import lubjoint
    >>> def place(viscosity, length, radius, clearance, omega, load):
    ...     bearing = lubjoint.Bearing(viscosity, length, 2 * radius, clearance)  # the diameter
    ...     rest = lubjoint.equilibrium("long_full", bearing, load, omega)
    ...     return {"eccentricity_ratio": rest.eccentricity_ratio}
    >>> report = verify(place, "long_full", "equilibrium", random=20, vectorized=False)
    >>> bool(report), report.suspects[0]["mistakes"], [c["verdict"] for c in report.columns]
    (False, ['diameter_for_radius'], ['wrong'])
    >>> def half_of_the_squeeze(viscosity, length, radius, clearance, eccentricity_ratio, squeeze_rate, omega,
    ...                         attitude_rate):
    ...     bearing = lubjoint.Bearing(viscosity, length, radius, clearance)
    ...     slip_rate = eccentricity_ratio * (omega - 2 * attitude_rate)
    ...     solved = lubjoint.oracle_force("finite_full", bearing, eccentricity_ratio, slip_rate, squeeze_rate / 2)
    ...     return solved.radial, solved.tangential
    >>> report = verify(half_of_the_squeeze, "finite_full", "polar", vectorized=False)
    >>> report.verdict, report.suspects[0]["mistakes"]
    ('disagrees', ['squeeze_rate_halved'])
    """
    names = _columns(_library.lubjoint_verify_answer_columns, quantities)
    given = states(quantities, random, seed, domain, steady, shear, at_most, law, onset)
    answers = _answers(function, given, names, vectorized)
    verdict = ctypes.c_int()
    text = ctypes.c_void_p()
    content = ctypes.c_void_p()
    asked = _asked(quantities, law, onset, random, seed, domain, steady, shear, at_most)
    _check(_library.lubjoint_verify_judge(asked, answers.ctypes.data, tolerance, unit, verdict, text, content))
    try:
        return Report(json.loads(ctypes.string_at(content)), ctypes.string_at(text).decode())
    finally:
        _library.lubjoint_verify_free(text)
        _library.lubjoint_verify_free(content)
