"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report;
texts that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

import math
from math import asin, sqrt
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest
from choice import engines, paired, spread
from click.testing import CliRunner
from fmi.described import of_text
from fmi.exported import export_quickly
from fmi.texts import export_text

import lagdsl
from lagdsl.derivation.scene.stage import stage_of
from lagdsl.documents.plot.picture.recording import prepare, recorded
from lagdsl.documents.plot.picture.shapes import Faces, parts_of
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.exchange.fmi.variables.ports import Ports
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.pipeline import flatten_file

TEXTS = Path(__file__).parent / "texts"

# ---- bounces: a contact that is located as closing strikes -----------------------------------------------------------


BOB = """
model Bob "A bob on a rod strikes a floor: its height is no coordinate that a projection leaves alone"
  coordinate Length x(start = 0.8 m), y(start = 0.6 m);
  gravity = -9.81 m/s2*world.y;
  mass 1 kg at {x, y};
  constraint rod: x^2 + y^2 = 1 m2;
  contact floor: y >= 0.1 m with restitution = 0.6;
  annotation(experiment(StopTime = 1));
end Bob;
"""


def test_a_bounce_is_not_lost() -> None:
    """The first blow at sqrt(2 g (y0 - 0.1)) sqrt(1 - 0.1^2), and 0.6 times that behind it, from sixty starts."""
    model = lagdsl.compile(BOB, engine="tape")
    for x in np.linspace(0.5, 0.95, 60):
        y = sqrt(1 - x**2)
        motion = model.simulate(start={"x": x, "y": y})
        row = int(np.searchsorted(motion.time, motion.events[0].time))
        speed = sqrt(2 * 9.81 * (y - 0.1)) * sqrt(0.99)
        assert motion.events[0].kind == "impact"
        assert motion["der(y)"][row : row + 2] == pytest.approx([-speed, 0.6 * speed], rel=1e-6)


# ---- fixed steps after bounces ---------------------------------------------------------------------------------------


ARM = """
model Arm "A pendulum bounces on a stop until it rests"
  coordinate Angle a(start = 0.6);
  gravity = -9.80665 m/s2*world.y;
  mass 1 kg at {cos(a), sin(a)}*(1 m);
  contact floor: (1 m)*sin(a) >= 0.1 m with restitution = 0.6;
  annotation(experiment(StopTime = 1.5));
end Arm;
"""


@pytest.mark.parametrize("solver", ["ros2", "rk4", "leapfrog"])
def test_bounces_end_with_steps_of_fixed_length(solver: str) -> None:
    model = lagdsl.compile(ARM, engine="tape")
    for step in (0.002, 0.005, 0.01, 0.02, 0.03):
        motion = model.simulate(solver=solver, step=step)
        assert motion.events[-1].kind == "closed"
        assert motion["a"][-1] == pytest.approx(asin(0.1), abs=1e-9)
        assert motion["der(a)"][-1] == pytest.approx(0.0, abs=1e-9)


# ---- angles of cut joints: whole turns -------------------------------------------------------------------------------


# Two hinges on one axis between the world and a wheel, which runs at 3 rad/s; `back` closes the loop, backwards.
WHEEL = """
model Wheel
  import Lag.Planar.*;
  Revolute front(q(start = 0, fixed = true, der(start = 3 rad/s, fixed = true))), back;
  Body wheel(m = 1 kg, Izz = 0.1);
  gravity = 0;
  connect(world, front, wheel);
  connect(wheel, back, world);
  {output}
end Wheel;
"""
READS = WHEEL.format(output="output Angle twice = 2*back.q;")
PLAIN = WHEEL.format(output="")


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_an_output_of_a_cut_angle_has_its_turns(engine: Any) -> None:
    motion = lagdsl.compile(READS, engine=engine).simulate(stop=4.0, interval=4.0)
    assert motion["twice"][-1] == pytest.approx(-24.0, abs=1e-6)


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
@pytest.mark.parametrize("interval", [4.0, 1.3, 0.01])
def test_turns_do_not_depend_on_the_rows(engine: Any, interval: float) -> None:
    motion = lagdsl.compile(PLAIN, engine=engine).simulate(stop=4.0, interval=interval)
    assert motion["back.q"] == pytest.approx(-3.0 * motion["time"], abs=1e-6)


def test_turns_of_many_runs_and_after_a_sweep_of_rates() -> None:
    motions = lagdsl.compile(PLAIN).simulate_many(start={"der(front.q)": [3.0, 50.0]}, stop=4.0, interval=4.0)
    assert motions["back.q"][:, -1] == pytest.approx([-12.0, -200.0], abs=1e-5)


