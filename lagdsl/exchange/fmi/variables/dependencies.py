"""Dependencies of an exported model, from the structure of its equations: never less, no more than their structure.

Outputs, named values and rates of states are functions of the graph; accelerations and multipliers are solutions of
the equations of motion, whose blocks say which of them a force reaches. Derivatives of rates are pulled towards the
constraints, everything else follows from the accelerations of the model. Discretes are held.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TypeAlias, assert_never

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.exchange.fmi.variables.scalar import Role
from lagdsl.foundation.record import record
from lagdsl.motion.analysis.sparsity.accelerations import Accelerations, bits_of
from lagdsl.motion.analysis.sparsity.dependency_pruning import pruned_dependencies
from lagdsl.motion.analysis.sparsity.influence import NONE, Influence, Influences, Kind, kind_of, only, raised, union

# A number of an exported model: entry `index` of the array that its role names (lag/fmu.h).
Entry: TypeAlias = tuple[Role, int]
Row: TypeAlias = tuple[tuple[Entry, Kind], ...]

_GROUPS = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.P, Group.W, Group.QDD, Group.LAMBDA)


@record(kw_only=True)
class Dependencies:
    """By unknown: derivatives, outputs, named values, multipliers, energies, residuals, indicators.

    `moving`: on states, inputs, parameters, discretes and time, each with its kind. `initial`: the same until
    initialization ends, where states and free parameters are unknowns, too; states whose start values are given are
    knowns.
    """

    moving: Mapping[Entry, Row]
    initial: Mapping[Entry, Row]


def dependencies(program: Program, free: Collection[int] = ()) -> Dependencies:
    """Of a program with all its named values, of which initialization finds the parameters `free`. The cost is about
    that of one pass over the graph."""
    return _Search(program, free).found()


class _Search:
    def __init__(self, program: Program, free: Collection[int]) -> None:
        self._free = [(Role.PARAMETER, index) for index in sorted(free)]
        self._program, graph = program, program.graph
        self._entries: list[Entry] = []
        bits: dict[int, int] = {}
        for group in _GROUPS:
            for index in range(program.layout.size(group)):
                bits[graph.symbol(group, index)] = 1 << len(self._entries)
                self._entries.append(self._entry(group, index))
        roots = [node for f in program.functions for block in f.results for node in block.elements]
        absent = pruned_dependencies(program)
        self._influences = Influences(graph, roots, bits, absent.derivatives)
        self._bit = {entry: 1 << position for position, entry in enumerate(self._entries)}
        first = len(self._entries) - program.layout.size(Group.QDD) - program.layout.size(Group.LAMBDA)
        self._solution = Accelerations(program, self._influences, first, absent.factors, pulled=False)
        self._pulled = self._solution
        if program.layout.constraints:
            self._pulled = Accelerations(program, self._influences, first, absent.factors, pulled=True)

    def _entry(self, group: Group, index: int) -> Entry:
        n = len(self._program.layout.coordinates)
        match group:
            case Group.Q:
                return Role.STATE, index
            case Group.QD:
                return Role.STATE, n + index
            case Group.Z:
                return Role.STATE, 2 * n + index
            case Group.U:
                return Role.INPUT, index
            case Group.P:
                return Role.PARAMETER, index
            case Group.W:
                return Role.DISCRETE, index
            case Group.QDD:
                return Role.DERIVATIVE, n + index
            case Group.LAMBDA:
                return Role.MULTIPLIER, index
            case Group.TIME:
                return Role.TIME, index
            case (
                Group.DIRECTION_Q
                | Group.DIRECTION_QD
                | Group.DIRECTION_Z
                | Group.DIRECTION_U
                | Group.DIRECTION_QDD
                | Group.DIRECTION_LAMBDA
                | Group.DIRECTION_P
                | Group.RELEASE
                | Group.RELEASE_RATE
            ):
                raise AssertionError(f"{group.name} is an argument of no function of an FMU")
            case _:
                assert_never(group)

    def found(self) -> Dependencies:
        moving = {entry: self._of_loads(influence) for entry, influence in self._unknowns().items()}
        starts = self._starts()
        initial = {entry: self._from_starts(influence, starts) for entry, influence in moving.items()}
        initial |= {entry: self._from_starts(self._own(entry), starts) for entry in starts}
        return Dependencies(
            moving={entry: self._row(influence) for entry, influence in moving.items()},
            initial={entry: self._row(influence) for entry, influence in initial.items()},
        )

    def _of_loads(self, influence: Influence) -> Influence:
        """With everything in the place of loads that depend on the accelerations that they cause."""
        kinds = self._program.layout.kinds
        loads = self._bits_of((Role.DISCRETE, index) for index, kind in enumerate(kinds) if kind == "load")
        if not influence[0] & loads:
            return influence
        known = (Role.STATE, Role.INPUT, Role.PARAMETER, Role.TIME, Role.DISCRETE)
        every = self._bits_of(entry for entry in self._entries if entry[0] in known) & ~loads
        return raised((influence[0] & ~loads | every, 0, 0, 0), Kind.DEPENDENT)

    def _own(self, entry: Entry) -> Influence:
        return (self._bit[entry], 0, 0, 0)

    def _row(self, influence: Influence) -> Row:
        return tuple((self._entries[bit], kind_of(influence, 1 << bit)) for bit in bits_of(influence[0]))

    # ---- while it moves ----------------------------------------------------------------------------------------------

    def _unknowns(self) -> dict[Entry, Influence]:
        n, solution = len(self._program.layout.coordinates), self._solution
        found = {(Role.DERIVATIVE, i): self._own((Role.STATE, n + i)) for i in range(n)}
        found |= {(Role.DERIVATIVE, n + i): self._pulled.solved[i] for i in range(n)}
        found |= self._values(Role.DERIVATIVE, "state_derivative", 0, 2 * n)
        found |= self._values(Role.OUTPUT, "output", 0)
        found |= self._values(Role.LOCAL, "definition", 0)
        found |= {(Role.MULTIPLIER, k): solution.solved[n + k] for k in range(solution.m)}
        for index in range(3):
            found |= self._values(Role.ENERGY, "energies", index, index)
        for index, function in enumerate(("position_constraint", "velocity_constraint")):
            total = self._influences.of_all(self._program.function(function).results[0].elements)
            found[(Role.RESIDUAL, index)] = raised(total, Kind.DEPENDENT)
        return found | self._indicators()

    def _values(self, role: Role, function: str, block: int, first: int = 0) -> dict[Entry, Influence]:
        elements = self._program.function(function).results[block].elements
        resolve, influences = self._solution.resolve, self._influences
        return {(role, first + index): resolve(influences[node]) for index, node in enumerate(elements)}

    def _indicators(self) -> dict[Entry, Influence]:
        """Of relations; of contacts, that open as a multiplier tells and close as a gap or a rate does; of friction,
        whose limits are compared with its force, and which comes to rest as its slip does."""
        if not self._program.has("indicator"):
            return {}
        found = self._values(Role.INDICATOR, "indicator", 0)
        count, n = len(found), len(self._program.layout.coordinates)
        instants = self._program.layout.instants
        gaps, rates = (block.elements for block in self._program.function("contact").results[:2])
        for contact, row in enumerate(instants.contact_rows):
            one_way = contact < len(instants.one_way) and instants.one_way[contact]
            gap = self._influences[(rates if one_way else gaps)[contact]]
            found[(Role.INDICATOR, count + contact)] = union(gap, self._solution.solved[n + row])
        count += len(instants.contact_rows)
        return found | {(Role.INDICATOR, count + friction): row for friction, row in enumerate(self._frictions())}

    def _frictions(self) -> Iterator[Influence]:
        """Of each friction, what it is compared with: its slip, its limit, its force, and forces that share a load."""
        if not self._program.has("friction"):
            return
        instants, n = self._program.layout.instants, len(self._program.layout.coordinates)
        slips, _, _, sticking, *_ = (block.elements for block in self._program.function("friction").results)
        forces = NONE
        for row in (*instants.contact_rows, *instants.friction_rows):
            forces = union(forces, self._solution.solved[n + row])
        first = 0
        for friction, components in enumerate(instants.friction_slips):
            nodes = (*slips[first : first + components], sticking[friction])
            total = union(self._solution.resolve(self._influences.of_all(nodes)), forces)
            yield raised(total, Kind.DEPENDENT)
            first += components

    # ---- until initialization ends -----------------------------------------------------------------------------------

    def _starts(self) -> dict[Entry, Influence]:
        """Dependencies of the start values of the states. If constraints or initial equations move them, each of these
        depends on everything that any of them reads, and so does each free parameter; nothing depends on its guess."""
        blocks = self._program.function("start").results[:3]
        nodes = [node for block in blocks for node in block.elements]
        known = ~self._bits_of(self._free)
        starts = {(Role.STATE, index): only(self._influences[node], known) for index, node in enumerate(nodes)}
        asked = self._conditions()
        if not asked[0]:
            return starts
        states = [entry for entry in starts if asked[0] & self._bit[entry]]
        n = len(self._program.layout.coordinates)
        places = {entry[1] % n for entry in states if entry[1] < 2 * n}
        coupled = [entry for entry in starts if entry in states or (entry[1] < 2 * n and entry[1] % n in places)]
        for entry in coupled:
            asked = union(asked, union(starts[entry], self._own(entry)))
        asked = raised(only(asked, known & ~self._bits(Role.DISCRETE)), Kind.DEPENDENT)
        return starts | dict.fromkeys([*coupled, *self._free], asked)

    def _conditions(self) -> Influence:
        """Arguments of constraints and initial equations."""
        program, total = self._program, NONE
        for function in ("position_constraint", "velocity_constraint", "initial_equation"):
            total = union(total, self._influences.of_all(program.function(function).results[0].elements))
        if total[0] and program.has("mass_matrix"):
            total = union(total, self._influences.of_all(program.function("mass_matrix").results[0].elements))
        return self._solution.resolve(total)

    def _bits(self, role: Role) -> int:
        return self._bits_of(entry for entry in self._bit if entry[0] is role)

    def _bits_of(self, entries: Iterable[Entry]) -> int:
        return sum(self._bit[entry] for entry in entries)

    def _from_starts(self, influence: Influence, starts: Mapping[Entry, Influence]) -> Influence:
        """States and free parameters followed back to what their values at the start depend on."""
        total = influence
        for bit in bits_of(influence[0] & (self._bits(Role.STATE) | self._bits_of(self._free))):
            total = union(total, raised(starts[self._entries[bit]], kind_of(influence, 1 << bit)))
        return total
