"""The triangles of `draw mesh`: files beside the text of the statement."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from lagdsl.derivation.scene.shapes import Shape
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.meshes.files import place_of, read_mesh
from lagdsl.foundation.meshes.triangles import MeshError, Triangles

_MOST = 6_000
_MOST_TOGETHER = 60_000


def meshes_of(shapes: Sequence[Shape], sink: Sink | None = None) -> dict[int, Triangles]:
    """The triangles of shapes, by their places among them; equal files have the same object.

    At most 6000 triangles of a file, and 60 000 of all. A shape whose file cannot be drawn has none: W0351 where its
    contents are the reason. A file that is not there has been told when its statement was checked.
    """
    files = {k: file for k, shape in enumerate(shapes) if (file := _file_of(shape)) is not None}
    most = min(_MOST, _MOST_TOGETHER // max(len(set(files.values())), 1))
    found: dict[int, Triangles] = {}
    for k, file in files.items():
        try:
            found[k] = read_mesh(file, most)
        except MeshError as fault:
            if sink is not None:
                sink.report("W0351", shapes[k].spans[0], file=shapes[k].texts["file"], reason=str(fault))
    return found


def _file_of(shape: Shape) -> Path | None:
    name = shape.texts.get("file")
    try:
        return None if shape.kind != "mesh" or name is None else place_of(name, shape.spans[0].file.folder)
    except MeshError:
        return None
