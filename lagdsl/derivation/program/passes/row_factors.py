"""Rows of constraints times powers of two, so that none is far smaller than others: a program over the same graph.

With factors s the rows are s phi, and the multipliers lam/s: the motion is the same, and nothing is rounded.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import product
from math import prod

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.program.functions import BY_NAME, Result
from lagdsl.derivation.program.program import Block, Function, Instants, Program


def with_row_factors(program: Program, factors: Sequence[float]) -> Program:
    """`program`, which has nothing solved yet, with the factors (nc,) of its rows. Gaps of contacts and slips are as
    their rows are, and forces of friction as their multipliers."""
    graph = program.graph
    of_text = {
        symbol: graph.multiply(graph.constant(factor), symbol)
        for group in (Group.LAMBDA, Group.DIRECTION_LAMBDA)
        for symbol, factor in zip(graph.symbols(group, len(factors)), factors, strict=True)
        if factor != 1.0
    }
    scaling = _Scaling(graph, Substitution(graph, of_text), _along(program.layout.instants, factors))
    layout = replace(program.layout, row_factors=tuple(factors))
    return replace(program, layout=layout, functions=tuple(map(scaling.of, program.functions)))


def _along(instants: Instants, factors: Sequence[float]) -> dict[str, list[float]]:
    """Factors of results by the length of an axis; what is longer has 1 at its end."""
    slips = [factors[row] for row in instants.friction_rows]
    first = [sum(instants.friction_slips[:k]) for k in range(len(instants.friction_slips))]
    gaps = [factors[row] for row in instants.contact_rows]
    return {"nc": list(factors), "nslip": slips, "nfriction": [1.0 / slips[k] for k in first], "ngap": gaps}


class _Scaling:
    def __init__(self, graph: Graph, substitution: Substitution, along: dict[str, list[float]]) -> None:
        self._graph = graph
        self._substitution = substitution
        self._along = along

    def of(self, function: Function) -> Function:
        signature = BY_NAME[function.name]
        pairs = zip(function.results, signature.results, strict=True)
        return replace(function, results=tuple(self._block(*pair) for pair in pairs))

    def _block(self, block: Block, result: Result) -> Block:
        graph, nodes = self._graph, self._substitution.of_all(block.nodes)
        scaled = zip(self._weights(block, result), nodes, strict=True)
        return block.with_nodes(
            [node if by == 1.0 else graph.multiply(graph.constant(by), node) for by, node in scaled]
        )

    def _weights(self, block: Block, result: Result) -> Iterable[float]:
        """Of its nodes."""
        # the only speed of a contact that is a number of its own
        shape = ("ngap",) if result.name == "capture_speed" else result.shape
        axes = [self._along.get(length, []) for length in shape]
        padded = [own + [1.0] * (extent - len(own)) for own, extent in zip(axes, block.shape, strict=True)]
        if block.is_sparse:
            places = (divmod(place, block.shape[1]) for place in block.places)
            return (padded[0][row] * padded[1][column] for row, column in places)
        return map(prod, product(*padded))
