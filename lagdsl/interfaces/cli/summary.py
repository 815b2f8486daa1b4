"""Summary that `lag run` prints without an output file: a table of the columns and a sketch of the motion."""

from __future__ import annotations

from math import inf

from lagdsl.documents.plot.terminal import sketch
from lagdsl.interfaces.cli.text_table import aligned
from lagdsl.motion.signals.moved import moved_text
from lagdsl.motion.signals.trajectory import Column, Event, Trajectory

_MOST_KINDS = 16
_LONGEST_NAME = 40
# A number below this part of the largest of its column is what rounding errors of times and states make of zero.
_ROUNDING = 1e-11


def summary(trajectory: Trajectory, *, freedom: int, loops: tuple[str, ...], curves: bool) -> str:
    """The table, what the start values became, invariants, and curves of the first coordinates and states."""
    parts = [
        moved_text(trajectory.model, freedom, trajectory.moved, loops),
        _table(trajectory),
        _events(trajectory.events),
        _quality(trajectory),
        sketch(trajectory) if curves else "",
    ]
    return "\n\n".join(part for part in parts if part)


def _table(trajectory: Trajectory) -> str:
    header = ("", "start", "end", "lowest", "highest", "")
    lines = aligned([header, *(_row(column) for column in trajectory.columns[1:])], left=(0, 5))
    first, last = float(trajectory.time[0]), float(trajectory.time[-1])
    title = f"{trajectory.model}: {len(trajectory)} rows from {first:g} s to {last:g} s, {trajectory.statistics.solver}"
    return "\n".join([title, *lines])


def _row(column: Column) -> tuple[str, ...]:
    numbers = [float(x) for x in (column.values[0], column.values[-1], column.lowest, column.highest)]
    least = _ROUNDING * max(abs(column.lowest), abs(column.highest))
    shown = (column.display(0.0 if abs(x) <= least < inf else x) for x in numbers)
    return (column.name, *(f"{x:.5g}" for x in shown), column.display.unit)


def _events(events: tuple[Event, ...]) -> str:
    """Kinds of events with their number, first and last time."""
    if not events:
        return ""
    times: dict[tuple[str, str], list[float]] = {}
    for event in events:
        times.setdefault((event.name, event.kind), []).append(event.time)
    shown = list(times.items())[:_MOST_KINDS]
    header = ("events", "", "number", "first", "last")
    rows = [(_short(name), kind, f"{len(t)}", f"{t[0]:.6g} s", f"{t[-1]:.6g} s") for (name, kind), t in shown]
    lines = aligned([header, *rows], left=(0, 1))
    if len(times) > len(shown):
        lines.append(f"and {len(times) - len(shown)} more")
    return "\n".join(lines)


def _short(name: str) -> str:
    return name if len(name) <= _LONGEST_NAME else f"{name[: _LONGEST_NAME - 3]}..."


def _quality(trajectory: Trajectory) -> str:
    lines = [f"{record.name} stayed within {record.drift:.1e}" for record in trajectory.invariants]
    return "\n".join([*lines, *trajectory.statistics.notes])
