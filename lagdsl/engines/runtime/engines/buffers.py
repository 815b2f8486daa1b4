"""Arrays that C works in."""

from __future__ import annotations

import numpy as np

from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel

# Bytes of the longest vector: what starts at a multiple of it is read fastest.
_ALIGNMENT = 64


def aligned(count: int) -> Floats:
    """Zeros."""
    spare = _ALIGNMENT // 8
    whole = np.zeros(count + spare)
    first = -(whole.ctypes.data // 8) % spare
    return whole[first : first + count]


class Buffers:
    """Buffers of the runtime for calls of a model, for one thread; never empty: every pointer points at something."""

    def __init__(self, model: NativeModel) -> None:
        self.workspace = aligned(model.workspace + 1)
        self.memory = aligned(model.memory + 1)
        self.lanes = aligned(model.lanes + 1)
