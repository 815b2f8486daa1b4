"""Files that describe no robot, or one that the language cannot hold: each is refused with the line at fault."""

from __future__ import annotations

import time
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from choice import ALL

import lagdsl
from lagdsl.exchange.robots import tree, xml_tree
from lagdsl.foundation.diagnostics import Sink
from robots.imported import ARM, imported, refusal

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
HEAD = f'<robot name="r">\n<link name="a">{INERTIAL}</link>\n<link name="b">{INERTIAL}</link>\n'
JOINT = '<joint name="j" type="revolute"><parent link="a"/><child link="b"/></joint>'
GOOD = f"{HEAD}{JOINT}\n</robot>\n"
LINK_C = f'<link name="c">{INERTIAL}</link>'
ON_B = '<joint name="k" type="fixed"><parent link="c"/><child link="b"/></joint>'
OF_J = '\n<mimic joint="j"/>'
BACK = '<joint name="k" type="fixed"><parent link="b"/><child link="a"/></joint>'


def with_joint(text: str) -> str:
    return f"{HEAD}{text}\n</robot>\n"


def with_mesh(name: str) -> str:
    shape = f'<visual><geometry>\n<mesh filename="{name}"/></geometry></visual>'
    return GOOD.replace('"b">', f'"b">{shape}')


def with_moments(text: str, mass: str = "1") -> str:
    xx, yy, zz = text.split()
    moments = f'ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"'
    return GOOD.replace(
        f'<link name="b">{INERTIAL}',
        f'<link name="b"><inertial>\n<mass value="{mass}"/>\n<inertia {moments}/></inertial>',
    )


def of_type(kind: str, inside: str = "", name: str = "j", child: str = "b") -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="a"/><child link="{child}"/>{inside}</joint>'


C = of_type("revolute", "", "k", "c")
C_OF_J = of_type("revolute", OF_J, "k", "c")

