"""A program that does not write M out gives the same mass matrix and dynamics."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from lagdsl import pipeline
from lagdsl.diagnostics import Sink
from lagdsl.runtime.numpy_engine import NumpyEngine

MODELS = ("chain", "four_bar", "heavy_top", "relativistic_particle", "rolling_coin", "charged_particle", "quarter_car")


@pytest.mark.parametrize("name", MODELS)
def test_lanes_agree_with_the_matrix_written_out(root: Path, name: str) -> None:
    sink = Sink()
    file = pipeline.read(root / "models" / f"{name}.lag", sink)
    assert file is not None
    flat = pipeline.front(file, sink)
    assert flat is not None
    whole = NumpyEngine(pipeline.derive(flat))
    slim_program = pipeline.derive(flat, dense=False)
    slim = NumpyEngine(slim_program)
    assert {"mass_matrix", "dynamics"}.isdisjoint(f.name for f in slim_program.functions)
    rng = np.random.default_rng(7)
    layout = whole.layout
    p = np.array(layout.defaults)
    for _ in range(3):
        q, qd = rng.uniform(0.1, 0.6, (2, len(layout.coordinates)))
        state = (0.3, q, qd, np.zeros(len(layout.states)), np.zeros(len(layout.inputs)), np.zeros(0), p)
        for function in ("mass_matrix", "dynamics"):
            for one, other in zip(whole.evaluate(function, *state), slim.evaluate(function, *state), strict=True):
                np.testing.assert_allclose(
                    other, one, rtol=1e-12, atol=1e-12 * (1.0 + np.max(np.abs(one), initial=0.0))
                )
        for one, other in zip(whole.solve(*state), slim.solve(*state), strict=True):
            np.testing.assert_allclose(other, one, rtol=1e-9, atol=1e-9 * (1.0 + np.max(np.abs(one), initial=0.0)))
