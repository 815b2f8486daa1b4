"""Parameters that the functions of a program read."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.graph.operation import Group, Op
from lagdsl.program.program import Function, Program

# Functions that are no part of the equations of motion: evaluated at the start, or for quantities with names.
_BESIDE = (
    "start",
    "start_tangent",
    "discrete_start",
    "clock",
    "initial_equation",
    "initial_equation_tangent",
    "definition",
    "definition_tangent",
)


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
    lasting = _read(program, [function for function in program.functions if function.name not in _BESIDE])
    return lasting - _read(program, [function for function in program.functions if function.name == "clock"])


def _read(program: Program, functions: Iterable[Function]) -> frozenset[int]:
    return parameters_of(program, [n for function in functions for block in function.results for n in block.elements])
