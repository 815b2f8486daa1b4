"""Everything that has a name in a model, and how all of it changes along a direction: what an exported model offers
beside its outputs. Simulations need none of it, so programs get it only where it is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.algebra.graph.differentiate import Tangent
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.tangents import P_GROUPS, SOLVED_GROUPS, STATE_GROUPS, directional
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.layout import slots
from lagdsl.derivation.program.program import Block, Function, Program, vector_block
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.quantity import Variability

_STILL = (Variability.CONSTANT, Variability.STRUCTURAL, Variability.PARAMETER)


def definitions(flat: FlatModel) -> tuple[Definition, ...]:
    """In the order of the function `definition`: first those that depend on parameters only."""
    found = [*(item for item in flat.named if isinstance(item, Definition)), *flat.observed]
    still = [item for item in found if item.variability in _STILL]
    return (*still, *(item for item in found if item.variability not in _STILL))


def with_names(equations: Equations, program: Program) -> Program:
    """`program`, which was made from `equations`, with the functions of OPTIONAL from `definition` on.

    Raises CompilationFailed where a definition needs the derivative of an input that has none (E0304) or of an
    acceleration (E0308).
    """
    graph, lowering, flat = equations.graph, equations.lowering, equations.flat
    named = definitions(flat)
    values = []
    for item in named:
        lowering.place = item.spans
        values.append(lowering.scalar(item.value))
    found = {
        "definition": [vector_block("d", values)],
        "definition_tangent": [vector_block("dd", directional(graph, values, SOLVED_GROUPS))],
        "start_tangent": _along(program, "start", P_GROUPS),
        "energies_tangent": _along(program, "energies", STATE_GROUPS),
        "initial_equation_tangent": _along(program, "initial_equation", SOLVED_GROUPS),
        "time_tangent": _in_time(program, values),
    }
    functions = [
        Function(name=name, arguments=arguments, results=tuple(found[name]))
        for name, arguments in OPTIONAL.items()
        if name in found
    ]
    layout = replace(program.layout, definitions=slots(named))
    return replace(program, layout=layout, functions=(*program.functions, *functions))


def _along(program: Program, function: str, groups: tuple[Group, ...]) -> list[Block]:
    return [_block_along(program, block, groups) for block in program.function(function).results]


def _in_time(program: Program, values: Sequence[int]) -> list[Block]:
    """Partial derivatives by time."""
    graph = program.graph
    tangent = Tangent(graph, (Group.TIME,), lambda symbol: graph.one)
    blocks = [
        *program.function("residual").results,
        *(program.function(name).results[0] for name in ("position_constraint", "velocity_constraint")),
        *(block for name in ("state_derivative", "output", "energies") for block in program.function(name).results),
        vector_block("d", values),
    ]
    return [replace(block, name=f"d{block.name}").with_nodes(tangent.of_all(block.nodes)) for block in blocks]


def _block_along(program: Program, block: Block, groups: tuple[Group, ...]) -> Block:
    nodes = directional(program.graph, block.nodes, groups)
    return replace(block, name=f"d{block.name}").with_nodes(nodes)