# what is wrong, text, code, line, warnings of a lenient import (None: refused, too)
WRONG = [
    ("not closed", GOOD.replace("</robot>", ""), "E1001", 6, None),
    ("no quotes", GOOD.replace('"revolute"', "revolute"), "E1001", 4, None),
    ("attribute twice", GOOD.replace('name="a"', 'name="a" name="a"'), "E1001", 2, None),
    ("nothing", "", "E1001", 1, None),
    ("second root", GOOD + "<robot/>", "E1001", 6, None),
    ("other format", '<sdf version="1.7"/>', "E1004", 1, None),
    ("macro", f'<robot name="r">{LINK_C}\n<xacro:arm prefix="left"/></robot>', "E1025", 2, None),
    ("value of a macro", GOOD.replace('value="1"', 'value="${m}"', 1), "E1025", 2, None),
    ("name of a macro", GOOD.replace('name="b"', 'name="$(arg side)_b"'), "E1025", 3, None),
    ("no links", "<robot/>", "E1005", 1, None),
    ("no name", GOOD.replace('link name="a"', "link"), "E1005", 2, None),
    ("no type", with_joint(JOINT.replace('type="revolute"', "")), "E1005", 4, None),
    ("no child", with_joint(JOINT.replace('<child link="b"/>', "")), "E1005", 4, None),
    ("no mass", GOOD.replace('<mass value="1"/>', "", 1), "E1005", 2, None),
    ("no moment", GOOD.replace('ixx="1"', "", 1), "E1005", 2, None),
    ("not a number", GOOD.replace('mass value="1"', 'mass value="NaN"', 1), "E1006", 2, None),
    ("infinite", with_joint(of_type("revolute", '\n<axis xyz="0 1e999 0"/>')), "E1006", 5, None),
    ("two of three", with_joint(of_type("revolute", '\n<origin xyz="0 1"/>')), "E1006", 5, None),
    ("python's number", GOOD.replace('mass value="1"', 'mass value="1_0"', 1), "E1006", 2, None),
    ("large mass", GOOD.replace('mass value="1"', 'mass value="1e308"', 1), "E1006", 2, None),
    ("large place", with_joint(of_type("revolute", '\n<origin xyz="0 0 -1e200" rpy="0 0 0"/>')), "E1006", 5, None),
    ("large angle", with_joint(of_type("fixed", '\n<origin rpy="0 1e308 0"/>')), "E1006", 5, None),
    ("other digits", with_joint(of_type("revolute", '\n<origin xyz="\uff11 \u0662 0"/>')), "E1006", 5, None),
    ("no direction", with_joint(of_type("revolute", '\n<axis xyz="0 0 0"/>')), "E1006", 5, None),
    ("negative damping", with_joint(of_type("revolute", '\n<dynamics damping="-1"/>')), "E1006", 5, ["E1006"]),
    ("link twice", GOOD.replace('"b">', '"a">'), "E1007", 3, None),
    ("joint twice", with_joint(f'{JOINT}\n{JOINT}<link name="c"/>'), "E1007", 5, None),
    ("axis twice", with_joint(of_type("revolute", '<axis xyz="1 0 0"/>\n<axis xyz="0 1 0"/>')), "E1007", 5, None),
    ("no such link", with_joint(JOINT.replace('child link="b"', 'child link="c"')), "E1008", 4, None),
    ("no leader", with_joint(of_type("revolute", '\n<mimic joint="k"/>')), "E1008", 5, ["E1008"]),
    ("no such joint", with_joint(JOINT + '\n<transmission><joint name="k"/></transmission>'), "E1008", 5, ["E1008"]),
    ("limits", with_joint(of_type("revolute", '\n<limit lower="2" upper="1"/>')), "E1009", 5, ["E1009"]),
    ("unknown joint", with_joint(of_type("ball") + LINK_C + of_type("revolute", "", "k", "c")), "E1010", 4, ["E1010"]),
    ("negative mass", with_moments("1 1 1", "-1"), "E1011", 4, None),
    ("negative moment", with_moments("1 1 -1"), "E1011", 5, ["E1011"]),
    ("no triangle", with_moments("1 1 2.1"), "E1011", 5, ["E1011"]),
    ("moves nothing", with_joint(f'{JOINT}<link name="c"/>\n{C}'), "E1012", 5, ["E1012"]),
    ("no mesh", with_mesh("b.stl"), "E1013", 4, ["E1013"]),
    ("leads out", with_mesh("../../../etc/passwd"), "E1013", 4, ["E1013"]),
    ("leads far out", with_mesh("file:///etc/passwd"), "E1013", 4, ["E1013"]),
    ("no package", with_mesh("package://../x"), "E1013", 4, ["E1013"]),
    ("from a network", with_mesh("http://x.org/b.stl"), "E1013", 4, ["E1013"]),
    ("rigid leader", with_joint(LINK_C + of_type("fixed") + C_OF_J), "E1016", 5, ["E1016"]),
    ("circle", with_joint(f"{JOINT}\n{BACK}"), "E1017", 5, None),
    ("two bases", GOOD.replace("</robot>", '\n<link name="c"/></robot>'), "E1017", 6, None),
    ("two parents", with_joint(f"{LINK_C}{JOINT}\n{ON_B}"), "E1017", 5, None),
    ("imitates itself", with_joint(of_type("revolute", OF_J)), "E1017", 5, ["E1017"]),
    ("rests", with_joint(of_type("fixed")), "E1018", 1, None),
]  # fmt: skip


@pytest.mark.parametrize(("text", "code", "line", "lenient"), [pytest.param(*row[1:], id=row[0]) for row in WRONG])
def test_what_is_wrong_is_told_at_its_line(
    tmp_path: Path, text: str, code: str, line: int, lenient: list[str] | None
) -> None:
    path = tmp_path / "robot.urdf"
    assert [each[:2] for each in refusal(path, text)] == [(code, line)]
    if lenient is None and code != "E1011":
        with pytest.raises(lagdsl.CompilationFailed):
            imported(path, lenient=True)
    elif lenient is not None:
        model, told = imported(path, lenient=True)
        assert [each.code for each in told if each.severity != "note"] == lenient
        assert all(each.severity == "warning" and each.notes for each in told if each.severity != "note")
        assert [each.code for each in lagdsl.check(model) if each.severity == "error"] == []


SHAPE = "<visual>\n<geometry>\n{}</geometry></visual>"
SHAPES = [
    ("scale", '<mesh filename="b.stl" scale="0.1"/>', "E1006", 5),
    ("scale of words", '<mesh filename="b.stl" scale="1 1 big"/>', "E1006", 5),
    ("size", '<box size="1 1"/>', "E1006", 5),
    ("no size", "<box/>", "E1005", 5),
    ("no radius", '<cylinder length="1"/>', "E1005", 5),
    ("no file", "<mesh/>", "E1005", 5),
]


@pytest.mark.parametrize(("shape", "code", "line"), [pytest.param(*row[1:], id=row[0]) for row in SHAPES])
def test_a_lenient_import_leaves_wrong_shapes_out(tmp_path: Path, shape: str, code: str, line: int) -> None:
    path = tmp_path / "robot.urdf"
    (tmp_path / "b.stl").write_text("solid")
    text = GOOD.replace('"b">', f'"b">{SHAPE.format(shape)}<visual><geometry><sphere radius="2"/></geometry></visual>')
    assert [each[:2] for each in refusal(path, text)] == [(code, line)]
    model, told = imported(path, lenient=True)
    assert [each.code for each in told] == [code] and told[0].notes == ("the shape is left out",)
    assert model.count("draw") == 1 and not [each for each in lagdsl.check(model) if each.severity == "error"]


