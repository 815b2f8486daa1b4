"""Accelerations where they would have to be known before they are solved for."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.language.flat.quantity import Spans


def refuse_accelerations(graph: Graph, nodes: Iterable[int], spans: Spans, what: str) -> None:
    """Raise E0308 at `spans` if one of `nodes`, parts of the equations, needs accelerations or multipliers."""
    if any(graph.depends(node, Group.QDD, Group.LAMBDA) for node in nodes):
        raise needs_accelerations(spans, what)


def needs_accelerations(spans: Spans, what: str, *, help: str | None = None) -> CompilationFailed:
    sink = Sink()
    sink.report("E0308", spans[0] if spans else None, what=what, help=help)
    return CompilationFailed(sink.diagnostics)


def as_coordinate(state: str) -> str:
    """The way out for a state that cannot be a function of time: the same rate by a constraint."""
    return f"declare `{state}` as a coordinate and write `constraint der({state}) = ...;`"
