"""How accelerations change along a direction: M dqdd = -dr, solved before run time as the equations of motion are.

r = M qdd - f is differentiated at the accelerations that solve it, so that M itself need not be. The factor does not
depend on the direction: one factor serves many of them.
"""

from __future__ import annotations

from lagdsl.eliminate.solve import solve
from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.inertia import acceleration_form
from lagdsl.mechanics.lagrange import Dynamics
from lagdsl.mechanics.lowering import Lowering
from lagdsl.mechanics.symbols import Directions
from lagdsl.program.functions import OPTIONAL
from lagdsl.program.program import Block, Function


def acceleration_tangent(
    lowering: Lowering, flat: FlatModel, found: Dynamics, directions: Directions, motion: Block, rows: Block
) -> Function:
    """The function of that name for a model that has `elimination`, all of whose rows are left to run time.

    `motion` is dr, `rows` is ds.
    """
    graph = lowering.graph
    form = acceleration_form(lowering, flat, found, directions)
    form.forces = {rate: graph.negate(node) for rate, node in zip(directions.rates, motion.elements, strict=True)}
    solution = solve(form, directions.rates)
    blocks = (
        Block(name="dqdd", shape=motion.shape, elements=tuple(solution.accelerations)),
        Block(name="dlam", shape=rows.shape, elements=(graph.zero,) * len(rows.elements)),
        rows,
        Block(name="pivot", shape=(), elements=(solution.pivot,)),
    )
    return Function(name="acceleration_tangent", arguments=OPTIONAL["acceleration_tangent"], results=blocks)