UNREAD = [
    ("attribute", JOINT.replace('name="j"', 'name="j" axis="0 1 0"'), 4, "`axis` is an element"),
    ("misspelled", of_type("revolute", '\n<dynamics dampng="0.3"/>'), 5, "did you mean `damping`?"),
    ("element", of_type("revolute", '\n<dynamic damping="0.3"/>'), 5, "did you mean `dynamics`?"),
    ("inside out", of_type("revolute", "\n<name/>"), 5, "`name` is an attribute"),
    ("no likeness", of_type("revolute", '\n<limit effort="1" velocity="1" current="7"/>'), 5, "known attributes of"),
]


@pytest.mark.parametrize(("joint", "line", "help"), [pytest.param(*row[1:], id=row[0]) for row in UNREAD])
def test_what_is_not_read_is_told(tmp_path: Path, joint: str, line: int, help: str) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(with_joint(joint))
    _, (told,) = imported(path)
    assert told.code == "W1026" and told.labels[0].span.first.line == line
    assert told.help is not None and help in told.help


def test_elements_that_act_between_links_are_refused(tmp_path: Path) -> None:
    text = GOOD.replace("</robot>", "<drake:linear_bushing_rpy/></robot>").replace("<robot", '<robot xmlns:drake="d"')
    assert [each[:2] for each in refusal(tmp_path / "robot.urdf", text)] == [("E1016", 5)]


ROTORS = [
    ("two ratios", "<r:gear_ratio>50</r:gear_ratio><mechanicalReduction>60</mechanicalReduction>", "E1006"),
    ("negative", "<r:rotor_inertia>-1</r:rotor_inertia>", "E1006"),
    ("no number", "<r:rotor_inertia>much</r:rotor_inertia>", "E1006"),
]


@pytest.mark.parametrize(("inside", "code"), [pytest.param(*row[1:], id=row[0]) for row in ROTORS])
def test_rotors_that_cannot_be_read_are_told(tmp_path: Path, inside: str, code: str) -> None:
    actuator = f'<actuator name="m">{inside}<r:rotor_inertia>1</r:rotor_inertia></actuator>'
    text = with_joint(f'{JOINT}<transmission><joint name="j"/>{actuator}</transmission>')
    told = refusal(tmp_path / "robot.urdf", text.replace("<robot", '<robot xmlns:r="d"'))
    assert [each[0] for each in told] == [code]


