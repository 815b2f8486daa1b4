"""Rows at times of the caller: `simulate(times=...)`."""

import numpy as np
import pytest

import lagdsl

FALL = "model Fall\n  coordinate Length h(start = 1 m);\n  gravity = -g_n*world.y;\n  mass 1 kg at {0, h};\nend Fall;\n"


def test_rows_are_where_they_are_asked_for():
    times = np.array([0.0, 0.1, 0.37, 1.0, 1.01])
    motion = lagdsl.compile(FALL).simulate(times=times)
    assert motion.time.tolist() == times.tolist()
    assert np.allclose(motion["h"], 1.0 - 0.5 * 9.80665 * times**2, atol=1e-9)
    assert len(motion.drawn()) > len(times)


@pytest.mark.parametrize(
    ("words", "times", "more"),
    [
        ("increase", [0.0, 1.0, 1.0], {}),
        ("at least two", [0.0], {}),
        ("at least two", [[0.0, 1.0]], {}),
        ("first row", [0.5, 1.0], {}),
        ("either", [0.0, 1.0], {"stop": 2.0}),
        ("either", [0.0, 1.0], {"interval": 0.1}),
    ],
)
def test_times_that_are_no_rows(words, times, more):
    with pytest.raises(ValueError, match=words):
        lagdsl.compile(FALL).simulate(times=times, **more)
