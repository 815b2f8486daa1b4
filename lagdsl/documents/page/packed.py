"""Data as text of a page, the counterpart of web/src/packed.ts. Triangles of meshes, that of web/src/meshes.ts: places
on a grid of 65 535 steps, in the box of each file."""

from __future__ import annotations

import zlib
from base64 import b85encode
from collections.abc import Mapping, Sequence
from functools import cache

import numpy as np

from lagdsl.derivation.scene.forms import triangles
from lagdsl.derivation.scene.shapes import Shape
from lagdsl.foundation.meshes.triangles import Triangles
from lagdsl.foundation.record import record

_STEPS = 65_535
_MOST_NAMED = 5


def digits(data: bytes) -> str:
    """Five digits of base 85 (RFC 1924) for four bytes, with `,` for `<`: no digits are markup."""
    return b85encode(data).decode().replace("<", ",")


def deflated(data: bytes) -> str:
    return digits(zlib.compress(data, 9))


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
    unique = {id(mesh): mesh for mesh in found.values()}
    places = {key: place for place, key in enumerate(unique)}
    left = [s.texts.get("file", "") for k, s in enumerate(shapes) if s.kind == "mesh" and k not in found]
    return [packed(mesh) for mesh in unique.values()], {k: places[id(mesh)] for k, mesh in found.items()}, _words(left)


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
        data=deflated(data),
    )


def _words(files: Sequence[str]) -> str:
    names = ", ".join(dict.fromkeys(files[:_MOST_NAMED])) + (", and others" if len(files) > _MOST_NAMED else "")
    return f"Not drawn, for want of a file with a mesh: {names}." if files else ""
