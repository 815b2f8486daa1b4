"""Operands of a loop that differ from lap to lap: in its text, in the head of its table, or in a row per lap."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from lagdsl.foundation.record import record

# Per run of a kernel, per lap.
Column = Sequence[Sequence[int]]


@record()
class Index:
    """The whole number `base + slope + offset`: C expressions, of a table's entry and of what a lap adds, or empty."""

    base: str
    slope: str
    offset: int


@dataclass(slots=True)
class Tables:
    """The columns of one kernel's tables: `head` has an entry per run, `rows` and `values` one per run and lap."""

    head: list[tuple[int, ...]] = field(default_factory=list)
    rows: list[tuple[tuple[int, ...], ...]] = field(default_factory=list)
    values: list[tuple[tuple[float, ...], ...]] = field(default_factory=list)

    def index(self, column: Column) -> Index:
        """The index that takes these values; columns that differ by a constant are one."""
        firsts = [laps[0] for laps in column]
        strides = [_stride(laps) for laps in column]
        if _UNEVEN in strides:
            least = min(map(min, column))
            rows = tuple(tuple(value - least for value in laps) for laps in column)
            return Index(f"row[{_place(self.rows, rows)}]", "", least)
        known = {stride for stride in strides if stride is not None}
        if len(known) > 1:
            slopes = tuple(0 if stride is None else stride for stride in strides)
            return self._based(firsts, f" + lap*head[{_place(self.head, slopes)}]")
        slope = min(known, default=0)
        return self._based(firsts, "" if slope == 0 else f" + lap*{slope}" if slope > 0 else f" - lap*{-slope}")

    def value(self, column: Sequence[Sequence[float]]) -> str | float:
        """The C expression of a number that takes these values; the number itself where there is only one."""
        first = column[0][0]
        if all(value == first for laps in column for value in laps):
            return first
        return f"value[{_place(self.values, tuple(tuple(laps) for laps in column))}]"

    def _based(self, firsts: Sequence[int], slope: str) -> Index:
        least = min(firsts)
        if max(firsts) == least:
            return Index("", slope, least)
        return Index(f"head[{_place(self.head, tuple(first - least for first in firsts))}]", slope, least)


_UNEVEN = -(1 << 40)


def _stride(laps: Sequence[int]) -> int | None:
    """The difference from lap to lap: None of a single lap, _UNEVEN where it varies."""
    if len(laps) == 1:
        return None
    stride = laps[1] - laps[0]
    last = laps[0]
    for value in laps[1:]:
        if value - last != stride:
            return _UNEVEN
        last = value
    return stride


_T = TypeVar("_T")


def _place(columns: list[_T], column: _T) -> int:
    if column in columns:
        return columns.index(column)
    columns.append(column)
    return len(columns) - 1
