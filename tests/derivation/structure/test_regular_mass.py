"""M that is shown to be regular, with the rows of constraints, without being formed."""

from __future__ import annotations

import numpy as np
import pytest

import lagdsl
from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.linear_steps import linear_steps
from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.structure.functions import ProgramFunctions

N = 15
# Each stands on the coupler of the one before, so that M has no entry that is zero.
FOUR_BARS = """model FourBars
  structural parameter Integer N = 15;
  parameter Mass m = 1 kg;
  coordinate Angle a[N](each start = 60 deg), b[N](each start = -33.38 deg), c[N](each start = 83.25 deg);
  frame crank[N], coupler[N], rocker[N];
  for i in 1:N loop
    frame crank[i] = (if i == 1 then world else coupler[i-1]).rotz(a[i]);
    frame coupler[i] = crank[i].move({0.4 m, 0 m}).rotz(b[i]);
    frame rocker[i] = (if i == 1 then world else coupler[i-1]).move({1 m, 0 m}).rotz(c[i]);
    body(m = m, com = {0.2 m, 0 m}, Izz = m*0.01 m2) on crank[i];
    body(m = 2*m, com = {0.5 m, 0 m}, Izz = m*0.2 m2) on coupler[i];
    body(m = 1.5*m, com = {0.4 m, 0 m}, Izz = m*0.1 m2) on rocker[i];
    constraint 0.4 m*cos(a[i]) + 1 m*cos(a[i] + b[i]) = 1 m + 0.8 m*cos(c[i]);
    constraint 0.4 m*sin(a[i]) + 1 m*sin(a[i] + b[i]) = 0.8 m*sin(c[i]);
  end for;
end FourBars;
"""
# T = (x'^2 - y'^2)/2 is a regular form that is zero where x and y move alike.
INDEFINITE = """model Indefinite
  structural parameter Integer N = 40;
  coordinate Length x[N], y(start = 1 m), z;
  for i in 1:N loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
  end for;
  kinetic 1/2*(1 kg)*(der(z)^2 - der(y)^2);
  constraint y - z = 1 m;
end Indefinite;
"""


def test_what_is_left_without_the_steps_is_the_matrix() -> None:
    """y = 2 v0/x0 - x1 (v0 + v1), -v1 or v0 where x0 is zero, v1 with itself subtracted."""
    graph = Graph()
    (x0, x1), (v0, v1) = graph.symbols(Group.Q, 2), graph.symbols(Group.QD, 2)
    elements = [
        graph.subtract(
            graph.divide(graph.multiply(graph.constant(2.0), v0), x0), graph.multiply(x1, graph.add(v0, v1))
        ),
        graph.select(x0, graph.negate(v1), v0),
        graph.zero,
        v1,
    ]
    steps = linear_steps(graph, elements, Group.QD, 2, {Group.Q: [0.5, 3.0]})
    assert steps is not None
    np.testing.assert_allclose(_left(steps.dense(), 4, 2), [[1.0, -3.0], [0.0, -1.0], [0.0, 0.0], [0.0, 1.0]])


def test_products_of_the_vector_are_not_linear() -> None:
    graph = Graph()
    v0, v1 = graph.symbols(Group.QD, 2)
    for element in (graph.multiply(v0, v1), graph.divide(graph.one, v0), graph.unary(Op.SIN, v1)):
        assert linear_steps(graph, [element], Group.QD, 2, {}) is None


@pytest.mark.parametrize("mass", ["1 kg", "1e-6 kg", "1e6 kg"])
def test_mass_of_a_chain_of_loops_is_not_formed(mass: str) -> None:
    compilation = lagdsl.compile(FOUR_BARS.replace("m = 1 kg", f"m = {mass}"), engine="tape")._compilation
    points = compilation.structure.points
    assert len(points) == 3 and all(point.mass is None for point in points)
    assert compilation.structure.freedom == N
    functions = ProgramFunctions(arrange(compilation.equations, dense=False))
    q, nothing = points[0].q, np.zeros(0)
    state = (0.0, q, 0.0 * q, nothing, nothing, nothing, np.array(compilation.program.layout.defaults))
    steps = functions.momentum_steps(*state)
    assert steps is not None
    expected = functions.mass(*state).dense()
    assert np.count_nonzero(expected) > 0.4 * expected.size
    np.testing.assert_allclose(_left(steps.dense(), 3 * N, 3 * N), expected, rtol=1e-10, atol=1e-12 * expected.max())


def test_a_regular_mass_that_vanishes_on_the_constraints_is_told() -> None:
    with pytest.raises(lagdsl.CompilationFailed, match="E0503"):
        lagdsl.compile(INDEFINITE, engine="tape")
    regular = lagdsl.compile(INDEFINITE.replace("y - z", "y - 2*z"), engine="tape")
    assert all(point.mass is None for point in regular._compilation.structure.points)


def _left(extended: np.ndarray, m: int, n: int) -> np.ndarray:
    """The Schur complement of the rest: the last m rows, for the first n columns alone."""
    k = len(extended) - m
    return extended[k:, :n] - extended[k:, n:] @ np.linalg.solve(extended[:k, n:], extended[:k, :n])
