"""Files of meshes: a box has its volume and area in each format, and damaged files have words."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from choice import examples
from meshes.solids import area, ball, binary_stl, collada, middle, obj, text_stl, volume

from lagdsl.foundation.meshes.collada import read_collada
from lagdsl.foundation.meshes.files import read_mesh
from lagdsl.foundation.meshes.obj import read_obj
from lagdsl.foundation.meshes.stl import read_stl
from lagdsl.foundation.meshes.triangles import MeshError, Triangles, thinned

BOXES: list[tuple[Callable[[bytes], Triangles], bytes]] = [
    (read_stl, binary_stl()),
    (read_stl, binary_stl(b"solid of a program that writes this word into binary files")),
    (read_stl, text_stl()),
    (read_obj, obj()),
    *((read_collada, collada(primitive)) for primitive in ("triangles", "polylist", "polygons")),
]
QUARTER = "<rotate>0 0 2 90</rotate>"


@pytest.mark.parametrize(("reader", "content"), BOXES)
def test_a_box_has_its_volume_and_area(reader: Callable[[bytes], Triangles], content: bytes) -> None:
    found = reader(content)
    assert len(found.points) == 8 and len(found.corners) == 12
    assert volume(found) == pytest.approx(6.0) and area(found) == pytest.approx(22.0)
    assert middle(found) == pytest.approx([0.5, 1.0, 1.5])


@pytest.mark.parametrize(
    ("nodes", "place", "size"),
    [
        (f'<node><translate>1 0 0</translate>{QUARTER}<instance_geometry url="#g"/></node>', [0.0, 0.5, 1.5], 6.0),
        (f'<node>{QUARTER}<translate>1 0 0</translate><instance_geometry url="#g"/></node>', [-1.0, 1.5, 1.5], 6.0),
        ('<node><scale>-2 1 1</scale><instance_geometry url="#g"/></node>', [-1.0, 1.0, 1.5], 12.0),
        (
            '<node><matrix>1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1</matrix><node><instance_geometry url="#g"/></node></node>',
            [5.5, 7.0, 8.5],
            6.0,
        ),
    ],
)
def test_nodes_place_what_they_hold(nodes: str, place: list[float], size: float) -> None:
    """Transformations apply from the last one to the first; a mirrored box still looks outwards."""
    found = read_collada(collada(nodes=nodes))
    assert middle(found) == pytest.approx(place) and volume(found) == pytest.approx(size)


def test_the_unit_of_a_file_is_metres() -> None:
    assert volume(read_collada(collada(unit="0.01"))) == pytest.approx(6e-6)


def test_a_node_may_be_placed_twice() -> None:
    twice = '<node><translate>{} 0 0</translate><instance_node url="#n"/></node>'
    library = '<node id="n"><instance_geometry url="#g"/></node>'
    found = read_collada(collada(nodes=twice.format(0) + twice.format(10), library=library))
    assert volume(found) == pytest.approx(12.0) and middle(found)[0] == pytest.approx(5.5)


DOUBLED = "".join(
    f'<node id="n{k}"><instance_node url="#n{k + 1}"/><instance_node url="#n{k + 1}"/></node>' for k in range(30)
)
WRONG = [
    (".stl", b"", "it is no STL file"),
    (".stl", binary_stl()[:-1], "it is no STL file"),
    (".stl", bytes(84), "it is no STL file"),
    (".stl", b"solid box\nendsolid box", "it has no triangle"),
    (".stl", text_stl().replace(b"2", b"two"), "is no number"),
    (".stl", text_stl().replace(b"vertex", b"point", 1), "ends within a triangle"),
    (".stl", text_stl().replace(b" 3\n", b" inf\n"), "no finite number"),
    (".stl", text_stl().replace(b" 3\n", b" nan\n"), "no finite number"),
    (".stl", text_stl().replace(b" 3\n", b" 1e300\n"), "no finite number"),
    (".obj", b"f 1 2 3", "line 1"),
    (".obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4", "line 4"),
    (".obj", b"v 0 0 0\nf 0 0 0", "line 2"),
    (".obj", b"v 0 0\n", "line 1"),
    (".obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "it has no triangle"),
    (".dae", b"", "it is not valid XML"),
    (".dae", b"<COLLADA>", "it is not valid XML"),
    (".dae", b"<COLLADA/>", "it has no triangle"),
    (".dae", b'<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>', "declarations"),
    (".dae", b"<a>" * 200, "levels"),
    (".dae", collada().replace(b'source="#s"', b'source="#t"'), "points are missing"),
    (".dae", collada().replace(b"<p>0", b"<p>9"), "does not have"),
    (".dae", collada().replace(b"<p>0", b"<p>-1"), "does not have"),
    (".dae", collada().replace(b"<p>0", b"<p>x"), "another word"),
    (".dae", collada().replace(b"<p>0", b"<p>1e400"), "does not have"),
    (".dae", collada().replace(b'offset="1"', b'offset="many"'), "do not fit"),
    (".dae", collada().replace(b'stride="3"', b'stride="0"'), "wrong number of coordinates"),
    (".dae", collada("polylist").replace(b"<vcount>4", b"<vcount>9"), "other numbers"),
    (".dae", collada(unit="0"), "no length"),
    (".dae", collada(unit=""), "no length"),
    (".dae", collada(nodes="<node><matrix>1 0</matrix></node>"), "wrong number of values"),
    (".dae", collada().replace(b'version="1.0"', b'version="1.0" encoding="klingon"'), "unknown encoding"),
    (".dae", collada(nodes='<node id="n"><instance_node url="#n"/></node>'), "nodes"),
    (".dae", collada(nodes='<node><instance_node url="#n0"/></node>', library=DOUBLED), "nodes"),
]


def test_damaged_files_have_words(tmp_path: Path) -> None:
    begin = time.process_time()
    for number, (ending, content, words) in enumerate(WRONG):
        file = tmp_path / f"{number}{ending}"
        file.write_bytes(content)
        with pytest.raises(MeshError, match=words) as told:
            read_mesh(file, 100)
        assert len(str(told.value)) < 200, content[:60]
    assert time.process_time() - begin < 5.0


def test_a_file_that_changes_is_read_anew(tmp_path: Path) -> None:
    file = tmp_path / "box.stl"
    file.write_bytes(binary_stl())
    assert volume(read_mesh(file, 100)) == pytest.approx(6.0)
    file.write_bytes(text_stl().replace(b" 3\n", b" 5\n"))
    assert volume(read_mesh(file, 100)) == pytest.approx(10.0)


def test_noise_is_refused_or_drawn(tmp_path: Path) -> None:
    """A file with some bytes changed has triangles, or words: nothing else leaves the readers."""
    chance, refused = random.Random(7), 0
    whole = [(".stl", binary_stl()), (".stl", text_stl()), (".obj", obj()), (".dae", collada("polylist"))]
    for number in range(examples(4000)):
        ending, content = whole[number % 4]
        damaged = bytearray(content)
        for _ in range(chance.randint(1, 6)):
            damaged[chance.randrange(len(damaged))] = chance.choice(b'\0 -9e"<x\xff\n')
        file = tmp_path / f"{number}{ending}"
        file.write_bytes(damaged)
        try:
            found = read_mesh(file, 100)
        except MeshError:
            refused += 1
        else:
            assert np.all(np.isfinite(found.points)) and len(found.corners) > 0
    assert refused > 0


def test_a_thinned_ball_is_a_ball() -> None:
    whole = ball(100)
    few = thinned(whole, 2000)
    assert len(whole.corners) == 40_000 and 1000 < len(few.corners) <= 2000
    assert volume(few) == pytest.approx(4.0 / 3.0 * np.pi, rel=0.03)
    assert np.all(np.abs(np.linalg.norm(few.points, axis=1) - 1.0) < 0.06)
    assert thinned(few, 2000) is few
