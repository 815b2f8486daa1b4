"""Figures of small motions: mode shapes, and eigenvalues that move with a parameter."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from lagdsl.documents.plot.figure import COLORS, STYLE, escaped, matplotlib_or_reason, save
from lagdsl.motion.analysis.modes import Modes, phase_of
from lagdsl.motion.analysis.variation import Variation

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_MODES = 8
_MOST_PLACES = 24
_COLUMNS = 2


def plot_modes(modes: Modes, path: Path | str | None = None) -> Figure:
    """One panel for each mode: amplitudes of coordinates and states as bars with sign, or with phase where it is none.

    Of a pair of conjugate eigenvalues one is drawn. Needs the extra `plot`; written to `path` if given.
    """
    shown = [i for i, s in enumerate(modes.eigenvalues.tolist()) if not s.imag < 0.0 and s != 0.0]
    shown = shown[:_MOST_MODES]
    rows = max((len(shown) + _COLUMNS - 1) // _COLUMNS, 1)
    columns = min(_COLUMNS, max(len(shown), 1))
    places = min(len(modes.places), _MOST_PLACES)
    figure, axes = _panels(rows, columns, (4.2 * columns, 0.7 + rows * (1.1 + 0.2 * places)), share=True)
    for panel, i in zip(axes, shown, strict=False):
        _draw_shape(panel, modes, i, places)
    for panel in axes[len(shown) :]:
        panel.set_visible(False)
    figure.suptitle(f"{modes.model}: mode shapes", x=0.01, ha="left", fontweight="bold", color="#333333", fontsize=10)
    return _finished(figure, path)


def plot_variation(variation: Variation, path: Path | str | None = None) -> Figure:
    """The root locus, colored by the varied value, and real parts and frequencies over it, with the thresholds.

    Needs the extra `plot`; written to `path` if given.
    """
    figure, (locus, growth, frequency) = _panels(1, 3, (11.0, 3.6), share=False)
    unit = variation.varied.unit
    label = escaped(variation.varied.name) + (f" [{unit}]" if unit not in ("", "1") else "")
    values, s = variation.values, variation.eigenvalues
    points = locus.scatter(
        s.real.ravel(), s.imag.ravel(), c=np.repeat(values, s.shape[1]), s=7, cmap="viridis", linewidths=0.0
    )
    figure.colorbar(points, ax=locus, label=label, pad=0.02)
    locus.axvline(0.0, color="#333333", linewidth=0.8)
    locus.set(xlabel="real part [1/s]", ylabel="imaginary part [1/s]")
    for branch in range(s.shape[1]):
        color = COLORS[branch % len(COLORS)]
        growth.plot(values, s[:, branch].real, ".", markersize=3, color=color)
        frequency.plot(values, np.abs(s[:, branch].imag) / (2.0 * np.pi), ".", markersize=3, color=color)
    growth.axhline(0.0, color="#333333", linewidth=0.8)
    growth.set(xlabel=label, ylabel="real part [1/s]")
    frequency.set(xlabel=label, ylabel="frequency [Hz]")
    for each in variation.thresholds:
        for panel in (growth, frequency):
            panel.axvline(each.value, color="#D55E00", linewidth=0.9, linestyle="--")
        locus.plot([0.0, 0.0], [each.eigenvalue.imag, -each.eigenvalue.imag], "x", color="#D55E00", markersize=6)
        frequency.annotate(
            f" {each.kind} {each.value:.5g}",
            (each.value, 1.0),
            xycoords=("data", "axes fraction"),
            rotation=90,
            va="top",
            ha="right",
            fontsize=8,
            color="#D55E00",
        )
    locus.set_title(variation.model, loc="left", fontweight="bold", color="#333333")
    return _finished(figure, path)


def _panels(rows: int, columns: int, size: tuple[float, float], *, share: bool) -> tuple[Figure, list[Axes]]:
    mpl, figure_class, canvas_class = matplotlib_or_reason()
    with mpl.rc_context(cast(Any, STYLE)):
        figure = figure_class(figsize=size, layout="constrained")
        canvas_class(figure)
        grid = figure.subplots(rows, columns, squeeze=False, sharex=share, sharey=share)
    return figure, list(grid.ravel())


def _draw_shape(panel: Axes, modes: Modes, i: int, places: int) -> None:
    shape = modes.shapes[i, :places]
    real = bool(np.all(np.abs(shape.imag) <= 1e-6))
    heights = shape.real if real else np.abs(shape)
    positions = np.arange(places)
    panel.barh(positions, heights, height=0.6, color=COLORS[0] if real else COLORS[5])
    if not real:
        for position, entry in zip(positions, shape.tolist(), strict=True):
            if abs(entry) > 1e-6:
                angle = f" {phase_of(entry):.0f}°"
                panel.annotate(angle, (abs(entry), position), va="center", fontsize=7, color="#333333")
    panel.axvline(0.0, color="#333333", linewidth=0.8)
    panel.set_yticks(positions, [escaped(named.name) for named in modes.places[:places]])
    panel.set_ylim(places - 0.4, -0.6)
    panel.set_xlim(-1.25, 1.25)
    panel.set_title(_title(modes, i), loc="left", fontsize=9, color="#333333")


def _title(modes: Modes, i: int) -> str:
    s, f, z = complex(modes.eigenvalues[i]), float(modes.frequencies[i]), float(modes.damping[i])
    if f > 0.0:
        return f"{f:.4g} Hz" + (f", damping {z:.3g}" if abs(z) > 1e-7 else "")
    return "zero" if s == 0.0 else f"{s.real:.4g} 1/s"


def _finished(figure: Figure, path: Path | str | None) -> Figure:
    if path is not None:
        save(figure, path)
    return figure
