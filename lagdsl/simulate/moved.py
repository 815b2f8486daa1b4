"""What became of the starts: a table as data, and as text."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from lagdsl.diagnostics import Sink
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_display import Display, display, display_rate
from lagdsl.mechanics.structure_names import located
from lagdsl.simulate.initial_problem import Problem

# Parts of the natural size: what counts as moved at all, and as more than the digits of a typed number.
_MOVED = 1e-9
_NOTICED = 1e-3
_MOST_LOOPS = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedRow:
    """One coordinate or rate (`der(x)`) that is fixed or whose start was moved; values in SI units."""

    name: str
    start: float
    value: float
    kind: Literal["fixed", "explicit", "default", "derived"]
    unit: Display

    @property
    def reason(self) -> str:
        """`fixed`, `derived (cut joint)`, or by how much the start was moved."""
        if self.kind == "fixed":
            return "fixed"
        if self.kind == "derived":
            return "derived (cut joint)"
        distance = abs(self.value - self.start) * self.unit.scale
        noun = "explicit start" if self.kind == "explicit" else "guess"
        digits = f"{distance:.1f}" if 1.0 <= distance < 1000.0 else f"{distance:.2g}"
        return f"{noun} moved by {digits} {self.unit.unit}".rstrip()


def moved_rows(task: Problem, q: Floats, qd: Floats) -> tuple[MovedRow, ...]:
    """Rows of everything that moved and, if anything did, of what was fixed; positions first."""
    space = task.space
    groups = (
        (q, space.q, task.fixed, task.explicit, display, "{}"),
        (qd, space.qd, task.rate_fixed, task.rate_explicit, display_rate, "der({})"),
    )
    rows: list[MovedRow] = []
    anything = False
    guesses = _in_loops(task)
    for values, starts, fixed, explicit, shown, pattern in groups:
        for index, coordinate in enumerate(task.flat.coordinates):
            start, value = float(starts[index]), float(values[index])
            moved = abs(value - start) > _MOVED * max(abs(start), float(space.sizes[index]))
            anything = anything or moved
            if moved or fixed[index]:
                name = pattern.format(coordinate.name)
                kind: Literal["fixed", "explicit", "default"] = (
                    "fixed" if fixed[index] else "explicit" if explicit[index] and name not in guesses else "default"
                )
                rows.append(MovedRow(name=name, start=start, value=value, kind=kind, unit=shown(coordinate)))
    return (*rows, *_derived(task, q, qd)) if anything else ()


def _derived(task: Problem, q: Floats, qd: Floats) -> list[MovedRow]:
    """The coordinates of cut joints, which follow from the motion of their frames."""
    outputs = task.flat.outputs
    if not any(output.joint for output in outputs):
        return []
    space = task.space
    at_rest = np.zeros_like(q), np.zeros(len(space.row_sizes))
    (values,) = space.functions.evaluate("output", space.t, q, qd, space.z, space.u, space.w, space.p, *at_rest)
    return [
        MovedRow(name=output.name, start=value, value=value, kind="derived", unit=display(output))
        for output, value in zip(outputs, values.tolist(), strict=True)
        if output.joint
    ]


def report_moved(task: Problem, rows: tuple[MovedRow, ...], sink: Sink) -> None:
    """W0814 for explicit starts that were moved by more than the digits they were typed with."""
    coordinates = {c.name: (c, size) for c, size in zip(task.flat.coordinates, task.space.sizes.tolist(), strict=True)}
    for row in rows:
        rate = row.name.startswith("der(")
        if row.kind != "explicit":
            continue
        coordinate, size = coordinates[row.name[4:-1] if rate else row.name]
        if abs(row.value - row.start) <= _NOTICED * max(abs(row.start), size):
            continue
        written = coordinate.rate_start_span if rate else coordinate.start_span
        span = written or (coordinate.spans[0] if coordinate.spans else None)
        sink.report("W0814", span, name=row.name, start=_shown(row, row.start), value=_shown(row, row.value))


def _in_loops(task: Problem) -> set[str]:
    """Names of the coordinates that closures of loops hold: their starts choose how the loop is assembled, and are
    guesses even where they are written."""
    items = [item for item in located(task.flat) if item.constraint.closure is not None]
    held = np.any(task.space.pattern[[row for item in items for row in item.rows]], axis=0)
    return {c.name for c, inside in zip(task.flat.coordinates, held.tolist(), strict=True) if inside}


def _shown(row: MovedRow, si: float) -> str:
    return f"{row.unit(si):.4g} {row.unit.unit}".rstrip()


def moved_text(model: str, freedom: int, rows: tuple[MovedRow, ...], loops: tuple[str, ...] = ()) -> str:
    """The table for people; empty if nothing moved. `loops` names the joints that were cut."""
    if not rows:
        return ""
    degrees = f"{freedom} degree{'' if freedom == 1 else 's'} of freedom"
    lines = [f"initial state ({model}): {degrees}, {_adjusted(rows, loops)}"]
    width = max(len(row.name) for row in rows)
    numbers = max(len(f"{row.unit(x):.2f}") for row in rows for x in (row.start, row.value))
    units = max(len(row.unit.unit) for row in rows)
    for row in rows:
        before = f"{_digits(row, row.start):>{numbers}} {row.unit.unit:<{units}}"
        arrow = "  " if row.kind == "derived" else "->"
        if row.kind == "derived":
            before = " " * (numbers + units + 1)
        after = "" if row.kind == "fixed" else f"{arrow} {_digits(row, row.value):>{numbers}} {row.unit.unit:<{units}}"
        lines.append(f"  {row.name:<{width}}  {before} {after:<{numbers + units + 4}}  {row.reason}".rstrip())
    return "\n".join(lines)


def _adjusted(rows: tuple[MovedRow, ...], loops: tuple[str, ...]) -> str:
    """`2 coordinates adjusted to close the loop at D`."""
    moved = [row for row in rows if row.kind in ("explicit", "default")]
    rates = sum(row.name.startswith("der(") for row in moved)
    if not loops or len(moved) == rates:
        return f"{len(moved)} start value{'' if len(moved) == 1 else 's'} adjusted"
    count = len(moved) - rates
    where = f"the loop at {loops[0]}" if len(loops) == 1 else f"the loops at {', '.join(loops[:-1])} and {loops[-1]}"
    if len(loops) > _MOST_LOOPS:
        where = f"{len(loops)} loops"
    text = f"{count} coordinate{'' if count == 1 else 's'} adjusted to close {where}"
    return f"{text}, {rates} rate{'' if rates == 1 else 's'} adjusted" if rates else text


def loops_of(flat: FlatModel) -> tuple[str, ...]:
    """Names of the joints at which loops are cut."""
    return tuple(dict.fromkeys(c.closure.joint or c.name for c in flat.constraints if c.closure is not None))


def _digits(row: MovedRow, si: float) -> str:
    """Two decimals, or as many as four significant digits need."""
    shown = row.unit(si)
    return f"{shown:.2f}" if shown == 0.0 or abs(shown) >= 0.1 else f"{shown:.4g}"
