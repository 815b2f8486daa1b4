"""The mass matrix without its entries as expressions: derivatives of the momenta, one lane for each rate.

M written out has nq^2 entries, and in a long tree of bodies each of them is a sum over what both coordinates move. The
momenta and their derivative along one direction are of the size of the kinetic energy; evaluated for all directions at
once they give the same numbers. Programs of many coordinates may therefore leave out `mass_matrix` and `dynamics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.graph.differentiate import Tangent
from lagdsl.graph.evaluate import evaluate
from lagdsl.graph.operation import Group
from lagdsl.program.functions import STATE
from lagdsl.program.program import Program

Floats = NDArray[np.float64]

OMITTED = ("mass_matrix", "dynamics")


class Lanes:
    """The functions of OMITTED for a program that has them not, at one state."""

    def __init__(self, program: Program) -> None:
        self._program = program
        graph = program.graph
        tangent = Tangent(graph, (Group.QD,), lambda rate: graph.symbol(Group.DIRECTION_QD, graph.b[rate]))
        (momenta,) = program.function("momenta").results
        self._columns = tangent.of_all(momenta.elements)

    def evaluate(self, function: str, *state: Floats | float) -> tuple[Floats, ...]:
        """The result blocks of `mass_matrix` or `dynamics` at t, q, qd, z, u, w, p."""
        mass = self._mass(*state)
        if function == "mass_matrix":
            return (mass,)
        count, rows = len(self._program.layout.coordinates), len(self._program.layout.constraints)
        still, free = np.zeros(count), np.zeros(rows)
        (tau,) = self._named("inverse_dynamics", *state, still)
        _, jacobian = self._named("velocity_constraint", *state)
        _, missing = self._named("residual", *state, still, free)
        return mass, -tau, jacobian, -missing

    def _mass(self, *state: Floats | float) -> Floats:
        count = len(self._columns)
        symbols = {**dict(zip(STATE, state, strict=True)), Group.DIRECTION_QD: np.eye(count)}
        columns = evaluate(self._program.graph, self._columns, symbols)
        return np.array([np.broadcast_to(column, count) for column in columns]).reshape(count, count)

    def _named(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]:
        definition = self._program.function(function)
        symbols = dict(zip(definition.arguments, arguments, strict=True))
        elements = [node for block in definition.results for node in block.elements]
        values = np.array(evaluate(self._program.graph, elements, symbols), dtype=np.float64)
        ends = np.cumsum([len(block.elements) for block in definition.results])
        parts = np.split(values, ends[:-1])
        return tuple(part.reshape(block.shape) for part, block in zip(parts, definition.results, strict=True))
