"""A sketch of a motion for a terminal: one Braille curve for each coordinate, as wide as the window."""

from __future__ import annotations

import shutil

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.signals.trajectory import Column, Trajectory

# Bits of the dots of a Braille character, two across and four down.
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_BLANK = 0x2800
_MOST_CURVES = 6
_FINE = 12
_MARK = "\N{BOX DRAWINGS LIGHT VERTICAL}"


def sketch(trajectory: Trajectory, *, width: int | None = None, height: int = 4) -> str:
    """Curves of the first coordinates and states over time, in display units; empty without any."""
    trajectory = trajectory.drawn()
    columns = [c for c in trajectory.columns if c.kind in ("coordinate", "state")]
    shown = columns[:_MOST_CURVES]
    if not shown or len(trajectory) < 2:
        return ""
    total = max(shutil.get_terminal_size().columns if width is None else width, 40)
    bounds = [_bounds(column) for column in shown]
    names = [f"{column.name} [{column.display.unit}]" if column.display.unit else column.name for column in shown]
    margin = max(len(text) for text in ["events", *names, *(b for pair in bounds for b in pair)])
    lines: list[str] = []
    for column, name, (low, high) in zip(shown, names, bounds, strict=True):
        labels = [high, name, *[""] * (height - 3), low] if height > 2 else [name]
        curve = braille(trajectory.time, column.values, width=total - margin - 2, height=len(labels))
        lines += [f"{label:>{margin}} {row}".rstrip() for label, row in zip(labels, curve, strict=True)]
    marks = _marks(trajectory, total - margin - 2)
    if marks:
        lines.append(f"{'events':>{margin}} {marks}".rstrip())
    first, last = f"{trajectory.time[0]:g} s", f"{trajectory.time[-1]:g} s"
    lines.append(" " * (margin + 1) + first + last.rjust(total - margin - 2 - len(first)))
    if len(columns) > len(shown):
        lines.append(f"and {len(columns) - len(shown)} more")
    return "\n".join(lines)


def _marks(trajectory: Trajectory, width: int) -> str:
    """A mark where something happened, but for clocks; empty where nothing did."""
    first, last = trajectory.time[0], trajectory.time[-1]
    times = np.array([event.time for event in trajectory.events if event.kind != "tick"])
    line = np.full(width, " ")
    if last > first:
        line[np.minimum((times - first) / (last - first) * width, width - 1).astype(int)] = _MARK
    return "".join(line).rstrip()


def _bounds(column: Column) -> tuple[str, str]:
    finite = column.values[np.isfinite(column.values)]
    if not len(finite):
        return "", ""
    ends = (column.display(float(np.min(finite))), column.display(float(np.max(finite))))
    return f"{min(ends):.4g}", f"{max(ends):.4g}"


def braille(time: Floats, values: Floats, *, width: int, height: int) -> list[str]:
    """`height` lines of `width` characters. A value that is constant is a line in the middle; no number, no dot."""
    across, down = 2 * width, 4 * height
    moments = np.linspace(time[0], time[-1], _FINE * across)
    curve = np.interp(moments, time, values)
    seen = np.isfinite(curve)
    low, high = (float(np.min(curve[seen])), float(np.max(curve[seen]))) if seen.any() else (0.0, 0.0)
    part = (high - curve) / (high - low) if high > low else np.full(len(curve), 0.5)
    cells = np.zeros((height, width), dtype=np.int64)
    x, y = np.flatnonzero(seen) // _FINE, np.rint(part[seen] * (down - 1)).astype(int)
    np.bitwise_or.at(cells, (y // 4, x // 2), np.array(_DOTS)[y % 4, x % 2])
    return ["".join(chr(_BLANK + cell) for cell in line) for line in cells.tolist()]
