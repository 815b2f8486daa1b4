"""What `lag run` says when no file is asked for: a table of the columns and a sketch of the motion."""

from __future__ import annotations

from lagdsl.plot.terminal import sketch
from lagdsl.simulate.moved import moved_text
from lagdsl.simulate.trajectory import Column, Trajectory


def summary(trajectory: Trajectory, *, freedom: int, loops: tuple[str, ...], curves: bool) -> str:
    """The table, what the start values became, invariants, and curves of the first coordinates and states."""
    parts = [
        moved_text(trajectory.model, freedom, trajectory.moved, loops),
        _table(trajectory),
        _quality(trajectory),
        sketch(trajectory) if curves else "",
    ]
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