@pytest.mark.parametrize(("kind", "version"), paired(["CoSimulation", "ModelExchange"], [2, 3]))
def test_turns_in_fmus(kind: str, version: int, tmp_path: Path) -> None:
    for text, name, right in ((READS, "twice", -24.0), (PLAIN, "back.q", -12.0)):
        path = tmp_path / f"{name}{version}.fmu"
        export_text(text, path, version)
        rows = fmpy.simulate_fmu(str(path), fmi_type=kind, stop_time=4.0, output_interval=4.0)
        assert rows[name][-1] == pytest.approx(right, abs=1e-5)


# ---- a ball joint that closes a loop half a turn from its start ------------------------------------------------------


# A pendulum about y at 40 deg, its base half a turn about z away: that of the bob is (0, -sin 20 deg, 0, cos 20 deg).
BALL = """
model Ball
  import Lag.Spatial.*;
  frame base = world.rotz(pi);
  Revolute hinge(axis = {{0, 1, 0}}, q(start = 40 deg, fixed = true));
  BodyShape bob(r = {{0, 0, -1}}, m = 1 kg, com = {{0, 0, -1}});
  {joint} ball;
  gravity = -g_n*world.z;
  connect(base, hinge, bob);
  connect(world, ball, bob.frame_a);
  {output}
end Ball;
"""


@pytest.mark.parametrize("engine", engines(["tape", "numpy"]))
@pytest.mark.parametrize("joint", ["Spherical", "FreeQuaternion"])
@pytest.mark.parametrize("output", ["", "output Real e[4] = ball.e;"])
def test_the_quaternion_of_a_cut_ball_half_a_turn_away(joint: str, output: str, engine: Any) -> None:
    motion = lagdsl.compile(BALL.format(joint=joint, output=output), engine=engine).simulate(stop=2.0, interval=0.1)
    e = np.stack([motion[f"ball.e[{k}]"] for k in range(1, 5)])
    half = 0.5 * motion["hinge.q"]
    right = np.array([0.0 * half, -np.sin(half), 0.0 * half, np.cos(half)])
    assert e == pytest.approx(right * np.sign(e[3, 0]), abs=1e-6)


def test_the_quaternion_of_a_cut_ball_in_an_fmu(tmp_path: Path) -> None:
    export_text(BALL.format(joint="Spherical", output="output Angle a = hinge.q;"), tmp_path / "ball.fmu")
    rows = fmpy.simulate_fmu(str(tmp_path / "ball.fmu"), stop_time=0.5, output_interval=0.25)
    assert abs(rows["ball.e[4]"][0]) == pytest.approx(np.cos(np.deg2rad(20.0)), abs=1e-9)
    assert np.abs(rows["ball.e[4]"]) == pytest.approx(np.cos(0.5 * rows["a"]), abs=1e-6)


# ---- starts: guesses choose branches, explicit values hold -----------------------------------------------------------


# Two bars of 0.5 m, folded, with their ends 0.4 m apart: the middle angle is +-acos(0.68).
FOLDED = """
model Folded
  import Lag.Planar.*;
  Prismatic way(s(start = 0.4 m, fixed = true));
  Revolute {joints};
  FixedTranslation one(r = {{0.5, 0}}), two(r = {{-0.5, 0}});
  Body b1(m = 1 kg, Izz = 0.05), b2(m = 1 kg, Izz = 0.05), b3(m = 0.5 kg);
  gravity = 0;
  connect(world, way, b3);
  connect(world, A, one, B, two, C, b3);
  connect(one.frame_b, b1);
  connect(two.frame_b, b2);
end Folded;
"""
OPENING = np.rad2deg(np.arccos(0.68))


@pytest.mark.parametrize(
    "joints", spread(["A, B({}), C", "C, A, B({})", "C(q(start = 0)), A(q(start = 0)), B({})", "B({}), A, C"], 2)
)
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_guess_chooses_the_branch_wherever_the_loop_is_cut(joints: str, sign: float) -> None:
    text = FOLDED.format(joints=joints.format(f"q(start = {10.0 * sign} deg)"))
    motion = lagdsl.compile(text).simulate(stop=0.01, interval=0.01)
    assert np.rad2deg(motion["B.q"][0]) == pytest.approx(sign * OPENING, abs=1e-6)


@pytest.mark.parametrize("joints", ["A, C, B", "C(q(start = 0)), A(q(start = 0)), B(q(start = 10 deg))"])
def test_the_guess_of_a_cut_joint_is_set_from_outside(joints: str) -> None:
    model = lagdsl.compile(FOLDED.format(joints=joints))
    motion = model.simulate(stop=0.01, interval=0.01, start={"B.q": "-10 deg"})
    assert np.rad2deg(motion["B.q"][0]) == pytest.approx(-OPENING, abs=1e-6)
    folded, other = (model.linearize(start={"B.q": f"{angle} deg"}).point.q for angle in (-10, 10))
    assert folded == pytest.approx(model.initial_state(start={"B.q": "-10 deg"}).q, abs=1e-9)
    assert np.abs(folded - other).max() > 0.1
    motions = model.simulate_many(stop=0.01, interval=0.01, start={"B.q": [-0.2, 0.2]})
    assert np.rad2deg(motions["B.q"][:, 0]) == pytest.approx([-OPENING, OPENING], abs=1e-6)


