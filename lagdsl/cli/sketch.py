"""A curve drawn with Braille characters: the motion at a glance, in a terminal."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # rows of one character, two dots each
_BLANK = 0x2800


def sketch(time: Floats, values: Floats, *, width: int, height: int) -> list[str]:
    """`height` lines of `width` characters; the lowest value on the last line, the highest on the first."""
    columns, rows = 2 * width, 4 * height
    grid = np.zeros((height, width), dtype=np.int64)
    moments = np.linspace(time[0], time[-1], 4 * columns)
    curve = np.interp(moments, time, values)
    low, high = float(np.min(values)), float(np.max(values))
    span = high - low if high > low else 1.0
    across = np.minimum((np.arange(len(moments)) * columns) // len(moments), columns - 1)
    down = (
        np.rint((high - curve) / span * (rows - 1)).astype(np.int64) if high > low else np.full(len(curve), rows // 2)
    )
    for x, y in zip(across.tolist(), down.tolist(), strict=True):
        grid[y // 4, x // 2] |= _DOTS[y % 4][x % 2]
    return ["".join(chr(_BLANK + cell) for cell in line) for line in grid.tolist()]
