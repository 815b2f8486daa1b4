"""Visible shapes of links: primitives, and files of meshes, which must exist in the folder of the robot."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from urllib.parse import unquote

from lagdsl.meshes.files import in_folder, package_of
from lagdsl.meshes.triangles import MeshError
from lagdsl.robots.attributes import Attributes
from lagdsl.robots.description import Box, Cylinder, Mesh, Pose, Sphere, Visual
from lagdsl.robots.findings import Findings
from lagdsl.robots.mesh_faults import MeshFault
from lagdsl.robots.xml_tree import Element

_KNOWN = frozenset({"origin", "geometry", "material"})


def read_visuals(link: Element, path: Path, read: Attributes, findings: Findings) -> tuple[Visual, ...]:
    """The shapes of all `<visual>` of a link."""
    found = []
    for visual in link.all("visual"):
        read.leave_out_others(visual, _KNOWN)
        geometry = read.only(visual, "geometry")
        if geometry is None or not geometry.children:
            findings.error(
                "E1005", visual.head, element="visual", what="element `<geometry>`", instead="it is left out"
            )
            continue
        shape = _shape(geometry.children[0], read.pose(visual), path, read)
        if shape is not None:
            found.append(shape)
    return tuple(found)


def _shape(element: Element, pose: Pose, path: Path, read: Attributes) -> Visual | None:
    match element.tag:
        case "box":
            return Box(pose=pose, size=read.vector(element, "size"), span=element.head)
        case "cylinder":
            radius, length = (read.required(element, name, element, "cylinder") for name in ("radius", "length"))
            return Cylinder(pose=pose, radius=radius, length=length, span=element.head)
        case "sphere":
            return Sphere(pose=pose, radius=read.required(element, "radius", element, "sphere"), span=element.head)
        case "mesh":
            return _mesh(element, pose, path, read)
        case _:
            read.leave_out(element)
            return None


def _mesh(element: Element, pose: Pose, path: Path, read: Attributes) -> Mesh | None:
    name = read.text(element, "filename")
    if name is None:
        return None
    scale = read.vector(element, "scale") if "scale" in element.attributes else (1.0, 1.0, 1.0)
    try:
        place = mesh_place(name, path)
    except MeshError as fault:
        read.untaken.append(MeshFault(name, element.place("filename"), str(fault)))
        return None
    return Mesh(file=name, place=place, pose=pose, scale=scale, span=element.head)


def mesh_place(name: str, path: Path) -> Path:
    """The file of a mesh; raises MeshError where it cannot be taken.

    `package://NAME/rest` is `rest` in the folder of the package NAME, which is looked for around the robot's file;
    other names count from that file. A mesh lies in the package of the robot: a name never leads out of it.
    """
    folder = path.resolve().parent
    scheme, separator, rest = name.partition("://")
    if separator and scheme == "package":
        package, _, inner = unquote(rest).partition("/")
        home = _package(package, folder)
        if home is None:
            raise MeshError(f"there is no folder `{package}` around the robot's file")
        return in_folder(home / inner, home)
    if separator and scheme != "file":
        raise MeshError(f"`{scheme}` is no folder of this machine")
    return in_folder(Path(unquote(rest)) if separator else folder / name, package_of(folder))


def leads_out(name: str, path: Path, folders: Sequence[str]) -> bool:
    """True if a name, behind one of the folders that a file gives, leads out of the folder of the robot."""
    home = path.resolve().parent
    root = package_of(home)
    try:
        return any(not (home / folder / name).resolve().is_relative_to(root) for folder in folders)
    except (OSError, ValueError, RuntimeError):
        return True


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
