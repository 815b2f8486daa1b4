"""Files that an MJCF file names: each is judged before MuJoCo opens it, in the folder that MuJoCo looks into for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mesh_faults import MeshFault, fault_of, tell_faults
from lagdsl.exchange.robots.reach import Reach
from lagdsl.exchange.robots.xml_tree import Element, read_xml
from lagdsl.foundation.meshes.triangles import MeshError
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span

_MAX_FILES = 100
_READ = {"include": "included file", "model": "included model"}  # texts that MuJoCo reads with the file
_PICTURES = ("fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")


def all_elements(path: Path, root: Element, reach: Reach, findings: Findings) -> list[Element] | None:
    """The elements of a file and of those that it includes, which become children of `<include>`; every file that
    MuJoCo reads with it is checked before. MuJoCo counts names of included files from the folder of the first file.

    E1013 for a name that leads out of the folders of the robot; None after errors of an included file.
    """
    waiting, found, files = [root], [], 1
    faults: list[MeshFault] = []
    while waiting:
        element = waiting.pop()
        found.append(element)
        name = element.attributes.get("file")
        place = _judged(element, name, reach, faults) if name is not None and element.tag in _READ else None
        if place is not None:
            files += 1
            inner = read_xml(place, findings.sink) if files <= _MAX_FILES else None
            if inner is None:
                if files > _MAX_FILES:
                    findings.error("E1002", element.head, what="this robot", limit=_MAX_FILES, unit="files")
                return None
            if element.tag == "include":
                element.children.append(inner)
            else:
                waiting.append(inner)
        waiting += reversed(element.children)
    faults += _flexible(found, reach)
    tell_faults(faults, findings, None)
    return found


def _judged(element: Element, name: str, reach: Reach, faults: list[MeshFault]) -> Path | None:
    try:
        return reach.found(reach.folder / name)
    except MeshError as fault:
        faults.append(fault_of(name, element.place("file"), fault, _READ[element.tag]))
        return None


def _flexible(elements: list[Element], reach: Reach) -> Iterator[MeshFault]:
    """Meshes of flexible bodies, which MuJoCo opens while it reads the text."""
    compilers = [element.attributes for element in elements if element.tag == "compiler"]
    folders = [each[name] for each in compilers for name in ("meshdir", "assetdir") if name in each]
    for element in elements:
        name = element.attributes.get("file")
        if element.tag == "flexcomp" and name is not None:
            try:
                for folder in folders or [""]:
                    reach.inside(reach.folder / folder / name)
            except MeshError as fault:
                yield fault_of(name, element.place("file"), fault, "flexible mesh")


@record()
class _Asset:
    """A file that MuJoCo opens when it compiles: `owner` is what has it in the specification."""

    owner: Any
    kind: str
    file: str
    place: Path
    span: Span


def take_assets(spec: Any, elements: list[Element], reach: Reach, findings: Findings) -> None:
    """Judge meshes, fields of heights, skins and pictures of a specification of MuJoCo.

    E1013 for those that are missing or lead out of the folders of the robot. A lenient import leaves them out, with the
    shapes that they give, unless a body has its mass from such a shape.
    """
    lost, weighing = list[MeshFault](), list[MeshFault]()
    for asset in _assets(spec, elements, reach):
        try:
            reach.found(asset.place)
        except MeshError as fault:
            told = fault_of(asset.file, asset.span, fault, asset.kind)
            shapes = _shapes(spec, asset)
            if any(_weighs(spec, shape) for shape in shapes):
                weighing.append(replace(told, reason=f"{told.reason}, and it gives a body its mass"))
                continue
            lost.append(told)
            if findings.lenient:
                _leave_out(spec, asset, shapes)
    tell_faults(weighing, findings, None)
    tell_faults(lost, findings, "it is left out")


def mesh_files(spec: Any, reach: Reach) -> dict[str, tuple[str, Path]]:
    """The file of each mesh by the name of the mesh: as the robot's file names it, and its place."""
    return {mesh.name: (mesh.file, _place(spec, reach, spec.meshdir, mesh.file)) for mesh in spec.meshes if mesh.file}


def _assets(spec: Any, elements: list[Element], reach: Reach) -> Iterator[_Asset]:
    places: dict[tuple[str, str], Span] = {}
    for element in elements:
        for name in ("file", *_PICTURES):
            if name in element.attributes:
                places.setdefault((element.tag, element.attributes[name]), element.place(name))
    groups: tuple[tuple[str, str, str, Iterable[Any]], ...] = (
        ("mesh", "mesh", spec.meshdir, spec.meshes),
        ("hfield", "field of heights", spec.meshdir, spec.hfields),
        ("skin", "skin", spec.meshdir, spec.skins),
        ("texture", "texture", spec.texturedir, spec.textures),
    )
    root = elements[0].head
    for tag, kind, folder, owners in groups:
        for owner in list(owners):
            for file in (owner.file, *(owner.cubefiles if tag == "texture" else ())):
                if file:
                    place = _place(spec, reach, folder, file)
                    yield _Asset(owner, kind, file, place, places.get((tag, file), root))


def _place(spec: Any, reach: Reach, folder: str, file: str) -> Path:
    return reach.folder / folder / (Path(file).name if spec.strippath else file)


def _shapes(spec: Any, asset: _Asset) -> list[Any]:
    match asset.kind:
        case "mesh":
            return [geom for geom in spec.geoms if geom.meshname == asset.owner.name]
        case "field of heights":
            return [geom for geom in spec.geoms if geom.hfieldname == asset.owner.name]
        case _:
            return []


def _weighs(spec: Any, shape: Any) -> bool:
    """True if the body of a shape has its mass from it."""
    body, compiler = shape.parent, spec.compiler
    if body.name == "world" or shape.mass == 0.0 or not shape.meshname:
        return False
    low, high = compiler.inertiagrouprange
    if not low <= shape.group <= high or compiler.inertiafromgeom.name.endswith("FALSE"):
        return False
    return not body.explicitinertial or bool(compiler.inertiafromgeom.name.endswith("TRUE"))


def _leave_out(spec: Any, asset: _Asset, shapes: list[Any]) -> None:
    for shape in shapes:
        spec.delete(shape)
    if asset.kind == "texture":
        for material in spec.materials:
            material.textures = ["" if name == asset.owner.name else name for name in material.textures]
    spec.delete(asset.owner)
