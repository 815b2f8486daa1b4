"""The frames and points of a model by name."""

from __future__ import annotations

from lagdsl.flat.model import FlatModel, Frame, Point


def frame_names(flat: FlatModel) -> list[str]:
    """In the order of their definition, without the world."""
    return [item.name for item in flat.named if isinstance(item, Frame)]


def point_names(flat: FlatModel) -> list[str]:
    """In the order of their definition."""
    return [item.name for item in flat.named if isinstance(item, Point)]
