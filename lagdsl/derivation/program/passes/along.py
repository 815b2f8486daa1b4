"""The functions of several directions at one state: what they compute, apart from how it is written."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import DIRECTION_OF, Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.program.passes.pattern import equations_pattern
from lagdsl.derivation.program.program import Block, Function, Program
from lagdsl.foundation.record import record

# The functions of directions by their names in lag_tangents.
_OF_DIRECTIONS = {
    "residual": "residual_tangent",
    "acceleration": "acceleration_tangent",
    "state_derivative": "state_derivative_tangent",
    "output": "output_tangent",
}
_STATE_AND_INPUT = (Group.DIRECTION_Q, Group.DIRECTION_QD, Group.DIRECTION_Z, Group.DIRECTION_U)


@record()
class Along:
    """`functions` by their names in lag_tangents, and the `motion`: accelerations, multipliers and pivot. That is empty
    where rows are left to run time, for derivatives need more than these then."""

    functions: Mapping[str, Function]
    motion: tuple[Block, ...]


def along(program: Program, *, parameters: bool) -> Along:
    """The functions along directions of states and inputs or, with `parameters`, along those of parameters only."""
    held = _STATE_AND_INPUT if parameters else (Group.DIRECTION_P,)
    motion = _motion(program)
    substitution = Substitution(program.graph, {**_zeros(program, held), **_solution(program, motion)})
    of_equations = not parameters and bool(equations_pattern(program).places)
    functions = _directional(program, of_equations=of_equations)
    return Along({name: _substituted(f, substitution) for name, f in functions.items()}, motion)


def shared(graph: Graph, roots: Sequence[int], given: Collection[int]) -> list[int]:
    """Nodes that do not depend on a direction and that `roots` or what depends on one is computed from, ascending;
    symbols and constants among them. The nodes of `given` are at hand."""
    moving = sum(1 << group for group in DIRECTION_OF.values())
    wanted = set(roots)
    for node in graph.live(roots, given):
        if graph.groups[node] & moving:
            wanted.update(graph.arguments(node))
    return sorted(node for node in wanted if not graph.groups[node] & moving and node not in given)


def elements(functions: Iterable[Function]) -> list[int]:
    """The nodes of all results."""
    return [node for function in functions for block in function.results for node in block.nodes]


def _motion(program: Program) -> tuple[Block, ...]:
    if program.kept_rows or not program.has("elimination"):
        return ()
    results = program.function("elimination").results
    return results[0], results[1], results[-1]


def _solution(program: Program, motion: tuple[Block, ...]) -> dict[int, int]:
    """Symbols of accelerations and multipliers."""
    found = zip((Group.QDD, Group.LAMBDA), motion, strict=False)
    return {
        program.graph.symbol(group, index): node for group, block in found for index, node in enumerate(block.elements)
    }


def _zeros(program: Program, groups: Sequence[Group]) -> dict[int, int]:
    graph = program.graph
    return {graph.symbol(g, index): graph.zero for g in groups for index in range(program.layout.size(g))}


def _directional(program: Program, *, of_equations: bool) -> dict[str, Function]:
    """The functions of directions that the model has something for: `of_equations` with `residual` beside
    `acceleration`, which serves all others."""
    solved = program.has("acceleration_tangent") and not of_equations
    found = {}
    for name, known in _OF_DIRECTIONS.items():
        if program.has(known) and not (solved and name == "residual"):
            function = program.function(known)
            if name in ("residual", "acceleration") or function.results[0].nodes:
                found[name] = function
    return found


def _substituted(function: Function, substitution: Substitution) -> Function:
    blocks = tuple(block.with_nodes(substitution.of_all(block.nodes)) for block in function.results)
    return Function(name=function.name, arguments=function.arguments, results=blocks)
