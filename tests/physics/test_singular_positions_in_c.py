"""Through singular positions by C alone, as in test_singular_positions: on the branch the motion comes on, or none."""

from __future__ import annotations

from pathlib import Path

import linkages
import numpy as np
import pytest
from run_in_c import Motion
from test_singular_positions import NEUTRAL, PARALLELOGRAM, SLIDER_CRANK, STACKED

import lagdsl

OK, FORKED = 0, 17


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        (PARALLELOGRAM, [("A", "B")]),
        (linkages.THREE_BARS, [("A", "B")]),
        (STACKED, [("A", "B"), ("D", "F")]),
        (SLIDER_CRANK, [("th", "ph")]),
    ],
    ids=["parallelogram", "third bar", "stacked", "slider-crank"],
)
def test_crossing_keeps_the_branch(tolerance: float, text: str, pairs: list[tuple[str, str]]) -> None:
    motion = Motion(text, 1.2, tolerance)
    assert motion.status == OK and len(motion.rows) == len(motion.times)
    for first, second in pairs:
        assert np.max(np.abs(motion[first] + motion[second])) < 1e-8
    assert motion.drift < max(1e-8, 10.0 * tolerance)


def test_parallelogram_keeps_its_energy() -> None:
    motion = Motion(PARALLELOGRAM, 3.0, 1e-9)
    assert motion.status == OK
    assert motion.drift < 1e-8 and np.ptp(motion["A"]) > np.pi


def test_neutral_four_bar_crosses_its_flat_position() -> None:
    coarse, fine = (Motion(NEUTRAL, 1.5, tolerance, rows=150) for tolerance in (1e-7, 1e-10))
    assert coarse.status == fine.status == OK
    assert fine.drift < 1e-8 and np.ptp(fine["A"]) > 2.0 * np.pi
    assert np.max(np.abs(coarse["B"] - fine["B"])) < 1e-4
    assert np.max(np.abs(np.diff(fine["der(C)"]))) < 2.0


@pytest.mark.parametrize("error", [1e-4, 1e-8, 1e-9])
def test_rod_longer_by_little_turns_back(error: float) -> None:
    motion = Motion(SLIDER_CRANK, 0.4, 1e-8, parameters={"l": 0.2 + error})
    assert motion.status == OK
    assert motion["th"].max() > 2.0 and np.all(np.cos(motion["ph"]) > 0.0)
    assert motion.drift < 1e-7


def test_rod_shorter_by_little_turns_the_crank_back() -> None:
    motion = Motion(SLIDER_CRANK, 0.4, 1e-8, parameters={"l": 0.2 - 1e-8})
    assert motion.status == OK
    assert np.all(np.cos(motion["th"]) > 0.0) and motion["ph"].min() < -2.0
    assert motion.drift < 1e-7


@pytest.mark.parametrize("error", [1e-10, 1e-11])
def test_near_the_limit_of_resolution_the_motion_is_right_or_ends(error: float) -> None:
    motion = Motion(SLIDER_CRANK, 0.4, 1e-6, parameters={"l": 0.2 + error})
    assert motion.status in (OK, FORKED)
    assert np.all(np.cos(motion["ph"]) > 0.0) and motion.drift < 1e-5


def test_out_of_a_singular_start() -> None:
    """Both cranks of a parallelogram that starts flat turn with the same rate for good."""
    text = (Path(__file__).parents[2] / "models" / "parallelogram.lag").read_text(encoding="utf-8")
    motion = Motion(text, 0.7, 1e-10)
    assert motion.status == OK
    assert np.max(np.abs(motion["a"] - motion["c"])) < 1e-8 and np.max(np.abs(motion["b"])) < 1e-8
    assert motion["a"] == pytest.approx(4.0 * motion.times, abs=1e-8)


def test_rows_inside_of_a_crossing_are_on_the_motion() -> None:
    """At other times than those of steps, as many as there are: the constraints hold at each row."""
    motion = Motion(PARALLELOGRAM, 1.2, 1e-10, rows=20_000)
    assert motion.status == OK and motion.steps < 1_000
    assert np.max(np.abs(motion["A"] + motion["B"])) < 1e-9
    reference = lagdsl.compile(PARALLELOGRAM).simulate(stop=1.2, tolerance=1e-10, interval=1.2 / 400)
    assert motion["A"][::50] == pytest.approx(reference["A"], abs=1e-7)
