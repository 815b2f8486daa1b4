"""Equations of motion for tools that integrate ordinary differential equations: solved while they are expressions where
that is possible, else as the linear system of accelerations and multipliers."""

from __future__ import annotations

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.constraints import baumgarte_terms
from lagdsl.derivation.mechanics.eliminated import eliminate
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.mechanics.solve import cost_of_forming
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.structure import Structure
from lagdsl.foundation.record import record

# A solution as expressions is preferred to one at run time that costs so many operations, or so many times fewer.
_FEW = 10_000
_TIMES = 2


@record(kw_only=True)
class Motion:
    """Equations of accelerations and multipliers, nodes all.

    `accelerations` and `multipliers` are expressions of the state, one for each; where both are empty, `residuals`
    vanish, and the multipliers of `idle` rows are zero. `stabilized`: they hold the rate of Baumgarte's terms.
    """

    accelerations: tuple[int, ...] = ()
    multipliers: tuple[int, ...] = ()
    residuals: tuple[int, ...] = ()
    idle: tuple[int, ...] = ()
    stabilized: bool = False


def stabilization_rate(program: Program) -> int:
    """The symbol of the rate of Baumgarte's terms [1/s]: the parameter after those of the model."""
    return program.graph.symbol(Group.P, program.layout.size(Group.P))


def motion(equations: Equations, program: Program, structure: Structure) -> Motion:
    """The equations of `program`, with Baumgarte's terms where there are constraints."""
    rate = stabilization_rate(program)
    constrained = bool(program.layout.constraints)
    if not program.layout.coordinates:
        return Motion()
    solvable = structure if constrained else None
    if not constrained or structure.points:
        found = eliminate(equations, solvable, _TIMES * cost_of_forming(program) + _FEW, rate)
        if found is not None and not found.factor.rows.kept:
            accelerations, multipliers = found.function.results[:2]
            return Motion(
                accelerations=accelerations.elements, multipliers=multipliers.elements, stabilized=constrained
            )
    return _as_residuals(equations, program, rate)


def _as_residuals(equations: Equations, program: Program, rate: int) -> Motion:
    graph: Graph = program.graph
    forces, rows = program.function("residual").results
    terms = baumgarte_terms(equations.lowering, equations.rows, rate)
    redundant = program.layout.redundant
    kept = [
        graph.add(row, term) for row, term, excess in zip(rows.elements, terms, redundant, strict=True) if not excess
    ]
    idle = tuple(row for row, excess in enumerate(redundant) if excess)
    return Motion(residuals=(*forces.elements, *kept), idle=idle, stabilized=bool(kept))
