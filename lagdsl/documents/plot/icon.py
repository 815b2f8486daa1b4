"""A small square picture of a model for lists and diagrams of other tools: its first curves, without axes."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.documents.plot.sheet import COLORS, DARK, escaped, sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from lagdsl.motion.signals.trajectory import Trajectory

_CURVES = 3
_INCHES, _DOTS = 2.0, 128
# The largest letters that still leave a long name within the picture.
_LARGEST, _WIDTH = 16.0, 210.0


def icon(trajectory: Trajectory) -> bytes:
    """A PNG of 256 x 256 pixels; the same motion, the same bytes. Needs the extra `plot`."""
    with sheet((_INCHES, _INCHES), layout=None) as figure:
        axes = figure.add_axes((0.08, 0.2, 0.84, 0.72))
        axes.set_axis_off()
        for color, column in zip(COLORS, trajectory.columns[1 : 1 + _CURVES], strict=False):
            low, high = np.min(column.values), np.max(column.values)
            heights = (column.values - low) / (high - low) if high > low else np.full(len(trajectory), 0.5)
            axes.plot(trajectory.time, heights, color=color, linewidth=2.2, solid_capstyle="round")
        name = escaped(trajectory.model)
        size = min(_LARGEST, _WIDTH / max(len(name), 1))
        figure.text(0.5, 0.06, name, ha="center", va="bottom", fontsize=size, fontweight="bold", color=DARK)
        return png(figure, _DOTS)


def png(figure: Figure, dots: int = 110) -> bytes:
    """The figure as a PNG that does not tell which version of Matplotlib made it."""
    file = BytesIO()
    figure.savefig(file, dpi=dots, format="png", metadata={"Software": None})
    return file.getvalue()
