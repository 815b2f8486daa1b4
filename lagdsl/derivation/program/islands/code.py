"""The functions of one island as instructions, which are equal for islands that differ in numbers only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagdsl.algebra.graph.graph import ZERO, Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.derivation.program.islands.partition import AXIS_OF, NUMBERS, OF_STARTS, Island, Partition
from lagdsl.derivation.program.islands.shares import SUMMED, Shares, Term, shares
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.record import record

_SHARED = (Group.P, Group.DIRECTION_P, Group.U, Group.DIRECTION_U)

# An operation with the numbers of the instructions that it is computed from; a symbol with its group and place; a
# constant.
Instruction = tuple[int, ...]


@record()
class Code:
    """`constants` are those of the instructions that are constants, in their order. `roots` are the results of all
    functions, `shapes` their shapes. `parameters` and `inputs` are the places of those that are read."""

    instructions: tuple[Instruction, ...]
    roots: tuple[tuple[tuple[int, ...], ...], ...]
    shapes: tuple[tuple[tuple[int, ...], ...], ...]
    constants: tuple[float, ...]
    parameters: tuple[int, ...]
    inputs: tuple[int, ...]


class Coder:
    """Writes the code of each island of one program.

    Raises NotSeparable.
    """

    def __init__(self, program: Program, parts: Partition) -> None:
        self._program, self._parts = program, parts
        self._shares = shares(program, parts)
        self._entries = {each.name: [dict(block.entries) for block in each.results] for each in program.functions}

    def code(self, number: int) -> Code:
        """Of the island of this number."""
        own = _Writer(self._program.graph, self._parts.islands[number], self._shares[number])
        found = {}
        # The start tells all inputs: it comes when it is known which the others read.
        for function in sorted(self._program.functions, key=lambda each: each.name == "start"):
            results = BY_NAME[function.name].results
            found[function.name] = [
                own.block(function.name, result.name, result.shape, entries, block.shape)
                for result, block, entries in zip(results, function.results, self._entries[function.name], strict=True)
            ]
        blocks = [found[function.name] for function in self._program.functions]
        return Code(
            tuple(own.instructions),
            tuple(tuple(nodes for _, nodes in each) for each in blocks),
            tuple(tuple(shape for shape, _ in each) for each in blocks),
            tuple(own.constants),
            tuple(own.shared[Group.P]),
            tuple(own.shared[Group.U]),
        )


class _Writer:
    """The instructions of one island so far."""

    def __init__(self, graph: Graph, island: Island, shares: Shares) -> None:
        self._graph, self._island, self._shares = graph, island, shares
        self._local = {axis: {p: k for k, p in enumerate(own.tolist())} for axis, own in island.places.items()}
        self._known: dict[int, int] = {}
        self.instructions: list[Instruction] = []
        self.constants: list[float] = []
        self.shared: dict[Group, dict[int, int]] = {Group.P: {}, Group.U: {}}

    def block(
        self, function: str, result: str, axes: tuple[str, ...], entries: Mapping[int, int], shape: tuple[int, ...]
    ) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The shape of the part of a result that belongs to the island, and its instructions."""
        if not axes:
            return (), (self._share(self._shares.get((function, result), ()), summed=function in SUMMED),)
        if function in OF_STARTS:
            return (0,), ()
        places = [self._places(axis) for axis in axes]
        if len(axes) == 1:
            nodes = [entries.get(place, ZERO) for place in places[0]]
        else:
            nodes = [entries.get(row * shape[1] + column, ZERO) for row in places[0] for column in places[1]]
        if (function, result) in NUMBERS:
            local = self._local[NUMBERS[function, result]]
            return (len(nodes),), tuple(self._constant(float(local[int(self._graph.value[n])])) for n in nodes)
        return tuple(len(each) for each in places), tuple(self._of(node) for node in nodes)

    def _places(self, axis: str) -> Sequence[int]:
        return list(self.shared[Group.U]) if axis == "nu" else self._island.places[axis].tolist()

    def _add(self, *instruction: int) -> int:
        self.instructions.append(instruction)
        return len(self.instructions) - 1

    def _constant(self, value: float) -> int:
        """Each by itself: where islands differ in one of them, others of the same value may not."""
        self.constants.append(value)
        return self._add(Op.CONSTANT)

    def _of(self, root: int) -> int:
        """The number of the instruction of a node that depends on the island alone."""
        graph, known = self._graph, self._known
        if graph.op[root] is Op.CONSTANT:
            return self._constant(graph.value[root])
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known:
                stack.pop()
                continue
            operands = graph.operands[node]
            missing = [each for each in operands if each not in known and graph.op[each] is not Op.CONSTANT]
            if missing:
                stack += missing
                continue
            stack.pop()
            known[node] = self._operation(node) if operands else self._symbol(node)
        return known[root]

    def _operation(self, node: int) -> int:
        graph, known = self._graph, self._known
        own = [
            self._constant(graph.value[each]) if graph.op[each] is Op.CONSTANT else known[each]
            for each in graph.operands[node]
        ]
        return self._add(graph.op[node], *own)

    def _symbol(self, node: int) -> int:
        group, index = self._graph.group(node), self._graph.b[node]
        if group in _SHARED:
            seen = self.shared[Group.P if group in (Group.P, Group.DIRECTION_P) else Group.U]
            return self._add(Op.SYMBOL, group, seen.setdefault(index, len(seen)))
        return self._add(Op.SYMBOL, group, 0 if group is Group.TIME else self._local[AXIS_OF[group]][index])

    def _share(self, terms: Sequence[Term], *, summed: bool) -> int:
        """The sum of `terms`, or the least of them."""
        total: int | None = None
        for term in terms:
            node = self._of(term.node)
            for op, other, is_second in term.factors:
                node = self._add(op, self._of(other), node) if is_second else self._add(op, node, self._of(other))
            if total is None:
                total = self._add(Op.NEGATE, node) if term.negative else node
            else:
                joined = (Op.SUBTRACT if term.negative else Op.ADD) if summed else Op.MIN
                total = self._add(joined, total, node)
        return self._constant(0.0 if summed else 1.0) if total is None else total
