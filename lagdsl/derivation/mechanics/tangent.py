"""Directional derivatives of accelerations: M dqdd - J' dlam = -dr, J dqdd = -ds, solved before run time like the
equations of motion.

r = M qdd - f - J' lam is differentiated at the accelerations and multipliers that solve it, so that M itself need not
be. The factor does not depend on the direction: one factor serves many of them.
"""

from __future__ import annotations

from lagdsl.algebra.eliminate.rows import Side
from lagdsl.algebra.eliminate.solve import respond
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Block, Eliminated, Function, number_block, vector_block


def acceleration_tangent(found: Eliminated, motion: Block, rows: Block) -> Function:
    """The function of that name for a model that has `elimination`. `motion` is dr, `rows` is ds."""
    factor = found.factor
    graph = factor.graph
    forces = {rate: graph.negate(node) for rate, node in zip(factor.rates, motion.elements, strict=True)}
    biases = {index: graph.negate(node) for index, node in enumerate(rows.elements)}
    response = respond(factor, Side(forces=forces, biases=biases))
    multipliers = [response.multipliers.get(index, graph.zero) for index in range(len(rows.elements))]
    kept = [rows.elements[row.index] for row in factor.rows.kept]
    blocks = (
        vector_block("dqdd", response.accelerations),
        vector_block("dlam", multipliers),
        vector_block(rows.name, kept),
        number_block("pivot", found.pivot),
    )
    return Function(name="acceleration_tangent", arguments=OPTIONAL["acceleration_tangent"], results=blocks)
