"""Figures of chosen columns: names, axes by unit, paths, events; families of a sweep."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from choice import spread
from plot.motions import ANGLE, T, bounces, column, trajectory

from lagdsl.documents.plot.figure import plot_of
from lagdsl.documents.plot.names import columns_in, paths_of
from lagdsl.language.settings.arrays import names_in

SPIN = column("der(theta)", 5 * np.cos(5 * T), "rate", "deg/s", scale=180 / np.pi)
X, Y = column("x", np.sin(T)), column("y", np.cos(T))


def test_names_stand_between_commas_outside_of_brackets() -> None:
    assert names_in("m[1,2], der(x) ,y") == ["m[1,2]", "der(x)", "y"]
    assert columns_in("q, x", ["q[1]", "q[2]", "x"]) == ["q[1]", "q[2]", "x"]
    assert columns_in("x, x", ["x"]) == ["x"]


@pytest.mark.parametrize(
    ("name", "told"), [("thetta", "did you mean `theta`?"), ("w", "there are time, theta, der(theta), energy")]
)
def test_an_unknown_name_is_told_with_the_nearest_one(name: str, told: str) -> None:
    for arguments in ({"show": name}, {"xy": ("theta", name)}):
        with pytest.raises(KeyError, match="there is no column") as found:
            plot_of(trajectory(ANGLE, SPIN), **arguments)
        assert told in str(found.value)


def test_names_that_make_no_panel_are_told() -> None:
    for xy, told in ((("x, y", "x, y, z"), "2 and 3 columns make no pairs"), ([("x", "y", "z")], "pairs of names")):
        with pytest.raises(ValueError, match=told):
            paths_of(xy, ["x", "y", "z"])
    with pytest.raises(ValueError, match="needs the name of a column"):
        columns_in(" , ", ["x"])


def test_two_units_have_two_axes_and_their_labels_the_units() -> None:
    figure = plot_of(trajectory(ANGLE, SPIN, X), show="theta, der(theta)")
    left, right = figure.axes
    assert (left.get_ylabel(), right.get_ylabel()) == ("theta\n[deg]", "der(theta)\n[rad/s]")
    assert right.lines[0].get_ydata()[0] == pytest.approx(5.0)
    assert left.lines[0].get_color() != right.lines[0].get_color()


def test_a_third_unit_and_every_further_text_open_a_panel() -> None:
    motion = trajectory(ANGLE, SPIN, X, energy=2.0 + T)
    assert [axes.get_ylabel() for axes in plot_of(motion, show="theta, der(theta), x").axes] == [
        "theta\n[deg]", "x\n[m]", "der(theta)\n[rad/s]",
    ]  # fmt: skip
    labels = [axes.get_ylabel() for axes in plot_of(motion, show=["theta", "energy"]).axes]
    assert labels == ["theta\n[deg]", "energy\n[J]"]


def test_a_phase_portrait_has_columns_on_both_axes_and_marks_its_start_and_events() -> None:
    (panel,) = plot_of(trajectory(ANGLE, SPIN, events=bounces(float(T[50]))), xy=("theta", "der(theta)")).axes
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("theta [deg]", "der(theta)\n[rad/s]")
    path, event = panel.lines
    radius = (path.get_xdata() / np.rad2deg(1.0)) ** 2 + (path.get_ydata() / 5.0) ** 2
    assert np.abs(radius - 1.0).max() < 1e-12
    assert path.get_marker() == "o" and path.get_markevery() == [0]
    assert event.get_xdata() == pytest.approx(np.rad2deg(np.sin(5 * T[50])))


def test_a_path_in_space_keeps_its_shape() -> None:
    motion = trajectory(X, Y, ANGLE)
    (path,) = plot_of(motion, xy=("x", "y")).axes
    (portrait,) = plot_of(motion, xy=("x", "theta")).axes
    assert path.get_aspect() == 1.0 and portrait.get_aspect() == "auto"


@pytest.mark.parametrize("suffix", spread([".png", ".svg", ".pdf"], 2))
def test_the_suffix_says_the_form(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"figure{suffix}"
    plot_of(trajectory(ANGLE, SPIN), path, show="theta", xy=("theta", "der(theta)"))
    assert path.read_bytes()[:5].lstrip() in {b"\x89PNG\r", b"<?xml", b"%PDF-"}


@pytest.mark.parametrize("size", spread([1.5e-3, 2.4e-4, 0.15, 3.3, 12500.0], 3))
def test_numbers_beside_each_other_do_not_overlap(size: float) -> None:
    figure = plot_of(trajectory(column("x", size * X.values), column("y", size * Y.values)), show="x", xy=("x", "y"))
    figure.canvas.draw()
    for panel in figure.axes:
        low, high = panel.get_xlim()
        shown = [t for t in panel.xaxis.get_major_ticks() if low <= t.get_loc() <= high and t.label1.get_text()]
        boxes = [tick.label1.get_window_extent() for tick in shown]
        assert len(boxes) > 2 and all(a.x1 < b.x0 for a, b in pairwise(boxes))