ROLLING = """
model Rolling "A disc inside a fixed ring"
  parameter Length R = 0.5 m, r = 0.1 m;
  coordinate Angle phi(start = 30 deg), psi;
  frame disc = world.at({(R - r)*sin(phi), -(R - r)*cos(phi)}).rotz(psi);
  body round(m = 1 kg, Izz = 0.005) on disc;
  gravity = -g_n*world.y;
  constraint rolling: r*psi = -(R - r)*phi;
end Rolling;
"""


@pytest.mark.parametrize("engine", engines(["tape", "numpy"]))
def test_a_written_start_holds_and_the_other_moves(engine: Any) -> None:
    found = lagdsl.compile(ROLLING, engine=engine).initial_state()
    assert np.rad2deg(found.q) == pytest.approx([30.0, -120.0], abs=1e-10) and found.q[0] == np.deg2rad(30.0)


TOP = """
model Top "A quaternion whose axis z leans by al, in the plane of x and z"
  coordinate Quaternion e({omega});
  coordinate Angle al(start = 30 deg, {rate});
  body top(m = 1 kg, Ixx = 0.1, Iyy = 0.1, Izz = 0.2) on world.quat(e);
  gravity = 0;
  frame B = world.quat(e);
  output AngularVelocity spin = omega(B)*B.z, tilt = omega(B)*B.y;
  constraint lean: B.z*world.x = sin(al);
  constraint plane: B.z*world.y = 0;
end Top;
"""


def test_an_angular_velocity_turns_with_a_position_that_moves() -> None:
    text = TOP.format(omega="omega(start = {0, 0, 5 rad/s})", rate='symbol = "a"')
    motion = lagdsl.compile(text).simulate(stop=0.01, interval=0.01)
    assert [motion["spin"][0], motion["tilt"][0]] == pytest.approx([5.0, 0.0], abs=1e-9)


def test_rates_that_contradict_each_other_are_an_error() -> None:
    text = TOP.format(omega="omega(start = {0, 0, 5 rad/s})", rate="der(start = 0.5 rad/s)")
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(text).initial_state()
    (told,) = failure.value.diagnostics
    assert told.code == "E0887" and told.labels and told.help


# ---- names of connected variables ------------------------------------------------------------------------------------


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
    with pytest.raises(ValueError, match=r"`motor.phi` and `shaft.phi_a` one coordinate"):
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


# ---- models in which nothing is free to move -------------------------------------------------------------------------


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
    ("version", "kind"),
    spread([(2, "ModelExchange"), (2, "CoSimulation"), (3, "ModelExchange"), (3, "CoSimulation")], 2),
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


@pytest.mark.parametrize(("name", "engine"), spread(paired(list(IMMOBILE), ["tape", "numpy", "c"]), 1))
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


@pytest.mark.parametrize(
    ("name", "version", "kind"), spread(paired(list(IMMOBILE), [2, 3], ["CoSimulation", "ModelExchange"]), 1)
)
def test_models_without_freedom_as_fmu(name, version, kind, tmp_path):
    text, ends = IMMOBILE[name]
    export_quickly(of_text(text), tmp_path / "still.fmu", version=version)
    found = fmpy.simulate_fmu(str(tmp_path / "still.fmu"), fmi_type=kind, output=list(ends))
    assert {each: pytest.approx(found[each][-1], rel=1e-9) for each in ends} == ends


# ---- certificates of statics -----------------------------------------------------------------------------------------


def test_a_mechanism_that_cannot_move_has_a_certificate() -> None:
    """A shelf on two consoles, one row too many: it stays where it is, and no momentum is called one of symmetry."""
    text = """
    model Shelf
      coordinate Length x, y(start = 1.2 m);
      coordinate Angle q;
      frame board = world.at({x, y, 0}).rotz(q);
      body b(m = 4 kg, com = {0.05 m, 0}, Izz = 0.3 kg.m2) on board;
      gravity = -g_n*world.y;
      point L = board.point({-0.3 m, 0, 0}), R = board.point({0.5 m, 0, 0});
      constraint left: {L.x, L.y} = {-0.3 m, 1.2 m};
      constraint right: {R.x, R.y} = {0.5 m, 1.2 m};
      output Force F[2] = multiplier(left);
      annotation(experiment(StopTime = 1));
    end Shelf;
    """
    certificate = lagdsl.compile(text).verify()
    assert certificate.holds
    assert not any("ignorable" in line.says for line in certificate.lines)


