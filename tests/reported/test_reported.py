"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report; texts
that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import engines
from fmi.texts import export_text

import lagdsl

TEXTS = Path(__file__).parent / "texts"

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

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


# ---- robots: MJCF ------------------------------------------------------------------------------------------------------


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
