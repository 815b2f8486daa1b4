"""The multipliers of rows in an elimination: when they are complete, and what it tells of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from lagdsl.algebra.eliminate.rows import Rows, components, is_multiplier, multiplier_of
from lagdsl.algebra.graph.graph import Graph


class Multipliers:
    """`following` are those of rows that follow from solved ones. By multiplier: `sizes` are what its pivot was before
    others were eliminated from it, J W^-1 J'; `rests` what they left of it where the row follows from them; `tied` the
    other multipliers that take part in a solved one."""

    def __init__(self, rows: Rows) -> None:
        self.following = {multiplier_of(row.index): None for row in rows.following}
        self._waiting, self._open = _waiting(rows)
        self.sizes: dict[int, int] = {}
        self.rests: dict[int, int] = {}
        self.tied: dict[int, dict[int, int]] = {}

    def complete_after(self, variable: int) -> Iterator[int]:
        """Multipliers for whose pivot `variable` was the last that had to be eliminated."""
        for multiplier in self._waiting.get(variable, ()):
            self._open[multiplier] -= 1
            if not self._open[multiplier]:
                yield multiplier

    def enlarge(self, graph: Graph, row: Mapping[int, int], shares: Mapping[int, int]) -> None:
        """The sizes, by what the elimination of a rate with this row adds to them."""
        for k, share in shares.items():
            if is_multiplier(k):
                own = graph.multiply(row[k], share)
                self.sizes[k] = graph.add(self.sizes.get(k, graph.zero), own)


def _waiting(rows: Rows) -> tuple[dict[int, list[int]], dict[int, int]]:
    """Multipliers by the rates and multipliers that are eliminated before them; and how many these are."""
    waiting: dict[int, list[int]] = {}
    solved = {row.index: None for row in rows.solved}
    for group in components((*rows.solved, *rows.following)):
        first = [multiplier_of(row.index) for row in group if row.index in solved]
        for row in group:
            for variable in (*row.terms, *(() if row.index in solved else first)):
                waiting.setdefault(variable, []).append(multiplier_of(row.index))
    counts: dict[int, int] = {}
    for multipliers in waiting.values():
        for multiplier in multipliers:
            counts[multiplier] = counts.get(multiplier, 0) + 1
    return waiting, counts
