"""A lag_model in memory, however it was filled, as the runtime is handed it."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_size_t
from dataclasses import field
from pathlib import Path
from typing import Any, cast

from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import VERSION, Model
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record


@record()
class NativeModel:
    """`model` is the address of a lag_model, `part` that of its lag_states or lag_tangents, or None; `context` is what
    its functions need beside their arguments.

    `workspace`, `memory` and `lanes` are the doubles that functions of the runtime need for them. `held` is what must
    live as long; `raised` is where functions of Python leave what they raised. `idle` are runs of it that are over,
    whose memory the next ones take; `starts` are start values and default inputs for the last time and parameters,
    `found` is the start that was found last, behind what it was found from.
    """

    model: object
    context: int | None
    part: object
    workspace: int
    memory: int
    lanes: int
    held: object
    raised: list[BaseException] | None = None
    idle: list[object] = field(default_factory=list)
    starts: list[tuple[tuple[float, bytes], tuple[Floats, Floats]]] = field(default_factory=list)
    found: list[tuple[object, object]] = field(default_factory=list)

    @property
    def address(self) -> int:
        """That of the lag_model."""
        return _address(self.model)

    @property
    def part_address(self) -> int:
        """That of the part; 0: there is none."""
        return 0 if self.part is None else _address(self.part)

    @property
    def at_once(self) -> int:
        """So many states or directions the functions of the part take at once: its first member."""
        return 1 if self.part is None else c_size_t.from_address(self.part_address).value


def _address(pointer: object) -> int:
    return ctypes.cast(cast(Any, pointer), ctypes.c_void_p).value or 0


def native_model(
    at: Model,
    held: object,
    *,
    states: object = None,
    tangents: object = None,
    raised: list[BaseException] | None = None,
) -> NativeModel:
    """The lag_model `at`, with at most one of its parts.

    Raises OSError where it was made for another version of lag/model.h.
    """
    if at.version != VERSION:
        raise OSError(f"the model was compiled for version {at.version} of lag/model.h, not {VERSION}")
    runtime, model = runtime_library(), byref(at)
    return NativeModel(
        model=model,
        context=at.context,
        part=tangents if states is None else states,
        workspace=int(runtime.jacobian_workspace(model, tangents)),
        memory=int(runtime.jacobian_memory(model, tangents)),
        lanes=0 if states is None else int(runtime.batch_memory(model, states)),
        held=held,
        raised=raised,
    )


def load_compiled(path: Path, symbol: str, part: str | None = None) -> NativeModel:
    """The model `symbol` of the shared library at `path` and, with a part, the constant of that name.

    Raises OSError where it cannot be loaded, or was compiled against another version of lag/model.h.
    """
    library = ctypes.CDLL(str(path))
    at = Model.in_dll(library, symbol)
    if part is None:
        return native_model(at, library)
    constant = byref(c_size_t.in_dll(library, part))
    if part.endswith("_states"):
        return native_model(at, library, states=constant)
    return native_model(at, library, tangents=constant)
