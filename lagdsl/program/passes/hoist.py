"""What depends on parameters only: computed once per parameter set instead of in every call."""

from __future__ import annotations

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group, Op
from lagdsl.program.program import Program


def hoisted(program: Program) -> tuple[int, ...]:
    """Nodes computed from parameters alone that something else is computed from, or that are results; ascending.

    Constants and the parameters themselves are not worth a place.
    """
    graph = program.graph
    roots = [node for function in program.functions for block in function.results for node in block.elements]
    live = graph.live(roots)
    parametric = _parametric(graph, live)
    wanted = {root for root in roots if root in parametric}
    for node in live:
        if node not in parametric:
            wanted.update(argument for argument in graph.arguments(node) if argument in parametric)
    return tuple(sorted(node for node in wanted if graph.op[node] not in (Op.CONSTANT, Op.SYMBOL)))


def _parametric(graph: Graph, live: list[int]) -> set[int]:
    parametric: set[int] = set()
    for node in live:
        match graph.op[node]:
            case Op.CONSTANT:
                parametric.add(node)
            case Op.SYMBOL:
                if graph.group(node) is Group.P:
                    parametric.add(node)
            case _:
                if all(argument in parametric for argument in graph.arguments(node)):
                    parametric.add(node)
    return parametric
