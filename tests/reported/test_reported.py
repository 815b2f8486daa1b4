"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report; texts
that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest
from choice import engines
from fmi.texts import export_text

import lagdsl

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

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


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_turns_in_fmus(kind: str, version: int, tmp_path: Path) -> None:
    for text, name, right in ((READS, "twice", -24.0), (PLAIN, "back.q", -12.0)):
        path = tmp_path / f"{name}{version}.fmu"
        export_text(text, path, version)
        rows = fmpy.simulate_fmu(str(path), fmi_type=kind, stop_time=4.0, output_interval=4.0)
        assert rows[name][-1] == pytest.approx(right, abs=1e-5)


# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

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


# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

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
    "joints", ["A, B({}), C", "C, A, B({})", "C(q(start = 0)), A(q(start = 0)), B({})", "B({}), A, C"]
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


# ---- names of connected variables --------------------------------------------------------------------------------------

# ---- models in which nothing is free to move ---------------------------------------------------------------------------

# ---- certificates of statics -------------------------------------------------------------------------------------------

# ---- linearization of circuits, verdicts on sampled loops --------------------------------------------------------------

# ---- lowest and highest of outputs -------------------------------------------------------------------------------------

# ---- derivations: stability and equilibria -----------------------------------------------------------------------------

# ---- derivations: names and letters ------------------------------------------------------------------------------------

# ---- derivations: what is printed is short -----------------------------------------------------------------------------

# ---- pictures: springs and bars ----------------------------------------------------------------------------------------

# ---- robots: URDF ------------------------------------------------------------------------------------------------------

# ---- robots: MJCF ------------------------------------------------------------------------------------------------------
