"""Models through FMPy with its defaults: no error, and the motion of `lag run` as far as two tolerances agree."""

from __future__ import annotations

from pathlib import Path

import pytest
from choice import chosen, in_turn
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException
from models.corpus import MODELS

from fmi.default_runs import KINDS, SAME, TOLERANCES, judged
from fmi.exported import VERSIONS
from fmi.texts import export_text

# A contact that hovers, blows in a row, and friction, which steps at the tolerance itself follow to 3 % of the range.
SOME = [
    ("ball_on_moving_table", 3, "ModelExchange", 1e-4),
    ("newtons_cradle", 2, "ModelExchange", None),
    ("block_on_incline", 3, "CoSimulation", 1e-4),
]
# At 1e-4 FMPy brings the hub so far beside its constraint that the next spoke does not stand where it lands.
LESS_EXACT = ("rimless_wheel", "ModelExchange", 1e-4)


@pytest.mark.parametrize(
    ("name", "version", "kind", "tolerance"), in_turn(MODELS, VERSIONS, KINDS, TOLERANCES, some=SOME)
)
def test_fmpy_with_nothing_given(name: str, version: int, kind: str, tolerance: float | None) -> None:
    if (name, kind, tolerance) == LESS_EXACT:
        with pytest.raises(FMICallException):
            judged(name, version, kind, tolerance)
        return
    of = judged(name, version, kind, tolerance)
    assert of.error <= SAME, of
    assert kind == "ModelExchange" or of.until == 1.0, of


BALL = """model Ball
  coordinate Real h(start = 1);
  kinetic 1/2*der(h)^2;
  force -10 on h;
  contact floor: h >= 0 with restitution = 0;
  annotation(units = "none", experiment(StopTime = 1, Tolerance = 1e-6));
equation
  when closed(floor) then terminate("it lies"); end when;
end Ball;
"""


@pytest.mark.parametrize("version", chosen(VERSIONS, [3]))
@pytest.mark.parametrize("kind", KINDS)
def test_a_model_that_ends_within_a_step(kind: str, version: int, tmp_path: Path) -> None:
    """FMPy allows no early return unless it is asked to: the time of the last row tells where the model has ended."""
    path = tmp_path / "ball.fmu"
    export_text(BALL, path, version)
    rows = simulate_fmu(str(path), validate=False, fmi_type=kind)
    assert rows["time"][-1] == pytest.approx(0.2**0.5, abs=2e-3)
