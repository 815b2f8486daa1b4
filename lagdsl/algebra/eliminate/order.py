"""Elimination in order of depth, the deepest velocities first.

With the rates as soon as nothing uses them any more this is the articulated-body recursion (Featherstone, *Rigid Body
Dynamics Algorithms*, 2008, ch. 7), with all rates at the end the composite-body one with a factorization that keeps the
sparsity of branches (ch. 6 and 8 there).

Neither is written here: they are two orders of the same elimination.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from heapq import heappop, heappush

from lagdsl.algebra.eliminate.count import Budget
from lagdsl.algebra.eliminate.definitions import Definitions
from lagdsl.algebra.eliminate.form import NotApplicable
from lagdsl.algebra.eliminate.matrix import SparseSystem
from lagdsl.algebra.eliminate.multipliers import Multipliers
from lagdsl.algebra.eliminate.rotations import Rotation, Turns
from lagdsl.algebra.eliminate.rows import Rows, is_multiplier
from lagdsl.algebra.eliminate.steps import Defined, Exchanged, Pivoted, Step
from lagdsl.algebra.graph.graph import Graph
from lagdsl.foundation.record import record


@record(kw_only=True)
class Order:
    """Variables by least `priority` as soon as nothing uses them, `rates` at once, those that are `delayed` last."""

    rates: Sequence[int]
    priority: Mapping[int, tuple[int, int]]
    delayed: frozenset[int] = frozenset()


class Elimination:
    """One order, with multipliers of solved rows as soon as the last rate that the row uses is eliminated.

    `steps` are what solving has to take back.
    """

    def __init__(
        self, system: SparseSystem, definitions: Definitions, order: Order, budget: Budget, rows: Rows | None = None
    ) -> None:
        self._graph: Graph = system.graph
        self._system, self._terms = system, definitions.terms
        self._order, self._budget = order, budget
        self._left = dict.fromkeys((*order.rates, *definitions.terms), 0)
        for terms in definitions.terms.values():
            for p in terms:
                self._left[p] += 1
        self._turns = Turns(definitions.rotations, order.priority)
        self.multipliers = Multipliers(rows or Rows())
        self._heap: list[tuple[tuple[int, int], int]] = []
        self.steps: list[Step] = []

    def run(self) -> list[Step]:
        """Raises NotApplicable where a coordinate has no inertia, and TooMany."""
        for variable in (*self._terms, *self._order.rates):
            if not self._left[variable]:
                self._release(variable)
        while self._heap or self._turns.ready:
            self._budget.check()
            if self._heap:
                self._eliminate(heappop(self._heap)[1])
            else:
                self._turn([self._turns.take_some()])
        for rate in reversed(self._order.rates):
            if rate in self._order.delayed:
                self._budget.check()
                self._minimize(rate)
        return self.steps

    def _release(self, variable: int) -> None:
        """Nothing uses `variable` any more."""
        if variable in self._turns:
            if self._turns.release(variable):
                heappush(self._heap, (self._order.priority[variable], variable))
        elif variable in self._terms:
            heappush(self._heap, (self._order.priority[variable], variable))
        elif variable not in self._order.delayed:
            self._minimize(variable)

    def _eliminate(self, variable: int) -> None:
        if variable in self._turns:
            self._turn(self._turns.group(variable))
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
            if alone and p not in self._order.delayed and self._graph.is_constant(factor):
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
            self.multipliers.tied[variable] = {k: share for k, share in shares.items() if is_multiplier(k)}
        else:
            self.multipliers.enlarge(self._graph, row, shares)
        following = self.multipliers.following
        acting = {k: share for k, share in shares.items() if k not in following} if following else shares
        self.steps.append(Pivoted(variable, pivot, acting))
        for multiplier in self.multipliers.complete_after(variable if rate is None else rate):
            if multiplier in following:
                self.multipliers.rests[multiplier] = self._graph.negate(system.pivot(multiplier))
                system.take(multiplier)
            else:
                self._minimize(multiplier)


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
