"""Accelerations where they would have to be known before they are solved for."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group
from lagdsl.semantics.flat_model import Spans


def refuse_accelerations(graph: Graph, nodes: Iterable[int], spans: Spans) -> None:
    """Raise E0308 at `spans` if one of `nodes`, parts of the equations of motion, needs accelerations or multipliers."""
    if any(graph.depends(node, Group.QDD, Group.LAMBDA) for node in nodes):
        raise needs_accelerations(spans)


def needs_accelerations(spans: Spans) -> CompilationFailed:
    sink = Sink()
    sink.report("E0308", spans[0] if spans else None)
    return CompilationFailed(sink.diagnostics)
