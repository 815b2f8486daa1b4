"""A box in each format of meshes, and a ball."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np

from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.numerics.rank import Floats

QUADS = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
"""Faces of a box, counterclockwise from outside."""


def corners(sizes: Sequence[float] = (1.0, 2.0, 3.0)) -> list[tuple[float, ...]]:
    return list(product(*((0.0, size) for size in sizes)))


def halves() -> list[tuple[int, int, int]]:
    return [half for a, b, c, d in QUADS for half in ((a, b, c), (a, c, d))]


def binary_stl(head: bytes = b"") -> bytes:
    facets = b"".join(
        bytes(12) + np.array([corners()[k] for k in half], dtype="<f4").tobytes() + bytes(2) for half in halves()
    )
    return head.ljust(80) + len(halves()).to_bytes(4, "little") + facets


def text_stl() -> bytes:
    lines = ["solid box"]
    for half in halves():
        vertices = ["vertex {:e} {:g} {:g}".format(*corners()[k]) for k in half]
        lines += ["facet normal 0 0 0", "outer loop", *vertices, "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid"]).encode()


def obj() -> bytes:
    """Quadrilaterals, the last one counted from the end."""
    points = ["v {} {} {} 1".format(*each) for each in corners()]
    faces = ["f " + " ".join(f"{k + 1}/1/{k + 1}" for k in quad) for quad in QUADS[:-1]]
    last = "f " + " ".join(str(k - 8) for k in QUADS[-1])
    return "\n".join(["# box", "vn 0 0 1", *points, "usemtl red", *faces, last]).encode()


def collada(primitive: str = "triangles", nodes: str = '<node><instance_geometry url="#g"/></node>', unit: str = "1",
            library: str = "") -> bytes:  # fmt: skip
    """Each corner of a face has a point and a normal."""
    places = " ".join(str(value) for each in corners() for value in each)
    match primitive:
        case "triangles":
            p = "<p>" + " ".join(f"{k} 0" for half in halves() for k in half) + "</p>"
        case "polylist":
            p = "<vcount>4 4 4 4 4 4</vcount><p>" + " ".join(f"{k} 0" for quad in QUADS for k in quad) + "</p>"
        case _:
            p = "".join("<p>" + " ".join(f"{k} 0" for k in quad) + "</p>" for quad in QUADS)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="{unit}"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="24">{places}</float_array>
<technique_common><accessor source="#a" count="8" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<{primitive} count="6"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="NORMAL" source="#s" offset="1"/>{p}</{primitive}>
</mesh></geometry></library_geometries>
<library_nodes>{library}</library_nodes>
<library_visual_scenes><visual_scene id="w">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene>
</COLLADA>""".encode()


def ball(count: int) -> Triangles:
    """Of radius 1, by longitude and latitude."""
    theta, phi = np.linspace(0.0, np.pi, count + 1), np.linspace(0.0, 2.0 * np.pi, 2 * count + 1)[:-1]
    points = np.array([[np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)] for a in theta for b in phi])
    across = 2 * count
    found = [
        half
        for i in range(count)
        for j in range(across)
        for a, b in [(i * across + j, i * across + (j + 1) % across)]
        for half in ((a, a + across, b + across), (a, b + across, b))
    ]
    return Triangles(points=points, corners=np.array(found))


def volume(mesh: Triangles) -> float:
    """By the divergence theorem: positive if the faces look outwards."""
    a, b, c = np.moveaxis(mesh.points[mesh.corners], 1, 0)
    return float(np.sum(a * np.cross(b, c)) / 6.0)


def area(mesh: Triangles) -> float:
    a, b, c = np.moveaxis(mesh.points[mesh.corners], 1, 0)
    return float(np.sum(np.linalg.norm(np.cross(b - a, c - a), axis=1)) / 2.0)


def middle(mesh: Triangles) -> Floats:
    """Of the solid inside."""
    a, b, c = np.moveaxis(mesh.points[mesh.corners], 1, 0)
    parts = np.sum(a * np.cross(b, c), axis=1) / 6.0
    return np.asarray(parts @ (a + b + c) / 4.0 / parts.sum())
