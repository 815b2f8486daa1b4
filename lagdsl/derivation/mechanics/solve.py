"""Solve the equations of motion while they are expressions, where that is cheaper than at run time."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.algebra.eliminate.count import flops
from lagdsl.derivation.mechanics.correction import correction
from lagdsl.derivation.mechanics.eliminated import eliminate
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.tangent import acceleration_tangent
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.structure import Structure


def solve(equations: Equations, program: Program, structure: Structure | None = None) -> Program:
    """`program`, arranged from `equations`, with the functions `elimination` and `acceleration_tangent`, in long ones
    with `correction`; as it is where solving at run time is cheaper or `structure` has no point of the constraints.

    `structure` is needed where there are constraints: their ranks decide which multipliers are eliminated.
    """
    if structure is not None and not structure.points:
        return program
    found = eliminate(equations, structure, cost_of_forming(program))
    if found is None:
        return program
    change = acceleration_tangent(found, *program.function("residual_tangent").results)
    added = (found.function, change, *correction(equations, found))
    kept = tuple(row.index for row in found.factor.rows.kept)
    return replace(program, functions=(*program.functions, *added), kept_rows=kept, eliminated=found)


def cost_of_forming(program: Program) -> int:
    """Operations for M, f, J and gamma at run time."""

    def cost(*names: str) -> int:
        return flops(
            program.graph,
            [node for name in names for block in program.function(name).results for node in block.nodes],
        )

    if program.has("dynamics"):
        return cost("dynamics")
    return len(program.layout.coordinates) * cost("momentum_tangent") + cost("inverse_dynamics", "velocity_constraint")
