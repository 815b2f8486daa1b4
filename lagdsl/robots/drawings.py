"""Visible shapes of links as `draw` statements."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from lagdsl.robots.description import Box, Capsule, Cylinder, Mesh, Pose, Sphere, Visual
from lagdsl.robots.numbers import angle, array, number, quantity
from lagdsl.robots.plan import Plan, frame_of


def drawings(plan: Plan) -> Iterator[str]:
    """A statement for each primitive; a comment names the file of a mesh."""
    for link in plan.robot.links:
        for visual in link.visuals:
            yield from _drawn(visual, frame_of(plan, link), plan.links[link.name])


def _drawn(visual: Visual, frame: str, name: str) -> Iterator[str]:
    match visual:
        case Box():
            sizes = zip(("length", "width", "height"), visual.size, strict=True)
            arguments = ", ".join(f"{role} = {number(size)}" for role, size in sizes)
            yield f"draw box({arguments}) on {_placed(frame, visual.pose)};"
        case Cylinder() | Capsule():
            arguments = f"radius = {number(visual.radius)}, length = {number(visual.length)}"
            place = _placed(frame, visual.pose)
            yield f"draw cylinder({arguments}) on {place};"
            if isinstance(visual, Capsule):
                for end in (-visual.length / 2, visual.length / 2):
                    seat = f"{place}.move({{0, 0, {quantity(end, 'm')}}})"
                    yield f"draw sphere(radius = {number(visual.radius)}) on {seat};"
        case Sphere():
            yield f"draw sphere(radius = {number(visual.radius)}) on {_placed(frame, visual.pose)};"
        case Mesh():
            yield f"// {name} looks like {_on_one_line(visual.file)}"
        case _:
            assert_never(visual)


def _placed(frame: str, pose: Pose) -> str:
    """The frame of a shape: a turn about one axis by its name, others as the intrinsic sequence zyx."""
    text = frame
    if any(pose.xyz):
        text += f".move({array(quantity(value, 'm') for value in pose.xyz)})"
    if sum(map(bool, pose.rpy)) > 1:
        text += f'.euler("zyx", {", ".join(map(angle, reversed(pose.rpy)))})'
    else:
        text += "".join(f".rot{axis}({angle(value)})" for axis, value in zip("xyz", pose.rpy, strict=True) if value)
    return text


def _on_one_line(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text)
