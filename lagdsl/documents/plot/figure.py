"""A figure of a motion: what moves, how fast, what comes out, and whether the energy behaves."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from lagdsl.motion.signals.trajectory import Column, Trajectory

if TYPE_CHECKING:
    from types import ModuleType

    from matplotlib.axes import Axes
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

# Endings of files that a figure can be written to.
FORMS = (".eps", ".jpg", ".pdf", ".png", ".svg", ".webp")
# Okabe and Ito's colors, told apart with any kind of color vision.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
LINES: tuple[Literal["-", "--", ":", "-."], ...] = ("-", "--", ":", "-.")
_MOST_CURVES = 14
_MOST_LINES = 100
_MARKS = "#999999"
STYLE: dict[str, Any] = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#666666",
    "axes.labelcolor": "#333333",
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "xtick.color": "#666666",
    "ytick.color": "#666666",
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
}


def matplotlib_or_reason() -> tuple[ModuleType, type[Figure], type[FigureCanvasAgg]]:
    """Matplotlib, its figure and a canvas that belongs to no window. Raises ModuleNotFoundError."""
    try:
        import matplotlib as mpl
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(f"figures need matplotlib: pip install matplotlib ({missing})") from missing
    return mpl, Figure, FigureCanvasAgg


def plot(trajectory: Trajectory, path: Path | str | None = None) -> Figure:
    """One panel for each kind of quantity and unit, above one time axis; written to `path` (by its suffix) if given.

    Needs the extra `plot`. The figure belongs to no window and needs no display. `plot_of` draws chosen columns.
    """
    mpl, figure_class, canvas_class = matplotlib_or_reason()
    trajectory = trajectory.drawn(smooth=True)
    panels = _panels(trajectory)
    heights = [1.5, *([1.0] * (len(panels) - 1))] if panels else []
    energy = bool(np.any(np.isfinite(trajectory.energy)) and np.any(trajectory.energy))
    rows = len(panels) + energy
    with mpl.rc_context(cast(Any, STYLE)):
        figure = figure_class(figsize=(8.0, 1.2 + 1.75 * max(sum(heights) + energy, 1.0)), layout="constrained")
        canvas_class(figure)
        grid = figure.subplots(
            max(rows, 1), 1, sharex=True, squeeze=False, height_ratios=[*heights, *[1.0] * energy] or [1]
        )
        axes: list[Axes] = list(grid[:, 0])
        for panel, columns in zip(axes, panels, strict=False):
            _draw(panel, trajectory, columns)
        if energy:
            _draw_energy(axes[-1], trajectory)
        times = sorted({event.time for event in trajectory.events if event.kind != "tick"})
        for panel in axes:
            mark_events(panel, times, float(trajectory.time[-1] - trajectory.time[0]))
        axes[-1].set_xlabel("time [s]")
        axes[0].set_title(trajectory.model, loc="left", fontweight="bold", color="#333333")
        axes[-1].set_xlim(float(trajectory.time[0]), float(trajectory.time[-1]) if len(trajectory) > 1 else None)
        figure.align_ylabels(axes)
        if path is not None:
            save(figure, path)
    return figure


def save(figure: Figure, path: Path | str) -> None:
    """In the form of the suffix; a file without one, as drafts of atomic writing have, is a PNG."""
    suffix = Path(path).suffix.lstrip(".").lower()
    known = suffix in figure.canvas.get_supported_filetypes()
    figure.savefig(path, dpi=150, format=suffix if known else "png")


def _panels(trajectory: Trajectory) -> list[list[Column]]:
    """Columns that share an axis: same kind, same display unit; in order of first appearance."""
    panels: dict[tuple[str, str], list[Column]] = {}
    for column in trajectory.columns[1:]:
        panels.setdefault((column.kind, column.display.unit), []).append(column)
    return list(panels.values())


def _draw(panel: Axes, trajectory: Trajectory, columns: Sequence[Column]) -> None:
    for index, column in enumerate(columns[:_MOST_CURVES]):
        values = column.values * column.display.scale + column.display.shift
        panel.plot(
            trajectory.time,
            values,
            color=COLORS[index % len(COLORS)],
            linestyle=LINES[index // len(COLORS) % len(LINES)],
            label=escaped(column.name),
        )
    panel.set_ylabel(_label(columns))
    panel.margins(y=0.08)
    panel.ticklabel_format(axis="y", useOffset=False)
    if len(columns) > 1:
        hidden = len(columns) - _MOST_CURVES
        title = f"and {hidden} more" if hidden > 0 else None
        panel.legend(loc="upper left", bbox_to_anchor=(1.0, 1.03), title=title, fontsize=8, handlelength=1.6)


def mark_events(panel: Axes, times: Sequence[float], length: float) -> None:
    """Lines at `times`, or dashes at the bottom if lines would hide the curves; `length` of the motion, all in s."""
    apart = [t for k, t in enumerate(times) if k == 0 or t - times[k - 1] > length / _MOST_LINES]
    if len(apart) < len(times) or len(times) > _MOST_LINES // 4:
        (marks,) = panel.plot(times, np.zeros(len(times)), marker="|", linestyle="", color=_MARKS, markersize=5)
        marks.set(transform=panel.get_xaxis_transform(), clip_on=False, zorder=1)
    else:
        for time in times:
            panel.axvline(time, color=_MARKS, linewidth=0.7, linestyle=(0, (4, 3)), zorder=0.9)


def _label(columns: Sequence[Column]) -> str:
    """The name of a lone curve, else what the curves have in common; and the unit."""
    plural = {"coordinate": "coordinates", "rate": "rates", "state": "states", "discrete": "discretes"}
    name = escaped(columns[0].name) if len(columns) == 1 else plural.get(columns[0].kind, "outputs")
    unit = columns[0].display.unit
    return f"{name}\n[{unit}]" if unit not in ("", "1") else name


def _draw_energy(panel: Axes, trajectory: Trajectory) -> None:
    """The energy itself where it changes visibly, its drift where it is conserved."""
    change = trajectory.energy - trajectory.energy[0]
    size = float(np.nanmax(np.abs(trajectory.energy)))
    conserved = float(np.nanmax(np.abs(change))) < 1e-4 * size
    panel.plot(trajectory.time, change if conserved else trajectory.energy, color="#555555")
    panel.set_ylabel("energy drift\n[J]" if conserved else "energy\n[J]")
    panel.margins(y=0.08)
    if conserved:
        panel.ticklabel_format(axis="y", style="sci", scilimits=(0, 0))
        panel.text(
            1.0,
            1.02,
            f"of {trajectory.energy[0]:.5g} J",
            transform=panel.transAxes,
            ha="right",
            va="bottom",
            color="#666666",
            fontsize=8,
        )


def escaped(name: str) -> str:
    """Names are plain text: `$` would start a formula, a leading `_` would hide a legend entry."""
    text = name.replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text
