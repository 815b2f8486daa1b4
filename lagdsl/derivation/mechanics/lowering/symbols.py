"""The leaves of a model on the graph: which symbol, or which number, a name stands for."""

from __future__ import annotations

from collections.abc import Callable

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.events import entries
from lagdsl.language.flat.model import FlatModel, Input


@record()
class Directions:
    """Generalized coordinates to form equations for, with their rates: those of the model, or released ones."""

    positions: tuple[int, ...]
    rates: tuple[int, ...]
    position_group: Group
    rate_group: Group


class Symbols:
    """Symbols of `flat` in the order of the layout. `input_rate` gives for an input the one that is its derivative,
    `rows` for the name of a row its multiplier as the text
    means it."""

    def __init__(self, graph: Graph, flat: FlatModel) -> None:
        time = graph.symbol(Group.TIME)
        self.q = graph.symbols(Group.Q, len(flat.coordinates))
        self.qd = graph.symbols(Group.QD, len(flat.coordinates))
        graph.symbols(Group.QDD, len(flat.coordinates))
        self.z = graph.symbols(Group.Z, len(flat.states))
        self.u = graph.symbols(Group.U, len(flat.inputs))
        discretes = entries(flat.events)
        self.previous = dict(zip((e.name for e in discretes), graph.symbols(Group.W, len(discretes)), strict=True))
        independent = [parameter for parameter in flat.parameters if not parameter.structural]
        p = graph.symbols(Group.P, len(independent))
        rows = [row for constraint in flat.constraints for row in constraint.rows]
        self.lam = graph.symbols(Group.LAMBDA, len(rows))
        self.rows = dict(zip(rows, self.lam, strict=True))
        self.coordinate_index = {item.name: index for index, item in enumerate(flat.coordinates)}
        self.by_name = {"time": time}
        self.by_name |= {item.name: graph.constant(item.value) for item in flat.parameters if item.structural}
        named = ((independent, p), (flat.coordinates, self.q), (flat.states, self.z), (flat.inputs, self.u))
        for items, nodes in named:
            self.by_name |= {item.name: node for item, node in zip(items, nodes, strict=True)}
        self.by_name |= self.previous
        self.input_rate = _input_rates(graph, flat)

    @property
    def directions(self) -> Directions:
        return Directions(tuple(self.q), tuple(self.qd), Group.Q, Group.QD)


def delay_rates(symbols: Symbols, flat: FlatModel) -> dict[int, int]:
    """For each delayed value the entry that is its time derivative."""
    return {symbols.previous[each.name]: symbols.previous[each.rate] for each in flat.events.delays}


def _input_rates(graph: Graph, flat: FlatModel) -> Callable[[int], int]:
    """For each input the input that is its time derivative; one without is refused with its declaration."""
    following = {item.derivative_of: index for index, item in enumerate(flat.inputs) if item.derivative_of is not None}

    def rate(index: int) -> int:
        item = flat.inputs[index]
        if item.name not in following:
            raise _not_differentiable(flat, item)
        return graph.symbol(Group.U, following[item.name])

    return rate


def _not_differentiable(flat: FlatModel, item: Input) -> CompilationFailed:
    """E0304 at the declaration of the input that `item` is a derivative of."""
    by_name = {other.name: other for other in flat.inputs}
    count = 1
    while item.derivative_of is not None:
        item = by_name[item.derivative_of]
        count += 1
    times = "once" if count == 1 else "twice" if count == 2 else f"{count} times"
    sink = Sink()
    sink.report(
        "E0304", item.spans[0], name=item.name, what="moves something", times=times, type=item.type_name, count=count
    )
    return CompilationFailed(sink.diagnostics)
