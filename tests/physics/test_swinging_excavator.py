"""The excavator while its cab swings and is driven: all four bodies move in space."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from models.references.excavator import swinging

import lagdsl

MODEL = Path(__file__).parents[2] / "models" / "excavator.lag"


def test_it_moves_as_four_free_bodies_with_pins() -> None:
    model = lagdsl.compile(MODEL, engine="tape")
    drive, turning = 4e5, 0.8
    motion = model.simulate(
        stop=0.4, interval=0.02, tolerance=1e-10, start={"der(swing)": turning}, inputs={"swing_drive": drive}
    )
    expected = swinging(motion.time, turning, drive)
    assert np.ptp(motion["swing"]) > 0.3
    assert np.max(np.abs(motion["tip[3]"])) > 2.0
    for column, values in expected.items():
        size = np.max(np.abs(values))
        np.testing.assert_allclose(motion[column], values, rtol=0, atol=1e-7 * size, err_msg=column)
