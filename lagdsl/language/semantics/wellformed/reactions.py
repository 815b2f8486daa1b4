"""A reaction that is asked for is the reaction on something (W0525)."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place
from lagdsl.language.semantics.wellformed.effect import physics
from lagdsl.language.semantics.wellformed.readings import mechanical, with_released


def check_reactions(flat: fm.FlatModel, sink: Sink) -> None:
    """W0525 where nothing that has mass, load or constraint is reached through a point whose reaction is asked for."""
    asked: dict[str, Item] = {}
    for node, item in mechanical(flat):
        if isinstance(node, fx.ReactionAlong):
            asked.setdefault(node.point, item)
    for point, item in asked.items():
        if not any(point in orders for orders in physics(flat, with_released(flat, frozenset((point,))))):
            sink.report("W0525", place(item), *around(item), name=point)
