"""Blocks of results: of matrices only what is not zero by itself is kept."""

from __future__ import annotations

import pytest
from named_models import compiled

from lagdsl.algebra.graph.graph import ZERO, Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Block, matrix_block, vector_block, whole_block

COLUMN = """
model Column
structural parameter Integer N = {count};
coordinate Length h[N](start = {{0.1 m*i for i in 1:N}});
for i in 1:N loop
  mass 1 kg at {{0, h[i]}};
end for;
contact floor: h[1] >= 0.1 m with restitution = 0;
for i in 1:N-1 loop
  contact c: h[i+1] - h[i] >= 0.1 m with restitution = 0;
end for;
end Column;
"""


def test_a_matrix_is_the_same_by_entries_and_whole() -> None:
    x, y = Graph().symbols(Group.Q, 2)
    elements = (ZERO, x, ZERO, y, ZERO, x)
    found = matrix_block("J", [{1: x}, {2: x, 0: y}], 3)
    assert found == whole_block("J", (2, 3), elements) == matrix_block("J", [elements[:3], elements[3:]], 3)
    assert found.elements == elements
    assert (found.size, found.nodes, found.places) == (6, (x, y, x), (1, 3, 5))
    assert list(found.entries) == [(1, x), (3, y), (5, x)]


def test_what_becomes_zero_is_not_kept() -> None:
    x, y = Graph().symbols(Group.Q, 2)
    found = matrix_block("J", [{0: x, 1: y}], 2).with_nodes([ZERO, y])
    assert (found.places, found.elements) == ((1,), (ZERO, y))


def test_a_vector_keeps_its_zeros() -> None:
    (x,) = Graph().symbols(Group.Q, 1)
    found = vector_block("f", [ZERO, x])
    assert (found.nodes, found.elements, list(found.entries)) == ((ZERO, x), (ZERO, x), [(1, x)])


def test_as_many_nodes_as_places() -> None:
    with pytest.raises(AssertionError, match="J"):
        Block(name="J", shape=(2, 2), nodes=(1, 2), places=(0,))


def test_blocks_in_a_column_have_entries_in_their_number() -> None:
    """Each row of contact ties two neighbors: the blocks of n bodies are not n times n."""

    def kept(count: int) -> int:
        program = compiled(COLUMN.format(count=count)).program
        return sum(len(block.nodes) for function in program.functions for block in function.results)

    few, many, most = kept(45), kept(60), kept(75)
    assert most - many == many - few
