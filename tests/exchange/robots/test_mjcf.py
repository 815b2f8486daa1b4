"""An MJCF file as a model: its equations are those that MuJoCo computes from the file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from meshes.solids import binary_stl, corners

import lagdsl
from lagdsl.derivation.scene.living import scene_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.syntax.printer import format_text
from robots.imported import FILES, imported, refusal
from robots.mujoco_peer import compare_with_mujoco

mujoco = pytest.importorskip("mujoco")

MOBILE = FILES / "mobile.xml"
SERVOS = FILES / "servos.xml"


def test_equations_and_places_are_those_of_mujoco(tmp_path: Path) -> None:
    """Without the gear, whose force MuJoCo makes soft."""
    path = tmp_path / "mobile.xml"
    text = MOBILE.read_text(encoding="utf-8")
    path.write_text(text[: text.index("<equality>")] + text[text.index("<actuator>") :], encoding="utf-8")
    worst = compare_with_mujoco(path, states=10)
    assert max(worst.values()) < 1e-12, worst


def test_servos_and_tendons_are_those_of_mujoco() -> None:
    """Positions, velocities, filters, integrators, affine gains and biases, bounds of forces, springs with slack."""
    worst = compare_with_mujoco(SERVOS, states=20)
    assert max(worst.values()) < 1e-12, worst
    assert "activations" in worst


def test_servos_are_written_as_a_person_writes_them() -> None:
    text, told = imported(SERVOS)
    assert [each.code for each in told] == ["N1024"] and not lagdsl.check(text)
    for line in (
        "input Angle aim(min = -1, max = 1);",
        "input Velocity pace;",
        "force max(min(12 N.s/m*(pace - der(rail.s)), 9 N), -8 N) on rail.s;",
        "torque 6 N.m/rad*(slow_activation - elbow.q) on elbow.q;",
        "der(slow_activation) = (slow - slow_activation)/(0.2 s);",
        "Length cable = 2*rail.s - 0.3 m/rad*shoulder.q;",
        "output Length cable_within(min = -1, max = 2) = cable;",
    ):
        assert f"\n  {line}\n" in text, text


def test_limits_of_tendons_as_contacts() -> None:
    text, _ = imported(SERVOS, limits="contact")
    assert "contact cable_lower: cable + 1 m >= 0 with restitution = 0;" in text
    assert "contact cable_upper: 2 m - cable >= 0 with restitution = 0;" in text


def test_the_text_is_sound_and_starts_where_the_file_starts() -> None:
    text, told = imported(MOBILE)
    assert format_text(SourceFile("mobile.lag", text), Sink()) == text
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []
    assert {each.code for each in told} <= {"N1020", "N1024"}
    for line in (
        "connect(world, rail_origin, rail, swivel_origin, swivel, swivel_end, cart);",
        "gravity = {0.5 m/s2, 0, -9.7 m/s2};",
        "FreeQuaternion flight(r(start = {1, 2, 3}), e(start = {0.6, 0, 0.8, 0}));",
        "input Real drive(min = -1, max = 1);",
        "input Real u_elbow(min = -6, max = 8);",
        "Revolute elbow(q(min = -90 deg, max = 45 deg), tau = 2 N.m*u_elbow);",
    ):
        assert f"\n  {line}\n" in text, text
    assert "sphere(radius = 0.05)" not in text  # a shape for collisions
    assert "potential 1/2*15 N/m*(rail.s - 0.5 m)^2;" in text


def test_the_gear_counts_from_the_references_of_both_joints() -> None:
    """q1 - ref1 = 0.1 - 1.5 (q2 - ref2): radians, ref1 = 5 deg, ref2 = 0."""
    text, _ = imported(MOBILE)
    offset = float(np.radians(5)) + 0.1
    assert f"constraint follower_gear: follower.q = -1.5*elbow.q + {offset!r} rad;" in text


def body(inside: str = "", after: str = "", joint: str = '<joint name="j" type="hinge"/>') -> str:
    ball = f'<body name="b">{joint}<geom name="g" size="0.1"/>{inside}</body>'
    return f"<mujoco>\n<worldbody>{ball}</worldbody>\n{after}</mujoco>"


MUSCLE = '<muscle joint="j" lengthrange="0 1"/>'
EARLY = 'dyntype="filter" dynprm="0.1" actearly="true"'
SHARED = '<joint name="j" type="hinge" actuatorfrcrange="-1 1"/>'
TWO_MOTORS = '<motor name="a" joint="j"/>\n<motor name="b" joint="j"/>'
SPATIAL = '<tendon><spatial name="t" stiffness="1"><site site="w"/><site site="s"/></spatial></tendon>'
TIED = body(
    inside='<body><joint name="k" axis="1 0 0"/><geom size="0.1" pos="0 1 0"/></body>'
    '<body><joint name="l" axis="1 0 0"/><geom size="0.1" pos="0 1 0"/></body>',
    after="<equality>\n{}</equality>",
)
REFUSED = [
    ("drag", body(after='<option density="1.2"/>'), "E1016", 1),
    ("muscle", body(after='<actuator>\n<muscle name="m" joint="j" lengthrange="0 1"/></actuator>'), "E1016", 4),
    ("early", body(after=f'<actuator>\n<general name="m" joint="j" {EARLY}/></actuator>'), "E1016", 4),
    ("shared", body(joint=SHARED, after=f"<actuator>{TWO_MOTORS}</actuator>"), "E1016", 4),
    ("nameless", body(after=f"<actuator>\n{MUSCLE}</actuator>"), "E1016", 4),
    ("ball spring", body(joint='<joint name="j" type="ball" stiffness="1"/>'), "E1016", 2),
    ("nameless joint", body(joint='<joint type="ball" stiffness="1"/>'), "E1016", 2),
    ("limit in space", body(joint='<joint type="ball" range="0 60"/>'), "E1016", 2),
    (
        "spatial tendon",
        body(inside='<site name="s" pos="1 0 0"/>', after=SPATIAL).replace("<body", '<site name="w"/><body'),
        "E1016",
        3,
    ),
    ("unknown", body(after="<wheel/>"), "E1015", 1),
    ("no inertia", body().replace('<geom name="g" size="0.1"/>', ""), "E1015", 1),
    ("mesh outside", body(after='<asset><mesh name="m" file="/etc/passwd"/></asset>'), "E1013", 3),
    ("folder outside", body(after='<compiler meshdir="../.."/><asset><mesh file="m.stl"/></asset>'), "E1013", 3),
    ("include outside", body(after='<include file="../../other.xml"/>'), "E1013", 3),
    ("include itself", body(after='<include file="robot.xml"/>'), "E1002", 3),
    ("entity", '<!DOCTYPE m [<!ENTITY a "a">]>' + body(), "E1003", 1),
]


@pytest.mark.parametrize(("text", "code", "line"), [pytest.param(*row[1:], id=row[0]) for row in REFUSED])
def test_what_the_text_cannot_have_is_refused(tmp_path: Path, text: str, code: str, line: int) -> None:
    assert [each[:2] for each in refusal(tmp_path / "robot.xml", text)] == [(code, line)]
    if code == "E1016":
        model, told = imported(tmp_path / "robot.xml", lenient=True)
        assert [each.code for each in told if each.severity == "warning"] == ["E1016"]
        assert [each.code for each in lagdsl.check(model) if each.severity == "error"] == []


def test_equalities_in_a_circle_are_rows_as_others(tmp_path: Path) -> None:
    """MuJoCo takes them: j = k and k = 2 j hold both still."""
    ties = '<joint joint1="j" joint2="k"/>\n<joint joint1="k" joint2="j" polycoef="0 2"/>'
    (tmp_path / "robot.xml").write_text(TIED.format(ties))
    model, _ = imported(tmp_path / "robot.xml")
    assert "constraint j_gear: j.q = k.q;" in model and "constraint k_gear: k.q = 2*j.q;" in model
    assert not [each for each in lagdsl.check(model) if each.severity == "error"]


def test_elements_of_included_files_have_their_places(tmp_path: Path) -> None:
    (tmp_path / "drives.xml").write_text(f"<mujocoinclude>\n\n{MUSCLE}</mujocoinclude>")
    path = tmp_path / "robot.xml"
    path.write_text(body(after=f'<actuator><motor joint="j"/>\n<include file="drives.xml"/>{MUSCLE}</actuator>'))
    sink = Sink()
    with pytest.raises(lagdsl.CompilationFailed):
        lagdsl.import_robot(path, sink=sink)
    spans = [each.labels[0].span for each in sink.diagnostics if each.code == "E1016"]
    assert [(Path(span.file.name).name, span.first.line) for span in spans] == [("drives.xml", 3), ("robot.xml", 4)]


def test_a_motor_without_gear_has_an_input_without_effect(tmp_path: Path) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(body(after='<actuator><motor name="m" joint="j" gear="0"/></actuator>'))
    assert not [each for each in lagdsl.check(imported(path)[0]) if each.severity == "error"]


def test_sites_are_frames(tmp_path: Path) -> None:
    """Places, axes and Jacobians of the frames are those of MuJoCo's sites; one is called as its body."""
    tool = '<site name="b" pos="0.1 0.2 0.3" euler="10 20 30"/><site name="tip" pos="0 0 0.4"/><site pos="1 0 0"/>'
    inner = f'{tool}<body pos="0 0.5 0"><joint name="k" axis="1 0 0"/><geom size="0.1" pos="0 1 0"/></body>'
    path = tmp_path / "robot.xml"
    path.write_text(body(inner).replace("<worldbody>", '<worldbody><site name="goal" pos="1 2 3"/>'))
    text, told = imported(path)
    assert "frame tip;" in text and not told and not lagdsl.check(text)
    arm = lagdsl.compile(text, engine="tape")
    model = mujoco.MjModel.from_xml_path(str(path))
    data, jacobian, q = mujoco.MjData(model), np.zeros((6, 2)), np.array([0.7, -1.2])
    data.qpos[:] = q
    mujoco.mj_forward(model, data)
    for site, name in (("b", "b_site"), ("tip", "tip"), ("goal", "goal")):
        frame, index = arm.frame(name), model.site(site).id
        mujoco.mj_jacSite(model, data, jacobian[:3], jacobian[3:], index)
        np.testing.assert_allclose(frame.position(0.0, q), data.site_xpos[index], atol=1e-12)
        np.testing.assert_allclose(frame.rotation(0.0, q), data.site_xmat[index].reshape(3, 3), atol=1e-12)
        np.testing.assert_allclose(frame.jacobian(0.0, q), jacobian, atol=1e-12)


