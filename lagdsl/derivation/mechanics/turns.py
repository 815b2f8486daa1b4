"""Outputs that are known up to whole turns, on the graph: what a run counts them by."""

from __future__ import annotations

from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Function, vector_block
from lagdsl.language.flat.model import FlatModel


def turn_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """`turn` of a model with coordinates of cut joints that are known up to whole turns; none for others."""
    turns = [(place, item.value, item.turn) for place, item in enumerate(flat.outputs) if item.turn is not None]
    if not turns:
        return ()
    values = [lowering.scalar(value) for _, value, _ in turns]
    blocks = {
        "value": values,
        "rate": [lowering.rate.of(value) for value in values],
        "turn": [lowering.scalar(turn) for _, _, turn in turns],
        "entry": [lowering.graph.constant(float(place)) for place, _, _ in turns],
    }
    results = tuple(vector_block(name, nodes) for name, nodes in blocks.items())
    return (Function(name="turn", arguments=OPTIONAL["turn"], results=results),)
