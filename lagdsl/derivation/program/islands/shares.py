"""Numbers for a whole program, energies and the pivot of `elimination`, as sums and extremes over its islands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TypeAlias

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.derivation.program.islands.partition import AXIS_OF, Partition
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.record import record

# Functions whose numbers are sums; of others the least counts.
SUMMED = frozenset({"energies", "energies_tangent"})
_SEVERAL = -1


class NotSeparable(Exception):  # noqa: N818  it is a property of a program
    """A number for the whole program is no sum, and no extreme, of numbers for its islands."""


@record()
class Term:
    """`node`, and from the inside out the operations that it enters: with what other operand, and 1 if the node is the
    second one."""

    node: int
    negative: bool = False
    factors: tuple[tuple[Op, int, bool], ...] = ()


Shares: TypeAlias = "dict[tuple[str, str], list[Term]]"
"""The terms of one island by the names of the function and its result."""


def shares(program: Program, parts: Partition) -> list[Shares]:
    """Of every island. A term that depends on none is a term of the first one, or, where the least counts, of all.

    Raises NotSeparable.
    """
    found: list[Shares] = [{} for _ in parts.islands]
    numbers = list(_numbers(program))
    owner = _owners(program.graph, parts, [node for _, node in numbers])
    for key, root in numbers:
        terms = _sum(program.graph, owner, root) if key[0] in SUMMED else _least(program.graph, owner, root)
        for island, term in terms:
            of = range(len(found)) if island is None and key[0] not in SUMMED else (island or 0,)
            for number in of:
                found[number].setdefault(key, []).append(term)
    return found


def _numbers(program: Program) -> Iterator[tuple[tuple[str, str], int]]:
    for function in program.functions:
        for result, block in zip(BY_NAME[function.name].results, function.results, strict=True):
            if not result.shape:
                yield (function.name, result.name), block.nodes[0]


def _owners(graph: Graph, parts: Partition, roots: Sequence[int]) -> Mapping[int, int]:
    """The number of the island that a node below `roots` depends on, or _SEVERAL; none that depends on no island."""
    found: dict[int, int] = {}
    mask = sum(1 << group for group in AXIS_OF)
    for node in graph.live(roots):
        if not graph.groups[node] & mask:
            continue
        if not graph.operands[node]:
            found[node] = parts.of(AXIS_OF[graph.group(node)], graph.b[node])
            continue
        owners = {found[each] for each in graph.operands[node] if each in found}
        found[node] = owners.pop() if len(owners) == 1 else _SEVERAL
    return found


def _sum(graph: Graph, owner: Mapping[int, int], root: int) -> Iterator[tuple[int | None, Term]]:
    """Terms of a sum, each with its island."""
    stack = [Term(root)]
    while stack:
        term = stack.pop()
        node, negative, factors = term.node, term.negative, term.factors
        if owner.get(node) != _SEVERAL:
            yield owner.get(node), term
            continue
        op, operands = graph.op[node], graph.operands[node]
        several = [each for each in operands if each in owner]
        if op is Op.NEGATE:
            stack.append(Term(operands[0], not negative, factors))
        elif op in (Op.ADD, Op.SUBTRACT):
            stack.append(Term(operands[1], negative != (op is Op.SUBTRACT), factors))
            stack.append(Term(operands[0], negative, factors))
        elif len(several) == 1 and (op is Op.MULTIPLY or (op is Op.DIVIDE and several[0] == operands[0])):
            is_second = several[0] != operands[0]
            factor = (op, operands[0] if is_second else operands[1], is_second)
            stack.append(Term(several[0], negative, (factor, *factors)))
        else:
            raise NotSeparable


def _least(graph: Graph, owner: Mapping[int, int], root: int) -> Iterator[tuple[int | None, Term]]:
    """Numbers of which the least is taken, each with its island."""
    stack = [root]
    while stack:
        node = stack.pop()
        if owner.get(node) != _SEVERAL:
            yield owner.get(node), Term(node)
        elif graph.op[node] is Op.MIN:
            stack += reversed(graph.operands[node])
        else:
            raise NotSeparable