def test_warnings_of_mujoco_are_notes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "robot.xml"
    path.write_text(body(after='<compiler settotalmass="14"/>'))
    _, told = imported(path)
    assert [each.code for each in told] in (["N1021"], [])  # a later version may say nothing
    assert [each.name for each in tmp_path.iterdir()] == ["robot.xml"]


def test_a_mesh_stands_where_mujoco_has_its_points(tmp_path: Path) -> None:
    """MuJoCo moves the points of a file to their centre: the text places the file itself."""
    (tmp_path / "b.stl").write_bytes(binary_stl())
    path = tmp_path / "robot.xml"
    seat = 'pos="1 2 3" euler="10 20 30" type="mesh" mesh="m"'
    path.write_text(body(f"<geom {seat}/>", '<asset><mesh name="m" file="b.stl" scale="0.1 0.2 0.3"/></asset>'))
    text, told = imported(path, folder=tmp_path)
    assert "scale = {0.1 m, 0.2 m, 0.3 m}" in text and not told
    flat = lagdsl.compile(text)._compilation.flat
    scene = scene_of(flat)
    (shape,) = [each for each in scene.shapes if each.kind == "mesh"]
    evaluator = Evaluator(flat, Values())
    at, x, z = (evaluator.vector(shape.parts[0].numbers[role]) for role in ("at", "x", "z"))
    own = np.array([0.1, 0.2, 0.3]) * np.array(corners()) @ np.array([x, np.cross(z, x), z]) + at
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    theirs = model.mesh_vert @ data.geom_xmat[1].reshape(3, 3).T + data.geom_xpos[1]
    distances = np.linalg.norm(own[:, None] - theirs[None], axis=2)
    assert len(theirs) == 8 and np.all(distances.min(axis=0) < 1e-6) and np.all(distances.min(axis=1) < 1e-6)
