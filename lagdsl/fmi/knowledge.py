"""Which parameters functions of a program read."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.graph.operation import Group, Op
from lagdsl.program.functions import OPTIONAL
from lagdsl.program.program import Program

# What is evaluated once, when a motion begins.
_ONCE = ("start", "start_tangent", "discrete_start", "clock", "initial_equation", "initial_equation_tangent")


def parameters_of(program: Program, nodes: Iterable[int]) -> frozenset[int]:
    """Indices of the parameters that the expressions are computed from."""
    graph = program.graph
    return frozenset(
        graph.b[node] for node in graph.live(nodes) if graph.op[node] is Op.SYMBOL and graph.group(node) is Group.P
    )


def start_parameters(program: Program) -> tuple[frozenset[int], ...]:
    """By entry of (q, qd, z)."""
    blocks = program.function("start").results[:3]
    return tuple(parameters_of(program, [node]) for block in blocks for node in block.elements)


def tunable(program: Program) -> frozenset[int]:
    """Indices of the parameters that have an effect after the start; periods of clocks stay as they began."""
    named = {*OPTIONAL} & {"definition", "definition_tangent"}
    lasting = [function for function in program.functions if function.name not in (*_ONCE, *named)]
    read = parameters_of(program, [n for function in lasting for block in function.results for n in block.elements])
    clocks = [f for f in program.functions if f.name == "clock"]
    return read - parameters_of(
        program, [n for function in clocks for block in function.results for n in block.elements]
    )
