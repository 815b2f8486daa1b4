"""Meshes on the page: their triangles lie in it, on their grid; those without a file are told."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import spread
from meshes.solids import binary_stl, collada
from page.pages import Elements, inflated

import lagdsl
from lagdsl.derivation.scene.drawings import meshes_of
from lagdsl.derivation.scene.living import scene_of
from lagdsl.derivation.scene.stage import stage_of
from lagdsl.documents.plot.picture.shapes import GAUGES, Faces, parts_of
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.pipeline import flatten_file, read

MODEL = """model Arm
  import Lag.Spatial.*;
  Revolute joint(axis = {{0, 1, 0}});
  Body link(m = 1 kg, com = {{0.5, 0, 0}}, I = {{0.1, 0.1, 0.1}});
  connect(world, joint, link);
  gravity = -g_n*world.z;
  {}
end Arm;
"""


def model(folder: Path, *drawings: str) -> lagdsl.Model:
    (folder / "box.stl").write_bytes(binary_stl())
    (folder / "box.dae").write_bytes(collada())
    file = folder / "arm.lag"
    file.write_text(MODEL.format("\n  ".join(drawings)))
    return lagdsl.compile(file, engine="tape")


def head(folder: Path, *drawings: str) -> dict[str, Any]:
    page = model(folder, *drawings).show(folder / "page.html", browser=False)
    return Elements(page.read_text(encoding="utf-8")).head


def unpacked(mesh: dict[str, Any]) -> tuple[Floats, list[tuple[int, ...]]]:
    numbers = np.frombuffer(inflated(mesh["data"]), dtype="<u2").reshape(-1, 3)
    points = np.array(mesh["low"]) + np.array(mesh["step"]) * numbers[: mesh["points"]]
    return points, [tuple(row) for row in numbers[mesh["points"] :].tolist()]


def test_a_page_carries_each_file_once(tmp_path: Path) -> None:
    found = head(
        tmp_path,
        'draw mesh(file = "box.stl", scale = 1 mm) on link.frame_a;',
        'draw mesh(file = "./box.stl") on world;',
        'draw mesh(file = "box.dae") on world.move({1 m, 0, 0});',
    )
    shown = [shape for shape in found["scene"]["shapes"] if shape["kind"] == "mesh"]
    assert [shape["mesh"] for shape in shown] == [0, 0, 1] and found["said"] == ""
    for mesh in found["meshes"]:
        points, triangles = unpacked(mesh)
        assert sorted(map(tuple, points.round(9).tolist())) == [
            (a, b, c) for a in (0, 1) for b in (0, 2) for c in (0, 3)
        ]
        a, b, c = np.moveaxis(points[np.array(triangles)], 1, 0)
        assert np.sum(a * np.cross(b, c)) / 6.0 == pytest.approx(6.0)


def test_links_with_meshes_have_no_symbols_in_them(tmp_path: Path) -> None:
    def kinds(*drawings: str) -> list[str]:
        return [shape["kind"] for shape in head(tmp_path, *drawings)["scene"]["shapes"] if shape["kind"] != "frame"]

    assert kinds('draw mesh(file = "box.stl") on link.frame_a;') == ["mesh"]
    assert kinds() == ["cylinder", "rope", "body", "support"]


@pytest.mark.parametrize(
    ("name", "reason"),
    spread(
        [
            ("none.stl", "has no such file"),
            ("../box.stl", "lies outside of the folder"),
            ("box.png", "files of meshes end in .stl, .obj, .dae"),
            ("link.stl", "lies outside of the folder"),
            ("x" * 5000 + ".stl", "no such file"),
            ("</script><b>.stl", "has no such file"),
            ("pipe.stl", "has no such file"),
        ],
        4,
    ),
)
def test_a_file_that_cannot_be_drawn_is_told(name: str, reason: str, tmp_path: Path) -> None:
    folder = tmp_path / "model"
    folder.mkdir()
    (tmp_path / "box.stl").write_bytes(binary_stl())
    (folder / "link.stl").symlink_to(tmp_path / "box.stl")
    os.mkfifo(folder / "pipe.stl")
    file = folder / "arm.lag"
    file.write_text(MODEL.format(f'draw mesh(file = "{name}") on link.frame_a;'))
    sink = Sink()
    text = read(file, sink)
    assert text is not None
    flat = flatten_file(text, sink)
    ((code, message),) = [(each.code, each.message) for each in sink.diagnostics]
    assert code == "W0351" and reason in message and flat is not None
    found = head(folder, f'draw mesh(file = "{name}") on link.frame_a;')
    assert found["meshes"] == [] and found["said"].startswith("Not drawn, for want of a file with a mesh: ")


def test_a_broken_file_is_told_where_its_picture_is_made(tmp_path: Path) -> None:
    made = model(tmp_path, 'draw mesh(file = "box.stl") on link.frame_a;')
    (tmp_path / "box.stl").write_bytes(b"no mesh at all")
    sink = Sink()
    assert meshes_of(scene_of(made._compilation.flat).shapes, sink) == {}
    assert [(each.code, "it is no STL file" in each.message) for each in sink.diagnostics] == [("W0351", True)]


@pytest.mark.parametrize(("scale", "sizes"), [("2 m", (2, 2, 2)), ("{1 m, -1 m, 2 m}", (1, -1, 2)), ("", (1, 1, 1))])
def test_pictures_have_the_corners_in_place(scale: str, sizes: tuple[float, ...], tmp_path: Path) -> None:
    """On a frame at (10, 0, 0), turned by 90 degrees about z; a mirrored box still looks outwards."""
    given = f", scale = {scale}" if scale else ""
    drawing = f'draw mesh(file = "box.stl"{given}) on world.move({{10 m, 0, 0}}).rotz(90 deg);'
    flat = model(tmp_path, drawing)._compilation.flat
    scene = scene_of(flat)
    row = np.zeros((1, len(scene.columns)))
    (shape,) = [each for each in scene.shapes if each.kind == "mesh"]
    [part] = shape.parts
    placed = {"at": (10, 0, 0), "x": (0, 1, 0), "z": (0, 0, 1)}
    for role, values in placed.items():
        row[0, scene.places[part.numbers[role]]] = values
    for size, given_size in zip(part.sizes, sizes, strict=True):
        if size.value is not None:
            row[0, scene.first(size.value)] = given_size
    painted = parts_of(stage_of(scene, row, (0, 0, 1)), 0, without=GAUGES)
    (faces,) = [each for each in painted if isinstance(each, Faces)]
    a, b, c, d = np.moveaxis(faces.corners, 1, 0)
    assert np.sum(a * (np.cross(b, c) + np.cross(c, d))) / 6.0 == pytest.approx(6.0 * abs(np.prod(sizes)))
    box = np.array([faces.corners.min(axis=(0, 1)), faces.corners.max(axis=(0, 1))])
    ends = np.array([[10.0, 0.0, 0.0], [10.0 - 2.0 * sizes[1], 1.0 * sizes[0], 3.0 * sizes[2]]])
    assert box == pytest.approx(np.sort(ends, axis=0))


def test_heads_of_models_without_meshes_have_none(tmp_path: Path) -> None:
    assert json.dumps(head(tmp_path)["meshes"]) == "[]"
