"""The search for a spanning tree: least cost, one way to every node, the same whatever the order of the edges."""

from __future__ import annotations

from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from lagdsl.language.semantics.assembly.graph import Edge, Given, Step, span

COUNT = 7
edges_strategy = st.lists(st.tuples(st.integers(0, COUNT - 1), st.integers(0, COUNT - 1)), max_size=12)


def numbered(pairs: list[tuple[int, int]]) -> list[Edge]:
    return [Edge(a, b, (number,)) for number, (a, b) in enumerate(pairs)]


def reachable(edges: list[Edge], start: int = 0) -> set[int]:
    found = {start}
    while True:
        more = {end for edge in edges for end in (edge.a, edge.b) if {edge.a, edge.b} & found} - found
        if not more:
            return found
        found |= more


def cheapest(edges: list[Edge]) -> list[int]:
    """Edges of the spanning forest of least cost, by trying all of the right size (costs are powers of two)."""
    size = len(reachable(edges)) - 1
    mine = [k for k, edge in enumerate(edges) if edge.a in reachable(edges)]
    ways = (way for way in combinations(mine, size) if len(reachable([edges[k] for k in way])) == size + 1)
    return list(min(ways, key=lambda way: sum(2**k for k in way)))


@given(edges_strategy)
def test_the_tree_is_the_one_of_least_cost(pairs):
    edges = numbered(pairs)
    tree = span(COUNT, edges, [Given(0)])
    assert {step.node for step in tree.steps} == reachable(edges)
    used = sorted(step.edge for step in tree.steps if step.edge is not None)
    assert used == cheapest(edges)
    assert sorted([*used, *tree.cuts]) == [k for k, edge in enumerate(edges) if edge.a in reachable(edges)]


@given(edges_strategy)
def test_every_node_follows_from_one_that_is_known(pairs):
    edges = numbered(pairs)
    known: set[int] = set()
    for step in span(COUNT, edges, [Given(0)]).steps:
        if step.edge is not None:
            edge = edges[step.edge]
            start, end = (edge.b, edge.a) if step.backward else (edge.a, edge.b)
            assert start in known
            assert end == step.node
        assert step.node not in known
        known.add(step.node)


@given(edges_strategy, st.randoms(use_true_random=False))
def test_the_order_of_the_edges_does_not_matter(pairs, random):
    edges = numbered(pairs)
    shuffled = random.sample(edges, len(edges))
    one, two = span(COUNT, edges, [Given(0)]), span(COUNT, shuffled, [Given(0)])
    chosen = {edges[step.edge] for step in one.steps if step.edge is not None}
    assert chosen == {shuffled[step.edge] for step in two.steps if step.edge is not None}


def test_a_given_waits_for_what_it_needs():
    """Node 3 is given by 1 and 2; the edge from 2 to it is put off until then."""
    edges = [Edge(0, 1, (2,)), Edge(0, 2, (0,)), Edge(2, 3, (1,))]
    tree = span(4, edges, [Given(0), Given(3, needs=(1, 2))])
    assert tree.steps == (Step(0, given=0), Step(2, edge=1), Step(1, edge=0), Step(3, given=1))
    assert tree.cuts == (2,)
    assert tree.redundant_edges == ()


def test_a_given_that_comes_late_is_surplus():
    """Node 1 is needed by what would place it: the edge does."""
    tree = span(2, [Edge(0, 1, (0,))], [Given(0), Given(1, needs=(1,))])
    assert tree.steps == (Step(0, given=0), Step(1, edge=0))
    assert tree.redundant_edges == (1,)


def test_an_edge_waits_for_what_it_needs():
    edges = [Edge(0, 2, (0,), needs=(1,)), Edge(0, 1, (5,))]
    tree = span(3, edges, [Given(0)])
    assert [step.node for step in tree.steps] == [0, 1, 2]
    unmet = span(3, edges[:1], [Given(0)])
    assert [step.node for step in unmet.steps] == [0]
    assert unmet.cuts == ()


def test_an_edge_from_a_node_to_itself_closes_a_loop():
    assert span(1, [Edge(0, 0, (0,))], [Given(0)]).cuts == (0,)
