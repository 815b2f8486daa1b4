"""A slider-crank from joints and bodies, and the same from a constraint; what the cylinders of a V6 push on."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import lagdsl

MODELS = Path(__file__).parents[2] / "models"


@cache
def _motion(name: str, load: float) -> lagdsl.Trajectory:
    model = lagdsl.compile(MODELS / f"{name}.lag", engine="tape")
    smooth = {"kick": 1.0}  # no jump of the pressure: the motions can be compared closely
    return model.simulate(stop=0.2, interval=1e-3, tolerance=1e-12, parameters=smooth, inputs={"load": load})


@pytest.mark.parametrize("load", [0.0, 60.0])
def test_joints_and_a_constraint_say_the_same(load: float) -> None:
    written, built = _motion("slider_crank", load), _motion("slider_crank_components", load)
    np.testing.assert_allclose(built["main.q"], written["th"], rtol=0, atol=1e-8)
    np.testing.assert_allclose(built["speed"], written["speed"], rtol=1e-9)
    side = np.max(np.abs(written["side"]))
    assert side > 100.0
    np.testing.assert_allclose(built["side"], written["side"], rtol=0, atol=1e-8 * side)