FREE = """<robot name="free">
<link name="root"/>
{links}
{joints}
</robot>"""
BODY = """<link name="{0}"><inertial><origin xyz="0.1 0.2 0"/><mass value="2"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.015"/></inertial></link>"""
HINGE = """<joint name="to_{0}" type="{1}"><parent link="root"/><child link="{0}"/><origin xyz="{2} 0 0"/>
<axis xyz="{3}"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""


def free(*bodies: tuple[str, str, str, str]) -> str:
    """A root link without mass, and what hangs on it."""
    links = "\n".join(BODY.format(name) for name, *_ in bodies)
    return FREE.format(links=links, joints="\n".join(HINGE.format(*body) for body in bodies))


def test_a_free_root_without_mass_whose_motion_is_not_determined(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    text = free(("b", "revolute", "0", "0 0 1"))
    assert [each[:2] for each in refusal(path, text, floating=True)] == [("E1022", 1)]
    assert refusal(path, text, floating=True, lenient=True)[0][0] == "E1022"
    model, _ = imported(path, floating=True, lenient=True)
    assert "FreeQuaternion" not in model and lagdsl.compile(model).coordinates == ["to_b.q"]


@pytest.mark.parametrize(
    "bodies",
    [[("b", "fixed", "0", "0 0 1")], [("b", "revolute", "0", "0 0 1"), ("c", "revolute", "0.5", "0 1 0")]],
)
def test_a_free_root_without_mass_that_bodies_move(tmp_path: Path, bodies: list[tuple[str, str, str, str]]) -> None:
    """The mass matrix along the motions that the unit quaternion permits has full rank."""
    path = tmp_path / "robot.urdf"
    path.write_text(free(*bodies))
    text, told = imported(path, floating=True)
    assert "FreeQuaternion floating_base;" in text and not [each for each in told if each.severity != "note"]
    model = lagdsl.compile(text)
    q = np.zeros(len(model.coordinates))
    q[model.coordinates.index("floating_base.e[1]")] = 1.0
    mass = np.asarray(model.mass_matrix(0.0, q))
    rows = np.asarray(model.constraint_jacobian(0.0, q))
    assert np.linalg.eigvalsh(mass + rows.T @ rows)[0] > 1e-4


def test_a_mesh_behind_a_link_out_of_the_folder_is_outside(tmp_path: Path) -> None:
    (tmp_path / "robot" / "urdf").mkdir(parents=True)
    (tmp_path / "outside.stl").write_text("solid")
    (tmp_path / "robot" / "urdf" / "b.stl").symlink_to(tmp_path / "outside.stl")
    text = with_mesh("b.stl")
    path = tmp_path / "robot" / "urdf" / "robot.urdf"
    ((code, _, message),) = refusal(path, text)
    assert code == "E1013" and "lies outside of the folder `robot`" in message
    assert imported(path, root=tmp_path)[0]


@pytest.mark.parametrize("name", ["package://robot/meshes/b.stl", "meshes/b.stl", "package://beside/b.stl"])
def test_meshes_of_packages_are_found(tmp_path: Path, name: str) -> None:
    for place in ("robot/meshes/b.stl", "beside/b.stl"):
        (tmp_path / place).parent.mkdir(parents=True)
        (tmp_path / place).write_text("solid")
    path = tmp_path / "robot" / "robot.urdf"
    path.write_text(with_mesh(name).replace("<mesh ", '<mesh scale="0.1 0.1 -0.1" '))
    found = "../beside/b.stl" if "beside" in name else "meshes/b.stl"
    text, told = imported(path, folder=tmp_path)
    place = (tmp_path / "robot" / found).resolve().relative_to(tmp_path)
    assert f'draw mesh(file = "{place}", scale = {{0.1 m, 0.1 m, -0.1 m}}) on b.frame_a;' in " ".join(text.split())
    assert told == ()
    text, told = imported(path, folder=tmp_path / "beside" / "text")
    assert f"// b looks like {name}\n" in text and "draw" not in text
    assert [each.code for each in told] == ["N1023"] and "lies outside of the folder `text`" in told[0].message


def test_a_reason_against_several_meshes_is_told_once(tmp_path: Path) -> None:
    shapes = "".join(
        f'<visual><geometry><mesh filename="package://arm/meshes/{name}"/></geometry></visual>'
        for name in ("b.stl", "c.stl", "b.stl", "d.glb")
    )
    path = tmp_path / "arm" / "urdf" / "arm.urdf"
    path.parent.mkdir(parents=True)
    text = with_mesh("package://arm/meshes/a.stl").replace("</visual>", f"</visual>{shapes}", 1)
    ((code, line, _),) = refusal(path, text.replace("//arm", "//leg"))
    assert (code, line) == ("E1013", 4)
    assert len(refusal(path, text)) == 1
    (path.parents[1] / "meshes").mkdir()
    for name in ("a.stl", "b.stl", "c.stl", "d.glb"):
        (path.parents[1] / "meshes" / name).write_text("solid")
    _, told = imported(path, folder=path.parent)
    outside, other = told
    assert "outside of the folder `urdf`" in outside.message and "`b.stl`, `c.stl`" in outside.notes[0]
    assert outside.help is not None and f"`{path.parents[1].as_posix()}`" in outside.help
    assert "d.glb" in other.message and other.help == "convert it to one of these formats"
    _, told = imported(path, folder=path.parents[1])
    assert [each.message for each in told] == [other.message]


def test_a_rod_of_a_file_with_impossible_moments_keeps_its_moments(tmp_path: Path) -> None:
    """Lenient: the energy of the moments as they are; about the axis x of the joint it is that of 3 kg.m2."""
    path = tmp_path / "robot.urdf"
    path.write_text(with_moments("3 1 1"))
    text, _ = imported(path, lenient=True)
    assert lagdsl.compile(text).mass_matrix(0.0, [0.3]).item() == pytest.approx(3.0, rel=1e-15)


def test_a_gear_between_an_angle_and_a_length_has_a_unit(tmp_path: Path) -> None:
    rack = of_type("prismatic", '<mimic joint="j" multiplier="0.2" offset="0.1"/>', "k", "c")
    path = tmp_path / "robot.urdf"
    path.write_text(with_joint(LINK_C + JOINT + rack))
    text, _ = imported(path)
    assert "constraint k_gear: k.s = 0.2 m/rad*j.q + 0.1 m;" in text
    assert [each.code for each in lagdsl.check(text) if each.severity != "note"] == []


# ---- files that are made to do harm ----------------------------------------------------------------------------------

BOMB = (
    '<!DOCTYPE robot [<!ENTITY a "aaaaaaaaaa">\n'
    + "".join(f'<!ENTITY {chr(98 + i)} "{f"&{chr(97 + i)};" * 10}">\n' for i in range(9))
    + ']><robot name="&j;"/>'
)
HOSTILE = [
    ("bomb", BOMB, "E1003"),
    ("external entity", '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>', "E1003"),
    ("parameter entity", '<!DOCTYPE r [<!ENTITY % x SYSTEM "http://localhost/x.dtd"> %x;]><robot/>', "E1003"),
    ("undeclared entity", '<robot name="&x;"/>', "E1001"),
    ("document type elsewhere", '<!DOCTYPE r SYSTEM "http://localhost/x.dtd"><robot name="&x;"/>', "E1003"),
    ("deep", "<robot>" + "<a>" * 100_000, "E1002"),
    ("wide", "<robot>" + "<a/>" * 60_000, "E1002"),
    ("attributes", "<robot " + " ".join(f'a{i}=""' for i in range(200)) + "/>", "E1002"),
    ("ten thousand links", "<robot>" + "".join(f'<link name="l{i}"/>' for i in range(10_000)) + "</robot>", "E1002"),
    ("large", "<robot>" + " " * 17_000_000, "E1002"),
    ("NUL", "<robot>\0</robot>", "E1001"),
]


@pytest.mark.parametrize(("text", "code"), [pytest.param(*row[1:], id=row[0]) for row in HOSTILE])
def test_harm_is_refused_in_little_time_and_memory(tmp_path: Path, text: str, code: str) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(text)
    small = len(text) < 10_000  # where memory that grows would come from the import alone
    begin = time.process_time()
    if small:
        tracemalloc.start()
    with pytest.raises(lagdsl.CompilationFailed) as caught:
        lagdsl.import_robot(path, lenient=True)
    if small:
        assert tracemalloc.get_traced_memory()[1] < 2 * xml_tree.MAX_BYTES  # what is read at once
        tracemalloc.stop()
    assert [each.code for each in caught.value.diagnostics] == [code]
    assert len(str(caught.value)) < 5000
    assert time.process_time() - begin < 20


def test_many_links_in_a_row_are_imported(tmp_path: Path) -> None:
    """As many as are allowed, where everything is tested: there is no recursion over links."""
    count = tree.MAX_LINKS if ALL else 100
    links = "".join(f'<link name="l{i}">{INERTIAL}</link>' for i in range(count))
    joints = "".join(
        f'<joint name="j{i}" type="continuous"><parent link="l{i}"/><child link="l{i + 1}"/></joint>'
        for i in range(count - 1)
    )
    path = tmp_path / "robot.urdf"
    path.write_text(f"<robot>{links}{joints}</robot>")
    text, _ = imported(path)
    assert text.count("Revolute ") == count - 1


@pytest.mark.parametrize("encoding", ["utf-8-sig", "latin-1", "cp1252"])
def test_texts_are_read_in_their_encoding(tmp_path: Path, encoding: str) -> None:
    name = {"cp1252": "windows-1252", "latin-1": "ISO-8859-1"}.get(encoding, "utf-8")
    path = tmp_path / "robot.urdf"
    path.write_bytes(f'<?xml version="1.0" encoding="{name}"?>\r\n{GOOD}'.replace('"r"', '"Bär"').encode(encoding))
    assert imported(path)[0].startswith("model Bar ")


@pytest.mark.parametrize(
    ("content", "reason"),
    [(b"<robot name='\xff'/>", "its text is not UTF-8"), (b"<?xml version='1.0' encoding='EBCDIC'?>", "EBCDIC")],
)
def test_other_bytes_are_no_text(tmp_path: Path, content: bytes, reason: str) -> None:
    path = tmp_path / "robot.urdf"
    path.write_bytes(content)
    with pytest.raises(lagdsl.CompilationFailed, match=r"E1000.*" + reason):
        imported(path)


def test_a_path_that_cannot_be_read(tmp_path: Path) -> None:
    for path in (tmp_path / "none.urdf", tmp_path):
        with pytest.raises(lagdsl.CompilationFailed, match="E1000"):
            lagdsl.import_robot(path, sink=Sink())


def test_what_is_left_out_is_told_once_for_each_kind() -> None:
    _, told = imported(ARM)
    assert [each.message for each in told if each.code == "N1019"] == ["`<collision>` is left out, once"]
