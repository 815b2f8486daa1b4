"""Columns of friction for the regressor: forces of damping and dry friction, linear in coefficients of the model.

Damping, from a dissipation function D, has the coefficients B_ij = d2D/dqd_i dqd_j where these depend on nothing but
parameters; the column of B_ij has qd_j in row i and qd_i in row j. Dry friction of one slip s with a limit R that is
so, too, has the column (ds/dqd)' sign(s): the sense of the slip, whatever mode w tells.
Source: Khalil and Dombre, *Modeling, Identification and Control of Robots* (2002), section 12.5.
"""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.program import Slot
from lagdsl.foundation.units.dimension import POWER, TIME
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.listing import force_unit


def friction_columns(equations: Equations) -> Iterator[tuple[Slot, int, list[int]]]:
    """Name, value and column (nq) of every coefficient of damping, then of every limit of dry friction."""
    yield from _damping(equations)
    yield from _dry(equations)


def _damping(equations: Equations) -> Iterator[tuple[Slot, int, list[int]]]:
    graph, rates, coordinates = equations.graph, equations.symbols.qd, equations.flat.coordinates
    second = jacobian(graph, equations.dynamics.terms.drag, rates)
    for i, first in enumerate(coordinates):
        for j in range(i, len(coordinates)):
            value, other = second[i].get(j, graph.zero), coordinates[j]
            if value == graph.zero or not _constant(graph, value):
                continue
            column = [graph.zero] * len(rates)
            column[i], column[j] = rates[j], rates[i]
            name = f"damping({first.name})" if i == j else f"damping({first.name}, {other.name})"
            speeds = first.dimension / TIME * (other.dimension / TIME)
            yield Slot(name=name, unit=unit_text(POWER / speeds)), value, column


def _dry(equations: Equations) -> Iterator[tuple[Slot, int, list[int]]]:
    graph, lowering, rates = equations.graph, equations.lowering, equations.symbols.qd
    for friction in equations.flat.events.frictions:
        if len(friction.slips) > 1 or friction.contact is not None:
            continue
        limit, slip = lowering.scalar(friction.limit), lowering.scalar(friction.slips[0])
        if not _constant(graph, limit):
            continue
        sense = graph.unary(Op.SIGN, slip)
        (slopes,) = jacobian(graph, [slip], rates)
        column = [graph.multiply(slopes.get(j, graph.zero), sense) for j in range(len(rates))]
        yield Slot(name=f"limit({friction.name})", unit=force_unit(friction)), limit, column


def _constant(graph: Graph, node: int) -> bool:
    """True if it depends on nothing but parameters."""
    return not graph.depends(node, *(group for group in Group if group is not Group.P))