# ---- linearization of circuits, verdicts on sampled loops ------------------------------------------------------------


def test_a_motor_has_no_states_of_charges_that_nothing_depends_on() -> None:
    """w/v = k/(L J s^2 + R J s + k^2), of order 2: no charge is a state, and no entry is round-off."""
    text = """
    model Drive
      import Lag.Electrical.*;
      input Voltage v;
      DCMotor m(R = 2, L = 2 mH, k = 0.1, J = 4e-5 kg.m2);
      VoltageSource s(v = v);
      Ground g;
      connect(s.p, m.p);
      connect(s.n, m.n, g.p);
      output AngularVelocity w = der(m.phi);
    end Drive;
    """
    found = lagdsl.compile(text).linearize()
    assert [each.name for each in found.states] == ["m.phi", "der(m.q)", "der(m.phi)"]
    assert [each.name for each in found.left_out] == ["m.q", "s.q", "g.q"]
    assert pytest.approx(np.array([[0.0, 0.0, 1.0], [0.0, -1000.0, -50.0], [0.0, 2500.0, 0.0]]), rel=1e-12) == found.A
    assert np.count_nonzero(found.A) == 4
    steps = np.hstack([np.linalg.matrix_power(found.A, k) @ found.B for k in range(3)])
    seen = np.vstack([found.C @ np.linalg.matrix_power(found.A, k) for k in range(3)])
    assert np.linalg.matrix_rank(seen @ steps) == 2
    s = 30.0 + 200.0j
    gain = found.C @ np.linalg.solve(s * np.eye(3) - found.A, found.B) + found.D
    assert gain[0, 0] == pytest.approx(0.1 / (2e-3 * 4e-5 * s**2 + 2 * 4e-5 * s + 0.01), rel=1e-12)


def test_a_plant_with_a_held_controller_is_not_the_loop() -> None:
    """An inverted rod under a sampled law falls if the law is held, and stays up in the loop, whose verdict is told: a
    and der(a) are multiplied by the flow of a'' = 9 a + u over 5 ms, with u held."""
    text = """
    model Upright
      coordinate Angle a(start = 0);
      kinetic 1/2*(1 kg.m2)*der(a)^2;
      potential -1/2*(9 N.m/rad2)*a^2;
      discrete Torque u(start = 0);
      torque u on a;
    equation
      when sample(0, 5 ms) then
        u = -(30 N.m/rad)*a - (8 N.m.s/rad)*der(a);
      end when;
      annotation(experiment(StopTime = 5));
    end Upright;
    """
    model = lagdsl.compile(text)
    c, s = np.cosh(3 * 5e-3), np.sinh(3 * 5e-3)
    flow, push = np.array([[c, s / 3], [3 * s, c]]), np.array([[(c - 1) / 9], [s / 3]])
    largest = np.max(np.abs(np.linalg.eigvals(flow - push @ [[30.0, 8.0]])))
    found = model.modes()
    assert (found.unstable, found.held) == (1, ("u",))
    assert found.stability == f"stable: largest multiplier {largest:.6g} at 5 ms"
    assert abs(model.simulate(start={"a": 0.1})["a"][-1]) < 1e-4


# ---- lowest and highest of outputs -----------------------------------------------------------------------------------


@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_the_highest_of_an_output_lies_between_rows(engine: EngineName) -> None:
    """x = cos 10 t passes zero at pi/20 s, where the output is 1; outside of 4 cm it is nothing."""
    text = """
    model Flash
      coordinate Length x(start = 1 m);
      kinetic 1/2*(1 kg)*der(x)^2;
      potential 1/2*(100 N/m)*x^2;
      output Real flash = exp(-(x/(5 mm))^2);
      output Length twice = 2*x;
    end Flash;
    """
    motion = lagdsl.compile(text, engine=engine).simulate(stop=3.0, interval=0.5)
    assert motion.column("flash").highest == pytest.approx(1.0, rel=1e-6)
    assert motion.column("flash").lowest == 0.0
    assert motion.column("twice").lowest == pytest.approx(-2.0, rel=1e-7)


# ---- derivations: stability and equilibria ---------------------------------------------------------------------------


