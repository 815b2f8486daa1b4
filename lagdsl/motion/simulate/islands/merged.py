"""The motions of islands as one: rows at all times of all islands, events in the order of time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import groupby
from typing import Any

import numpy as np

from lagdsl.derivation.program.islands.partition import Island
from lagdsl.derivation.program.program import Layout
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.simulate.islands.pieces import Indices
from lagdsl.motion.simulate.islands.runs import IslandResult

# Numbers of a row behind the columns: energy, residuals of positions, residuals of velocities.
_CHECKS = 3
# Lengths of the entries to which events of a kind happen; relations and what time changes are entries of w, warnings
# are those of assertions or, behind them, of clauses.
_HAPPENS_TO = {
    "tick": "nclock",
    **dict.fromkeys(("opened", "closed", "impact"), "ncontact"),
    **dict.fromkeys(("slips", "sticks", "reverses"), "nfriction"),
    "reinit": "nreset",
}
_TOLD = ("nclock", None, "ncontact", "nfriction", "nreset")
_ORDER = {kind: _TOLD.index(_HAPPENS_TO.get(kind)) for kind in (*_HAPPENS_TO, "true", "false", "jump", "warning")}


class MergedRows:
    """Rows (columns, rows), time first, of which those of an island are made when they are first asked for.

    An island has rows at the times that were asked for and at its own events. At those of others its motion is made
    again, with rows there: all of N islands at all events of all would be N^2 numbers, which few want to see.
    """

    def __init__(
        self,
        columns: Sequence[Indices],
        results: Sequence[IslandResult],
        again: Callable[[int, Floats], Floats],
    ) -> None:
        """`columns` of all islands, as Places has them."""
        self._rows = [result.rows for result in results]
        self._again, self._merged = again, [False] * len(results)
        self._column: dict[int, tuple[int, int]] = {}
        for number, own in enumerate(columns):
            for k, place in enumerate(own.tolist()):
                self._column[1 + place] = number, 1 + k

    @cached_property
    def _grid(self) -> tuple[Floats, Indices]:
        """All times, ascending, and how many rows each has: before and after an event it is two."""
        counted = [np.unique(rows[:, 0], return_counts=True) for rows in self._rows]
        times, places = np.unique(np.concatenate([each for each, _ in counted]), return_inverse=True)
        counts = np.zeros(len(times), dtype=np.intp)
        np.maximum.at(counts, places, np.concatenate([count for _, count in counted]))
        return times, counts

    def __getitem__(self, place: int) -> Floats:
        if place == 0:
            return np.repeat(*self._grid)
        number, column = self._column[place]
        return np.ascontiguousarray(self._of(number)[:, column])

    def check(self, number: int) -> Floats:
        """The energy is that of all islands, a residual the largest one."""
        parts = (self._of(k)[:, number - _CHECKS] for k in range(len(self._rows)))
        total = next(parts).copy()
        for part in parts:
            total = total + part if number == 0 else np.maximum(total, part)
        return total

    def _of(self, number: int) -> Floats:
        """Rows of an island at all times of all, its last one again where others have more at one time."""
        if not self._merged[number]:
            self._rows[number] = self._spread(number)
            self._merged[number] = True
        return self._rows[number]

    def _spread(self, number: int) -> Floats:
        times, counts = self._grid
        rows = self._rows[number]
        if len(np.unique(rows[:, 0])) < len(times):
            rows = self._again(number, times)
        own, first, count = np.unique(rows[:, 0], return_index=True, return_counts=True)
        assert len(own) == len(times), "internal error: rows are missing"
        behind = np.arange(int(counts.sum())) - np.repeat(np.cumsum(counts) - counts, counts)
        return rows[np.repeat(first, counts) + np.minimum(behind, np.repeat(count - 1, counts))]


class Chosen:
    """Some columns of merged rows."""

    def __init__(self, rows: MergedRows, places: Sequence[int]) -> None:
        self._rows, self._places = rows, places

    def __getitem__(self, place: int) -> Floats:
        return self._rows[self._places[place]]

    def __len__(self) -> int:
        return len(self._places)

    def __reduce__(self) -> tuple[Any, ...]:
        """All of them, in another process."""
        return np.array, ([self[k] for k in range(len(self))],)


class Checks:
    """Energy and residuals."""

    def __init__(self, rows: MergedRows) -> None:
        self._rows = rows
        self._known: dict[int, Floats] = {}

    def __getitem__(self, number: int) -> Floats:
        if number not in self._known:
            self._known[number] = self._rows.check(number)
        return self._known[number]

    def __reduce__(self) -> tuple[Any, ...]:
        return np.array, ([self[k] for k in range(_CHECKS)],)


def merged_notes(
    layout: Layout, islands: Sequence[Island], results: Sequence[IslandResult]
) -> list[tuple[float, str, int]]:
    """Events of the entries of the whole model, in the order of time. At one time an instant tells causes,
    contacts, friction and resets, each in the order of the model."""
    numbered = [
        (number, note)
        for number, (island, result) in enumerate(zip(islands, results, strict=True))
        for note in _renamed(layout, island, result.notes)
    ]
    found: list[tuple[float, str, int]] = []
    for _, group in groupby(sorted(numbered, key=lambda each: each[1][0]), key=lambda each: each[1][0]):
        together = list(group)
        if len({number for number, _ in together}) > 1:
            together.sort(key=lambda each: (_ORDER[each[1][1]], each[1][2]))
        found += [note for _, note in together]
    return found


def _renamed(
    layout: Layout, island: Island, notes: Sequence[tuple[float, str, int]]
) -> Iterator[tuple[float, str, int]]:
    relations = len(layout.instants.strict)
    changing = np.concatenate([island.places["nindicator"], relations + island.places["ntimed"]])
    places = {kind: island.places[axis] for kind, axis in _HAPPENS_TO.items()}
    places["warning"] = np.concatenate([island.places["na"], len(layout.assertions) + island.places["nfail"]])
    for t, what, which in notes:
        yield t, what, int(places.get(what, changing)[which])
