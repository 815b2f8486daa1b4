"""Outputs of the flat model by what computes them."""

from __future__ import annotations

from lagdsl.flat.model import FlatModel, Output


def discrete_outputs(flat: FlatModel) -> tuple[str, ...]:
    """Names of the discrete variables that are declared `output`: they stand among both, under one name."""
    outputs = {item.name for item in flat.outputs}
    return tuple(item.name for item in flat.events.discretes if item.name in outputs)


def computed_outputs(flat: FlatModel) -> tuple[Output, ...]:
    """All other outputs."""
    discrete = frozenset(discrete_outputs(flat))
    return tuple(item for item in flat.outputs if item.name not in discrete)
