"""Many values of one thing of a model, in SI units."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.admissible import report_outside
from lagdsl.language.flat.model import Coordinate, FlatModel, Input, State
from lagdsl.language.settings.aliases import own_name
from lagdsl.language.settings.failure import SettingError, short
from lagdsl.language.settings.literal import Literal
from lagdsl.language.settings.ranges import Grid, counted, evenly, grid_of, is_count, parts_of, rewritten
from lagdsl.language.settings.target import (
    Kind,
    Target,
    find,
    lacks_unit,
    note_lacking_unit,
    report_lacking_unit,
    targets,
    value_of,
)

_STEPS = 101  # of a search that is given an interval only
_MOST = 100_000
VARIED: tuple[Kind, ...] = ("parameter", "start", "input")


def values_of(target: Target, text: str, grid: Grid, sink: Sink) -> tuple[float, ...]:
    """The values of a grid in SI units; N0871 where they lack a unit, N0872 where steps do not meet the last value,
    W0328 for starts and inputs out of bounds. Raises SettingError."""
    given = [value_of(target, each) for each in grid.texts()]
    note_bare(target, text, given, sink)
    item = target.quantity
    if isinstance(item, Coordinate | State | Input) and not target.rate:
        for value in (min(each.value for each in given), max(each.value for each in given)):
            report_outside(item, target.name, value, sink)
    if grid.missed:
        whole = f"{target.name}={text}"
        sink.report("N0872", None, what=whole, given=grid.shown, last=grid.missed, count=grid.count)
    return tuple(each.value for each in given)


def varied(flat: FlatModel, name: str, text: str, sink: Sink) -> tuple[Target, tuple[float, ...]]:
    """The target that `name` means, and the values of a range `0:0.1:3 N`, a list, or an interval `0:3 N`, in SI units.
    N0873 where a range may have been meant as from:to:count. Raises SettingError."""
    target = _varied_target(flat, name)
    whole = f"{name}={short(text)}"
    grid = _grid(target, text)
    if not 2 <= grid.count <= _MOST:
        raise SettingError(f"{whole}: give 2 to {_MOST} different values, not {grid.count}")
    values = values_of(target, text, grid, sink)
    parts = parts_of(name, text) if ":" in text else []
    if len(parts) == 3 and not target.unit and is_count(parts[2]):
        other = rewritten(target.name, parts, "")
        sink.report("N0873", None, what=whole, count=grid.count, other=other, number=parts[2][0])
    if len(set(values)) < len(values):
        raise SettingError(f"{whole}: the range is empty, or holds a value twice")
    return target, values


def note_bare(target: Target, text: str, given: list[Literal], sink: Sink) -> None:
    """N0871, once, where some of these values lack a unit; with the largest of them."""
    bare = [each for each in given if lacks_unit(target, each)]
    if not bare:
        return
    largest = max(bare, key=lambda each: abs(each.value))
    if len(bare) == 1 and bare[0].text == text:
        note_lacking_unit(target, text, largest.value, sink)
        return
    shown = target.display
    readings = [f"in {target.unit}"]
    if shown.unit != target.unit:
        value = f"{largest.value:.6g} {target.unit} = {shown(largest.value):.4g} {shown.unit}"
        readings.append(f"up to {value}")
    report_lacking_unit(target, text, ", ".join(readings), largest.value, sink)


def _varied_target(flat: FlatModel, name: str) -> Target:
    known, name = targets(flat, VARIED), own_name(flat, name)
    alone = known.get(f"{name}.start") if name not in known else None  # a start by the name of what moves
    return alone or find(flat, name, known)


def _grid(target: Target, text: str) -> Grid:
    """As `grid_of`, and an interval; a range of three bare numbers for a quantity with unit has two readings, since
    `from:to:count` was the form of --vary."""
    if ":" not in text:
        return grid_of(target.name, text)
    parts = parts_of(target.name, text)
    if len(parts) == 2:
        return evenly(f"{target.name}={short(text)}", parts[0], parts[1], _STEPS)
    if len(parts) == 3 and target.unit and is_count(parts[2]) and not any(unit for _, unit in parts):
        raise counted(target.name, text, parts, target.display.unit)
    return grid_of(target.name, text)
