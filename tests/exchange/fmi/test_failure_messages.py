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

# A rod of length and mass 1 that slides with its lower end ahead, above the critical friction, 5/3 at 45 degrees.
ROD = """model Rod
  coordinate Real x(der(start = -8)), y(start = 1/2*sin(pi/4)), a(start = pi/4);
  kinetic 1/2*(der(x)^2 + der(y)^2) + 1/24*der(a)^2;
  potential 10*y;
  contact tip: y - 1/2*sin(a) >= 0 with restitution = 0, friction = 3, slip = der(x) + 1/2*sin(a)*der(a);
  annotation(units = "none", experiment(StopTime = 1));
end Rod;
"""


@pytest.mark.parametrize(("clause", "kind"), [("time >= 1 s", "CoSimulation"), ("sample(1 s, 5 s)", "ModelExchange")])
def test_a_state_that_would_move_a_mass_is_named(
    clause: str, kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "carried.fmu"
    export_text(CARRIED.format(clause=clause), path)
    with pytest.raises(Exception, match="failed with status"):
        simulate_fmu(str(path), fmi_type=kind, stop_time=3.0)
    assert "t = 1 s: The position of a mass would jump by `p`.\n" in capsys.readouterr().out


def test_friction_that_wedges_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It wedges at the start, so an export that tries its FMU out refuses it (E0908)."""
    path = tmp_path / "rod.fmu"
    monkeypatch.setattr("lagdsl.exchange.fmi.export.try_out", lambda *_, **__: None)
    export_text(ROD, path)
    with pytest.raises(Exception, match="failed with status"):
        simulate_fmu(str(path), fmi_type="ModelExchange", stop_time=1.0)
    assert "t = 0 s: No forces satisfy the law of friction of `tip.friction`: it wedges.\n" in capsys.readouterr().out
