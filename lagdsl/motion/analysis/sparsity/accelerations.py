"""Dependence of accelerations and multipliers: the blocks of M qdd - J'lam = f, J qdd = gamma."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.numerics.disjoint_sets import DisjointSets
from lagdsl.motion.analysis.sparsity.coupling import components, matching
from lagdsl.motion.analysis.sparsity.influence import NONE, Influence, Influences, Kind, kind_of, only, raised, union


class Accelerations:
    """The influence of known symbols on each unknown: qdd, then lam.

    Equations are r, then s of the function `residual`, with the pull towards the constraints in s if they are `pulled`.
    Rows that depend on others, or that events switch, may or may not decide: what they touch depends on all that any
    choice would give.
    """

    def __init__(
        self, program: Program, influences: Influences, first: int, zeros: frozenset[int], *, pulled: bool
    ) -> None:
        """`first` is the bit of the first unknown; the others follow. `zeros` are elements of M and J that vanish."""
        self._program, self._found, self._first = program, influences, first
        self._zeros = zeros | {program.graph.zero}
        layout = program.layout
        self.n, self.m = len(layout.coordinates), len(layout.constraints)
        self._mask = ((1 << (self.n + self.m)) - 1) << first
        self._equations = [self._equation(e, pulled) for e in range(self.n + self.m)]
        self._occurring = [[bit - first for bit in bits_of(e[0] & self._mask)] for e in self._equations]
        self.solved = self._solve()

    def resolve(self, influence: Influence) -> Influence:
        """Accelerations and multipliers replaced by what they depend on."""
        total = only(influence, ~self._mask)
        for bit in bits_of(influence[0] & self._mask):
            total = union(total, raised(self.solved[bit - self._first], kind_of(influence, 1 << bit)))
        return total

    # ---- the equations -----------------------------------------------------------------------------------------------

    def _equation(self, number: int, pulled: bool) -> Influence:
        """Of one equation: as it is evaluated, and no more than the matrices that it is made of allow."""
        program, found = self._program, self._found
        motion, rows = program.function("residual").results
        own = found[(*motion.elements, *rows.elements)[number]]
        if program.has("dynamics"):
            other = self._formed(number)
            own = (own[0] & other[0], own[1] & other[1], own[2] & other[2], own[3] & other[3])
        if number >= self.n and pulled:
            for function in ("position_constraint", "velocity_constraint"):
                own = union(own, found[program.function(function).results[0].elements[number - self.n]])
        return own

    def _formed(self, number: int) -> Influence:
        """From M and f, or J and gamma."""
        mass, force, jacobian, gamma = (block.elements for block in self._program.function("dynamics").results)
        n, row = self.n, number - self.n
        if row < 0:
            factors = {j: mass[number * n + j] for j in range(n)}
            factors |= {n + k: jacobian[k * n + number] for k in range(self.m)}
        else:
            factors = {j: jacobian[row * n + j] for j in range(n)}
        total = self._found[force[number] if row < 0 else gamma[row]]
        for unknown, node in factors.items():
            if node not in self._zeros:
                own = self._found[node]
                kind = _kind(self._program.graph, node)
                total = union(total, union(raised(own, Kind.DEPENDENT), self._unknown(unknown, kind)))
        return total

    def _unknown(self, number: int, kind: Kind) -> Influence:
        return raised((1 << (self._first + number), 0, 0, 0), kind)

    # ---- their solution ----------------------------------------------------------------------------------------------

    def _solve(self) -> list[Influence]:
        size = self.n + self.m
        loose = self._loose_rows()
        equations = [
            [number] if number in loose else [unknown for unknown in occurring if unknown not in loose]
            for number, occurring in enumerate(self._occurring)
        ]
        match = _completed(matching(equations, size), size)
        owner = {unknown: equation for equation, unknown in enumerate(match)}
        successors = [[owner[unknown] for unknown in occurring] for occurring in self._occurring]
        for group in self._groups_of_rows():
            members = [*(self.n + row for row in group), *(owner[self.n + row] for row in group)]
            for one, other in zip(members, [*members[1:], members[0]], strict=True):
                successors[one].append(other)
        solved = [NONE] * size
        for members in components(successors):
            together = self._component(members, match, solved)
            for equation in members:
                solved[match[equation]] = together
        return [solution if self._exists(number) else NONE for number, solution in enumerate(solved)]

    def _component(self, members: Sequence[int], match: Sequence[int], solved: Sequence[Influence]) -> Influence:
        own = {match[equation] for equation in members}
        total, hardest = NONE, Kind.CONSTANT
        for equation in members:
            influence = self._equations[equation]
            total = union(total, only(influence, ~self._mask))
            for unknown in self._occurring[equation]:
                kind = kind_of(influence, 1 << (self._first + unknown))
                if unknown in own:
                    hardest = max(hardest, kind)
                else:
                    total = union(total, raised(solved[unknown], kind))
        return raised(total, hardest)

    def _exists(self, unknown: int) -> bool:
        """Multipliers of rows that restrict nothing are zero."""
        return unknown < self.n or any(other < self.n for other in self._occurring[unknown])

    def _loose_rows(self) -> frozenset[int]:
        """Numbers of the equations of rows that may have no part in the solution."""
        graph, redundant = self._program.graph, self._program.layout.redundant
        _, rows = self._program.function("residual").results
        switched = (graph.depends(node, Group.W) for node in rows.elements)
        flags = (one or other for one, other in zip(redundant, switched, strict=True))
        empty = (not any(unknown < self.n for unknown in self._occurring[self.n + row]) for row in range(self.m))
        return frozenset(
            self.n + row for row, (loose, none) in enumerate(zip(flags, empty, strict=True)) if loose or none
        )

    def _groups_of_rows(self) -> Iterator[list[int]]:
        """Rows that share coordinates, where one depends on the others: multipliers of least length mix them."""
        groups = DisjointSets(range(self.m))
        first_row: dict[int, int] = {}
        for row in range(self.m):
            for unknown in self._occurring[self.n + row]:
                if unknown < self.n:
                    groups.join(row, first_row.setdefault(unknown, row))
        redundant = self._program.layout.redundant
        return (rows for rows in groups.all() if len(rows) > 1 and any(redundant[row] for row in rows))


def bits_of(number: int) -> Iterator[int]:
    """Positions of the ones, ascending."""
    while number:
        lowest = number & -number
        yield lowest.bit_length() - 1
        number ^= lowest


def _completed(match: list[int], size: int) -> list[int]:
    """An unknown without a partner gets a free one: the system is singular, and any choice will do."""
    free = iter(sorted(set(range(size)) - set(match)))
    return [next(free) if unknown < 0 else unknown for unknown in match]


def _kind(graph: Graph, node: int) -> Kind:
    """Effect of a factor on the dependence of its product."""
    if graph.op[node] is Op.CONSTANT:
        return Kind.CONSTANT
    if not graph.depends(node, *(group for group in Group if group is not Group.P)):
        return Kind.PARAMETER
    events_only = not graph.depends(node, *(group for group in Group if group not in (Group.P, Group.W)))
    return Kind.DISCRETE if events_only else Kind.DEPENDENT
