"""lag_initial_find() of a compiled model, called from Python."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, Structure, byref, c_char, c_double, c_int, c_size_t, c_void_p
from dataclasses import dataclass

import numpy as np

from lagdsl.backends.c.emit import model_symbol, sources
from lagdsl.backends.c.start import start_of
from lagdsl.mechanics.rank import Floats
from lagdsl.pipeline import Compilation
from lagdsl.runtime.build import build


class _Start(Structure):
    _fields_ = [
        ("t", c_double),
        *((name, c_void_p) for name in ("x", "fixed", "written", "nominal", "minimum", "maximum")),
    ]


class _Initial(Structure):
    _fields_ = [
        ("fault", c_int),
        ("which", c_size_t),
        ("residual", c_double),
        ("rank", c_size_t),
        ("moved", c_int),
        ("dependent", c_void_p),
    ]


@dataclass(frozen=True)
class Found:
    """`status` and `fault` as in lag/initial.h."""

    status: int
    fault: int
    which: int
    residual: float
    rank: int
    x: Floats


class Initial:
    """The start of one model, as C finds it."""

    def __init__(self, compilation: Compilation) -> None:
        program, flat = compilation.program, compilation.flat
        self._library = library = ctypes.CDLL(str(build(sources(program))))
        self._model = byref(c_char.in_dll(library, model_symbol(program)))
        self._layout = program.layout
        self.size = 2 * len(flat.coordinates) + len(flat.states)
        told = start_of(flat, flat.experiment.start_time, [0.0] * self.size)
        self._kept: list[np.ndarray] = [
            np.array(told.fixed, dtype=np.uint8),
            np.array(told.written, dtype=np.uint8),
            *(np.array(values, dtype=np.float64) for values in (told.nominal, told.minimum, told.maximum)),
        ]
        self._start = _Start(told.t, None, *(each.ctypes.data for each in self._kept))
        for name in ("lag_motion_memory", "lag_initial_memory"):
            getattr(library, name).restype = c_size_t

    def find(self, p: Floats, start: dict[int, float], t: float | None = None) -> Found:
        """`start`: further start values by entry of (q, qd, z)."""
        library, model = self._library, self._model
        # A guard behind every array: what is written beyond its end shows.
        memory = np.full(int(library.lag_motion_memory(model)) + 1, 7.5)
        search = np.full(int(library.lag_initial_memory(model)) + 1, 7.5)
        motion = (c_double * 400)()
        p = np.append(p, 0.0)
        x, told = np.zeros(self.size + 1), _Initial()
        chosen = np.zeros(self.size + 1, dtype=np.uint8)
        time = self._start.t if t is None else t
        library.lag_motion_place(byref(motion), model, c_void_p(memory.ctypes.data))
        assert library.lag_motion_parameters(byref(motion), c_void_p(p.ctypes.data)) == 0
        assert library.lag_motion_start(byref(motion), c_double(time), c_void_p(x.ctypes.data)) == 0
        for entry, value in start.items():
            x[entry], chosen[entry] = value, 1
        library.lag_initial_find.argtypes = [
            *(c_void_p, POINTER(_Start), c_void_p, c_double, c_void_p, c_void_p, POINTER(_Initial)),
        ]
        status = library.lag_initial_find(
            byref(motion),
            byref(self._start),
            chosen.ctypes.data if start else None,
            time,
            x.ctypes.data,
            search.ctypes.data,
            byref(told),
        )
        assert memory[-1] == 7.5 and search[-1] == 7.5 and x[-1] == 0.0
        return Found(status, told.fault, told.which, told.residual, told.rank, x[: self.size].copy())
