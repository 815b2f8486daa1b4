"""Arrays that C works in."""

from __future__ import annotations

import numpy as np

from lagdsl.runtime.engine import Floats
from lagdsl.runtime.load import Library

# Bytes of the longest vector: what starts at a multiple of it is read fastest.
_ALIGNMENT = 64


def aligned(count: int) -> Floats:
    """Zeros."""
    spare = _ALIGNMENT // 8
    whole = np.zeros(count + spare)
    first = -(whole.ctypes.data // 8) % spare
    return whole[first : first + count]


class Buffers:
    """What a library needs to be called, for one thread; never empty, so that every pointer points at something."""

    def __init__(self, library: Library) -> None:
        self.workspace = aligned(library.workspace + 1)
        self.memory = aligned(library.memory + 1)
        self.lanes = aligned(library.lanes + 1)