SPRING_BETWEEN = """
model Two
  parameter Mass m = 1 kg;
  parameter Length l = 1 m, a = 1 m;
  parameter Stiffness k = 10 N/m;
  coordinate Angle theta1(start = 10 deg), theta2;
  point A = {l*sin(theta1), -l*cos(theta1)};
  point B = {a + l*sin(theta2), -l*cos(theta2)};
  mass m at A;
  mass m at B;
  Lag.Forces.Spring s(a = A, b = B, k = k, rest = a);
  gravity = -g_n*world.y;
end Two;
"""
TWO_MESHES = """
model Meshes
  import Lag.Electrical.*;
  VoltageSource src(v = 5 V*sin(20*time/(1 s)));
  Resistor R(R = 2 Ohm);
  Inductor L1(L = 10 mH), L2(L = 10 mH);
  Capacitor C1(C = 1 mF), C2(C = 1 mF);
  Ground g;
  connect(src.p, R.p);
  connect(R.n, L1.p);
  connect(L1.n, C1.p, L2.p);
  connect(L2.n, C2.p);
  connect(src.n, C1.n, C2.n, g.p);
end Meshes;
"""


def derived(text: str) -> str:
    return str(lagdsl.compile(text).derive())


def test_growth_against_damping_is_that_of_the_eigenvalue() -> None:
    """s = -d/2 + sqrt(d^2/4 + g/l) with d = c/(m l^2): 1/s is 10.2 s, without damping it were 0.32 s."""
    text = derived(
        """model Upright
          parameter RotationalDamping c = 100 N.m.s/rad;
          coordinate Angle theta;
          gravity = -9.81 m/s2*world.y;
          mass 1 kg at {sin(theta), cos(theta)}*(1 m);
          dissipation 1/2*c*der(theta)^2;
        end Upright;"""
    )
    growth = -50.0 + math.sqrt(50.0**2 + 9.81)
    assert f"deviations grow by a factor of e in {1 / growth:.4g} s" in " ".join(text.split())


def test_a_dashpot_that_drives_is_unstable() -> None:
    """x'' - 2 a x' + w^2 x = 0 grows as exp(a t)."""
    body = "mass 1 kg at {x, 0}; gravity = 0; potential 1/2*(9 N/m)*x^2; dissipation -1/2*(0.5 N.s/m)*der(x)^2;"
    text = " ".join(derived(f"model Driven coordinate Length x; {body} end Driven;").split())
    assert "ω = 3 rad/s, 0.4775 Hz, unstable: deviations grow by a factor of e in 4 s" in text
    assert "without swinging" not in text


def test_a_ball_rests_on_the_floor() -> None:
    text = derived(
        """model Ball
          parameter Mass m = 2 kg;
          coordinate Length h(start = 1 m);
          gravity = -g_n*world.y;
          mass m at {0, h};
          contact floor: h >= 0 with restitution = 0.5;
        end Ball;"""
    )
    assert "Equilibrium h = 0, λ = m g_n: the contact floor is closed." in text
    assert "While all contacts are open, so that their multipliers are zero:\n    ḧ = −g_n" in text
    assert "nowhere" not in text


def test_a_contact_on_the_wrong_side_holds_nothing() -> None:
    """Under a ceiling the contact would have to pull."""
    body = "gravity = -g_n*world.y; mass 1 kg at {0, h}; contact ceiling: -h >= 0 with restitution = 0;"
    assert "nowhere at rest" in derived(f"model Up coordinate Length h(start = -1 m); {body} end Up;")


def test_constants_that_must_vanish_for_rest_are_named() -> None:
    """Two masses over a pulley: none rests unless (m1 - m2) g = 0, whatever x is."""
    body = "coordinate Length x; gravity = g_n*world.y; mass a at {0, x}; mass b at {1 m, -x};"
    text = derived(f"model Pulley parameter Mass a = 3 kg, b = 1 kg; {body} end Pulley;")
    assert "There is no equilibrium unless (b − a) g_n = 0." in text
    even = derived(f"model Pulley parameter Mass a = 3 kg, b = 3 kg; {body} end Pulley;")
    assert "with any x, where (b − a) g_n = 0" in even


def test_roots_that_are_the_same_are_told_once() -> None:
    """1 - cos x = 0 has one root, and cos x = 2 none."""
    body = "coordinate Angle x; gravity = 0; kinetic 1/2*(1 kg.m2)*der(x)^2; torque (1 N.m)*({} - cos(x)) on x;"
    once = derived(f"model Once {body.format(1)} end Once;")
    assert once.count("Equilibrium x = 0") == 1 and "≤" not in once
    assert "nowhere at rest" in derived(f"model No {body.format(2)} end No;")


def test_two_pendulums_and_a_spring_of_default_rest_hang_still() -> None:
    """ω1^2 = g/l and ω2^2 = g/l + 2 k/m."""
    text = derived(SPRING_BETWEEN)
    assert "if" not in text.split("4. Energies")[1].split("6–9")[0]
    assert "Equilibrium θ₁ = 0, θ₂ = 0. For small deviations δ:" in text
    assert "ω₁ = √(g_n/l)\n    ω₂ = √(g_n/l + 2 k/m)" in text
    assert "There may be other equilibria" in text


# ---- derivations: names and letters ----------------------------------------------------------------------------------


