"""Triangles of meshes as a page carries them: places on a grid of 65 535 steps, in the box of each file."""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from functools import cache

import numpy as np

from lagdsl.derivation.scene.forms import triangles
from lagdsl.derivation.scene.shapes import Shape
from lagdsl.documents.page.digits import digits
from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.record import record

_STEPS = 65_535
_MOST_NAMED = 5


@record(kw_only=True)
class PackedMesh:
    """`data`: three steps for each of `points`, then three points for each of `triangles`, as 16 bits little endian,
    deflated, as digits of base 85. A coordinate is `low` plus `step` times its steps, in units of the file."""

    points: int
    triangles: int
    low: tuple[float, ...]
    step: tuple[float, ...]
    data: str


def packed_meshes(
    shapes: Sequence[Shape], found: Mapping[int, Triangles]
) -> tuple[list[PackedMesh], dict[int, int], str]:
    """Meshes, `found` by the numbers of shapes, each once; the number of the mesh by that of the shape; what there is
    to say of those not drawn."""
    numbers: dict[int, int] = {}
    different: dict[int, int] = {}
    for k, mesh in found.items():
        numbers[k] = different.setdefault(id(mesh), len(different))
    unique = {id(mesh): mesh for mesh in found.values()}
    left = [dict(s.texts).get("file", "") for k, s in enumerate(shapes) if s.kind == "mesh" and k not in found]
    return [packed(unique[key]) for key in different], numbers, _words(left)


@cache
def packed_form(name: str, around: int) -> PackedMesh:
    """Triangles of a unit body, `around` of them around a round one."""
    return packed(triangles(name, around))


def packed(mesh: Triangles) -> PackedMesh:
    low, size = mesh.points.min(axis=0), np.ptp(mesh.points, axis=0)
    step = np.where(size > 0.0, size / _STEPS, 1.0)
    places = np.rint((mesh.points - low) / step).astype("<u2")
    data = places.tobytes() + mesh.corners.astype("<u2").tobytes()
    return PackedMesh(
        points=len(mesh.points),
        triangles=len(mesh.corners),
        low=tuple(float(f"{x:.12g}") for x in low),
        step=tuple(float(f"{x:.12g}") for x in step),
        data=digits(zlib.compress(data, 9)),
    )


def _words(files: Sequence[str]) -> str:
    if not files:
        return ""
    names = ", ".join(dict.fromkeys(files[:_MOST_NAMED])) + (", and others" if len(files) > _MOST_NAMED else "")
    return f"Not drawn, for want of a file with a mesh: {names}."
