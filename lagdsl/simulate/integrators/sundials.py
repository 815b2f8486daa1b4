"""CVODE by its C interface, of SUNDIALS 6 or 7 with double precision and indices of 64 bits."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from ctypes import CFUNCTYPE, byref, c_double, c_int, c_int64, c_long, c_void_p
from ctypes.util import find_library
from functools import cache
from typing import Any

import numpy as np

from lagdsl.mechanics.rank import Floats

_BDF, _ONE_STEP = 2, 2
_LIMIT_REACHED = 1  # CV_TSTOP_RETURN
# Steps are at least this part of time, some round-off; its first would be shorter.
_SMALLEST = 1e-14
_RIGHT = CFUNCTYPE(c_int, c_double, c_void_p, c_void_p, c_void_p)
_WEIGHTS = CFUNCTYPE(c_int, c_void_p, c_void_p, c_void_p)
_MATRIX = CFUNCTYPE(c_int, c_double, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)
_MAKERS = ("N_VMake_Serial", "SUNDenseMatrix", "SUNLinSol_Dense", "CVodeCreate")


@cache
def library(place: str | None) -> ctypes.CDLL | None:
    """SUNDIALS, if it is usable: libsundials_cvode at that place, or where the system looks."""
    path = place or find_library("sundials_cvode")
    try:
        found = ctypes.CDLL(path, mode=ctypes.RTLD_GLOBAL) if path else None
        for name in (*_MAKERS, "SUNContext_Create", "SUNDenseMatrix_Data", "N_VGetArrayPointer"):
            getattr(found, name).restype = c_int if name == "SUNContext_Create" else c_void_p
    except (OSError, AttributeError):
        return None
    return found


class Cvode:
    """y' = right(t, y) with its Jacobian, from (t, y); not beyond t_end."""

    def __init__(
        self,
        found: ctypes.CDLL,
        right: Callable[[float, Floats], Floats],
        jacobian: Callable[[float, Floats], Floats],
        t: float,
        y: Floats,
        t_end: float,
        rtol: float,
        atol: Floats,
        first: float,
    ) -> None:
        self._c, self._size = found, len(y)
        self.t, self.y = t, np.array(y, dtype=np.float64)
        self._trouble: BaseException | None = None
        self._right, self._jacobian = right, jacobian
        self._given, self._inside = np.array(y, dtype=np.float64), np.empty(self._size)
        self._rtol, self.atol = rtol, np.array(atol, dtype=np.float64)
        self._context = c_void_p()
        found.SUNContext_Create(c_void_p(None), byref(self._context))
        self._vectors = [self._vector(array) for array in (self._given, self.y, self._inside)]
        self._matrix = c_void_p(found.SUNDenseMatrix(c_int64(self._size), c_int64(self._size), self._context))
        self._linear = c_void_p(found.SUNLinSol_Dense(self._vectors[0], self._matrix, self._context))
        self._memory = c_void_p(found.CVodeCreate(c_int(_BDF), self._context))
        self._calls = (_RIGHT(self._slopes), _MATRIX(self._matrix_of), _WEIGHTS(self._weights))
        self._do("CVodeInit", self._calls[0], c_double(t), self._vectors[0])
        self._do("CVodeWFtolerances", self._calls[2])
        self._do("CVodeSetLinearSolver", self._linear, self._matrix)
        self._do("CVodeSetJacFn", self._calls[1])
        self._do("CVodeSetMaxNumSteps", c_long(-1))
        self._do("CVodeSetInitStep", c_double(first))
        self._do("CVodeSetMinStep", c_double(_SMALLEST * max(abs(t), abs(t_end))))
        self._do("CVodeSetStopTime", c_double(t_end))

    def _vector(self, array: Floats) -> c_void_p:
        return c_void_p(self._c.N_VMake_Serial(c_int64(self._size), c_void_p(array.ctypes.data), self._context))

    def _do(self, name: str, *arguments: Any) -> int:
        return int(getattr(self._c, name)(self._memory, *arguments))

    def _view(self, vector: int) -> Floats:
        start = self._c.N_VGetArrayPointer(c_void_p(vector))
        return np.ctypeslib.as_array(ctypes.cast(start, ctypes.POINTER(c_double)), (self._size,))

    def _slopes(self, t: float, y: int, out: int, _: int) -> int:
        return self._into(self._view(out), lambda: self._right(t, self._view(y).copy()))

    def _matrix_of(self, t: float, y: int, _f: int, matrix: int, *_: int) -> int:
        """Column by column, as SUNDIALS keeps it."""
        start = ctypes.cast(self._c.SUNDenseMatrix_Data(c_void_p(matrix)), ctypes.POINTER(c_double))
        columns = np.ctypeslib.as_array(start, (self._size, self._size))
        return self._into(columns, lambda: self._jacobian(t, self._view(y).copy()).T)

    def _into(self, array: Floats, values: Callable[[], Floats]) -> int:
        """Called from C, where nothing may be raised. 1: a shorter step, please."""
        try:
            array[...] = values()
        except BaseException as trouble:
            self._trouble = trouble
            return -1
        return 0 if np.all(np.isfinite(array)) else 1

    def _weights(self, y: int, out: int, _: int) -> int:
        """Asked for at every step, so that absolute tolerances may follow the motion."""
        return self._into(self._view(out), lambda: 1.0 / (self._rtol * np.abs(self._view(y)) + self.atol))

    def step(self, t_end: float, longest: float) -> bool:
        """One step; whether it could be done."""
        now = c_double(self.t)
        self._do("CVodeSetMaxStep", c_double(longest if np.isfinite(longest) else 0.0))
        status = self._do("CVode", c_double(t_end), self._vectors[1], byref(now), c_int(_ONE_STEP))
        if self._trouble is not None:
            raise self._trouble
        self.t = t_end if status == _LIMIT_REACHED else float(now.value)
        return status in (0, _LIMIT_REACHED)

    def inside(self, t: float) -> Floats:
        """The state at a time within the last step."""
        self._do("CVodeGetDky", c_double(t), c_int(0), self._vectors[2])
        return self._inside.copy()

    def restart(self, t: float, y: Floats) -> None:
        """From another state, at order 1."""
        self._given[:] = y
        self._do("CVodeReInit", c_double(t), self._vectors[0])

    def __del__(self) -> None:
        if hasattr(self, "_calls"):
            self._c.CVodeFree(byref(self._memory))
            self._c.SUNLinSolFree(self._linear)
            self._c.SUNMatDestroy(self._matrix)
            for vector in self._vectors:
                self._c.N_VDestroy(vector)
            self._c.SUNContext_Free(byref(self._context))