def test_a_place_has_one_name() -> None:
    text = derived(
        """model Chain
          parameter Mass m = 1 kg;
          parameter Length l = 1 m;
          input Force F = 2 N;
          coordinate Angle a, b;
          gravity = 0;
          mass m at {l*sin(a), -l*cos(a)};
          mass m at {l*sin(a) + l*sin(b), -l*cos(a) - l*cos(b)};
          force {F, 0} at {l*sin(b) + l*sin(a), -l*cos(a) - l*cos(b)};
          point end_ = {2*l*sin(a), 0};
          force {0, F} at end_;
        end Chain;"""
    )
    assert "(F, 0)  point r₂" in text and "∂r₂/∂b = (l cos b, l sin b)" in text
    assert "(0, F)\n        point r_end = (2 l sin a, 0)" in text and "∂r_end/∂a = (2 l cos a, 0)" in text
    assert "∂r₁" not in text


def test_a_torque_turns_what_the_body_turns_with() -> None:
    text = derived(
        """model Wheel
          coordinate Angle q;
          frame D = world.rotz(q);
          body wheel(m = 1 kg, Izz = 2 kg.m2) on D;
          gravity = 0;
          torque {0, 0, 3 N.m} on D;
        end Wheel;"""
    )
    assert "frame D, which turns with ω_wheel" in text and "∂ω_wheel/∂q̇ = (0, 0, 1)" in text


def test_an_input_keeps_its_letter_with_its_value_beside_it() -> None:
    text = derived(
        """model Pulled
          parameter Stiffness k1 = 10 N/m;
          input Force F = 1 N;
          coordinate Length x;
          mass 1 kg at {x, 0};
          gravity = 0;
          potential 1/2*k1*x^2;
          force F on x;
        end Pulled;"""
    )
    assert "Inputs are held at their defaults: F = 1 N." in text
    assert "Equilibrium x = F/k₁." in text
    assert "d = 3 N − k = 3·1 − 2 = 1" in text


def test_letters_give_way_only_where_they_collide_and_are_named() -> None:
    body = "gravity = 0; mass 1 kg at {x + N + Q1, zeta};"
    text = derived(f"model M parameter Length N = 3 m, Q1 = 1 m, k_a = 1 m; coordinate Length zeta, x; {body} end M;")
    assert "N is a letter of the model; the derivation writes 𝒩." in text
    assert "d = 3 𝒩 − k" in text
    own = {letter for letter in text if ord(letter) > 0x1D400}
    assert own == {"𝒩"}


def test_loads_in_components_are_named_by_these() -> None:
    assert "src: force -v on q;" in derived(TWO_MESHES)


def test_units_are_typeset_in_every_format() -> None:
    source = "model U parameter RotationalDamping c = 1 N.m.s/rad; coordinate Angle q; gravity = 0;"
    found = lagdsl.compile(source + " kinetic 1/2*(1 kg.m2)*der(q)^2; dissipation c*der(q)^2/2; end U;").derive()
    for form in ("text", "html", "markdown"):
        assert "1 N·m·s/rad" in found.to(form)
    assert r"1 N\ensuremath{\cdot}m\ensuremath{\cdot}s/rad" in found.to("latex")
    assert r"\quad[\mathrm{N{\cdot}m}]" in found.to("latex", units=True)


# ---- derivations: what is printed is short ---------------------------------------------------------------------------


def test_a_sum_that_the_model_writes_is_a_factor() -> None:
    """A disc rolls in a cylinder that slides: T = (M + m) X'^2/2 + m (R - r)^2 phi'^2/2 + ... as in every textbook."""
    text = derived(
        """model Disc
          parameter Mass M = 2 kg, m = 1 kg;
          parameter Length R = 0.5 m, r = 0.1 m;
          coordinate Length X;
          coordinate Angle phi, psi;
          point O = {X, 0};
          frame D = world.at(O + (R - r)*{sin(phi), -cos(phi)}).rotz(psi);
          mass M at O;
          body disc(m = m, Izz = 1/2*m*r^2) on D;
          gravity = -g_n*world.y;
          constraint rolling: r*psi = -(R - r)*phi;
        end Disc;"""
    )
    assert "T = ½ (M + m) Ẋ² + ½ (R − r)² m φ̇² + (R − r) m Ẋ φ̇ cos φ + ¼ m r² ψ̇²" in text
    assert "V = −(R − r) m g_n cos φ" in text
    assert "(R − r) φ + r ψ = 0" in text
    assert "(r − R)" not in text and "R² + r²" not in text


def test_the_length_of_a_spring_is_named_once() -> None:
    text = derived(SPRING_BETWEEN)
    assert text.count("√((l cos θ₁ − l cos θ₂)² + (a − l sin θ₁ + l sin θ₂)²)") == 1
    assert "V = ½ k (s_length,s − a)² − m g_n l (cos θ₁ + cos θ₂)" in text
    assert "l k (s_length,s − a) (l sin(θ₁ − θ₂) − a cos θ₁)/s_length,s = 0" in text


