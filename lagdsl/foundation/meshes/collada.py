"""COLLADA files (DAE): triangles and polygons of the geometries that the scene places.

Coordinates are those of the file in its unit; `up_axis` turns nothing, as in the viewers of robots. Materials,
animations and skins are left out. Elements: COLLADA 1.4.1, Khronos 2008.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from xml.etree.ElementTree import Element

import numpy as np

from lagdsl.foundation.meshes.elements import elements, numbers
from lagdsl.foundation.meshes.triangles import MOST_TRIANGLES, Integers, MeshError, Triangles, triangles
from lagdsl.foundation.numerics.rank import Floats

_MOST_PLACES, _DEEPEST = 5000, 40
_LARGEST = 2**31


def read_collada(content: bytes) -> Triangles:
    """All triangles of the scene; of a file without a scene those of all geometries."""
    root = elements(content)
    known = {element.attrib["id"]: element for element in root.iter() if "id" in element.attrib}
    scenes = [known.get(_target(each)) for each in root.iter("instance_visual_scene")]
    tops = [node for scene in scenes if scene is not None for node in scene.findall("node")]
    if not tops:
        placed = [(geometry, np.eye(4)) for geometry in root.iter("geometry")]
    else:
        walk = _Walk(known)
        placed = [found for node in tops for found in walk.placed(node, np.eye(4), 0)]
    points, corners, count = [np.zeros((0, 3))], [np.zeros((0, 3), dtype=np.int64)], 0
    shapes: dict[int, Triangles | None] = {}
    for geometry, matrix in placed:
        if id(geometry) not in shapes:
            shapes[id(geometry)] = _geometry(geometry, known)
        own = shapes[id(geometry)]
        if own is None:
            continue
        points.append(own.points @ matrix[:3, :3].T + matrix[:3, 3])
        turned = own.corners[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0 else own.corners
        corners.append(turned + count)
        count += len(own.points)
        if sum(map(len, corners)) > MOST_TRIANGLES:
            break
    return triangles(_unit(root) * np.concatenate(points), np.concatenate(corners))


def _unit(root: Element) -> float:
    """Metres of the unit of the file."""
    asset = root.find("asset")
    unit = asset.find("unit") if asset is not None else None
    if unit is None or "meter" not in unit.attrib:
        return 1.0
    size = numbers(unit.attrib["meter"])
    if len(size) != 1 or not 0.0 < size[0] < math.inf:
        raise MeshError("its unit has no length")
    return float(size[0])


def _target(element: Element) -> str:
    """The id of `url="#id"`, `source="#id"`."""
    return element.attrib.get("url", element.attrib.get("source", "")).partition("#")[2]


class _Walk:
    """Nodes of a scene and what they place; the number of places is bounded, since nodes may be placed again."""

    def __init__(self, known: dict[str, Element]) -> None:
        self.known = known
        self.count = 0

    def placed(self, node: Element, before: Floats, depth: int) -> Iterator[tuple[Element, Floats]]:
        self.count += 1
        if depth > _DEEPEST or self.count > _MOST_PLACES:
            raise MeshError(f"it has more than {_MOST_PLACES} nodes, or more than {_DEEPEST} in a row")
        matrix = before
        for child in node:
            match child.tag:
                case "matrix" | "translate" | "rotate" | "scale":
                    matrix = matrix @ _transformation(child)
                case "instance_geometry":
                    geometry = self.known.get(_target(child))
                    if geometry is not None:
                        yield geometry, matrix
                case "instance_node":
                    inner = self.known.get(_target(child))
                    if inner is not None:
                        yield from self.placed(inner, matrix, depth + 1)
                case "node":
                    yield from self.placed(child, matrix, depth + 1)
                case _:
                    pass


def _transformation(element: Element) -> Floats:
    values = numbers(element.text)
    if len(values) != {"matrix": 16, "rotate": 4}.get(element.tag, 3):
        raise MeshError(f"a `<{element.tag}>` has a wrong number of values")
    made = np.eye(4)
    match element.tag:
        case "matrix":
            made = values.reshape(4, 4)
        case "translate":
            made[:3, 3] = values
        case "scale":
            made[:3, :3] = np.diag(values)
        case _:  # Rodrigues' formula
            size = float(np.linalg.norm(values[:3]))
            if size > 0.0:
                x, y, z = values[:3] / size
                cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
                angle = math.radians(values[3])
                made[:3, :3] += math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross)
    return made


def _geometry(geometry: Element, known: dict[str, Element]) -> Triangles | None:
    """The triangles of a geometry in its own coordinates; None if it has none."""
    mesh = geometry.find("mesh")
    points: list[Floats] = []
    corners: list[Integers] = []
    count = 0
    for primitive in mesh if mesh is not None else ():
        if primitive.tag not in ("triangles", "polylist", "polygons"):
            continue
        inputs = [(int(i.attrib.get("offset", "0")), i) for i in primitive.findall("input")]
        vertex = next(((offset, i) for offset, i in inputs if i.attrib.get("semantic") == "VERTEX"), None)
        if vertex is None:
            raise MeshError(f"a `<{primitive.tag}>` has no vertices")
        own = _positions(vertex[1], known)
        stride = max(offset for offset, _ in inputs) + 1
        corners += [part + count for part in _corners(primitive, vertex[0], stride)]
        points.append(own)
        count += len(own)
    if not corners:
        return None
    return Triangles(points=np.concatenate(points), corners=np.concatenate(corners))


def _positions(vertex: Element, known: dict[str, Element]) -> Floats:
    """The points (n, 3) that an input with the semantic VERTEX leads to."""
    vertices = known.get(_target(vertex))
    inputs = vertices.findall("input") if vertices is not None else []
    source = next((known.get(_target(i)) for i in inputs if i.attrib.get("semantic") == "POSITION"), None)
    array = source.find("float_array") if source is not None else None
    if source is None or array is None:
        raise MeshError("its points are missing")
    values = numbers(array.text)
    accessor = next(iter(source.iter("accessor")), None)
    stride = int(accessor.attrib.get("stride", "3")) if accessor is not None else 3
    if not 3 <= stride <= 16 or len(values) % stride:
        raise MeshError("its points have a wrong number of coordinates")
    return values.reshape(-1, stride)[:, :3]


def _corners(primitive: Element, offset: int, stride: int) -> Iterator[Integers]:
    """Triangles of the indices of points; polygons become fans about their first point."""
    lists = [_whole(p.text) for p in primitive.findall("p")]
    if any(len(each) % stride for each in lists):
        raise MeshError(f"a `<{primitive.tag}>` ends within a point")
    vcount = primitive.find("vcount")
    for each in lists:
        index = each.reshape(-1, stride)[:, offset]
        if primitive.tag == "polylist":
            sizes = _whole(vcount.text) if vcount is not None else np.zeros(0, dtype=np.int64)
        elif primitive.tag == "polygons":
            sizes = np.array([len(index)])
        else:
            sizes = np.full(len(index) // 3, 3)
        if np.any((sizes < 0) | (sizes > len(index))) or sizes.sum() != len(index):
            raise MeshError(f"the polygons of a `<{primitive.tag}>` have other numbers of points than it tells")
        yield _fans(index, sizes)


def _whole(text: str | None) -> Integers:
    values = numbers(text)
    if not np.all(np.abs(values) < _LARGEST):
        raise MeshError("a triangle has a point that the file does not have")
    return values.astype(np.int64)


def _fans(index: Integers, sizes: Integers) -> Integers:
    count = np.maximum(sizes - 2, 0)
    first = np.repeat(np.cumsum(sizes) - sizes, count)
    step = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.stack([index[first], index[first + step + 1], index[first + step + 2]], axis=1)
