"""Elimination, the dense solution and the textbook give the same motions, at many states."""

from __future__ import annotations

from dataclasses import replace

from choice import ALL, chosen

from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.derivation.program.program import Program, whole_block
from lagdsl.engines.runtime.engines.broadcast import solving
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from models.corpus import MODELS, compiled, textbook
from models.kinds import OF_EACH_KIND, over
from models.many_states import left_in_equations, many_states

LEFT = 1e-10  # of the size of the terms
# No state near their start holds all rows of their contacts at once, or a coordinate has no inertia.
SINGULAR = ("capstan", "library/boxes_in_contact", "viscoelastic_mount")


@over(chosen([name for name in MODELS if name not in SINGULAR], OF_EACH_KIND[::4]))
def test_solutions_satisfy_the_equations_of_both_derivations(name: str) -> None:
    program, states = written_out(compiled(name).graph), many_states(name)
    ways = [NumpyEngine(without_dense(program)).solve_many, NumpyEngine(without_elimination(program)).solve_many]
    if (
        ALL or name in OF_EACH_KIND[::6]
    ):  # with the loads that these states have, though others follow from their accelerations
        ways.append(solving(compiled(name).graph, CEngine(compiled(name).graph)))
    for solve in ways if program.has("elimination") else ways[1:]:
        qdd, lam = solve(*(states[group] for group in STATE))
        assert left_in_equations(program, states, qdd, lam) < LEFT
        assert left_in_equations(textbook(name), states, qdd, lam, solved=program) < LEFT


def without_elimination(program: Program) -> Program:
    return replace(program, functions=tuple(f for f in program.functions if f.name != "elimination"), kept_rows=())


def without_dense(program: Program) -> Program:
    """The dense equations are no numbers if asked for: elimination alone must do."""
    graph = program.graph
    t = graph.unary(Op.SQRT, graph.constant(-1.0))
    blocks = program.function("dynamics").results
    nothing = tuple(whole_block(block.name, block.shape, (t,) * block.size) for block in blocks)
    return replace(
        program,
        functions=tuple(replace(f, results=nothing) if f.name == "dynamics" else f for f in program.functions),
    )
