"""Is a Python function of a film force right, and if not, what is its mistake?"""

import ctypes
import json
import os

import numpy

_library = ctypes.CDLL(os.path.join(os.path.dirname(__file__), "liblubjoint_verify_c.so"))
_name = ctypes.c_char_p
_size = ctypes.c_size_t


class _Request(ctypes.Structure):
    _fields_ = [("quantities", _name), ("golden", _name), ("random", _size), ("seed", ctypes.c_uint64)]


_request = ctypes.POINTER(_Request)
_library.lubjoint_verify_message.restype = _name
_library.lubjoint_verify_state_columns.restype = _name
_library.lubjoint_verify_state_columns.argtypes = [_name]
_library.lubjoint_verify_answer_columns.restype = _name
_library.lubjoint_verify_answer_columns.argtypes = [_name]
_library.lubjoint_verify_count.argtypes = [_request, ctypes.POINTER(_size)]
_library.lubjoint_verify_states.argtypes = [_request, ctypes.c_void_p]
_library.lubjoint_verify_judge.argtypes = [_name, _request, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int),
                                           ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(ctypes.c_void_p)]
_library.lubjoint_verify_free.argtypes = [ctypes.c_void_p]


def _check(status):
    if status != 0:
        raise ValueError(_library.lubjoint_verify_message().decode())


def _asked(quantities, random, seed):
    golden = os.path.join(os.path.dirname(__file__), "golden")
    return _Request(quantities.encode(), os.fsencode(golden), random, seed)


def _columns(function, quantities):
    names = function(quantities.encode())
    if names is None:
        raise ValueError(_library.lubjoint_verify_message().decode())
    return names.decode().split(",")


class Report(dict):
    """The report as a dictionary (keys as in `lubjoint verify --json`); true if the function agrees; prints as text."""

    def __init__(self, content, text):
        super().__init__(content)
        self.text = text

    def __bool__(self):
        return self["verdict"] == "agrees"

    def __str__(self):
        return self.text

    def _repr_pretty_(self, printer, cycle):  # notebooks
        printer.text(self.text)


def states(quantities="cartesian", random=1000, seed=1):
    """The states that functions are asked about, as a dictionary of arrays: the golden ones, designed ones, random ones."""
    names = _columns(_library.lubjoint_verify_state_columns, quantities)
    asked = _asked(quantities, random, seed)
    count = _size()
    _check(_library.lubjoint_verify_count(asked, count))
    table = numpy.empty((len(names), count.value))
    _check(_library.lubjoint_verify_states(asked, table.ctypes.data))
    return dict(zip(names, table))


def _answers(function, given, names, vectorized):
    count = len(next(iter(given.values())))

    def row_by_row():
        return zip(*(function(**{name: float(column[i]) for name, column in given.items()}) for i in range(count)))

    if vectorized:
        try:
            answers = function(**given)
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


def verify(function, law="auto", quantities="cartesian", random=1000, seed=1, vectorized=True):
    """Compares a function with a film law, and names its likely mistake if it disagrees.

    function   called with keyword arguments named as the states' columns (see states()), one array each; gives the
               columns of the answer, e.g. (fx, fy): the force on the journal. One that fails with arrays, as math.sqrt
               does, is called with the numbers of one state at a time, which takes longer; vectorized=False does so
               from the start
    law        a name of laws(), or "auto": find out which
    """
    names = _columns(_library.lubjoint_verify_answer_columns, quantities)
    answers = _answers(function, states(quantities, random, seed), names, vectorized)
    verdict = ctypes.c_int()
    text = ctypes.c_void_p()
    content = ctypes.c_void_p()
    _check(_library.lubjoint_verify_judge(law.encode(), _asked(quantities, random, seed), answers.ctypes.data, verdict,
                                          text, content))
    try:
        return Report(json.loads(ctypes.string_at(content)), ctypes.string_at(text).decode())
    finally:
        _library.lubjoint_verify_free(text)
        _library.lubjoint_verify_free(content)
