"""Expressions of parameters only: computed once per parameter set instead of in every call."""

from __future__ import annotations

from lagdsl.algebra.graph.operation import FIRST_UNARY, Group
from lagdsl.derivation.program.functions import ALONG_MANY
from lagdsl.derivation.program.program import Program

_PARAMETER = 1 << Group.P


def hoisted(program: Program) -> tuple[int, ...]:
    """Nodes computed from parameters alone that something else is computed from, or that are results; ascending.

    Constants and the parameters themselves are not worth a place.
    """
    graph = program.graph
    ops, groups, operands = graph.op, graph.groups, graph.operands
    single = [function for function in program.functions if function.name not in ALONG_MANY]
    roots = [node for function in single for block in function.results for node in block.nodes]
    wanted = {root for root in roots if not groups[root] & ~_PARAMETER}
    for node in graph.live(roots):
        if groups[node] & ~_PARAMETER:
            for operand in operands[node]:
                if not groups[operand] & ~_PARAMETER:
                    wanted.add(operand)
    return tuple(sorted(node for node in wanted if ops[node] >= FIRST_UNARY))
