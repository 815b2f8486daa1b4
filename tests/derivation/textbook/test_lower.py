"""The tangents of the lowered program against SymPy's derivatives."""

from __future__ import annotations

import numpy as np
import pytest
from sympy import Expr, Symbol

from lagdsl.algebra.graph.evaluate import evaluate, evaluate_with_size
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.textbook.derive import derive
from lagdsl.derivation.textbook.equations import EquationsOfMotion
from lagdsl.derivation.textbook.lower import lower, symbol_nodes
from lagdsl.derivation.textbook.to_graph import ToGraph
from textbook import models
from textbook.compare import random_arguments

_DIRECTIONS = {
    Group.Q: Group.DIRECTION_Q,
    Group.QD: Group.DIRECTION_QD,
    Group.U: Group.DIRECTION_U,
    Group.P: Group.DIRECTION_P,
}


def residual(equations: EquationsOfMotion) -> list[Expr]:
    """M qdd - f - J' lam, J qdd - gamma."""
    s = equations.symbols
    jacobian = equations.constraint_jacobian
    rows = []
    for j in range(len(s.q)):
        inertia = sum(equations.mass_matrix[j, k] * s.qdd[k] for k in range(len(s.q)))
        rows.append(inertia - equations.forcing[j] - sum(jacobian[r, j] * lam for r, lam in enumerate(s.lam)))
    for r in range(len(s.lam)):
        rows.append(sum(jacobian[r, k] * s.qdd[k] for k in range(len(s.q))) - equations.gamma[r])
    return rows


@pytest.mark.parametrize("make", [models.pendulum, models.cart_pendulum, models.atwood], ids=lambda make: make.__name__)
def test_tangent_of_the_residual_is_sympys(make) -> None:  # type: ignore[no-untyped-def]
    flat = make()
    equations = derive(flat)
    program = lower(equations, flat)
    arguments = random_arguments(program, np.random.default_rng(9), states=5)
    graph = Graph()
    to_graph = ToGraph(graph, symbol_nodes(graph, equations.symbols))
    symbols = equations.symbols
    members: dict[Group, tuple[Symbol, ...]] = {
        Group.Q: symbols.q,
        Group.QD: symbols.qd,
        Group.U: symbols.u,
        Group.P: symbols.p,
    }
    expected = []
    for row in residual(equations):
        total = np.zeros(5)
        for group, direction in _DIRECTIONS.items():
            for index, symbol in enumerate(members[group]):
                [value] = evaluate(graph, [to_graph.node(row.diff(symbol))], arguments)
                total = total + value * arguments[direction][:, index]
        expected.append(total)
    function = program.function("residual_tangent")
    found = evaluate_with_size(program.graph, [n for block in function.results for n in block.elements], arguments)
    for (value, size), exact in zip(found, expected, strict=True):
        assert np.all(np.abs(value - exact) <= 1e-12 * np.maximum(size, 1e-9))


def test_start_and_layout() -> None:
    flat = models.cart_pendulum()
    program = lower(derive(flat), flat)
    assert [slot.name for slot in program.layout.inputs] == ["u"]
    assert program.layout.defaults == (1.0, 1.25, 1.5, 1.75, 2.0)
    start = program.function("start")
    values = evaluate(program.graph, start.results[0].elements, {Group.TIME: 0.0, Group.P: np.ones(5)})
    assert [float(value) for value in values] == [0.1, 0.1]
