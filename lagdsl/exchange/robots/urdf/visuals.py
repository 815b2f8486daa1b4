"""Visible shapes of links: primitives, and files of meshes, which must exist in the folder of the robot."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import unquote

from lagdsl.exchange.robots.attributes import Attributes
from lagdsl.exchange.robots.description import ZERO, Box, Cylinder, Mesh, Pose, Sphere, Visual
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mesh_faults import fault_of
from lagdsl.exchange.robots.reach import Reach
from lagdsl.exchange.robots.xml_tree import Element
from lagdsl.foundation.meshes.triangles import MeshError

_LEFT_OUT = "the shape is left out"


def read_visuals(link: Element, reach: Reach, read: Attributes, findings: Findings) -> tuple[Visual, ...]:
    """The shapes of all `<visual>` of a link."""
    found = []
    for visual in link.all("visual"):
        geometry = read.only(visual, "geometry")
        if geometry is None or not geometry.children:
            findings.error(
                "E1005", visual.head, element="visual", what="element `<geometry>`", instead="it is left out"
            )
            continue
        with read.or_else(_LEFT_OUT) as is_wrong:
            shape = _shape(geometry.children[0], read.pose(visual), reach, read)
        if shape is not None and not is_wrong():
            found.append(shape)
    return tuple(found)


def _shape(element: Element, pose: Pose, reach: Reach, read: Attributes) -> Visual | None:
    match element.tag:
        case "box":
            size = read.vector(element, "size") if read.text(element, "size") is not None else ZERO
            return Box(pose=pose, size=size, span=element.head)
        case "cylinder":
            radius, length = (read.required(element, name, element, "cylinder") for name in ("radius", "length"))
            return Cylinder(pose=pose, radius=radius, length=length, span=element.head)
        case "sphere":
            return Sphere(pose=pose, radius=read.required(element, "radius", element, "sphere"), span=element.head)
        case "mesh":
            return _mesh(element, pose, reach, read)
        case _:
            read.leave_out(element)
            return None


def _mesh(element: Element, pose: Pose, reach: Reach, read: Attributes) -> Mesh | None:
    name = read.text(element, "filename")
    if name is None:
        return None
    scale = read.vector(element, "scale") if "scale" in element.attributes else (1.0, 1.0, 1.0)
    try:
        place = mesh_place(name, reach)
    except MeshError as fault:
        read.untaken.append(fault_of(name, element.place("filename"), fault))
        return None
    return Mesh(file=name, place=place, pose=pose, scale=scale, span=element.head)


def mesh_place(name: str, reach: Reach) -> Path:
    """The file of a mesh; raises MeshError where it cannot be taken.

    `package://NAME/rest` is `rest` in the folder of the package NAME, which is looked for around the robot's file;
    other names count from that file.
    """
    scheme, separator, rest = name.partition("://")
    if separator and scheme == "package":
        package, _, inner = unquote(rest).partition("/")
        home = _package(package, reach.folder)
        if home is None:
            raise MeshError(f"there is no folder `{package}` around the robot's file")
        return reach.found(home / inner, home)
    if separator and scheme != "file":
        raise MeshError(f"`{scheme}` is no folder of this machine")
    return reach.found(Path(unquote(rest)) if separator else reach.folder / name)


def _package(name: str, folder: Path) -> Path | None:
    """The folder of a package: one of those around `folder`, or one beside them."""
    if name in ("", ".", ".."):
        return None
    for around in (folder, *folder.parents):
        if around.name == name:
            return around
        if (around / name).is_dir():
            return (around / name).resolve()
    return None
