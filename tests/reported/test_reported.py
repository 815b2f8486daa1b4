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
from click.testing import CliRunner
from fmi.described import of_text
from fmi.exported import export_quickly

import lagdsl
from lagdsl.cli.main import lag
from lagdsl.fmi.variables.ports import Ports

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

# ---- names of connected variables --------------------------------------------------------------------------------------

SHAFT = """
model Shaft
  import Lag.Rotational.*;
  Rotor motor(J = 2 kg.m2), load(J = 1 kg.m2);
  Spring shaft(k = 6 N.m/rad, phi_a(start = 0.3 rad));
  connect(motor.phi, shaft.phi_a);
  connect(shaft.phi_b, load.phi);
  annotation(experiment(StopTime = 1));
end Shaft;
"""


def _twisted(t: float, start: float = 0.3) -> tuple[float, float]:
    """Angles of both ends: J1 phi1 + J2 phi2 rests, the twist oscillates with sqrt(k (1/J1 + 1/J2)) = 3 rad/s."""
    mean, twist = 2.0 * start / 3.0, start * math.cos(3.0 * t)
    return mean + twist / 3.0, mean - 2.0 * twist / 3.0


@pytest.mark.parametrize("engine", ["tape", "numpy", "c"])
def test_every_name_of_a_connected_coordinate_is_that_of_a_column_and_of_a_start(engine):
    model = lagdsl.compile(SHAFT, engine=engine)
    assert model.coordinates == ["motor.phi", "load.phi"]
    motion = model.simulate(tolerance=1e-10)
    left, right = _twisted(1.0)
    assert motion["shaft.phi_a"][-1] == pytest.approx(left, abs=1e-8) == motion["motor.phi"][-1]
    assert motion["shaft.phi_b"][-1] == pytest.approx(right, abs=1e-8) == motion["load.phi"][-1]
    assert motion["der(shaft.phi_b)"][-1] == pytest.approx(0.6 * math.sin(3.0), abs=1e-7)
    assert motion.only(["shaft.phi_b"]).names == ("time", "shaft.phi_b")
    other = model.simulate(start={"shaft.phi_a": "-0.6 rad"}, tolerance=1e-10)
    assert other["shaft.phi_b"][-1] == pytest.approx(_twisted(1.0, -0.6)[1], abs=1e-8)
    many = model.simulate_many(start={"shaft.phi_a": [0.3, -0.6]}, columns=["shaft.phi_b"], tolerance=1e-10)
    assert np.allclose(many["shaft.phi_b"][:, -1], [right, _twisted(1.0, -0.6)[1]], atol=1e-8)
    at = {"shaft.phi_a": 0.3, "load.phi": 0.0}
    assert model.forward_dynamics(0.0, at, {"motor.phi": 0.0, "shaft.phi_b": 0.0}) == pytest.approx([-0.9, 1.8])
    with pytest.raises(ValueError, match="`motor.phi` and `shaft.phi_a` one coordinate"):
        model.simulate(start={"motor.phi": 1.0, "shaft.phi_a": 1.0})


def test_every_name_of_a_connected_coordinate_on_the_command_line(tmp_path):
    (tmp_path / "shaft.lag").write_text(SHAFT, encoding="utf-8")
    table = tmp_path / "shaft.csv"
    wanted = ["--column", "shaft.phi_b", "--column", "der(shaft.phi_a)", "-o", str(table), "--tolerance", "1e-10"]
    asked = ["run", str(tmp_path / "shaft.lag"), "--set", "shaft.phi_a.start=-0.6 rad", *wanted]
    told = CliRunner().invoke(lag, asked)
    assert told.exit_code == 0, told.stderr
    rows = table.read_text(encoding="utf-8").splitlines()
    assert rows[0] == "time,shaft.phi_b,der(shaft.phi_a)"
    assert float(rows[-1].split(",")[1]) == pytest.approx(_twisted(1.0, -0.6)[1], abs=1e-8)


@pytest.mark.parametrize(("version", "kind"), [(2, "CoSimulation"), (3, "ModelExchange")])
def test_every_name_of_a_connected_coordinate_in_an_fmu(version, kind, tmp_path):
    export_quickly(of_text(SHAFT), tmp_path / "shaft.fmu", version=version)
    names = ["shaft.phi_b", "load.phi", "der(shaft.phi_a)"]
    set_by = "motor.phi" if version == 2 else "shaft.phi_a"  # in FMI 2 one name of an alias set has the start value
    found = fmpy.simulate_fmu(
        str(tmp_path / "shaft.fmu"),
        fmi_type=kind,
        stop_time=1.0,
        relative_tolerance=1e-9,
        start_values={set_by: -0.6},
        output=names,
    )
    assert found["shaft.phi_b"][-1] == pytest.approx(_twisted(1.0, -0.6)[1], abs=1e-6) == found["load.phi"][-1]
    assert found["der(shaft.phi_a)"][-1] == pytest.approx(0.6 * math.sin(3.0), abs=1e-5)


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
    assert ("No coordinate is left:" if name == "structure" else "There is no coordinate,") in str(model.derive())


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
