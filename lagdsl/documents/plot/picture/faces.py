"""Pieces that a picture is painted from: faces in space and words; colors and light."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.shapes import Part
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

Color = tuple[float, float, float]
"""Red, green, blue, 0 to 1."""

_OTHER = "#64748b"
PAPER = "#f8fafc"
GRID = "#dbe3ec"
INK = "#475569"
# Over the left shoulder of the viewer: right, up, back.
_SUN = np.array([0.35, 0.6, 0.72]) / np.linalg.norm([0.35, 0.6, 0.72])


@record(kw_only=True)
class Faces:
    """Quadrilaterals (n, 4, 3) [m], counterclockwise seen from outside, in one color.

    `opacity` 0 to 1. `closed`: nobody sees the inside. `flat`: a line or a mark, which has no light and shade.
    """

    corners: Floats
    color: Color
    opacity: float = 1.0
    closed: bool = True
    flat: bool = False


@record(kw_only=True)
class Words:
    """A text at a point [m], as high as `size` [m]."""

    text: str
    at: Floats
    size: float


Painted = Faces | Words


def color_of(part: Part) -> Color:
    """The color of a part, where Matplotlib knows it."""
    from matplotlib.colors import is_color_like, to_rgb

    red, green, blue = to_rgb(part.color if is_color_like(part.color) else _OTHER)
    return red * part.shade, green * part.shade, blue * part.shade


def lit(color: Color, normals: Floats) -> Floats:
    """Colors (n, 3) of faces whose unit normals (n, 3) are in the viewer's axes."""
    bright = np.clip(normals @ _SUN, 0.0, 1.0)[:, None]
    shade = np.array(color) * (0.62 + 0.43 * bright)
    return np.asarray(np.clip(shade + 0.10 * bright**8, 0.0, 1.0))


def ribbon(points: Floats, width: float, towards: Floats, color: Color, opacity: float = 1.0) -> Faces:
    """A line through points (n, 3) [m], turned `towards` the viewer (3,), its pieces a little longer than they are, so
    that they join."""
    points = points[np.all(np.isfinite(points), axis=1)]
    ways = np.diff(points, axis=0)
    across = np.cross(towards, ways)
    sizes = np.linalg.norm(across, axis=1)
    kept = sizes > 1e-9 * float(np.max(sizes, initial=0.0))
    a, b, side = points[:-1][kept], points[1:][kept], 0.5 * width * across[kept] / sizes[kept, None]
    longer = (0.5 if opacity == 1.0 else 0.0) * np.cross(side, towards)
    corners = np.stack([a - side - longer, b - side + longer, b + side + longer, a + side - longer], axis=1)
    return Faces(corners=corners, color=color, opacity=opacity, closed=False, flat=True)
