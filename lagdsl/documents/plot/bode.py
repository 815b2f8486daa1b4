"""Bode plots: magnitude and phase over the frequency, with the margins of the loop."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.documents.plot.sheet import COLORS, DARK, escaped, sheet, title
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse
from lagdsl.motion.analysis.control.margins import Crossing, lag

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MARK = COLORS[1]
# Percent of the points, the highest and the lowest, may leave the panel; so many decibels beyond the others.
_SPIKES = 5.0
_BEYOND = 30.0


def plot_bode(found: FrequencyResponse, path: Path | str | None = None) -> Figure:
    """Two panels over one axis of frequency in Hz; written to `path` if given. Needs the extra `plot`."""
    unit = found.output.unit, found.input.unit
    units = "" if unit == ("", "") else f" [{unit[0] or '1'} per {unit[1] or '1'}]"
    with sheet((7.0, 5.0), path) as figure:
        above, below = figure.subplots(2, 1, sharex=True)
        _draw(above, below, found)
        title(above, escaped(f"{found.model}: from {found.input.name} to {found.output.name}{units}"))
        figure.align_ylabels([above, below])
    return figure


def _draw(above: Axes, below: Axes, found: FrequencyResponse) -> None:
    turns = np.degrees(found.phase)
    above.semilogx(found.frequencies, found.decibels, color=COLORS[0])
    below.semilogx(found.frequencies, turns, color=COLORS[0])
    finite = found.decibels[np.isfinite(found.decibels)]
    least, most = np.percentile(finite, [_SPIKES, 100.0 - _SPIKES]) if len(finite) else (0.0, 0.0)
    above.set_ylim(bottom=max(above.get_ylim()[0], least - _BEYOND), top=min(above.get_ylim()[1], most + _BEYOND))
    above.set_ylabel("magnitude [dB]")
    below.set_ylabel("phase [deg]")
    below.set_xlabel("frequency [Hz]")
    below.xaxis.set_major_formatter("{x:g}")
    below.margins(y=0.12)
    below.yaxis.set_major_locator(_steps(turns))
    above.set_xlim(float(found.frequencies[0]), float(found.frequencies[-1]))
    if found.every is not None:
        for panel in (above, below):
            panel.axvline(0.5 / found.every, color=DARK, linewidth=0.8)
    if found.margins is not None:
        _draw_margins(above, below, found)


def _steps(turns: Any) -> Any:
    """Ticks at parts of a turn."""
    from matplotlib.ticker import MultipleLocator

    finite = turns[np.isfinite(turns)]
    span = float(np.ptp(finite)) if len(finite) else 0.0
    return MultipleLocator(next((step for step in (15.0, 30.0, 45.0, 90.0, 180.0) if span <= 6.0 * step), 360.0))


def _draw_margins(above: Axes, below: Axes, found: FrequencyResponse) -> None:
    """Lines from the curves to gain one and to half a turn, at the crossings that decide."""
    margins = found.margins
    assert margins is not None
    above.axhline(0.0, color=DARK, linewidth=0.8, linestyle=":")
    of_gain = next((each for each in margins.of_gain if 1.0 / abs(each.value) == margins.gain), None)
    if of_gain is not None:
        decibels = 20.0 * math.log10(abs(of_gain.value))
        _mark(above, _hertz(of_gain), (decibels, 0.0), f"{round(-decibels, 1) + 0.0:g} dB")
    of_phase = next((each for each in margins.of_phase if lag(each.value) == margins.phase), None)
    if of_phase is not None:
        place = float(np.interp(_hertz(of_phase), found.frequencies, np.degrees(found.phase)))
        angle = math.degrees(margins.phase)
        below.axhline(place - angle, color=DARK, linewidth=0.8, linestyle=":")
        _mark(below, _hertz(of_phase), (place, place - angle), f"{round(angle, 1) + 0.0:g}°")


def _mark(panel: Axes, at: float, ends: tuple[float, float], text: str) -> None:
    """A line from the curve to the border, with its length beyond the border, where no curve is."""
    curve, border = ends
    panel.plot([at, at], ends, color=_MARK, linewidth=1.6, marker="o", markersize=3)
    below = curve > border
    panel.annotate(
        text.replace("-", "\u2212"), (at, border), xytext=(0, -4 if below else 4), textcoords="offset points",
        ha="center", va="top" if below else "bottom", color=_MARK, fontsize=9,
    )  # fmt: skip


def _hertz(crossing: Crossing) -> float:
    return crossing.omega / (2.0 * math.pi)
