"""Frames, points and outputs of a model in lists of their own."""

from __future__ import annotations

from lagdsl.flat.model import FlatModel, Frame, Output, Point


def frame_names(flat: FlatModel) -> list[str]:
    """In the order of their definition, without the world."""
    return [item.name for item in flat.named if isinstance(item, Frame)]


def point_names(flat: FlatModel) -> list[str]:
    """In the order of their definition."""
    return [item.name for item in flat.named if isinstance(item, Point)]


def discrete_outputs(flat: FlatModel) -> tuple[str, ...]:
    """Names of the discrete variables that are declared `output`: they stand among both, under one name."""
    outputs = {item.name for item in flat.outputs}
    return tuple(item.name for item in flat.events.discretes if item.name in outputs)


def computed_outputs(flat: FlatModel) -> tuple[Output, ...]:
    """All other outputs."""
    discrete = frozenset(discrete_outputs(flat))
    return tuple(item for item in flat.outputs if item.name not in discrete)
