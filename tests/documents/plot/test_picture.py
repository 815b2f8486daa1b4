"""Machines as pictures and films: what stands where, in which color, the same bytes each time."""

from __future__ import annotations

import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from choice import chosen, repeats
from PIL import Image

from lagdsl.derivation.scene.forms import FORMS, form
from lagdsl.derivation.scene.stage import Stage
from lagdsl.documents.plot.picture.draw import draw, prepared
from lagdsl.documents.plot.picture.film import write_film, write_picture
from lagdsl.documents.plot.picture.recording import prepare, recorded, staged
from lagdsl.documents.plot.picture.shapes import Faces, parts_of
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read

MODELS = Path(__file__).parents[3] / "models"
EVERY = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))
# A pendulum, a contact, a loop, rolling in space, springs and dampers, gauges, drawings of the model.
SOME = ("bouncing_ball", "rolling_coin", "library/forces_spring_damper")
GRID = 3  # colors of a picture in which nothing stands


def flat_of(name: str) -> FlatModel:
    sink = Sink()
    file = read(MODELS / f"{name}.lag", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    return flat


@cache
def stage(name: str) -> Stage:
    flat = flat_of(name)
    made = recorded(prepare(flat), Wishes(), 41)
    return staged(flat, made.scene, [made.motion])


def pieces(own: Stage, row: int, name: str) -> list[Faces]:
    """The parts of a picture with the form of this name."""
    return [p for p in parts_of(own, row) if isinstance(p, Faces) and len(p.corners) == len(form(name))]


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_every_machine_has_a_picture_that_holds_all_of_it(name: str) -> None:
    try:
        own = stage(name)
    except CompilationFailed:
        pytest.skip("the model has no motion without inputs")
    picture = prepared(own)
    for row in (0, len(own.rows) - 1):
        draw(picture, row)
        picture.figure.canvas.draw()
        pixels = np.asarray(picture.figure.canvas.buffer_rgba())[..., :3].reshape(-1, 3)  # type: ignore[attr-defined]
        drawn = any(shape.kind != "frame" for shape in own.scene.shapes)
        assert (len(np.unique(pixels, axis=0)) > GRID) == drawn
        for part in parts_of(own, row, without=("ground", "rail", "track", "trace")):
            if isinstance(part, Faces):
                places = picture.view.seen(part.corners)[0]
                assert np.all(places >= picture.view.low) and np.all(places <= picture.view.high)


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_every_shape_of_the_models_has_parts(name: str) -> None:
    try:
        scene = stage(name).scene
    except CompilationFailed:
        pytest.skip("the model has no motion without inputs")
    assert all(shape.parts or shape.kind in ("slider", "dial") for shape in scene.shapes)


def test_bodies_with_the_moment_of_a_bar_are_bars() -> None:
    """Closed form: the links of a four-bar, I = m l^2/12, from pin to pin by the law of cosines."""
    own = stage("four_bar_crank")
    pin = np.array([0.2, 0.2 * np.sqrt(3.0)])
    s = np.linalg.norm(pin - [1.0, 0.0])
    coupler = np.arctan2(-pin[1], 1.0 - pin[0]) + np.arccos((1.0 + s * s - 0.64) / (2.0 * s))
    other = np.add(pin, (np.cos(coupler), np.sin(coupler)))
    links = (((0.0, 0.0), pin), (pin, other), ((1.0, 0.0), other))
    bars = pieces(own, 0, "beam")
    for (start, end), bar in zip(links, bars, strict=True):
        along = np.subtract(end, start) / np.linalg.norm(np.subtract(end, start))
        reached = (bar.corners.reshape(-1, 3)[:, :2] - start) @ along
        length = float(np.linalg.norm(np.subtract(end, start)))
        assert (reached.min(), reached.max()) == pytest.approx((0.0, length), abs=0.02 * length)


def test_masses_stand_where_they_are() -> None:
    """Closed form: two pendulums of 0.5 m and 0.3 m, seen square on."""
    own = stage("double_pendulum")
    view = prepared(own).view
    balls = pieces(own, 0, "octants")[::2]
    a, b = np.deg2rad(30.0), np.deg2rad(-20.0)
    first = np.array([0.5 * np.sin(a), -0.5 * np.cos(a), 0.0])
    second = first + np.array([0.3 * np.sin(b), -0.3 * np.cos(b), 0.0])
    for ball, place in zip(balls, (first, second), strict=True):
        assert np.abs(ball.corners.mean(axis=(0, 1)) - place).max() < 1e-9
        seen = view.seen(place)[0] + own.center[:2]
        assert np.abs(seen - place[:2]).max() < 1e-12


@pytest.mark.parametrize("name", [*sorted(FORMS - {"octants"}), "gear of 12", "gear of -12"])
def test_faces_of_solids_look_outwards_and_close_them(name: str) -> None:
    """The divergence theorem: the flux of the place through the faces is three volumes; of a constant it is zero."""
    unit = form(name)
    first = np.cross(unit[:, 1] - unit[:, 0], unit[:, 2] - unit[:, 0]) / 2.0
    second = np.cross(unit[:, 2] - unit[:, 0], unit[:, 3] - unit[:, 0]) / 2.0
    assert np.abs((first + second).sum(axis=0)).max() < 1e-12
    flux = np.sum(first * unit[:, [0, 1, 2]].mean(axis=1)) + np.sum(second * unit[:, [0, 2, 3]].mean(axis=1))
    assert flux > 0.0


def test_two_images_of_octants_are_a_ball() -> None:
    """The divergence theorem for both together: three volumes of a ball, a little less for its flat faces."""
    light = form("octants")
    unit = np.concatenate([light, light[:, ::-1] * [-1.0, 1.0, 1.0]])
    normals = np.cross(unit[:, 2] - unit[:, 0], unit[:, 3] - unit[:, 1]) / 2.0
    assert np.sum(normals * unit.mean(axis=1)) == pytest.approx(4.0 * np.pi, rel=0.05)


@pytest.mark.parametrize("suffix", chosen(["gif", "svg"], ["svg"]))
def test_pictures_and_films_have_the_same_bytes_under_any_hash_seed(suffix: str, tmp_path: Path) -> None:
    """Pictures of a film are drawn as those that stand alone."""
    code = (
        "import sys; from lagdsl.documents.plot.picture.film import write_film, write_picture;"
        "from plot.test_picture import *;"
        "s = Sink(); f = flatten_file(read(MODELS / 'clutch.lag', s), s);"
        "(write_film if sys.argv[1].endswith('gif') else write_picture)(f, Wishes(stop=0.5), sys.argv[1])"
    )
    paths = os.pathsep.join([str(Path(__file__).parents[1]), *sys.path])
    environment = {**os.environ, "PYTHONHASHSEED": "1", "PYTHONPATH": paths}
    subprocess.run([sys.executable, "-c", code, str(tmp_path / f"1.{suffix}")], env=environment, check=True)
    write = write_film if suffix == "gif" else write_picture  # by this process, which drew its seed
    write(flat_of("clutch"), Wishes(stop=0.5), str(tmp_path / f"2.{suffix}"))
    assert (tmp_path / f"1.{suffix}").read_bytes() == (tmp_path / f"2.{suffix}").read_bytes()
    if suffix == "gif":
        with Image.open(tmp_path / "1.gif") as film:
            assert film.n_frames == 49 and film.info["loop"] == 0  # type: ignore[attr-defined]  # three seconds for a half
        assert (tmp_path / "1.gif").stat().st_size < 1e6


@repeats("test_every_machine_has_a_picture_that_holds_all_of_it")
def test_a_film_shows_the_machine_where_it_is(tmp_path: Path) -> None:
    """The lower ball of two pendulums, in its place and blue, in the first picture and in one later."""
    own = stage("double_pendulum")
    sink = Sink()
    file = read(MODELS / "double_pendulum.lag", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    write_film(flat, Wishes(), tmp_path / "film.gif")
    view = prepared(own).view
    with Image.open(tmp_path / "film.gif") as film:
        assert film.size[0] == 480
        for frame, row in ((0, 0), (40, 20)):  # 81 pictures, 41 rows
            film.seek(frame)
            ball = pieces(own, row, "octants")[-1]
            place = (view.seen(ball.corners.mean(axis=(0, 1)))[0] - view.low) / (view.high - view.low)
            at = (place * film.size * [1, -1] + [0, film.size[1]]).astype(int)
            red, _, blue = film.convert("RGB").getpixel((int(at[0]), int(at[1])))  # type: ignore[misc]
            assert blue > red + 60  # type: ignore[operator]


def test_a_picture_of_several_moments_is_another_one(tmp_path: Path) -> None:
    flat = flat_of("pendulum")
    for name, times in (("one", (0.4,)), ("both", (0.1, 0.4))):
        write_picture(flat, Wishes(stop=1.0), tmp_path / f"{name}.png", times)
    assert (tmp_path / "one.png").read_bytes() != (tmp_path / "both.png").read_bytes()
    with pytest.raises(ValueError, match="the motion is from 0 s to 1 s: there is no picture at 2 s"):
        write_picture(flat, Wishes(stop=1.0), tmp_path / "late.png", (2.0,))
    assert not (tmp_path / "late.png").exists()


def test_a_model_without_places_has_no_picture(tmp_path: Path) -> None:
    """An empty grid told nobody that there is nothing to see."""
    text = "model VanDerPol\n  state Real x(start = 2);\nequation\n  der(x) = -x/(1 s);\nend VanDerPol;\n"
    flat = flatten_file(SourceFile("<text>", text), Sink())
    assert flat is not None
    for write, name in ((write_picture, "still.png"), (write_film, "film.gif")):
        with pytest.raises(ValueError, match="nothing in VanDerPol has a place"):
            write(flat, Wishes(), tmp_path / name)  # type: ignore[operator]
        assert not (tmp_path / name).exists()


def test_a_view_that_follows_holds_the_machine_at_every_row_and_nothing_of_its_way() -> None:
    """Closed form: the middle of the picture is that of the coin, which rolls around a circle of thirteen radii."""
    own = stage("rolling_coin")
    whole, near = prepared(own), prepared(own, follow=True)
    wide, narrow = (float(each.view.high[0] - each.view.low[0]) for each in (whole, near))
    assert narrow < 0.3 * wide
    for row in (0, 20, len(own.rows) - 1):
        view = near.at(row).view
        for part in parts_of(own, row, without=("ground", "rail", "track", "trace")):
            if isinstance(part, Faces):
                places = view.seen(part.corners)[0]
                assert np.all(places >= view.low) and np.all(places <= view.high)
