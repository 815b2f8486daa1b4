"""A graph as text: one line per node, numbered in order of use, the same for the same graph."""

from __future__ import annotations

from collections.abc import Mapping

from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import ARGUMENT_NAMES, Group, Op

_INFIX = {
    Op.ADD: "+",
    Op.SUBTRACT: "-",
    Op.MULTIPLY: "*",
    Op.DIVIDE: "/",
    Op.POWER: "^",
    Op.LESS: "<",
    Op.LESS_EQUAL: "<=",
    Op.EQUAL: "==",
    Op.AND: "and",
    Op.OR: "or",
}


def dump(graph: Graph, roots: Mapping[str, int]) -> str:
    """`%3 = %1 * sin(q[0])` and so on, then one line for each of the named roots; leaves stand where they are used."""
    texts: dict[int, str] = {}
    lines: list[str] = []
    for node in graph.live(roots.values()):
        if graph.op[node] in (Op.CONSTANT, Op.SYMBOL):
            texts[node] = _leaf(graph, node)
        else:
            name = f"%{len(lines) + 1}"
            lines.append(f"{name} = {_operation(graph, node, texts)}")
            texts[node] = name
    lines += [f"{name} = {texts[node]}" for name, node in roots.items()]
    return "\n".join(lines) + "\n"


def _leaf(graph: Graph, node: int) -> str:
    if graph.is_constant(node):
        return repr(graph.value[node])
    group = graph.group(node)
    name = ARGUMENT_NAMES.get(group, group.name.lower())
    return name if group is Group.TIME else f"{name}[{graph.b[node]}]"


def _operation(graph: Graph, node: int, texts: Mapping[int, str]) -> str:
    op = graph.op[node]
    arguments = [texts[x] for x in graph.arguments(node)]
    if op is Op.NEGATE:
        return f"-{arguments[0]}"
    if op in _INFIX:
        return f"{arguments[0]} {_INFIX[op]} {arguments[1]}"
    return f"{op.name.lower()}({', '.join(arguments)})"
