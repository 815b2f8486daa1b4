"""Messages of an FMU whose motion ends: they name what is to blame."""

from __future__ import annotations

from pathlib import Path

import pytest
from fmpy import simulate_fmu

from fmi.texts import export_text

CARRIED = """model Carried "A clause sets a state that carries a mass; another state that it sets is not to blame"
  coordinate Length x;
  state Length p;
  state Real far;
  gravity = 0;
  mass 1 kg at {{x + p, 0}};
equation
  der(p) = 0 m/s;
  der(far) = 0 Hz;
  when time >= 2 s then
    reinit(far, 1);
  elsewhen {clause} then
    reinit(p, 2 m);
    reinit(far, far);
  end when;
end Carried;
"""


@pytest.mark.parametrize(("clause", "kind"), [("time >= 1 s", "CoSimulation"), ("sample(1 s, 5 s)", "ModelExchange")])
def test_a_state_that_would_move_a_mass_is_named(
    clause: str, kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "carried.fmu"
    export_text(CARRIED.format(clause=clause), path)
    with pytest.raises(Exception, match="failed with status"):
        simulate_fmu(str(path), fmi_type=kind, stop_time=3.0)
    assert "t = 1 s: the position of a mass would jump with p\n" in capsys.readouterr().out
