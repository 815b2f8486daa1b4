"""Expressions of parameters that are the same function, and others."""

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.identity import identical
from lagdsl.algebra.graph.operation import Group, Op


def test_the_same_function_written_in_other_ways() -> None:
    graph = Graph()
    a, b, c = graph.symbols(Group.P, 3)
    one = graph.multiply(graph.add(a, b), c)
    other = graph.add(graph.multiply(a, c), graph.multiply(b, c))
    assert one != other
    assert identical(graph, one, other)
    assert identical(graph, graph.divide(one, c), graph.add(a, b))
    assert identical(graph, graph.constant(0.1 + 0.2), graph.constant(0.3))


def test_other_functions() -> None:
    graph = Graph()
    a, b = graph.symbols(Group.P, 2)
    assert not identical(graph, a, b)
    assert not identical(graph, a, graph.multiply(graph.constant(1.0 + 1e-9), a))
    assert not identical(graph, graph.zero, a)
    assert not identical(graph, graph.constant(1.0), graph.constant(1.0 + 1e-9))


def test_what_is_no_rational_function_is_the_same_as_itself_only() -> None:
    """Branches that no random parameter takes would go unseen."""
    graph = Graph()
    (a,) = graph.symbols(Group.P, 1)
    far = graph.select(graph.binary(Op.LESS, graph.constant(100.0), a), graph.zero, a)
    assert identical(graph, far, far)
    assert not identical(graph, far, a)
