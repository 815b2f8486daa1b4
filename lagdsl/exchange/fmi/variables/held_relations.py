"""Relations that the motion does not change: only inputs that are set at events, and other discretes, stand in them."""

from __future__ import annotations

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.language.flat.model import FlatModel


def held_relations(flat: FlatModel, program: Program) -> tuple[bool, ...]:
    """By relation, in their order. They are evaluated in event mode and are no event indicators (FMI 3.0, 2.3.3)."""
    if not flat.events.relations:
        return ()
    graph, kinds = program.graph, program.layout.kinds

    def is_held(node: int) -> bool:
        symbols = [each for each in graph.live([node]) if graph.op[each] is Op.SYMBOL]
        groups = {graph.group(each) for each in symbols}
        given = [flat.inputs[graph.b[each]] for each in symbols if graph.group(each) is Group.U]
        moved = any(graph.group(each) is Group.W and kinds[graph.b[each]] == "load" for each in symbols)
        return (
            not moved
            and groups <= {Group.U, Group.W, Group.P}
            and bool(given)
            and all(item.base != "Real" for item in given)
        )

    return tuple(is_held(node) for node in program.function("indicator").results[0].elements)
