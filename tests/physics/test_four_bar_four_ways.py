"""One linkage from components, from points, in one coordinate and from joints in space: one motion, one pin force."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl

MODELS = Path(__file__).parents[2] / "models"
TOLERANCE = 1e-8
WAYS = ["four_bar", "four_bar_points", "four_bar_spatial"]


@cache
def _motion(name: str) -> lagdsl.Trajectory:
    return lagdsl.compile(MODELS / f"{name}.lag", engine="tape").simulate(stop=2.0, interval=0.01, tolerance=1e-11)


def _crank(name: str) -> NDArray[np.float64]:
    motion = _motion(name)
    return np.asarray(motion["A.q" if name in ("four_bar", "four_bar_spatial") else "a"])


def _pin(name: str) -> NDArray[np.float64]:
    """Force of the coupler on the rocker."""
    return np.stack([_motion(name)[f"pinC[{k}]"] for k in (1, 2, 3)], axis=-1)


@pytest.mark.parametrize("name", WAYS)
def test_the_motion_is_that_of_the_crank_angle_alone(name: str) -> None:
    alone = _crank("four_bar_crank")
    assert np.ptp(alone) > 1.0
    np.testing.assert_allclose(_crank(name), alone, rtol=0, atol=TOLERANCE)


@pytest.mark.parametrize("name", WAYS)
def test_the_pin_force_is_that_of_the_crank_angle_alone(name: str) -> None:
    alone = _pin("four_bar_crank")
    size = np.max(np.abs(alone))
    assert size > 10.0
    np.testing.assert_allclose(_pin(name), alone, rtol=0, atol=TOLERANCE * size)


def test_all_joints_turn_alike_in_the_plane_and_in_space() -> None:
    plane, space = _motion("four_bar"), _motion("four_bar_spatial")
    for column in ("A.q", "B.q", "C.q", "D.q", "der(A.q)", "der(B.q)", "der(C.q)"):
        size = np.max(np.abs(plane[column]))
        np.testing.assert_allclose(space[column], plane[column], rtol=0, atol=TOLERANCE * size, err_msg=column)
