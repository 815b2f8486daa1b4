"""Elimination in order of depth, the deepest velocities first.

With the rates as soon as nothing uses them any more this is the articulated-body recursion (Featherstone, *Rigid Body
Dynamics Algorithms*, 2008, ch. 7), with all rates at the end the composite-body one with a factorization that keeps the
sparsity of branches (ch. 6 and 8 there).

Neither is written here: they are two orders of the same elimination.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from heapq import heappop, heappush

from lagdsl.eliminate.definitions import Definitions
from lagdsl.eliminate.form import NotApplicable
from lagdsl.eliminate.matrix import SparseSystem
from lagdsl.eliminate.rotations import Rotation
from lagdsl.graph.graph import Graph
from lagdsl.record import record


@record()
class Defined:
    """The variable follows from its definition."""

    variable: int


@record()
class Minimized:
    """a = u - sum of shares times others, with u by right-hand side; `pivot` is what was divided by."""

    variable: int
    pivot: int
    shares: dict[int, int]
    parts: list[int]


@record()
class Swapped:
    """A rate that follows from the variable it alone makes free: variable = rest + factor * rate."""

    rate: int
    variable: int
    factor: int


Step = Defined | Minimized | Swapped


class Elimination:
    """One order: variables by least `priority` as soon as nothing uses them, rates at once, `delayed` ones last.

    `steps` are what solving has to take back.
    """

    def __init__(
        self,
        system: SparseSystem,
        definitions: Definitions,
        rates: Sequence[int],
        *,
        priority: Mapping[int, tuple[int, int]],
        delayed: Container[int] = (),
    ) -> None:
        self._graph: Graph = system.graph
        self._system, self._terms = system, definitions.terms
        self._rates, self._delayed = rates, delayed
        self._left = dict.fromkeys((*rates, *definitions.terms), 0)
        self._priority = priority
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
        self._ready: dict[int, None] = {}
        self._heap: list[tuple[tuple[int, int], int]] = []
        self.steps: list[Step] = []

    def run(self) -> list[Step]:
        """Raises NotApplicable where a coordinate has no inertia."""
        for variable in (*self._terms, *self._rates):
            if not self._left[variable]:
                self._release(variable)
        while self._heap or self._ready:
            if self._heap:
                self._eliminate(heappop(self._heap)[1])
            else:
                self._turn_some()
        for rate in reversed(self._rates):
            if rate in self._delayed:
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
            alone = p not in self._terms and self._left[p] == 1 and not self._system.rows.get(p)
            if alone and p not in self._delayed and self._graph.is_constant(factor):
                return p
        return None

    def _swap(self, variable: int, rate: int) -> None:
        graph, system, terms = self._graph, self._system, self._terms[variable]
        factor = terms[rate]
        for index, side in enumerate(system.take_sides(rate)):
            moved = graph.divide(side, factor)
            system.add_side(index, variable, moved)
            for p, c in terms.items():
                if p != rate:
                    system.add_side(index, p, graph.negate(graph.multiply(c, moved)))
        self.steps.append(Swapped(rate, variable, factor))
        self._minimize(variable)

    def _minimize(self, variable: int) -> None:
        pivot = self._system.pivot(variable)
        if pivot == self._graph.zero:
            raise NotApplicable
        self.steps.append(Minimized(variable, pivot, *self._system.minimize(variable)))


def by_creation(definitions: Definitions, rates: Sequence[int]) -> dict[int, tuple[int, int]]:
    """What was written last comes first."""
    return {variable: (-variable, 0) for variable in (*rates, *definitions.terms)}


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


def back_substitute(graph: Graph, definitions: Definitions, steps: Sequence[Step], sides: int) -> list[dict[int, int]]:
    """Accelerations of all variables for each right-hand side, the last step first."""
    found: list[dict[int, int]] = [{} for _ in range(sides)]
    for step in reversed(steps):
        for index, known in enumerate(found):
            match step:
                case Minimized(variable, _, shares, parts):
                    known[variable] = graph.subtract(parts[index], _sum(graph, shares, known))
                case Defined(variable):
                    known[variable] = _sum(graph, definitions.terms[variable], known)
                case Swapped(rate, variable, factor):
                    others = {p: c for p, c in definitions.terms[variable].items() if p != rate}
                    rest = graph.subtract(known[variable], _sum(graph, others, known))
                    known[rate] = graph.divide(rest, factor)
    return found


def _sum(graph: Graph, terms: Mapping[int, int], known: Mapping[int, int]) -> int:
    return graph.sum(graph.multiply(c, known[p]) for p, c in terms.items())
