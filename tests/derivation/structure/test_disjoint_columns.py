"""Entries of Jacobians by symbols, columns in groups that share no row, and M that is found by such groups."""

from __future__ import annotations

import numpy as np
import pytest
from choice import examples
from hypothesis import given, settings
from hypothesis import strategies as st

import lagdsl
from lagdsl.algebra.graph import Graph, Group
from lagdsl.algebra.graph.occurrence import dependences, occurrences
from lagdsl.derivation.mechanics.arrange import arrange
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.foundation.numerics.disjoint_columns import disjoint_columns


@settings(max_examples=examples(50), deadline=None)
@given(st.integers(1, 12), st.integers(1, 12), st.floats(0.05, 0.6), st.integers(0, 2**31))
def test_columns_of_a_group_share_no_row(m: int, n: int, density: float, seed: int) -> None:
    rows, columns = np.nonzero(np.random.default_rng(seed).random((m, n)) < density)
    groups = disjoint_columns(rows, columns, (m, n))
    assert len({*zip(rows.tolist(), groups[columns].tolist(), strict=True)}) == len(rows)
    assert set(groups.tolist()) == set(range(int(np.max(groups)) + 1))


def test_columns_of_a_band_need_as_many_groups_as_it_is_wide() -> None:
    rows, columns = np.nonzero(np.abs(np.subtract.outer(np.arange(30), np.arange(30))) <= 2)
    assert int(np.max(disjoint_columns(rows, columns, (30, 30)))) + 1 == 5


def test_an_expression_has_the_symbols_below_it() -> None:
    graph = Graph()
    x = graph.symbols(Group.Q, 70)
    v = graph.symbols(Group.QD, 2)
    elements = [graph.multiply(x[0], x[69]), graph.add(v[1], graph.one), graph.zero, graph.multiply(v[0], x[3]), x[69]]
    rows, columns = occurrences(graph, elements, Group.Q)
    assert list(zip(rows.tolist(), columns.tolist(), strict=True)) == [(0, 0), (0, 69), (3, 3), (4, 69)]
    of_both = dependences(graph, elements, {Group.QD: 0, Group.Q: 2})
    assert [row.tolist() for row in of_both] == [[2, 71], [1], [], [0, 5], [71]]
    assert of_both.counts == [2, 1, 0, 2, 1]


CHAIN = """model Chain
  structural parameter Integer N = 45;
  coordinate Length x[N];
  for i in 1:N loop
    kinetic 1/2*(1 kg)*der(x[i])^2*(2 + cos(x[i]*(1 rad/m)));
  end for;
  for i in 1:N-1 loop
    kinetic 1/2*(0.1 kg)*(der(x[i+1]) - der(x[i]))^2;
  end for;
end Chain;
"""


@pytest.mark.parametrize("size", [45, 3])
def test_mass_by_columns_is_the_matrix_that_is_written_out(size: int) -> None:
    model = lagdsl.compile(CHAIN, engine="tape", structural={"N": size})
    equations = model._compilation.equations
    q = np.linspace(0.1, 0.9, size)
    state = (0.0, q, 0.0 * q, np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0))
    found = [
        ProgramFunctions(arrange(equations, dense=dense)).evaluate("mass_matrix", *state)[0] for dense in (True, False)
    ]
    own = 2.0 + np.cos(q) + 0.2 - 0.1 * np.isin(np.arange(size), (0, size - 1))
    beside = np.full(size - 1, -0.1)
    np.testing.assert_allclose(found[1], np.diag(own) + np.diag(beside, 1) + np.diag(beside, -1), rtol=1e-14)
    np.testing.assert_allclose(found[0], found[1], rtol=1e-14, atol=1e-15)
