"""Names in a robot's file lead to its package, or to the parent of its folder, and to the folder of `--root`."""

from __future__ import annotations

from pathlib import Path

import pytest
from choice import chosen
from click.testing import CliRunner
from meshes.solids import binary_stl

import lagdsl
from lagdsl.interfaces.cli.main import lag
from robots.imported import imported, refusal

SOLID = '<inertial pos="0.1 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>'
SHAPE = '<geom type="mesh" mesh="m" contype="0" conaffinity="0"/>'
FORM = """<mujoco model="m">
<compiler {folders}/>
<asset>
<mesh name="m" file="{mesh}"/>
{more}
</asset>
<worldbody><body name="arm"><joint name="j" axis="0 1 0"/>{solid}{shape}</body></worldbody>
</mujoco>"""
URDF = """<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><visual><geometry>
<mesh filename="{mesh}"/></geometry></visual></link>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/></joint></robot>"""


def mjcf(mesh: str = "m.stl", folders: str = "", more: str = "", solid: str = SOLID) -> str:
    return FORM.format(mesh=mesh, folders=folders, more=more, solid=solid, shape=SHAPE)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """far/robot/mjcf/robot.xml; meshes beside it, in far/robot/meshes, and in far/common."""
    for folder in ("robot/mjcf", "robot/meshes", "common"):
        (tmp_path / "far" / folder).mkdir(parents=True)
        (tmp_path / "far" / folder / "m.stl").write_bytes(binary_stl())
    return tmp_path / "far" / "robot" / "mjcf" / "robot.xml"


INSIDE = [
    ("beside", mjcf()),
    ("folder of meshes", mjcf(folders='meshdir="../meshes"')),
    ("pictures elsewhere", mjcf(folders='texturedir="../../../elsewhere"')),
    ("folder of meshes behind", mjcf().replace("<worldbody>", '<compiler meshdir="../meshes"/><worldbody>')),
    ("down and up", mjcf("../../m.stl", folders='meshdir="../meshes/a/b"')),
    ("without folders", mjcf("../../common/x/m.stl", folders='meshdir="../meshes" strippath="true"')),
    ("made by MuJoCo", mjcf(more='<texture name="t" type="2d" builtin="flat" width="2" height="2"/>')),
    ("URDF", URDF.format(mesh="../meshes/m.stl")),
]


@pytest.mark.parametrize("text", [pytest.param(text, id=name) for name, text in INSIDE])
def test_names_lead_to_the_parent_of_the_folder_and_below(path: Path, text: str) -> None:
    if "mujoco" in text:
        pytest.importorskip("mujoco")
    path.write_text(text)
    model, told = imported(path, folder=path.parents[1])
    assert "draw mesh(file = " in model and not told


FAR = [
    ("mesh", mjcf("../../common/m.stl"), 4),
    ("folder of meshes", mjcf(folders='meshdir="../../common"'), 4),
    ("texture", mjcf(more='<texture name="t" type="2d" file="../../common/m.stl"/>'), 5),
    ("included file", mjcf(more='<include file="../../common/more.xml"/>'), 5),
    ("included model", mjcf(more='<model name="o" file="../../common/more.xml"/>'), 5),
    ("mesh", URDF.format(mesh="../../common/m.stl"), 3),
]


@pytest.mark.parametrize(("kind", "text", "line"), FAR)
def test_farther_names_are_told_with_the_option_that_lets_them(path: Path, kind: str, text: str, line: int) -> None:
    if "mujoco" in text:
        pytest.importorskip("mujoco")
    ((code, at, message),) = refusal(path, text)
    kind = "mesh" if kind == "folder of meshes" else kind
    assert (code, at) == ("E1013", line) and message.startswith(f"the {kind} `")
    assert message.endswith("lies outside of the folder `robot`")
    told = CliRunner().invoke(lag, ["import", str(path)])
    assert f"--root {path.parents[2].as_posix()}`" in told.stderr


def test_the_option_lets_them(path: Path) -> None:
    pytest.importorskip("mujoco")
    path.write_text(mjcf(folders='meshdir="../../common"'))
    model, told = imported(path, root=path.parents[2], folder=path.parents[2])
    assert 'draw mesh(file = "common/m.stl")' in model and not told
    done = CliRunner().invoke(lag, ["import", str(path), "--root", str(path.parents[2])])
    assert done.exit_code == 0 and "Revolute j" in done.stdout


LOST = [
    ("missing mesh", mjcf("none.stl"), "E1013"),
    ("mesh outside", mjcf("/etc/passwd"), "E1013"),
    ("missing picture", mjcf(more='<texture name="t" type="2d" file="none.png"/>'), "E1013"),
    ("missing skin", mjcf(more='<skin name="s" file="none.skn"/>'), "E1013"),
    ("missing heights", mjcf(more='<hfield name="h" file="none.png" size="1 1 1 1"/>'), "E1013"),
]


@pytest.mark.parametrize(("text", "code"), [pytest.param(*row[1:], id=row[0]) for row in chosen(LOST, LOST[:3])])
def test_a_lenient_import_leaves_files_out_that_change_no_motion(path: Path, text: str, code: str) -> None:
    pytest.importorskip("mujoco")
    assert [each[0] for each in refusal(path, text)] == [code]
    model, told = imported(path, lenient=True)
    assert [each.code for each in told if each.severity == "warning"] == [code]
    assert lagdsl.compile(model, engine="tape").mass_matrix(0.0, [0.3]).item() == pytest.approx(0.02, rel=1e-12)


def test_a_missing_mesh_that_gives_a_body_its_mass_is_refused(path: Path) -> None:
    pytest.importorskip("mujoco")
    text = mjcf("none.stl", solid="")
    ((code, _, message),) = refusal(path, text)
    assert code == "E1013" and message.endswith("and it gives a body its mass")
    with pytest.raises(lagdsl.CompilationFailed):
        imported(path, lenient=True)
