"""Elimination in order of depth, the deepest velocities first.

With the rates as soon as nothing uses them any more this is the articulated-body recursion (Featherstone, *Rigid Body
Dynamics Algorithms*, 2008, ch. 7), with all rates at the end the composite-body one with a factorization that keeps the
sparsity of branches (ch. 6 and 8 there).

Neither is written here: they are two orders of the same elimination.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from heapq import heappop, heappush

from lagdsl.eliminate.count import Budget
from lagdsl.eliminate.definitions import Definitions
from lagdsl.eliminate.form import NotApplicable
from lagdsl.eliminate.matrix import SparseSystem
from lagdsl.eliminate.rotations import Rotation
from lagdsl.eliminate.rows import Rows, components, is_multiplier, multiplier_of
from lagdsl.eliminate.steps import Defined, Exchanged, Pivoted, Step
from lagdsl.graph.graph import Graph


class Elimination:
    """One order: variables by least `priority` as soon as nothing uses them, rates at once, `delayed` ones last, and
    multipliers of solved rows as soon as the last rate that the row uses is eliminated.

    `steps` are what solving has to take back. By multiplier: `sizes` are what its pivot was before others were
    eliminated from it, J W^-1 J'; `rests` what they left of it where the row follows from them; `tied` the other
    multipliers that take part in a solved one.
    """

    def __init__(
        self,
        system: SparseSystem,
        definitions: Definitions,
        rates: Sequence[int],
        *,
        priority: Mapping[int, tuple[int, int]],
        budget: Budget,
        delayed: Container[int] = (),
        rows: Rows | None = None,
    ) -> None:
        self._graph: Graph = system.graph
        self._system, self._terms = system, definitions.terms
        self._rates, self._delayed = rates, delayed
        self._left = dict.fromkeys((*rates, *definitions.terms), 0)
        self._priority, self._budget = priority, budget
        for terms in definitions.terms.values():
            for p in terms:
                self._left[p] += 1
        self._rotation: dict[int, Rotation] = {v: r for r in definitions.rotations for v in r.after}
        self._group: dict[int, list[Rotation]] = {}
        groups: dict[tuple[int, int], list[Rotation]] = {}
        for rotation in definitions.rotations:
            group = groups.setdefault((rotation.cosine, rotation.sine), [])
            group.append(rotation)
            for v in rotation.after:
                self._group[v] = group
        rows = rows or Rows()
        self._following = {multiplier_of(row.index): None for row in rows.following}
        self._waiting, self._open = _waiting(rows)
        self.sizes: dict[int, int] = {}
        self.rests: dict[int, int] = {}
        self.tied: dict[int, dict[int, int]] = {}
        self._ready: dict[int, None] = {}
        self._heap: list[tuple[tuple[int, int], int]] = []
        self.steps: list[Step] = []

    def run(self) -> list[Step]:
        """Raises NotApplicable where a coordinate has no inertia, and TooMany."""
        for variable in (*self._terms, *self._rates):
            if not self._left[variable]:
                self._release(variable)
        while self._heap or self._ready:
            self._budget.check()
            if self._heap:
                self._eliminate(heappop(self._heap)[1])
            else:
                self._turn_some()
        for rate in reversed(self._rates):
            if rate in self._delayed:
                self._budget.check()
                self._minimize(rate)
        return self.steps

    def _release(self, variable: int) -> None:
        """Nothing uses `variable` any more."""
        if variable in self._group:
            self._ready[variable] = None
            group = self._group[variable]
            if all(v in self._ready for rotation in group for v in rotation.after):
                for rotation in group:
                    for v in rotation.after:
                        del self._ready[v]
                heappush(self._heap, (self._priority[variable], variable))
        elif variable in self._terms:
            heappush(self._heap, (self._priority[variable], variable))
        elif variable not in self._delayed:
            self._minimize(variable)

    def _eliminate(self, variable: int) -> None:
        if variable in self._group:
            self._turn(self._group[variable])
            return
        rate = self._free_rate(variable)
        if rate is not None:
            self._swap(variable, rate)
        else:
            self._system.substitute(variable, self._terms[variable])
            self.steps.append(Defined(variable))
        self._settle(variable, rate)

    def _settle(self, variable: int, done: int | None = None) -> None:
        for p in self._terms[variable]:
            self._left[p] -= 1
            if not self._left[p] and p != done:
                self._release(p)

    def _turn_some(self) -> None:
        """Pairs whose group waits for one that waits for them: turned by themselves."""
        waiting = [self._rotation[v] for v in self._ready if v == self._rotation[v].after[0]]
        complete = [r for r in waiting if r.after[1] in self._ready]
        rotation = min(complete, key=lambda r: (self._priority[r.after[0]], r.after))
        self._group[rotation.after[0]].remove(rotation)
        for v in rotation.after:
            del self._ready[v]
        self._turn([rotation])

    def _turn(self, group: Sequence[Rotation]) -> None:
        self._system.rotate(group)
        self.steps += [Defined(v) for rotation in group for v in rotation.after]
        for rotation in group:
            for v in rotation.after:
                self._settle(v)

    def _free_rate(self, variable: int) -> int | None:
        """A rate that only `variable` uses, by a constant: varying it is varying `variable`."""
        if self._system.pivot(variable) == self._graph.zero:
            return None
        for p, factor in self._terms[variable].items():
            alone = p not in self._terms and self._left[p] == 1 and self._weighs_nothing(p)
            if alone and p not in self._delayed and self._graph.is_constant(factor):
                return p
        return None

    def _weighs_nothing(self, rate: int) -> bool:
        return all(is_multiplier(k) for k in self._system.rows.get(rate, ()))

    def _swap(self, variable: int, rate: int) -> None:
        graph, terms = self._graph, self._terms[variable]
        factor = terms[rate]
        shared = {p: graph.negate(graph.divide(c, factor)) for p, c in terms.items() if p != rate}
        self._system.substitute(rate, {variable: graph.divide(graph.one, factor), **shared})
        self.steps.append(Exchanged(rate, variable, factor))
        self._minimize(variable, rate)

    def _minimize(self, variable: int, rate: int | None = None) -> None:
        """Eliminate by its own equation; `rate`: the rate that is done with it, where it is another one."""
        system = self._system
        pivot = system.pivot(variable)
        if pivot == self._graph.zero:
            raise NotApplicable
        row = dict(system.rows[variable])
        shares = system.minimize(variable)
        if is_multiplier(variable):
            self.tied[variable] = {k: share for k, share in shares.items() if is_multiplier(k)}
        else:
            self._enlarge(row, shares)
        acting = {k: share for k, share in shares.items() if k not in self._following} if self._following else shares
        self.steps.append(Pivoted(variable, pivot, acting))
        for multiplier in self._waiting.get(variable if rate is None else rate, ()):
            self._open[multiplier] -= 1
            if not self._open[multiplier]:
                self._complete(multiplier)

    def _complete(self, multiplier: int) -> None:
        """Everything that its pivot is made from is eliminated."""
        if multiplier not in self._following:
            self._minimize(multiplier)
            return
        self.rests[multiplier] = self._graph.negate(self._system.pivot(multiplier))
        self._system.take(multiplier)

    def _enlarge(self, row: Mapping[int, int], shares: Mapping[int, int]) -> None:
        graph = self._graph
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


def by_creation(definitions: Definitions, rates: Sequence[int]) -> dict[int, tuple[int, int]]:
    """Rows come first, then what was written last."""
    return {variable: (int(variable >= 0), -variable) for variable in (*rates, *definitions.terms)}


def by_depth(definitions: Definitions, rates: Sequence[int]) -> dict[int, tuple[int, int]]:
    """The least is the deepest: by what the last rate that a variable depends on still moves, then by the way to it.

    Not by the length of the way alone: velocities that are turned at every joint would all be deeper than the angular
    ones, and be eliminated before those, which fills the matrix.
    """
    heights = dict.fromkeys((*rates, *definitions.terms), 0)
    for variable in reversed(definitions.terms):
        for p in definitions.terms[variable]:
            heights[p] = max(heights[p], heights[variable] + 1)
    depths = {rate: (heights[rate], 0) for rate in rates}
    for variable, terms in definitions.terms.items():
        known = [depths[p] for p in terms]
        least = min((height for height, _ in known), default=0)
        depths[variable] = least, min((length for _, length in known), default=0) - 1
    return depths
