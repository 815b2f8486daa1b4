"""Products fused with the sums they enter."""

from __future__ import annotations

from lagdsl.algebra.graph import Graph, Group
from lagdsl.algebra.graph.operation import Op
from lagdsl.derivation.program.passes.fuse import exact, fused, fusible
from lagdsl.derivation.program.passes.reassociate import reassociate


def test_the_later_product_is_fused() -> None:
    graph = Graph()
    x, y, z = graph.symbols(Group.Q, 3)
    early, late = graph.multiply(x, y), graph.multiply(graph.unary(Op.EXP, x), z)
    total = graph.add(early, late)
    live = graph.live([total])
    assert fused(graph, live, (), (), ()) == {total: graph.arguments(total).index(late)}
    assert fused(graph, live, {late}, (), ()) == {total: graph.arguments(total).index(early)}
    assert fused(graph, live, {early, late}, (), ()) == {}
    assert fused(graph, live, (), {total}, ()) == {}


def test_a_difference_that_a_step_depends_on_is_left_alone() -> None:
    graph = Graph()
    x, y, z, w = graph.symbols(Group.Q, 4)
    speed = graph.subtract(graph.multiply(x, y), graph.multiply(z, w))
    friction = graph.unary(Op.SIGN, graph.add(speed, graph.one))
    chosen = graph.select(graph.binary(Op.LESS, graph.subtract(graph.multiply(x, z), w), z), speed, w)
    free = graph.subtract(graph.multiply(y, z), w)
    live = graph.live([friction, chosen, free])
    assert set(fused(graph, live, (), (), exact(graph, live))) == {free}


def test_a_product_of_two_sums_is_computed_in_both() -> None:
    graph = Graph()
    x, y, z, w = graph.symbols(Group.Q, 4)
    shared, other = graph.multiply(x, y), graph.multiply(z, w)
    roots = [graph.add(shared, z), graph.subtract(w, shared)]
    assert fusible(graph, graph.live(roots), roots, ()) == {shared}
    roots.append(graph.add(shared, other))
    assert fusible(graph, graph.live(roots), roots, ()) == set()


def test_what_is_late_is_added_last() -> None:
    graph = Graph()
    p = graph.symbols(Group.P, 2)
    x, y, z = graph.symbols(Group.Q, 3)
    late = graph.unary(Op.EXP, x)
    total = graph.add(graph.add(late, y), z)
    product = graph.multiply(p[0], graph.multiply(p[1], late))
    kept = graph.add(graph.add(late, z), x)
    found = reassociate(graph, [total, product, kept], {kept})
    assert late in graph.arguments(found[0])
    assert graph.arguments(found[1]) == tuple(sorted((graph.multiply(*p), late)))
    assert found[2] == kept
