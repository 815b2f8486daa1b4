"""Pieces that a picture is painted from: faces in space, ribbons along lines, words."""

from __future__ import annotations

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record


@record(kw_only=True)
class Faces:
    """Quadrilaterals (n, 4, 3) [m], counterclockwise seen from outside, in one color (red, green, blue), 0 to 1.

    `opacity` 0 to 1. `closed`: nobody sees the inside. `flat`: a line or a mark, which has no light and shade.
    """

    corners: Floats
    color: tuple[float, float, float]
    opacity: float = 1.0
    closed: bool = True
    flat: bool = False


@record(kw_only=True)
class Ribbon:
    """A line through points (n, 3) [m], as wide in the picture as `width` [m] is there; `opacity` 0 to 1."""

    points: Floats
    width: float
    color: tuple[float, float, float]
    opacity: float = 1.0


@record(kw_only=True)
class Words:
    """A text at a point [m], as high as `size` [m]."""

    text: str
    at: Floats
    size: float


Painted = Faces | Ribbon | Words
