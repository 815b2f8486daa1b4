"""Figures and sketches of a motion."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from plot.motions import ANGLE, T, bounces, column, trajectory

from lagdsl.documents.plot.figure import plot
from lagdsl.documents.plot.terminal import braille, sketch
from lagdsl.motion.signals.trajectory import Event


def test_one_panel_for_each_kind_and_unit() -> None:
    x, y, v = column("x", T), column("y", T**2), column("der(x)", T, "rate", "m/s")
    figure = plot(trajectory(ANGLE, x, y, v, energy=5.0 + 1e-9 * T))
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert labels == ["theta\n[deg]", "coordinates\n[m]", "der(x)\n[m/s]", "energy drift\n[J]"]
    assert [text.get_text() for text in figure.axes[1].get_legend().get_texts()] == ["x", "y"]
    assert figure.axes[0].lines[0].get_ydata().max() == pytest.approx(np.rad2deg(1.0), rel=1e-3)
    assert figure.axes[-1].get_xlabel() == "time [s]"
    assert len({line.get_color() for line in figure.axes[1].lines}) == 2


def test_energy_that_changes_is_shown_itself() -> None:
    figure = plot(trajectory(ANGLE, energy=5.0 - T))
    assert figure.axes[-1].get_ylabel() == "energy\n[J]"


def test_no_panel_for_an_energy_that_is_always_zero() -> None:
    assert len(plot(trajectory(column("z", T, "state", "1"))).axes) == 1
    assert len(plot(trajectory()).axes) == 1


def test_lines_show_where_something_happened_but_no_ticks() -> None:
    tick = Event(time=0.3, name="sample(0, 0.1 s)", kind="tick")
    figure = plot(trajectory(ANGLE, energy=5.0 - T, events=(*bounces(0.5, 1.5), tick)))
    for panel in figure.axes:
        assert [line.get_xdata()[0] for line in panel.lines[1:]] == [0.5, 1.5]


def test_many_events_are_dashes_below_the_curves() -> None:
    for times in (np.linspace(0.1, 1.9, 40), 1.0 - 0.5 ** np.arange(10)):
        (panel,) = plot(trajectory(ANGLE, events=bounces(*times))).axes
        curve, marks = panel.lines
        assert marks.get_linestyle() == "None" and marks.get_marker() == "|"
        np.testing.assert_allclose(marks.get_xdata(), times)
        assert set(marks.get_ydata()) == {0.0} and len(curve.get_xdata()) == len(T)


def test_many_curves_are_cut_off_and_said_so() -> None:
    figure = plot(trajectory(*[column(f"x[{i}]", T * i) for i in range(30)]))
    assert len(figure.axes[0].lines) == 14
    assert figure.axes[0].get_legend().get_title().get_text() == "and 16 more"


def test_names_are_plain_text() -> None:
    figure = plot(trajectory(column("$a^{", T), column("_b", T)))
    texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert texts == [r"\$a^{", " _b"]


def test_files_by_suffix(tmp_path: Path) -> None:
    motion = trajectory(ANGLE)
    plot(motion, tmp_path / "a.png")
    plot(motion, tmp_path / "a.svg")
    plot(motion, tmp_path / "draft")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert b"<svg" in (tmp_path / "a.svg").read_bytes()
    assert (tmp_path / "draft").read_bytes().startswith(b"\x89PNG")


def test_one_row_only() -> None:
    motion = trajectory(ANGLE)
    columns = tuple(replace(c, values=c.values[:1]) for c in motion.columns)
    short = replace(motion, columns=columns, checks=[check[:1] for check in motion.checks[:3]])
    assert len(plot(short).axes) == 1
    assert sketch(short) == ""


# ---- terminal --------------------------------------------------------------------------------------------------------


def test_braille_of_a_rising_line() -> None:
    """Two dots by four in each character: a straight rise through three characters."""
    assert braille(T, T, width=3, height=1) == ["⣀⠤⠊"] or [len(r) for r in braille(T, T, width=3, height=1)] == [3]
    up = braille(T, T, width=8, height=2)
    assert up[0][:3] == "⠀⠀⠀" and up[1][-3:] == "⠀⠀⠀"
    assert up[0][-1] != "⠀" and up[1][0] != "⠀"
    down = braille(T, -T, width=8, height=2)
    assert down[0][0] != "⠀" and down[1][-1] != "⠀"


def test_braille_of_constants_and_gaps() -> None:
    flat = braille(T, np.ones_like(T), width=4, height=1)
    assert len(set(flat[0])) == 1 and flat[0] != "⠀⠀⠀⠀"
    assert braille(T, np.full_like(T, np.nan), width=4, height=1) == ["⠀⠀⠀⠀"]


def test_sketch_is_as_wide_as_asked_and_shows_display_units() -> None:
    for width in (40, 60, 100):
        text = sketch(trajectory(ANGLE, column("x", T)), width=width)
        assert max(len(line) for line in text.splitlines()) <= width
        assert "theta [deg]" in text and "57.3" in text and "-57.2" in text and "x [m]" in text
        assert text.splitlines()[-1].split() == ["0", "s", "2", "s"]


def test_sketch_of_many_curves_says_how_many_more() -> None:
    text = sketch(trajectory(*[column(f"x[{i}]", T * i) for i in range(9)]), width=60, height=1)
    assert text.splitlines()[-1] == "and 3 more"


def test_sketch_marks_where_something_happened() -> None:
    tick = Event(time=0.3, name="sample(0, 0.1 s)", kind="tick")
    lines = sketch(trajectory(ANGLE, events=(*bounces(1.0, 2.0), tick)), width=60).splitlines()
    place = lines[0].index(" ") + 1
    line = next(line for line in lines if line.lstrip().startswith("events"))
    marks = line[line.index("events") + len("events ") :]
    width = len(marks)
    assert [i for i, mark in enumerate(marks) if mark == "│"] == [width // 2, width - 1]
    assert place > 0 and len(line) <= 60
    assert "events" not in sketch(trajectory(ANGLE, events=(tick,)), width=60)


def test_sketch_of_nothing_and_of_no_numbers() -> None:
    assert sketch(trajectory(column("y", T, "output"))) == ""
    assert "x" in sketch(trajectory(column("x", np.full_like(T, np.nan))), width=50)
    assert sketch(trajectory(ANGLE)).count("\n") == 4


def test_terminal_needs_neither_scipy_nor_matplotlib() -> None:
    code = (
        "import sys, lagdsl.documents.plot.terminal; "
        "sys.exit(any(name in sys.modules for name in ('scipy', 'matplotlib', 'pandas', 'sympy')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_missing_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ModuleNotFoundError, match="figures need matplotlib: pip install matplotlib"):
        plot(trajectory())
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ModuleNotFoundError, match="data frames need pandas: pip install pandas"):
        trajectory().to_dataframe()
