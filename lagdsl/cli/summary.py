"""What `lag run` says when no file is asked for: a table of the columns and a sketch of the motion."""

from __future__ import annotations

import shutil

from lagdsl.cli.sketch import sketch
from lagdsl.simulate.moved import moved_text
from lagdsl.simulate.trajectory import Column, Trajectory

_MOST_CURVES = 3
_HEIGHT = 5


def summary(trajectory: Trajectory, *, freedom: int, curves: bool) -> str:
    """The table, what the start values became, invariants, and curves of the first coordinates and states."""
    parts = [moved_text(trajectory.model, freedom, trajectory.moved), _table(trajectory), _quality(trajectory)]
    if curves:
        parts += _curves(trajectory)
    return "\n\n".join(part for part in parts if part)


def _table(trajectory: Trajectory) -> str:
    header = ("", "start", "end", "lowest", "highest", "")
    rows = [header, *(_row(column) for column in trajectory.columns[1:])]
    widths = [max(len(row[i]) for row in rows) for i in range(len(header))]
    lines = [
        "  ".join([row[0].ljust(widths[0]), *(row[i].rjust(widths[i]) for i in range(1, 5)), row[5]]).rstrip()
        for row in rows
    ]
    first, last = float(trajectory.time[0]), float(trajectory.time[-1])
    title = f"{trajectory.model}: {len(trajectory)} rows from {first:g} s to {last:g} s, {trajectory.statistics.solver}"
    return "\n".join([title, *lines])


def _row(column: Column) -> tuple[str, ...]:
    values = column.values
    numbers = (values[0], values[-1], values.min(), values.max())
    return (column.name, *(f"{column.display(float(x)):.5g}" for x in numbers), column.display.unit)


def _quality(trajectory: Trajectory) -> str:
    lines = [f"{record.name} stayed within {record.drift:.1e}" for record in trajectory.invariants]
    return "\n".join([*lines, *trajectory.statistics.notes])


def _curves(trajectory: Trajectory) -> list[str]:
    moving = [c for c in trajectory.columns if c.kind in ("coordinate", "state")]
    width = max(20, min(72, shutil.get_terminal_size().columns - 14))
    return [_curve(trajectory, column, width) for column in moving[:_MOST_CURVES]]


def _curve(trajectory: Trajectory, column: Column, width: int) -> str:
    lines = sketch(trajectory.time, column.values, width=width, height=_HEIGHT)
    high, low = (f"{column.display(float(x)):.4g}" for x in (column.values.max(), column.values.min()))
    labels = [high, *[""] * (_HEIGHT - 2), low]
    body = [f"{label:>10} {line}".rstrip() for label, line in zip(labels, lines, strict=True)]
    unit = f" [{column.display.unit}]" if column.display.unit else ""
    return "\n".join([f"{column.name}{unit}", *body])
