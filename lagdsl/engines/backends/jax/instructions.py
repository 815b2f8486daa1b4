"""The body of a long function as data: lists of instructions that a loop executes.

XLA compiles the loop once, whatever the length of the lists, so the time to compile stays bounded. Values stand in one
array of registers: constants, then the arguments one after the other, then the results. Instructions of the same
operation on the same level, whose operands are results of levels below, fill rows of LANES; a row that is not full
repeats its last instruction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Function, Program
from lagdsl.engines.backends.python.body import ELEMENTARY, body_name, number

LANES = 8
_WIDTH = 118
_MOST_OPERANDS = 3
_LEAVES = (Op.CONSTANT, Op.SYMBOL)
_ARITHMETIC = {Op.NEGATE: "negate", Op.ADD: "add", Op.SUBTRACT: "subtract", Op.MULTIPLY: "multiply"}
_NAMES: dict[Op, str] = {**ELEMENTARY, **_ARITHMETIC}


def count_of(graph: Graph, function: Function) -> int:
    """Number of operations of a function."""
    return sum(graph.op[node] not in _LEAVES for node in graph.live(_roots(function)))


def instructions(program: Program, function: Function) -> str:
    """`_name = Instructions(...)`, which is called as the bodies of short functions are."""
    graph, roots = program.graph, _roots(function)
    live = graph.live(roots)
    constants = [node for node in live if graph.op[node] is Op.CONSTANT]
    rows = list(_rows(graph, [node for node in live if graph.op[node] not in _LEAVES]))
    register = {node: place for place, node in enumerate(constants)}
    first = {}
    end = len(constants)
    for group in function.arguments:
        first[group] = end
        end += 1 if group is Group.TIME else program.layout.size(group)
    register |= {node: first[graph.group(node)] + graph.b[node] for node in live if graph.op[node] is Op.SYMBOL}
    for row in rows:
        register |= {node: end + lane for lane, node in reversed(list(enumerate(row)))}
        end += LANES
    operands = [[0] * (LANES * len(rows)) for _ in range(_MOST_OPERANDS)]
    for place, node in enumerate(node for row in rows for node in row):
        for k, operand in enumerate(graph.arguments(node)):
            operands[k][place] = register[operand]
    kinds = ((_NAMES[graph.op[row[0]]], len(graph.arguments(row[0]))) for row in rows)
    runs = [(*kind, len(list(run))) for kind, run in groupby(kinds)]
    lines = [
        f"{body_name(function.name)} = Instructions(",
        *_field("constants", [number(graph.value[node]) for node in constants]),
        *_field("runs", [f"({name!a}, {arity}, {length})" for name, arity, length in runs]),
        *(line for k, name in enumerate("abc") for line in _field(name, [str(place) for place in operands[k]])),
        *_field("results", [str(register[root]) for root in roots]),
        ")",
    ]
    return "\n".join(lines) + "\n"


def _roots(function: Function) -> list[int]:
    return [node for block in function.results for node in block.elements]


def _rows(graph: Graph, operations: Sequence[int]) -> Iterator[list[int]]:
    """Nodes that do not need each other, LANES of one operation each, in an order in which they can be computed."""
    level: dict[int, int] = {}
    for node in operations:
        level[node] = 1 + max(level.get(operand, 0) for operand in graph.arguments(node))
    ordered = sorted(operations, key=lambda node: (level[node], graph.op[node], node))
    for _, nodes in groupby(ordered, key=lambda node: (level[node], graph.op[node])):
        same = list(nodes)
        for start in range(0, len(same), LANES):
            row = same[start : start + LANES]
            yield row + row[-1:] * (LANES - len(row))


def _field(name: str, texts: Sequence[str]) -> Iterator[str]:
    """`name=(...),` in lines of at most _WIDTH characters."""
    if not any(text != "0" for text in texts):
        yield f"    {name}=(0,) * {len(texts)},"
        return
    yield f"    {name}=("
    line = "       "
    for text in texts:
        if len(line) + len(text) + 2 > _WIDTH:
            yield line
            line = "       "
        line += f" {text},"
    yield line
    yield "    ),"
