"""Sums with terms in common: what they have in common is summed once, and nothing else changes."""

import numpy as np
import pytest

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.sums import share_sums

N = 12


def additions(graph: Graph, roots: list[int]) -> int:
    return sum(1 for node in graph.live(roots) if graph.op[node] in (Op.ADD, Op.SUBTRACT))


def backward(graph: Graph, terms: list[int]) -> list[int]:
    """t_i + ... + t_1 for every i, the last term first."""
    return [graph.sum(reversed(terms[:i])) for i in range(1, len(terms) + 1)]


def reduced(graph: Graph, terms: list[int]) -> list[int]:
    """-t_1 + t_i - t_2 + t_(i-1) ..., from both ends."""
    roots = []
    for i in range(1, len(terms) + 1):
        ends = [k // 2 if k % 2 else i - 1 - k // 2 for k in range(i)]
        total = graph.zero
        for k in ends:
            total = graph.subtract(total, terms[k]) if k % 2 else graph.add(total, terms[k])
        roots.append(total)
    return roots


def nested(graph: Graph, terms: list[int]) -> list[int]:
    """Sums of sines of sums."""
    return backward(graph, [graph.unary(Op.SIN, angle) for angle in backward(graph, terms)])


@pytest.mark.parametrize(("write", "most"), [(backward, N - 1), (reduced, N - 1), (nested, 2 * (N - 1))])
def test_common_terms_are_summed_once(write: object, most: int) -> None:
    assert callable(write)
    graph = Graph()
    q = graph.symbols(Group.Q, N)
    roots = write(graph, q)
    changed = share_sums(graph, roots)
    shared = [changed.get(root, root) for root in roots]
    assert additions(graph, shared) <= most < additions(graph, roots)
    values = np.random.default_rng(5).normal(size=N)
    expected = evaluate(graph, roots, {Group.Q: values})
    np.testing.assert_allclose(evaluate(graph, shared, {Group.Q: values}), expected, rtol=1e-13, atol=1e-13)
    assert not share_sums(graph, shared)


def test_what_is_shared_already_stays_as_it_is() -> None:
    graph = Graph()
    q = graph.symbols(Group.Q, N)
    ends, place = [], graph.zero
    for angle in q:
        place = graph.add(place, graph.unary(Op.COS, angle))
        ends.append(place)
    assert not share_sums(graph, ends)


def test_velocities_and_forces_stay_as_they_are() -> None:
    graph = Graph()
    roots = backward(graph, graph.symbols(Group.QD, N)) + backward(graph, graph.symbols(Group.U, N))
    assert not share_sums(graph, roots)
