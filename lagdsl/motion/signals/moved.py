"""Start values after initialization: a table as data, and as text."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.passes.pattern import Pattern
from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.structure.names import located
from lagdsl.engines.backends.start import free_parameters
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat.display import Display, display, display_rate
from lagdsl.language.flat.model import FlatModel

Flags = NDArray[np.bool_]
Kind: TypeAlias = Literal["fixed", "explicit", "default", "derived", "found"]

# Parts of the natural size: what counts as moved at all, and as more than the digits of a typed number.
_MOVED = 1e-9
NOTICED = 1e-3
_MOST_LOOPS = 4


@record(kw_only=True)
class MovedRow:
    """One coordinate or rate (`der(x)`) that is fixed or whose start was moved, or a parameter that was found with
    them; values in SI units."""

    name: str
    start: float
    value: float
    kind: Kind
    unit: Display

    @property
    def reason(self) -> str:
        """`fixed`, `derived (cut joint)`, `found parameter`, or by how much the start was moved."""
        if self.kind == "fixed":
            return "fixed"
        if self.kind == "derived":
            return "derived (cut joint)"
        if self.kind == "found":
            return "found parameter"
        distance = abs(self.value - self.start) * self.unit.scale
        noun = "explicit start" if self.kind == "explicit" else "guess"
        digits = f"{distance:.1f}" if 1.0 <= distance < 1000.0 else f"{distance:.2g}"
        return f"{noun} moved by {digits} {self.unit.unit}".rstrip()


@record(kw_only=True)
class Starts:
    """Start values x (2 nq + nz,) with their natural sizes, and which of them are fixed or written; `pattern` are the
    entries of J, `count` is nq."""

    flat: FlatModel
    x: Floats
    sizes: Floats
    fixed: Flags
    written: Flags
    pattern: Pattern
    count: int


def moved_rows(starts: Starts, x: Floats, outputs: Callable[[], Floats]) -> tuple[MovedRow, ...]:
    """Rows of everything that moved to `x` and, if anything did, of what was fixed, positions first; then those of cut
    joints, whose values stand in `outputs`."""
    least = _MOVED * np.maximum(np.abs(starts.x), starts.sizes)
    far = (np.abs(x - starts.x) > least)[: 2 * starts.count]
    if not far.any():
        return ()
    names, fixed = _names(starts.flat), starts.fixed[: 2 * starts.count]
    written = starts.written[: 2 * starts.count].copy()
    written[: starts.count] &= ~_in_loops(starts)
    kinds: list[Kind] = ["default", "explicit", "fixed"]
    places = np.flatnonzero(far | fixed)
    columns = (each[places].tolist() for each in (starts.x, x, np.where(fixed, 2, written)))
    rows = [
        MovedRow(name=names[place][0], start=start, value=value, kind=kinds[kind], unit=names[place][1])
        for place, start, value, kind in zip(places.tolist(), *columns, strict=True)
    ]
    cut = cut_joints(starts.flat)
    values = outputs()[list(cut)].tolist() if cut else ()
    derived = [
        MovedRow(name=name, start=value, value=value, kind="derived", unit=unit)
        for (name, unit), value in zip(cut.values(), values, strict=True)
    ]
    return (*rows, *derived)


@remembered
def _names(flat: FlatModel) -> list[tuple[str, Display]]:
    """Names and displays of coordinates, then of their rates."""
    coordinates = [(each.name, display(each)) for each in flat.coordinates]
    return coordinates + [(f"der({each.name})", display_rate(each)) for each in flat.coordinates]


@remembered
def cut_joints(flat: FlatModel) -> dict[int, tuple[str, Display]]:
    """The outputs that are coordinates of cut joints: names and displays by place."""
    return {place: (each.name, display(each)) for place, each in enumerate(flat.outputs) if each.joint}


def found_rows(flat: FlatModel, layout: Layout, guesses: Floats, p: Floats) -> tuple[MovedRow, ...]:
    """The parameters that are found with the start, and from which values."""
    free = {parameter.name: parameter for parameter in free_parameters(flat)}
    if not free:
        return ()
    return tuple(
        MovedRow(name=slot.name, start=guess, value=value, kind="found", unit=display(free[slot.name]))
        for slot, guess, value in zip(layout.parameters, guesses.tolist(), p.tolist(), strict=True)
        if slot.name in free
    )


def report_moved(starts: Starts, rows: tuple[MovedRow, ...], sink: Sink) -> None:
    """W0814 for explicit starts that were moved by more than the digits they were typed with."""
    explicit = [row for row in rows if row.kind == "explicit"]
    if not explicit:
        return
    coordinates = {c.name: (c, size) for c, size in zip(starts.flat.coordinates, starts.sizes.tolist(), strict=False)}
    for row in explicit:
        rate = row.name.startswith("der(")
        coordinate, size = coordinates[row.name[4:-1] if rate else row.name]
        if abs(row.value - row.start) <= NOTICED * max(abs(row.start), size):
            continue
        written = coordinate.rate_start_span if rate else coordinate.start_span
        span = written or (coordinate.spans[0] if coordinate.spans else None)
        sink.report("W0814", span, name=row.name, start=_shown(row, row.start), value=_shown(row, row.value))


def _in_loops(starts: Starts) -> Flags:
    """Coordinates (nq,) that closures of loops hold: their starts choose how the loop is assembled, and are guesses
    even where they are written."""
    closures, held = set(_rows_of_closures(starts.flat)), np.zeros(starts.count, dtype=np.bool_)
    held[[column for row, column in zip(*starts.pattern, strict=True) if row in closures]] = True
    return held


@remembered
def _rows_of_closures(flat: FlatModel) -> list[int]:
    return [row for item in located(flat) if item.constraint.closure is not None for row in item.rows]


def _shown(row: MovedRow, si: float) -> str:
    return f"{row.unit(si):.4g} {row.unit.unit}".rstrip()


def moved_text(model: str, freedom: int, rows: tuple[MovedRow, ...], loops: tuple[str, ...] = ()) -> str:
    """The table for people; empty if nothing moved. `loops` names the joints that were cut."""
    if not rows:
        return ""
    degrees = f"{freedom} degree{'' if freedom == 1 else 's'} of freedom"
    count = sum(row.kind == "found" for row in rows)
    found = [f"{count} parameter{'' if count == 1 else 's'} found"] if count else []
    adjusted = [] if all(row.kind == "found" for row in rows) else [_adjusted(rows, loops)]
    lines = [f"initial state ({model}): {', '.join([degrees, *adjusted, *found])}"]
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


@remembered
def loops_of(flat: FlatModel) -> tuple[str, ...]:
    """Names of the joints at which loops are cut."""
    return tuple(dict.fromkeys(c.closure.joint or c.name for c in flat.constraints if c.closure is not None))


def _digits(row: MovedRow, si: float) -> str:
    """Two decimals, or as many as four significant digits need."""
    shown = row.unit(si)
    return f"{shown:.2f}" if shown == 0.0 or abs(shown) >= 0.1 else f"{shown:.4g}"