def test_a_circuit_of_two_meshes_prints_its_equations() -> None:
    text = derived(TWO_MESHES).split("Equations in symbols")[1]
    assert "L_L1 q̈_L1 = λ_node(R,n) − λ_node(L1,n)" in text
    assert "q_C2/C_C2 = λ_node(L2,n) − λ_node(src,n)" in text
    assert "q̇_C2 − q̇_L2 = 0" in text
    assert "v_src = 5 sin(20 t)" in text


# ---- pictures: springs and bars --------------------------------------------------------------------------------------


def test_a_bar_is_drawn_in_its_length() -> None:
    """I = m l^2/12 about a centre that stands l/2 from its frame: one metre from end to end."""
    sink = Sink()
    flat = flatten_file(
        SourceFile(
            "bar.lag",
            """model Bar
              parameter Length l = 1 m;
              coordinate Angle q(start = 10 deg);
              frame F = world.rotz(q);
              body pole(m = 1 kg, com = {0, -l/2, 0}, Izz = (1 kg)*l^2/12) on F;
              gravity = -g_n*world.y;
            end Bar;""",
        ),
        sink,
    )
    assert flat is not None, sink.diagnostics
    made = recorded(prepare(flat), Wishes(), 5)
    columns = made.motion.columns[-len(made.scene.columns) :]
    rows = np.array([column.values for column in columns]).T.reshape(len(made.motion), -1)
    parts = parts_of(stage_of(made.scene, rows, (0, 1, 0)), 0)
    lengths = [np.linalg.norm(np.ptp(part.corners.reshape(-1, 3), axis=0)) for part in parts if isinstance(part, Faces)]
    assert max(lengths) == pytest.approx(1.0, rel=0.02)  # the support at its pin is small


# ---- robots: URDF ----------------------------------------------------------------------------------------------------


def planar_four_bar() -> tuple[np.ndarray, np.ndarray]:
    """Start and end of the loop by components in the plane; a positive angle about z is a negative one about the y axis
    of the robot's file."""
    plane = lagdsl.compile(TEXTS / "four_bar.lag", engine="tape")
    motion = plane.simulate(stop=0.5, tolerance=1e-11)
    start, end = (np.array([-motion[name][k] for name in ("A.q", "B.q", "D.q")]) for k in (0, -1))
    return start, end


