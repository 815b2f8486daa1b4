"""Figures of modes and root loci."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import lagdsl
from lagdsl.plot.modes import plot_modes, plot_variation

MODELS = Path(__file__).parents[2] / "models"


def test_a_panel_for_each_mode() -> None:
    figure = plot_modes(lagdsl.compile(MODELS / "three_masses.lag").modes(trim=True))
    shown = [panel for panel in figure.axes if panel.get_visible()]
    assert [panel.get_title(loc="left") for panel in shown] == ["1.055 Hz", "1.949 Hz", "2.547 Hz"]
    np.testing.assert_allclose([bar.get_width() for bar in shown[1].patches], [1, 0, -1], atol=1e-12)


def test_phases_are_written_where_there_are_any() -> None:
    figure = plot_modes(lagdsl.compile(MODELS / "sleeping_top.lag").modes(q=[0, 0, 0]))
    assert "-90" in "".join(text.get_text() for text in figure.axes[0].texts)


def test_thresholds_are_marked() -> None:
    variation = lagdsl.compile(MODELS / "ziegler_column.lag").vary("P", np.linspace(0, 3, 11), q=[0, 0])
    figure = plot_variation(variation)
    assert any("flutter 2.0858" in text.get_text() for panel in figure.axes for text in panel.texts)
