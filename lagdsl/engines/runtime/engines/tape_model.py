"""A tape as a lag_model in memory."""

from __future__ import annotations

from ctypes import byref, c_size_t

import numpy as np

from lagdsl.engines.runtime.engines.buffers import aligned
from lagdsl.engines.runtime.engines.native_model import NativeModel, native_model
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Model


class DamagedTape(ValueError):  # noqa: N818  it says what is the matter
    """Bytes that are no tape, of another version, or that were changed."""


def load_tape(tape: bytes, part: str | None = None) -> NativeModel:
    """The model of the bytes that `lagdsl.engines.backends.tape` made, with the functions of several states at once
    (`part` "states") or of several directions ("tangents", "parameter_tangents"), or with the derivatives of the motion
    ("jacobian"), where there are some.

    Raises DamagedTape.
    """
    runtime = runtime_library()
    held = aligned(len(tape) // 8 + 1)  # the C side wants them on an address that is a multiple of 8
    held.view(np.uint8)[: len(tape)] = np.frombuffer(tape, dtype=np.uint8)
    needed = c_size_t(0)
    if runtime.tape_check(held.ctypes.data, len(tape), byref(needed)) != 0:
        raise DamagedTape("these bytes are no tape of this version, or were changed")
    memory = aligned(needed.value // 8 + 1)
    runtime.tape_model(held.ctypes.data, len(tape), memory.ctypes.data)
    model = Model.from_address(memory.ctypes.data)
    states = runtime.tape_states(byref(model)) if part == "states" else None
    tangents = None
    if part in ("tangents", "parameter_tangents"):
        tangents = runtime.tape_tangents(byref(model), part != "tangents")
    if part == "jacobian":
        tangents = runtime.tape_jacobian(byref(model))
    return native_model(model, (held, memory), states=states, tangents=tangents)
