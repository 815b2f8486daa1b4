"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report; texts
that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

import math

import fmpy
import numpy as np
import pytest
from choice import paired
from fmi.described import of_text
from fmi.exported import export_quickly

import lagdsl
from lagdsl.fmi.variables.ports import Ports

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

# ---- names of connected variables --------------------------------------------------------------------------------------

# ---- models in which nothing is free to move ---------------------------------------------------------------------------

ROTOR_ON_A_TURNTABLE = """
model Gyro
  import Lag.Spatial.*;
  RevoluteDrive table(axis = {0, 0, 1}, angle = 0.8 rad/s*time);
  FixedTranslation arm(r = {2, 0, 0});
  RevoluteDrive motor(axis = {1, 0, 0}, angle = 12 rad/s*time + 0.7 rad/s2*time^2);
  Body rotor(m = 3, I = {0.08, 0.05, 0.05});
  gravity = -9.81 m/s2*world.z;
  connect(world, table, arm, motor, rotor);%s
  output Torque M[3] = reaction(motor).torque, T[3] = reaction(table).torque;
  output Force F[3] = reaction(motor).force;
  annotation(experiment(StopTime = 1.5));
end Gyro;
"""


def _euler(t: float) -> dict[str, list[float]]:
    """Torque of the motor dh/dt of h = I_x s e_x + I_y w e_z in turning axes; of the table, with the moment of m g."""
    w, s, growth, spin_inertia, m, r, g = 0.8, 12.0 + 1.4 * t, 1.4, 0.08, 3.0, 2.0, 9.81
    e_x, e_y = np.array([np.cos(w * t), np.sin(w * t), 0.0]), np.array([-np.sin(w * t), np.cos(w * t), 0.0])
    change = spin_inertia * (growth * e_x + s * w * e_y)
    force = -m * r * w**2 * e_x + np.array([0.0, 0.0, m * g])
    return {"M": change.tolist(), "T": (change + np.cross(r * e_x, force)).tolist(), "F": force.tolist()}


@pytest.mark.parametrize("engine", ["tape", "numpy", "c"])
def test_drives_that_prescribe_all_motion_tell_their_torques(engine):
    model = lagdsl.compile(ROTOR_ON_A_TURNTABLE % "", engine=engine)
    assert [each.code for each in model.diagnostics] == ["N0513"]
    assert model.diagnostics[0].message.endswith("2 prescribed motions and 9 outputs")
    motion = model.simulate(interval=0.5)
    for row, t in enumerate(motion.time.tolist()):
        for name, value in _euler(t).items():
            assert np.allclose(motion[name][row], value, rtol=1e-13, atol=1e-12), (name, t)
    idle = "\n  coordinate Length x; mass 1 kg at {0, x, 0}; potential 1/2*4 N/m*x^2;"
    beside = lagdsl.compile(ROTOR_ON_A_TURNTABLE % idle, engine=engine)
    assert "W0514" not in [each.code for each in beside.diagnostics]
    assert np.allclose(beside.simulate(interval=0.5)["T"], motion["T"], rtol=1e-13, atol=1e-12)


@pytest.mark.parametrize(
    ("version", "kind"), [(2, "ModelExchange"), (2, "CoSimulation"), (3, "ModelExchange"), (3, "CoSimulation")]
)
def test_drives_that_prescribe_all_motion_as_fmu(version, kind, tmp_path):
    compilation = of_text(ROTOR_ON_A_TURNTABLE % "")
    export_quickly(compilation, tmp_path / "gyro.fmu", version=version, ports=Ports(scalar=True))
    names = [f"{name}[{i}]" for name in "MTF" for i in (1, 2, 3)]
    found = fmpy.simulate_fmu(
        str(tmp_path / "gyro.fmu"), fmi_type=kind, stop_time=1.5, output_interval=0.5, output=names
    )
    for row, t in enumerate(found["time"].tolist()):
        told = [value for vector in _euler(t).values() for value in vector]
        assert np.allclose([found[name][row] for name in names], told, rtol=1e-9, atol=1e-9), t


STRUCTURE = """
model Bracket
  import Lag.Spatial.*;
  Weld wall, tip;
  FixedTranslation arm(r = {2, 0, 0});
  Body load(m = 3, I = {0.05, 0.05, 0.08});
  gravity = -10 m/s2*world.z;
  connect(world, wall, arm, tip, load);
  output Force F = reaction(wall).force*world.z;
  output Torque T = reaction(wall).torque*world.y;
end Bracket;
"""
COUNTER = """
model PI
  input Real e = 1;
  output discrete Real u(start = 0);
  discrete Real sum(start = 0);
  when sample(0 s, 0.1 s) then
    sum = pre(sum) + e;
    u = 2*e + 3*sum;
  end when;
  annotation(experiment(StopTime = 1.05));
end PI;
"""
SIGNAL = """
model Signal
  parameter Length a = 2 m;
  output Length y = a*sin(3 rad/s*time);
  output Velocity v = der(y);
  annotation(experiment(StopTime = 1));
end Signal;
"""
IMMOBILE = {
    "structure": (STRUCTURE, {"F": 30.0, "T": -60.0}),
    "clock": (COUNTER, {"u": 35.0}),
    "signal": (SIGNAL, {"y": 2.0 * math.sin(3.0), "v": 6.0 * math.cos(3.0)}),
}


@pytest.mark.parametrize(("name", "engine"), paired(list(IMMOBILE), ["tape", "numpy", "c"]))
def test_models_without_freedom_run_and_verify(name, engine):
    text, ends = IMMOBILE[name]
    model = lagdsl.compile(text, engine=engine)
    motion = model.simulate()
    assert {each: pytest.approx(motion[each][-1], rel=1e-12) for each in ends} == ends
    certificate = model.verify()
    assert certificate.holds, certificate.lines
    modes = model.modes()
    assert modes.steadiness.kind == "no freedom" and len(modes.eigenvalues) == 0
    assert "nothing is free to move" in modes.stability
    assert "W0206" not in [each.code for each in model.diagnostics]


@pytest.mark.parametrize(("name", "version", "kind"), paired(list(IMMOBILE), [2, 3], ["CoSimulation", "ModelExchange"]))
def test_models_without_freedom_as_fmu(name, version, kind, tmp_path):
    text, ends = IMMOBILE[name]
    export_quickly(of_text(text), tmp_path / "still.fmu", version=version)
    found = fmpy.simulate_fmu(str(tmp_path / "still.fmu"), fmi_type=kind, output=list(ends))
    assert {each: pytest.approx(found[each][-1], rel=1e-9) for each in ends} == ends


# ---- certificates of statics -------------------------------------------------------------------------------------------

# ---- linearization of circuits, verdicts on sampled loops --------------------------------------------------------------

# ---- lowest and highest of outputs -------------------------------------------------------------------------------------

# ---- derivations: stability and equilibria -----------------------------------------------------------------------------

# ---- derivations: names and letters ------------------------------------------------------------------------------------

# ---- derivations: what is printed is short -----------------------------------------------------------------------------

# ---- pictures: springs and bars ----------------------------------------------------------------------------------------

# ---- robots: URDF ------------------------------------------------------------------------------------------------------

# ---- robots: MJCF ------------------------------------------------------------------------------------------------------
