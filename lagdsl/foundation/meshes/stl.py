"""STL files, binary and ASCII: three points for each triangle; normals follow from their order."""

from __future__ import annotations

import re

import numpy as np

from lagdsl.foundation.meshes.triangles import MeshError, Triangles, triangles
from lagdsl.foundation.numerics.rank import Floats

_HEAD, _FACET = 84, 50
_VERTEX = re.compile(rb"\bvertex\s+(\S+)\s+(\S+)\s+(\S+)", re.IGNORECASE)


def read_stl(content: bytes) -> Triangles:
    """A binary file tells the number of its triangles, which its length confirms, whatever it begins with."""
    count = int.from_bytes(content[80:_HEAD], "little") if len(content) >= _HEAD else 0
    if count and len(content) >= _HEAD + _FACET * count and not _is_text(content):
        facets = np.frombuffer(content[_HEAD : _HEAD + _FACET * count], dtype=np.uint8).reshape(count, _FACET)
        points = np.ascontiguousarray(facets[:, 12:48]).view("<f4").reshape(-1, 3).astype(np.float64)
    elif content.lstrip()[:5].lower() == b"solid":
        points = _points(content)
    else:
        raise MeshError("it is no STL file, or ends early")
    return triangles(points, np.arange(len(points)).reshape(-1, 3))


def _is_text(content: bytes) -> bool:
    return content.lstrip()[:5].lower() == b"solid" and b"facet" in content[:1000] and b"\0" not in content[:1000]


def _points(content: bytes) -> Floats:
    try:
        found = np.array([[float(text) for text in vertex] for vertex in _VERTEX.findall(content)])
    except ValueError:
        raise MeshError("a coordinate of a point is no number") from None
    if len(found) % 3:
        raise MeshError("it ends within a triangle")
    return found.reshape(-1, 3)
