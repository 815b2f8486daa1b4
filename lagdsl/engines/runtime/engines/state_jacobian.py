"""The Jacobian of one state through buffers that are made once: steppers ask for it often."""

from __future__ import annotations

from ctypes import byref, c_size_t

import numpy as np

from lagdsl.engines.runtime.engines.buffers import Buffers
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Arguments, Range


class StateJacobian:
    """`model` has the functions of several directions at once.

    The vectors that `arguments` points at are those of the engine, which has to keep them.
    """

    def __init__(self, model: NativeModel, arguments: Arguments, size: int) -> None:
        runtime = runtime_library()
        self._prepare = runtime.prepare
        self._jacobian = runtime.jacobian
        self._buffers = Buffers(model)
        self._arguments = Arguments.from_buffer_copy(arguments)
        self._arguments.workspace = self._buffers.workspace.ctypes.data
        self._arguments.context = model.context
        self._prepared: bytes | None = None
        self._rates = np.zeros((size, size))
        self.coordinate = c_size_t(0)
        at, memory = byref(self._arguments), self._buffers.memory.ctypes.data
        self._prepare_call = (model.model, at)
        rates, index = self._rates.ctypes.data, byref(self.coordinate)
        self._call = (model.model, model.part, at, Range(0, size), memory, rates, None, index)

    def __call__(self, t: float, parameters: Floats) -> tuple[int, Floats]:
        """Status and d(qd, qdd, zd)/d(q, qd, z) at what the vectors hold."""
        now = parameters.tobytes()
        if now != self._prepared:
            self._prepare(*self._prepare_call)
            self._prepared = now
        self._arguments.t = t
        return int(self._jacobian(*self._call)), self._rates.copy()
