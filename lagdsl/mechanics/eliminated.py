"""The equations of motion solved before run time, where that is cheaper than a dense factorization at run time."""

from __future__ import annotations

from lagdsl.diagnostics import CompilationFailed
from lagdsl.eliminate.form import NotApplicable
from lagdsl.eliminate.solve import Solution, solve
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.inertia import acceleration_form
from lagdsl.mechanics.lagrange import Dynamics
from lagdsl.mechanics.lowering import Lowering
from lagdsl.mechanics.symbols import Directions
from lagdsl.program.functions import OPTIONAL
from lagdsl.program.program import Block, Function


def eliminated_equations(
    lowering: Lowering, flat: FlatModel, found: Dynamics, directions: Directions, forming: int
) -> tuple[Function, ...]:
    """The function `elimination`, or nothing. `forming` are the operations for M, f, J and gamma that it is to beat.

    Models with constraints are left to the dense path, whose ranks are told apart further than those of J M^-1 J'.
    """
    size = len(directions.rates)
    if flat.constraints or not size:
        return ()
    try:
        solution = solve(acceleration_form(lowering, flat, found, directions), directions.rates)
    except NotApplicable:
        return ()
    except CompilationFailed:  # an input has no derivative that only this form asks for
        return ()
    if solution.flops >= forming + _factorization(size):
        return ()
    return (Function(name="elimination", arguments=OPTIONAL["elimination"], results=_blocks(solution, size)),)


def _factorization(size: int) -> int:
    """Operations of a Cholesky factorization and of one solution with it."""
    return (size**3 + 6 * size**2) // 3


def _blocks(solution: Solution, size: int) -> tuple[Block, ...]:
    return (
        Block(name="a", shape=(size,), elements=tuple(solution.accelerations)),
        Block(name="l", shape=(0,), elements=()),
        Block(name="Y", shape=(0, size), elements=()),
        Block(name="K", shape=(0, 0), elements=()),
        Block(name="J", shape=(0, size), elements=()),
        Block(name="gamma", shape=(0,), elements=()),
        Block(name="pivot", shape=(), elements=(solution.pivot,)),
    )
