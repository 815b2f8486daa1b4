"""Visible shapes of links as `draw` statements."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import assert_never

from lagdsl.exchange.model_text.numbers import angle, array, number, quantity
from lagdsl.exchange.robots.description import Box, Capsule, Cylinder, Mesh, Pose, Sphere, Visual
from lagdsl.exchange.robots.mesh_faults import MeshFault
from lagdsl.exchange.robots.plan import Plan, frame_of
from lagdsl.foundation.meshes.files import is_drawable, place_of
from lagdsl.foundation.meshes.triangles import MeshError
from lagdsl.language.syntax.print_expressions import quoted


def drawings(plan: Plan, folder: Path) -> Iterator[str]:
    """A statement for each shape; a comment names the file of a mesh that a text in that folder cannot draw."""
    for link in plan.robot.links:
        for visual in link.visuals:
            yield from _drawn(visual, frame_of(plan, link), plan.links[link.name], folder)


def undrawn(plan: Plan, folder: Path) -> Iterator[MeshFault]:
    """Meshes whose files a text in that folder cannot name, and the reasons."""
    for link in plan.robot.links:
        for visual in link.visuals:
            if isinstance(visual, Mesh) and isinstance(file := _file_of(visual, folder), MeshError):
                yield MeshFault(visual.file, visual.span, str(file))


def folder_of_all(plan: Plan, path: Path) -> str:
    """The nearest folder around the robot's file that holds all meshes of which there is a reader: a text in it draws
    them. From the working directory, if it lies there."""
    visuals = [visual for link in plan.robot.links for visual in link.visuals]
    places = [each.place.resolve().parent for each in visuals if isinstance(each, Mesh) and is_drawable(each.file)]
    home = Path(os.path.commonpath([path.resolve().parent, *places]))
    return (home.relative_to(Path.cwd()) if home.is_relative_to(Path.cwd()) else home).as_posix()


def _drawn(visual: Visual, frame: str, link: str, folder: Path) -> Iterator[str]:
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
            file = _file_of(visual, folder)
            if isinstance(file, MeshError):
                yield f"// {link} looks like {_on_one_line(visual.file)}"
            else:
                yield f"draw mesh(file = {quoted(file)}{_scaled(visual)}) on {_placed(frame, visual.pose)};"
        case _:
            assert_never(visual)


def _file_of(mesh: Mesh, folder: Path) -> str | MeshError:
    """The name of its file as a text in that folder writes it."""
    try:
        name = Path(os.path.relpath(mesh.place.resolve(), folder.resolve())).as_posix()
        place_of(name, folder)
    except ValueError:  # two disks of Windows
        return MeshError("it lies on another disk than the text")
    except MeshError as fault:
        return fault
    return name


def _scaled(mesh: Mesh) -> str:
    x, y, z = mesh.scale
    if x == y == z:
        return "" if x == 1.0 else f", scale = {quantity(x, 'm')}"
    return f", scale = {array(quantity(value, 'm') for value in mesh.scale)}"


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
