"""Products fused with the sums they enter."""

from __future__ import annotations

from lagdsl.graph import Graph, Group
from lagdsl.graph.operation import Op
from lagdsl.program.passes.fuse import fused


def test_the_later_product_is_fused() -> None:
    graph = Graph()
    x, y, z = graph.symbols(Group.Q, 3)
    early, late = graph.multiply(x, y), graph.multiply(graph.unary(Op.EXP, x), z)
    total = graph.add(early, late)
    live = graph.live([total])
    assert fused(graph, live, (), ()) == {total: graph.arguments(total).index(late)}
    assert fused(graph, live, {late}, ()) == {total: graph.arguments(total).index(early)}
    assert fused(graph, live, {early, late}, ()) == {}
    assert fused(graph, live, (), {total}) == {}


def test_a_difference_that_a_step_depends_on_is_left_alone() -> None:
    graph = Graph()
    x, y, z, w = graph.symbols(Group.Q, 4)
    speed = graph.subtract(graph.multiply(x, y), graph.multiply(z, w))
    friction = graph.unary(Op.SIGN, graph.add(speed, graph.one))
    chosen = graph.select(graph.binary(Op.LESS, graph.subtract(graph.multiply(x, z), w), z), speed, w)
    free = graph.subtract(graph.multiply(y, z), w)
    live = graph.live([friction, chosen, free])
    assert set(fused(graph, live, (), ())) == {free}
