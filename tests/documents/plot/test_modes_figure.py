"""Figures of modes and root loci."""

from __future__ import annotations

import shlex
from pathlib import Path

import numpy as np
import pytest
from choice import ALL
from click.testing import CliRunner

import lagdsl
from lagdsl.documents.plot.modes import plot_modes, plot_variation
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.analysis.modes import phase_of

MODELS = Path(__file__).parents[3] / "models"


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


@pytest.mark.parametrize(
    ("entry", "text"), [(1 - 1e-5j, "0"), (1 + 1e-5j, "0"), (-1 - 1e-5j, "180"), (-1j, "-90"), (1 - 0.01j, "-1")]
)
def test_phases_have_no_sign_of_rounding(entry: complex, text: str) -> None:
    """`-0°` stood in figures, and `-180°` beside `180°`."""
    assert f"{phase_of(entry):.0f}" == text


def test_the_command_of_the_manual_warns_of_nothing(tmp_path: Path) -> None:
    """Without --trim the modes of the page were those of a state that is no equilibrium (W0854)."""
    text = (MODELS.parent / "docs" / "reference" / "living_page.md").read_text(encoding="utf-8")
    (line,) = (line for line in text.splitlines() if line.startswith("lag modes "))
    words = [word.replace("models/", f"{MODELS}/") for word in shlex.split(line)[1:]]
    words[words.index("--page") + 1] = str(tmp_path / "modes.html")
    if not ALL:  # three values of P instead of a hundred, each with an equilibrium to find
        words[words.index("P=0:3 N")] = "P=0:1.5:3 N"
    done = CliRunner().invoke(lag, words)
    assert (done.exit_code, done.stderr) == (0, "")