@pytest.mark.parametrize("form", ["urdf", "xml"])
@pytest.mark.parametrize("engine", engines(["tape", "c", "numpy"]))
def test_loops_of_robot_files_are_closed(form: str, engine: str) -> None:
    """One degree of freedom; closed to 1e-10; the motion is that of the same loop by components in the plane."""
    if form == "xml":
        pytest.importorskip("mujoco")
    text = lagdsl.import_robot(TEXTS / f"four_bar.{form}", actuators="none")
    model = lagdsl.compile(text, engine=engine)
    start, end = planar_four_bar()
    names = ("A.q", "B.q", "D.q")
    motion = model.simulate(stop=0.5, tolerance=1e-11, start=dict(zip(names, start, strict=True)))
    for k in (0, len(motion["time"]) // 2, -1):
        a, b, d = (motion[name][k] for name in names)
        x = 0.4 * np.cos(a) + np.cos(a + b) - 0.9 - 0.8 * np.sin(d)
        z = -0.4 * np.sin(a) - np.sin(a + b) - 0.1 - 0.8 * np.cos(d)
        assert np.hypot(x, z) < 1e-10
    assert np.abs([motion[name][-1] for name in names] - end).max() < 1e-7


def test_a_loop_of_a_robot_file_as_fmu(tmp_path: Path) -> None:
    fmpy = pytest.importorskip("fmpy")
    start, end = planar_four_bar()
    names = ("A.q", "B.q", "D.q")
    export_text(lagdsl.import_robot(TEXTS / "four_bar.urdf", actuators="none"), tmp_path / "four_bar.fmu")
    rows = fmpy.simulate_fmu(
        str(tmp_path / "four_bar.fmu"),
        stop_time=0.5,
        fmi_type="CoSimulation",
        start_values=dict(zip(names, map(float, start), strict=True)),
        output=list(names),
    )
    assert np.abs([rows[name][-1] for name in names] - end).max() < 1e-5


ROTOR = """<robot name="r" xmlns:drake="x"><link name="a"/><link name="b"><inertial><origin xyz="0.2 0 0"/>
<mass value="1.5"/><inertia ixx="0.01" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/></joint>
<transmission name="t"><joint name="j"/><actuator name="m">{}</actuator></transmission></robot>"""
RATIO, REDUCTION = '<drake:gear_ratio value="{}"/>', "<mechanicalReduction>{}</mechanicalReduction>"


@pytest.mark.parametrize(
    ("gear", "ratio"),
    [
        (REDUCTION.format(1) + RATIO.format(120), 120.0),
        (RATIO.format(-120), 120.0),
        (REDUCTION.format(80), 80.0),
        ("", 1.0),
    ],
)
def test_rotors_turn_by_the_ratio_of_their_gear(tmp_path: Path, gear: str, ratio: float) -> None:
    """The inertia about the axis is 0.02 + 1.5 0.2^2 + n^2 J."""
    (tmp_path / "r.urdf").write_text(ROTOR.format(gear + '<drake:rotor_inertia value="2e-4"/>'))
    model = lagdsl.compile(lagdsl.import_robot(tmp_path / "r.urdf"), engine="tape")
    assert model.mass_matrix(0.0, [0.3]).item() == pytest.approx(0.08 + ratio**2 * 2e-4, rel=1e-14)


def test_point_masses_on_axes_give_no_inertia(tmp_path: Path) -> None:
    """A lenient import writes a text that compiles: the point of 3 kg, 0.3 m from the axis, moves with its carrier."""
    rod = '<mass value="2"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/>'
    text = f"""<robot name="r"><link name="a"/>
<link name="b"><inertial><origin xyz="0.1 0 0"/>{rod}</inertial></link>
<link name="c"><inertial>{rod.replace('"2"', '"3"')}</inertial></link>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="k" type="continuous"><parent link="b"/><child link="c"/><origin xyz="0.3 0 0"/><axis xyz="0 0 1"/></joint>
</robot>"""
    (tmp_path / "r.urdf").write_text(text)
    with pytest.raises(lagdsl.CompilationFailed, match="E1012"):
        lagdsl.import_robot(tmp_path / "r.urdf")
    model = lagdsl.compile(lagdsl.import_robot(tmp_path / "r.urdf", lenient=True), engine="tape")
    assert model.mass_matrix(0.0, [0.3]).item() == pytest.approx(2 * 0.1**2 + 3 * 0.3**2, rel=1e-14)


# ---- robots: MJCF ----------------------------------------------------------------------------------------------------


def test_a_damped_ball_with_a_rotor_is_imported(tmp_path: Path) -> None:
    """From rest without gravity the angular velocity about a principal axis falls as exp(-d t/(I + m l^2 + a))."""
    pytest.importorskip("mujoco")
    body = '<inertial pos="0 0 -0.5" mass="2" diaginertia="0.1 0.1 0.02"/>'
    joint = '<joint name="hip" type="ball" damping="0.3" armature="0.05"/>'
    world = f'<worldbody><body name="bob">{joint}{body}</body></worldbody>'
    (tmp_path / "r.xml").write_text(f'<mujoco><option gravity="0 0 0"/>{world}</mujoco>')
    text = lagdsl.import_robot(tmp_path / "r.xml").replace(
        "end ", "output AngularVelocity w = omega(bob.frame_a)*world.x;\nend "
    )
    model = lagdsl.compile(text, engine="tape")
    motion = model.simulate(stop=1.0, tolerance=1e-10, start={"der(hip.e[2])": 0.5})
    assert motion["w"][-1] == pytest.approx(np.exp(-0.3 / (0.1 + 2 * 0.5**2 + 0.05)), rel=1e-7)


def test_folders_beside_that_of_the_file_are_reached(tmp_path: Path) -> None:
    """mjcf/r.xml beside meshes, with pictures farther away that it does not use, and a text that it includes."""
    pytest.importorskip("mujoco")
    for folder in ("mjcf", "meshes"):
        (tmp_path / "robot" / folder).mkdir(parents=True)
    (tmp_path / "robot" / "meshes" / "m.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    )
    (tmp_path / "robot" / "mjcf" / "more.xml").write_text('<mujoco><default><joint damping="0.3"/></default></mujoco>')
    shape = '<geom type="mesh" mesh="m" contype="0" conaffinity="0"/>'
    solid = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    body = f'<body name="b"><joint name="j" axis="0 1 0"/>{solid}{shape}</body>'
    (tmp_path / "robot" / "mjcf" / "r.xml").write_text(
        '<mujoco><compiler meshdir="../meshes" texturedir="../../../pictures"/><include file="more.xml"/>'
        f'<asset><mesh name="m" file="m.obj"/></asset><worldbody>{body}</worldbody></mujoco>'
    )
    text = lagdsl.import_robot(tmp_path / "robot" / "mjcf" / "r.xml", folder=tmp_path / "robot")
    assert 'draw mesh(file = "meshes/m.obj")' in text and "0.3 N.m.s/rad" in text
