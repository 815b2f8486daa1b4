"""Colors and light."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.shapes import Part
from lagdsl.foundation.numerics.rank import Floats

Color = tuple[float, float, float]

_OTHER = "#64748b"
PAPER = "#f8fafc"
GRID = "#dbe3ec"
INK = "#475569"
# Over the left shoulder of the viewer: right, up, back.
_SUN = np.array([0.35, 0.6, 0.72]) / np.linalg.norm([0.35, 0.6, 0.72])


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
