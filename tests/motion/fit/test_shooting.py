"""Multiple shooting: motions that are chaotic, so that whole ones say little."""

import numpy as np
import pytest
from fit.measured_models import BALL, compiled

import lagdsl

CHAOS = """model Chaos "A double pendulum that turns over"
  parameter Mass m1 = 1 kg, m2 = 0.8 kg;
  parameter Length l1 = 0.5 m, l2 = 0.4 m;
  coordinate Angle a(start = 120 deg), b(start = 100 deg);
  gravity = -g_n*world.y;
  point P1 = {l1*sin(a), -l1*cos(a)};
  point P2 = P1 + {l2*sin(b), -l2*cos(b), 0};
  mass m1 at P1;
  mass m2 at P2;
end Chaos;
"""


def seen():
    times = np.linspace(0.0, 4.0, 81)
    motion = compiled(CHAOS).simulate(times=times, parameters={"l1": 0.55, "l2": 0.36})
    return {"time": times, "a": motion["a"], "b": motion["b"]}


def test_segments_find_what_whole_motions_do_not():
    whole = compiled(CHAOS).fit(seen(), "l1, l2")
    cut = compiled(CHAOS).fit(seen(), "l1, l2", segments=10)
    assert whole["l1"] != pytest.approx(0.55, rel=0.01)
    assert cut.values == pytest.approx({"l1": 0.55, "l2": 0.36}, rel=1e-6)


def test_motions_that_cannot_be_cut():
    with pytest.raises(lagdsl.CompilationFailed, match="E1117"):
        compiled(BALL).fit({"time": [0.1, 0.2, 0.3], "h": [1.0, 0.9, 0.8]}, "g", segments=2)
    with pytest.raises(ValueError, match="at least 1"):
        compiled(CHAOS).fit(seen(), "l1", segments=0)
