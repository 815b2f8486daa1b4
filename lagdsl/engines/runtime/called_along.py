"""Functions of several directions of derivatives that the C runtime asks Python for."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from lagdsl.engines.runtime.engines.buffers import Buffers
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.structures import Along, RunCallbacks

_ALONG: Any = dict(field[:2] for field in RunCallbacks._fields_)["along"]


class CalledAlong:
    """`make`, which may be another one later, makes the model with these functions. In C nothing may be raised:
    `problem` is what was, to be raised later."""

    def __init__(self, make: Callable[[], NativeModel | None]) -> None:
        self.make = make
        self._held: tuple[NativeModel, Buffers] | None = None
        self.problem: BaseException | None = None
        self.called = _ALONG(self._tell)

    def _tell(self, _context: object, told: int) -> None:
        """Without functions, `told` stays as it is: zero."""
        try:
            model = None if self._held is None else self._held[0]
            model = self.make() if model is None else model
        except BaseException as problem:
            self.problem = problem
            return
        if model is None or not model.part:
            return
        if self._held is None:
            self._held = model, Buffers(model)
        buffers = self._held[1]
        to = Along.from_address(told)
        to.model, to.tangents = model.address, model.part
        to.workspace, to.memory = buffers.workspace.ctypes.data, buffers.memory.ctypes.data
