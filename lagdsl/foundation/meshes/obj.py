"""OBJ files: lines `v x y z` and `f a b c ...`; everything else has no part in the shape."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.meshes.triangles import MeshError, Triangles, triangles


def read_obj(content: bytes) -> Triangles:
    """Polygons become fans about their first point. Indices count from 1, negative ones back from the line."""
    points: list[tuple[float, float, float]] = []
    corners: list[tuple[int, int, int]] = []
    for number, line in enumerate(content.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").split(b"\n"), 1):
        words = line.split()
        try:
            if words and words[0] == b"v":
                points.append((float(words[1]), float(words[2]), float(words[3])))
            elif words and words[0] == b"f":
                polygon = [_place(word, len(points)) for word in words[1:]]
                corners += [(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, len(polygon) - 1)]
        except (ValueError, IndexError):
            raise MeshError(f"its line {number} is no line of an OBJ file") from None
    return triangles(np.array(points).reshape(-1, 3), np.array(corners, dtype=np.int64).reshape(-1, 3))


def _place(word: bytes, count: int) -> int:
    index = int(word.partition(b"/")[0])
    place = index - 1 if index > 0 else count + index
    if index == 0 or not 0 <= place < count:
        raise ValueError(index)
    return place
