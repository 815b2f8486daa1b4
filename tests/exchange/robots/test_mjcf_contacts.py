"""Bodies that MuJoCo lets touch are told: shapes of all bodies overlap, and MuJoCo says which ones meet."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from choice import examples

from robots.imported import imported

mujoco = pytest.importorskip("mujoco")

from lagdsl.exchange.robots.mjcf.contacts import touching  # noqa: E402

INERTIAL = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'


def random_text(chance: random.Random) -> str:
    """Bodies that carry each other, some of them welded, with spheres about one point and few bits."""

    def shape() -> str:
        bits = [chance.choice((0, 0, 1, 2, 5, 2**31 - 1)) for _ in range(2)]
        return f'<geom size="1" contype="{bits[0]}" conaffinity="{bits[1]}"/>' if chance.random() < 0.8 else ""

    def body(depth: int) -> str:
        joint = '<joint axis="0 0 1"/>' if chance.random() < 0.7 else ""
        inside = "".join(body(depth + 1) for _ in range(chance.randrange(3))) if depth < 3 else ""
        return f"<body>{INERTIAL}{joint}{shape()}{inside}</body>"

    bodies = "".join(body(0) for _ in range(chance.randrange(1, 4)))
    return f"<mujoco><worldbody>{shape()}{bodies}</worldbody></mujoco>"


def test_bodies_that_may_touch_are_those_of_mujoco() -> None:
    """Spheres about one point touch wherever MuJoCo does not exclude it."""
    seen = set()
    for seed in range(examples(2000)):
        model = mujoco.MjModel.from_xml_string(random_text(random.Random(seed)))
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        geoms = {int(each) for contact in data.contact for each in contact.geom}
        moving = {int(model.geom_bodyid[each]) for each in geoms if model.body_weldid[model.geom_bodyid[each]]}
        assert set(touching(mujoco, model)) == moving, random_text(random.Random(seed))
        seen.add(len(moving))
    assert {0, 1, 2, 3} <= seen


@pytest.mark.parametrize(("flag", "told"), [("", ["N1024"]), ('<option><flag contact="disable"/></option>', [])])
def test_contacts_are_told_once(tmp_path: Path, flag: str, told: list[str]) -> None:
    floor = '<geom type="plane" size="1 1 1"/>'
    ball = f'<body name="ball" pos="0 0 1">{INERTIAL}<freejoint/><geom size="0.1"/></body>'
    path = tmp_path / "ball.xml"
    path.write_text(f"<mujoco>{flag}<worldbody>{floor}{ball}</worldbody></mujoco>")
    _, found = imported(path)
    assert [each.code for each in found] == told
    assert all("one body" in each.message for each in found)


# The floor and the ball, of which MuJoCo takes the larger numbers; a shape that touches nothing does not count.
FRICTION = {
    ('friction="0.3 0.01 0.001"', 'friction="0.7 0.01 0.001"'): "with `mu` = 0.3 to 0.7",
    ("", ""): "with `mu` = 1",
    ('condim="1"', 'condim="1"'): "without friction",
    ('condim="1"', 'friction="0.5"'): "with `mu` = 0.5 to 1",
    ("", 'condim="6"'): "with `mu` = 1, torsional and rolling friction",
}


@pytest.mark.parametrize(("shapes", "told"), FRICTION.items())
def test_the_friction_that_is_left_out_is_told(tmp_path: Path, shapes: tuple[str, str], told: str) -> None:
    floor = f'<geom type="plane" size="1 1 1" {shapes[0]}/><geom size="1" friction="9" contype="0" conaffinity="0"/>'
    ball = f'<body name="ball" pos="0 0 1">{INERTIAL}<freejoint/><geom size="0.1" {shapes[1]}/></body>'
    path = tmp_path / "ball.xml"
    path.write_text(f"<mujoco><worldbody>{floor}{ball}</worldbody></mujoco>")
    _, found = imported(path)
    assert [each.message.partition(" touch others, ")[2] for each in found] == [told]
