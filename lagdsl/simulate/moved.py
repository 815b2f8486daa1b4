"""What became of the starts: a table as data, and as text."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from lagdsl.diagnostics import Sink
from lagdsl.mechanics.rank import Floats
from lagdsl.mechanics.structure_display import Display, display, display_rate
from lagdsl.simulate.initial_problem import Problem

# Parts of the natural size: what counts as moved at all, and as more than the digits of a typed number.
_MOVED = 1e-9
_NOTICED = 1e-3


@dataclass(frozen=True, slots=True, kw_only=True)
class MovedRow:
    """One coordinate or rate (`der(x)`) that is fixed or whose start was moved; values in SI units."""

    name: str
    start: float
    value: float
    kind: Literal["fixed", "explicit", "default"]
    unit: Display

    @property
    def reason(self) -> str:
        """`fixed`, or by how much the start was moved."""
        if self.kind == "fixed":
            return "fixed"
        distance = abs(self.value - self.start) * self.unit.scale
        noun = "explicit start" if self.kind == "explicit" else "guess"
        return f"{noun} moved by {distance:.2g} {self.unit.unit}".rstrip()


def moved_rows(task: Problem, q: Floats, qd: Floats) -> tuple[MovedRow, ...]:
    """Rows of everything that moved and, if anything did, of what was fixed; positions first."""
    space = task.space
    groups = (
        (q, space.q, task.fixed, task.explicit, display, "{}"),
        (qd, space.qd, task.rate_fixed, task.rate_explicit, display_rate, "der({})"),
    )
    rows: list[MovedRow] = []
    anything = False
    for values, starts, fixed, explicit, shown, pattern in groups:
        for index, coordinate in enumerate(task.flat.coordinates):
            start, value = float(starts[index]), float(values[index])
            moved = abs(value - start) > _MOVED * max(abs(start), float(space.sizes[index]))
            anything = anything or moved
            if moved or fixed[index]:
                kind: Literal["fixed", "explicit", "default"] = (
                    "fixed" if fixed[index] else "explicit" if explicit[index] else "default"
                )
                name = pattern.format(coordinate.name)
                rows.append(MovedRow(name=name, start=start, value=value, kind=kind, unit=shown(coordinate)))
    return tuple(rows) if anything else ()


def report_moved(task: Problem, rows: tuple[MovedRow, ...], sink: Sink) -> None:
    """W0814 for explicit starts that were moved by more than the digits they were typed with."""
    coordinates = {c.name: (c, size) for c, size in zip(task.flat.coordinates, task.space.sizes.tolist(), strict=True)}
    for row in rows:
        rate = row.name.startswith("der(")
        coordinate, size = coordinates[row.name[4:-1] if rate else row.name]
        if row.kind != "explicit" or abs(row.value - row.start) <= _NOTICED * max(abs(row.start), size):
            continue
        written = coordinate.rate_start_span if rate else coordinate.start_span
        span = written or (coordinate.spans[0] if coordinate.spans else None)
        sink.report("W0814", span, name=row.name, start=_shown(row, row.start), value=_shown(row, row.value))


def _shown(row: MovedRow, si: float) -> str:
    return f"{row.unit(si):.4g} {row.unit.unit}".rstrip()


def moved_text(model: str, freedom: int, rows: tuple[MovedRow, ...]) -> str:
    """The table for people; empty if nothing moved."""
    if not rows:
        return ""
    moved = sum(row.kind != "fixed" for row in rows)
    degrees = f"{freedom} degree{'' if freedom == 1 else 's'} of freedom"
    lines = [f"initial state ({model}): {degrees}, {moved} start value{'' if moved == 1 else 's'} adjusted"]
    width = max(len(row.name) for row in rows)
    numbers = max(len(f"{row.unit(x):.2f}") for row in rows for x in (row.start, row.value))
    units = max(len(row.unit.unit) for row in rows)
    for row in rows:
        before = f"{_digits(row, row.start):>{numbers}} {row.unit.unit:<{units}}"
        after = "" if row.kind == "fixed" else f"-> {_digits(row, row.value):>{numbers}} {row.unit.unit:<{units}}"
        lines.append(f"  {row.name:<{width}}  {before} {after:<{numbers + units + 4}}  {row.reason}".rstrip())
    return "\n".join(lines)


def _digits(row: MovedRow, si: float) -> str:
    """Two decimals, or as many as four significant digits need."""
    shown = row.unit(si)
    return f"{shown:.2f}" if shown == 0.0 or abs(shown) >= 0.1 else f"{shown:.4g}"
