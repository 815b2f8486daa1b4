"""MJCF files that are made to do harm: each is refused before MuJoCo takes much time or memory, or gives numbers that
no text has."""

from __future__ import annotations

import time
import warnings
from pathlib import Path

import pytest

import lagdsl

pytest.importorskip("mujoco")

BODY = '<body name="a"><joint name="j" type="hinge" axis="0 0 1"/><geom size="0.1" mass="1"/></body>'
MOTOR = '<motor joint="j"/>'


def mjcf(before: str = "", world: str = BODY, after: str = "") -> str:
    return f'<mujoco model="m">{before}<worldbody>{world}</worldbody>{after}</mujoco>'


def asset(text: str) -> str:
    return mjcf(f"<asset>{text}</asset>")


# what is wrong, text, code
HOSTILE = [
    ("picture", asset('<texture name="t" type="2d" builtin="flat" width="60000" height="60000"/>'), "E1002"),
    ("heights", asset('<hfield name="h" nrow="30000" ncol="30000" size="1 1 1 1"/>'), "E1002"),
    ("copies", mjcf(world=f'<replicate count="1000000">{BODY}</replicate>'), "E1002"),
    ("copies of copies", mjcf(world='<replicate count="100">' * 4 + BODY + "</replicate>" * 4), "E1002"),
    ("a cloth", mjcf(world='<body><flexcomp name="f" count="500 500 500"/></body>'), "E1002"),
    ("memory", mjcf('<size memory="100G"/>'), "E1002"),
    ("reserve", mjcf('<size nuserdata="2000000000"/>'), "E1002"),
    ("motors", mjcf(after=f"<actuator>{MOTOR * 20_000}</actuator>"), "E1002"),
    ("bodies", mjcf(world="<body/>" * 1001), "E1002"),
    ("deep", mjcf(world="<body>" * 5000 + "</body>" * 5000), "E1002"),
    ("includes itself", '<mujoco><include file="robot.xml"/></mujoco>', "E1002"),
    ("entities", '<!DOCTYPE m [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>' + mjcf(), "E1003"),
    ("a device", '<mujoco><include file="/dev/zero"/></mujoco>', "E1013"),
    ("a model outside", asset('<model name="o" file="/etc/passwd"/>'), "E1013"),
    ("gravity", mjcf('<option gravity="nan 0 0"/>'), "E1006"),
    ("endless gravity", mjcf('<option gravity="0 0 -1e999"/>'), "E1015"),
    ("a stiff spring", mjcf(world=BODY.replace('type="hinge"', 'stiffness="1e308"')), "E1015"),
    ("not a number", mjcf(world=BODY.replace('mass="1"', 'mass="nan"')), "E1006"),
    ("names", mjcf(world=BODY + BODY), "E1015"),
    ("a library", mjcf('<extension><plugin plugin="/tmp/evil.so"/></extension>'), "E1015"),
]


@pytest.mark.parametrize(("text", "code"), [pytest.param(*row[1:], id=row[0]) for row in HOSTILE])
def test_harm_is_refused_in_little_time(tmp_path: Path, text: str, code: str) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(text)
    begin = time.process_time()
    with pytest.raises(lagdsl.CompilationFailed) as caught, warnings.catch_warnings():
        warnings.simplefilter("error")
        lagdsl.import_robot(path, lenient=True)
    assert code in [each.code for each in caught.value.diagnostics]
    assert len(str(caught.value)) < 5000
    assert time.process_time() - begin < 10


def test_as_many_motors_as_are_allowed(tmp_path: Path) -> None:
    """On one joint, without names: their inputs are numbered."""
    path = tmp_path / "robot.xml"
    path.write_text(mjcf(after=f"<actuator>{MOTOR * 500}</actuator>"))
    text = lagdsl.import_robot(path)
    assert [f"input Real {name};" in text for name in ("u_j", "u_j_2", "u_j_500", "u_j_501")] == [
        True,
        True,
        True,
        False,
    ]
