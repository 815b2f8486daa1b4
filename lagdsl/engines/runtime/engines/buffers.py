"""Arrays that C works in."""

from __future__ import annotations

import mmap
import sys
from ctypes import addressof, c_char
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel

# Bytes of the longest vector: what starts at a multiple of it is read fastest.
_ALIGNMENT = 64
_byte_of: Any = c_char.from_buffer
# Bytes from which on memory is that of `zeros_of`: a few pages more for each block do not count then.
_LARGE = 1 << 23


def place_of(array: NDArray[Any]) -> int:
    """Its address. The buffer protocol tells it in a quarter of the time that NumPy takes, but not of an array without
    entries, nor of one that nobody may write to."""
    try:
        return addressof(_byte_of(array)) if array.size else _told_place(array)
    except (TypeError, ValueError):
        return _told_place(array)


def _told_place(array: NDArray[Any]) -> int:
    return array.__array_interface__["data"][0]  # type: ignore[no-any-return]


# Pages that are never touched need not be there for them: MAP_NORESERVE of Linux, which Python's module does not name.
_NO_RESERVE = 0x4000 if sys.platform == "linux" else 0


def zeros_of(size: int) -> Floats:
    """So many bytes, in pages of the system that are there when they are touched: matrices of large models have few
    entries, but may be larger than all memory.

    NumPy asks for huge pages, of which an entry in each row of a matrix touches all.
    """
    bytes = -(-size // 8) * 8
    if sys.platform == "win32":
        block = mmap.mmap(-1, bytes)
    else:
        block = mmap.mmap(-1, bytes, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | _NO_RESERVE)
    return np.frombuffer(block, dtype=np.float64)


def aligned(count: int) -> Floats:
    """Zeros."""
    spare = _ALIGNMENT // 8
    whole = np.zeros(count + spare) if 8 * count < _LARGE else zeros_of(8 * (count + spare))
    first = -(whole.ctypes.data // 8) % spare
    return whole[first : first + count]


class Buffers:
    """Buffers of the runtime for calls of a model, for one thread; never empty: every pointer points at something."""

    def __init__(self, model: NativeModel) -> None:
        self.workspace = aligned(model.workspace + 1)
        self.memory = aligned(model.memory + 1)
        self.lanes = aligned(model.lanes + 1)
