"""Parameters that the functions of a program read."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Function, Program
from lagdsl.language.flat.model import FlatModel

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
    return tuple(parameters_of(program, [node]) for block in blocks for node in block.nodes)


def free_places(flat: FlatModel) -> frozenset[int]:
    """Indices of the free parameters among the independent ones."""
    return frozenset(i for i, item in enumerate(p for p in flat.parameters if not p.structural) if item.free)


def tunable(flat: FlatModel, program: Program) -> frozenset[int]:
    """Indices of the parameters that may be set after the start and have an effect then; periods of clocks and free
    parameters stay as they began."""
    lasting = _read(program, [function for function in program.functions if function.name not in _BESIDE])
    settled = _read(program, [function for function in program.functions if function.name == "clock"])
    return lasting - settled - free_places(flat)


def _read(program: Program, functions: Iterable[Function]) -> frozenset[int]:
    return parameters_of(program, [n for function in functions for block in function.results for n in block.nodes])
