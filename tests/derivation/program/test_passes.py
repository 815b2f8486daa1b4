"""Schedules, hoisting and chunks."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import given
from hypothesis import strategies as st
from sample_programs import pendulum

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.derivation.program.passes.chunk import chunk
from lagdsl.derivation.program.passes.hoist import hoisted
from lagdsl.derivation.program.passes.schedule import schedule


def test_only_nodes_used_twice_get_a_variable() -> None:
    g = Graph()
    x, y = g.symbols(Group.Q, 2)
    shared = g.unary(Op.SIN, x)
    dead = g.unary(Op.COS, y)
    root = g.add(shared, g.multiply(shared, y))
    plan = schedule(g, [root])
    assert plan.named == (shared,)
    assert plan.symbols == (x, y)
    assert dead not in schedule(g, [root, shared]).named


def test_long_expressions_are_broken() -> None:
    g = Graph()
    total = g.symbol(Group.Q)
    for _ in range(100):
        total = g.unary(Op.SIN, total)
    assert 5 <= len(schedule(g, [total]).named) <= 50


def test_nodes_at_hand_end_the_schedule() -> None:
    g = Graph()
    x, p = g.symbol(Group.Q), g.symbol(Group.P)
    at_hand = g.unary(Op.EXP, g.multiply(p, p))
    plan = schedule(g, [g.multiply(x, at_hand), at_hand], {at_hand})
    assert plan.named == ()
    assert plan.symbols == (x,)


def test_an_empty_function_has_no_statements() -> None:
    assert schedule(Graph(), []).named == ()


def test_parameters_alone_are_hoisted_where_something_else_uses_them() -> None:
    program = pendulum()
    graph = program.graph
    found = hoisted(program)
    m, length = graph.symbol(Group.P, 0), graph.symbol(Group.P, 1)
    assert graph.multiply(m, graph.multiply(length, length)) in found
    for node in found:
        assert graph.op[node] not in (Op.CONSTANT, Op.SYMBOL)
        symbols = [x for x in graph.live([node]) if graph.op[x] is Op.SYMBOL]
        assert symbols
        assert all(graph.group(x) is Group.P for x in symbols)
    assert list(found) == sorted(set(found))


@given(st.lists(st.lists(st.integers(0, 200), max_size=4), min_size=1, max_size=120), st.integers(1, 20))
def test_chunks_keep_every_value_until_it_is_read(drawn: list[list[int]], largest: int) -> None:
    reads: Sequence[list[int]] = [[r % i for r in row] if i else [] for i, row in enumerate(drawn)]
    chunks = chunk(range(len(reads)), lambda s: reads[s], largest)
    assert [s for piece in chunks.pieces for s in piece] == list(range(len(reads)))
    assert all(len(piece) <= largest for piece in chunks.pieces)
    scratch: list[int | None] = [None] * chunks.size
    for piece in chunks.pieces:
        for statement in piece:
            for read in reads[statement]:
                assert read in piece or scratch[chunks.slot[read]] == read
            if statement in chunks.slot:
                scratch[chunks.slot[statement]] = statement
