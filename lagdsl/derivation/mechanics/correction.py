"""Back onto the constraints: M change - J' lam = 0, J change = -residual, solved before run time as the equations of
motion are.

The projection of a state that left the constraints asks for it at every step. At run time M and J are dense, and the
cost is that of the cube of the number of coordinates; along a chain of loops it is here that of the number of loops.

Source: Eich, *SIAM J. Numer. Anal.* 30 (1993), 1467: the projection that is orthogonal in the metric of M.
"""

from __future__ import annotations

from lagdsl.algebra.eliminate.rows import Side
from lagdsl.algebra.eliminate.solve import respond
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Eliminated, Function, number_block, vector_block

# The dense solution of fewer coordinates takes no longer than a step.
_FEW = 8


def correction(equations: Equations, found: Eliminated) -> tuple[Function, ...]:
    """The function of that name for a model that has `elimination`; none for few coordinates or without constraints."""
    residuals, factor = list(equations.symbols.lam), found.factor
    if not residuals or len(factor.rates) < _FEW:
        return ()
    graph = factor.graph
    response = respond(factor, Side(biases={index: graph.negate(node) for index, node in enumerate(residuals)}))
    multipliers = [response.multipliers.get(index, graph.zero) for index in range(len(residuals))]
    blocks = (
        vector_block("change", response.accelerations),
        vector_block("lam", multipliers),
        number_block("pivot", found.pivot),
    )
    return (Function(name="correction", arguments=OPTIONAL["correction"], results=blocks),)
