"""The machine of a page and that of a picture: the same parts, at the same places, of the same sizes."""

from __future__ import annotations

import io
from base64 import b64decode
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import chosen
from page.browser import CHROMIUM, Opened
from page.pages import MODELS, page_of
from PIL import Image
from scipy.ndimage import binary_dilation

from lagdsl.derivation.scene import living
from lagdsl.derivation.scene.shapes import Scene
from lagdsl.documents.plot.picture.draw import draw, prepared
from lagdsl.documents.plot.picture.recording import prepare, recorded, staged
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file, read

pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make page-check")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
_INK = 185  # darker than the grid, lighter than every part
_ENDLESS = ("ground", "rail", "track", "trace")  # may leave the picture, each in its own way
EVERY = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))
SOME = ["four_bar_crank", "robot_arm", "library/dc_motor"]  # a plane machine, one in space, a circuit


def shadow(pixels: np.ndarray) -> np.ndarray:
    """All that is drawn, in a box of 400 pixels."""
    dark = pixels[..., :3].min(axis=-1) < _INK
    rows, columns = np.flatnonzero(dark.any(axis=1)), np.flatnonzero(dark.any(axis=0))
    cut = Image.fromarray(dark[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1])
    scale = 400.0 / max(cut.size)
    size = (max(round(cut.size[0] * scale), 1), max(round(cut.size[1] * scale), 1))
    whole = Image.new("1", (400, 400))
    whole.paste(cut.resize(size), (0, 0))
    return np.asarray(whole)


@pytest.fixture
def _machine_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pages and pictures without what has no end."""
    scene_of = living.scene_of

    def alone(flat: FlatModel) -> Scene:
        found = scene_of(flat)
        return replace(found, shapes=tuple(each for each in found.shapes if each.kind not in _ENDLESS))

    monkeypatch.setattr(living, "scene_of", alone)


@pytest.mark.usefixtures("_machine_alone")
@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_page_and_picture_show_the_same_machine(name: str, browser: Any, tmp_path: Path) -> None:
    """Nine tenths of each silhouette lie on the other one, but for the width of an edge."""
    path = tmp_path / "page.html"
    path.write_text(page_of.__wrapped__(name), encoding="utf-8")
    page = Opened(browser, path, still=True).page
    page.keyboard.press("Home")
    page.wait_for_timeout(1000)  # the fine picture of a machine at rest
    data = page.evaluate("document.querySelector('#stage canvas').toDataURL()")
    shot = np.asarray(Image.open(io.BytesIO(b64decode(data.partition(",")[2]))).convert("RGB"))
    page.close()
    sink = Sink()
    file = read(MODELS / f"{name}.lag", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    made = recorded(prepare(flat), Wishes(), 601)
    picture = prepared(staged(flat, made.scene, [made.motion]))
    picture.figure.set_dpi(200)
    draw(picture, 0)
    picture.figure.canvas.draw()
    one, other = shadow(shot), shadow(np.asarray(picture.figure.canvas.buffer_rgba()))  # type: ignore[attr-defined]
    for a, b in ((one, other), (other, one)):
        assert np.sum(a & binary_dilation(b, iterations=2)) >= 0.9 * np.sum(a)
