"""Colors of shapes, as on the living page, and light."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.shapes import Shape
from lagdsl.foundation.numerics.rank import Floats

Color = tuple[float, float, float]

_OTHER = "#64748b"
_COLORS = {
    "spring": "#0d9488", "damper": "#7c3aed", "mass": "#2563eb", "body": "#3b82f6", "box": "#3b82f6",
    "cylinder": "#60a5fa", "cone": "#3b82f6", "disc": "#3b82f6", "sphere": "#2563eb", "circle": "#475569",
    "arrow": "#d97706", "force": "#dc2626", "torque": "#ea580c", "trace": "#d97706", "slider": "#2563eb",
    "dial": "#2563eb", "ground": "#94a3b8", "mesh": "#94a3b8",
}  # fmt: skip
PAPER = "#f8fafc"
GRID = "#dbe3ec"
INK = "#475569"
# Over the left shoulder of the viewer: right, up, back.
_SUN = np.array([0.35, 0.6, 0.72]) / np.linalg.norm([0.35, 0.6, 0.72])


def color_of(shape: Shape) -> Color:
    """The color that a drawing asks for, where Matplotlib knows it, else that of its kind."""
    from matplotlib.colors import is_color_like, to_rgb

    named = dict(shape.texts).get("color")
    return to_rgb(named if named is not None and is_color_like(named) else _COLORS.get(shape.kind, _OTHER))


def lit(color: Color, normals: Floats) -> Floats:
    """Colors (n, 3) of faces whose unit normals (n, 3) are in the viewer's axes."""
    bright = np.clip(normals @ _SUN, 0.0, 1.0)[:, None]
    shade = np.array(color) * (0.62 + 0.43 * bright)
    return np.asarray(np.clip(shade + 0.10 * bright**8, 0.0, 1.0))
