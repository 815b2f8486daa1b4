"""Figures of small motions: mode shapes, and eigenvalues that move with a parameter."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from lagdsl.documents.plot.sheet import COLORS, DARK, escaped, in_brackets, sheet, title
from lagdsl.motion.analysis.modes import Modes, phase_of
from lagdsl.motion.analysis.variation import Variation

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_MODES = 8
_MOST_PLACES = 24
_COLUMNS = 2
_THRESHOLD = COLORS[1]


def plot_modes(modes: Modes, path: Path | str | None = None) -> Figure:
    """One panel for each mode: amplitudes of coordinates and states as bars with sign, or with phase where it is none.

    Of a pair of conjugate eigenvalues one is drawn. Needs the extra `plot`; written to `path` if given.
    """
    shown = [i for i, s in enumerate(modes.eigenvalues.tolist()) if not s.imag < 0.0 and s != 0.0]
    shown = shown[:_MOST_MODES]
    rows = max((len(shown) + _COLUMNS - 1) // _COLUMNS, 1)
    columns = min(_COLUMNS, max(len(shown), 1))
    places = min(len(modes.places), _MOST_PLACES)
    with sheet((4.2 * columns, 0.7 + rows * (1.1 + 0.2 * places)), path) as figure:
        axes = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True).ravel()
        for panel, i in zip(axes, shown, strict=False):
            _draw_shape(panel, modes, i, places)
        for panel in axes[len(shown) :]:
            panel.set_visible(False)
        figure.suptitle(f"{modes.model}: mode shapes", x=0.01, ha="left", fontweight="bold", color=DARK, fontsize=10)
    return figure


def plot_variation(variation: Variation, path: Path | str | None = None) -> Figure:
    """The root locus, colored by the varied value, and real parts and frequencies over it, with the thresholds.

    Needs the extra `plot`; written to `path` if given.
    """
    with sheet((11.0, 3.6), path) as figure:
        locus, growth, frequency = figure.subplots(1, 3)
        label = escaped(variation.varied.name) + in_brackets(variation.varied.unit)
        values, s = variation.values, variation.eigenvalues
        colors = np.repeat(values, s.shape[1])
        points = locus.scatter(s.real.ravel(), s.imag.ravel(), c=colors, s=7, cmap="viridis", linewidths=0.0)
        figure.colorbar(points, ax=locus, label=label, pad=0.02)
        locus.axvline(0.0, color=DARK, linewidth=0.8)
        locus.set(xlabel="real part [1/s]", ylabel="imaginary part [1/s]")
        for panel, of, words in (
            (growth, s.real, "real part [1/s]"),
            (frequency, np.abs(s.imag) / (2.0 * np.pi), "frequency [Hz]"),
        ):
            for branch, column in enumerate(of.T):
                panel.plot(values, column, ".", markersize=3, color=COLORS[branch % len(COLORS)])
            panel.set(xlabel=label, ylabel=words)
            for each in variation.thresholds:
                panel.axvline(each.value, color=_THRESHOLD, linewidth=0.9, linestyle="--")
        growth.axhline(0.0, color=DARK, linewidth=0.8)
        for each in variation.thresholds:
            locus.plot([0.0, 0.0], [each.eigenvalue.imag, -each.eigenvalue.imag], "x", color=_THRESHOLD, markersize=6)
            frequency.annotate(
                f" {each.kind} {each.value:.5g}", (each.value, 1.0), xycoords=("data", "axes fraction"),
                rotation=90, va="top", ha="right", fontsize=8, color=_THRESHOLD,
            )  # fmt: skip
        title(locus, variation.model)
    return figure


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
                panel.annotate(angle, (abs(entry), position), va="center", fontsize=7, color=DARK)
    panel.axvline(0.0, color=DARK, linewidth=0.8)
    panel.set_yticks(positions, [escaped(named.name) for named in modes.places[:places]])
    panel.set_ylim(places - 0.4, -0.6)
    panel.set_xlim(-1.25, 1.25)
    panel.set_title(_title(modes, i), loc="left", fontsize=9, color=DARK)


def _title(modes: Modes, i: int) -> str:
    s, f, z = complex(modes.eigenvalues[i]), float(modes.frequencies[i]), float(modes.damping[i])
    if f > 0.0:
        return f"{f:.4g} Hz" + (f", damping {z:.3g}" if abs(z) > 1e-7 else "")
    return "zero" if s == 0.0 else f"{s.real:.4g} 1/s"
