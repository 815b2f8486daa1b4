"""The runtime's problem of friction as a function of Python."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, Structure, byref, c_double, c_int, c_size_t
from functools import cache

import numpy as np
from stepping.friction_problems import Floats, RandomProblem

from lagdsl.engines.runtime.building.platforms import library_name, this_machine
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.foundation.resources import runtime_library_folder

_DOUBLES = POINTER(c_double)


class _Problem(Structure):
    """lag_friction_problem of lag/optimization/friction_problem.h."""

    _fields_ = (
        ("normals", c_size_t),
        ("frictions", c_size_t),
        ("components", _DOUBLES),
        ("compliance", _DOUBLES),
        ("rates", _DOUBLES),
        ("limits", _DOUBLES),
        ("coefficients", _DOUBLES),
    )


@cache
def _library() -> ctypes.CDLL:
    runtime_library()  # builds it where its sources changed
    library = ctypes.CDLL(str(runtime_library_folder() / library_name(this_machine().partition("-")[0])))
    library.lag_friction_problem_memory.restype = c_size_t
    library.lag_friction_problem_memory.argtypes = (c_size_t, c_size_t, c_size_t)
    library.lag_friction_problem_solve.restype = c_int
    library.lag_friction_problem_solve.argtypes = (POINTER(_Problem), _DOUBLES, _DOUBLES)
    return library


def solved_in_c(problem: RandomProblem) -> Floats | None:
    library, size = _library(), len(problem.c)
    memory = np.zeros(library.lag_friction_problem_memory(problem.contacts, len(problem.components), size) + 1)
    blocks = [
        np.array(each, dtype=np.float64, order="C").ravel()
        for each in (problem.components, problem.G, problem.c, problem.limits, problem.mu)
    ]
    given = _Problem(problem.contacts, len(problem.components), *(_at(each) for each in blocks))
    f = np.zeros(size)
    return f if library.lag_friction_problem_solve(byref(given), _at(f), _at(memory)) else None


def _at(values: Floats) -> ctypes._Pointer[c_double]:
    return values.ctypes.data_as(_DOUBLES)
