"""Origin and axes of a frame as vectors of the flat model; structural zeros for the world."""

from __future__ import annotations

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression


def axis_of(frame: str, axis: int) -> FlatExpression:
    if frame != "world":
        return flat.FrameAxis(frame, axis)
    x, y, z = (flat.ONE if k == axis else flat.ZERO for k in range(3))
    return flat.Vector(x, y, z)


def origin_of(frame: str) -> FlatExpression:
    return flat.FrameOrigin(frame) if frame != "world" else flat.ZERO_VECTOR
