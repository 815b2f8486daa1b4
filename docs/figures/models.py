"""Contact sheets of all models: `python docs/figures/models.py` writes docs/images/models.

Of each model: the picture of `lag show --png`, then the picture of its page in a window 1280 and 420 pixels wide, light
and dark, where the motion begins. It needs Chromium and Playwright and takes half an hour; names of models as arguments
write these alone, one strip each, into the folder that is given last."""

from __future__ import annotations

import io
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw

from lagdsl.documents.page.page import page
from lagdsl.documents.plot.picture.draw import draw, prepared, save_picture
from lagdsl.documents.plot.picture.recording import prepare, recorded, staged
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import flatten_file, read

MODELS = Path(__file__).parents[2] / "models"
FOLDER = Path(__file__).parents[1] / "images" / "models"
OPTIONS = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")
WINDOWS = [(width, scheme) for width in (1280, 420) for scheme in ("light", "dark")]
CELL, NAME = (150, 110), 12  # pixels of a picture, and of the line with its name above
BESIDE, BELOW = 2, 20  # models of a sheet
MILLISECONDS = 60_000


def names() -> list[str]:
    return sorted(str(path.relative_to(MODELS).with_suffix("")) for path in MODELS.rglob("*.lag"))


def views(name: str, browser: Any) -> Iterator[Image.Image]:
    """The picture, then the pages. Raises SystemExit with the errors of a text that is no model."""
    sink = Sink()
    file = read(MODELS / f"{name}.lag", sink)
    flat = None if file is None else flatten_file(file, sink)
    if file is None or flat is None:
        raise SystemExit("\n".join(f"{name}: {d.code} {d.message}" for d in sink.diagnostics))
    made = recorded(prepare(flat), Wishes(), 201)
    picture = prepared(staged(flat, made.scene, [made.motion]))
    draw(picture, 0)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "machine.png"
        save_picture(picture, path, 640)
        yield Image.open(path).convert("RGB")
        path = Path(folder) / "machine.html"
        path.write_text(page(flat, Wishes(), source=file, sink=sink), encoding="utf-8")
        shown = browser.new_page(viewport={"width": WINDOWS[0][0], "height": 800}, reduced_motion="reduce")
        shown.goto(path.as_uri())
        shown.wait_for_selector("html[data-ready]", timeout=MILLISECONDS, state="attached")
        shown.keyboard.press("Home")
        for width, scheme in WINDOWS:
            shown.set_viewport_size({"width": width, "height": 800})
            shown.emulate_media(color_scheme=scheme)
            shown.wait_for_timeout(500)  # the fine picture of a machine at rest
            yield Image.open(io.BytesIO(shown.locator("#stage canvas").first.screenshot())).convert("RGB")
        shown.close()


def strip(name: str, browser: Any) -> Image.Image:
    """All views of a model side by side under its name."""
    found = Image.new("RGB", ((1 + len(WINDOWS)) * CELL[0], CELL[1] + NAME), "white")
    ImageDraw.Draw(found).text((2, 0), name, fill="black")
    for k, view in enumerate(views(name, browser)):
        view.thumbnail((CELL[0] - 2, CELL[1] - 2))
        found.paste(view, (k * CELL[0], NAME))
    return found


def main(chosen: list[str], folder: Path) -> None:
    from playwright.sync_api import sync_playwright

    folder.mkdir(exist_ok=True)
    with sync_playwright() as started:
        chromium = shutil.which("chromium") or shutil.which("google-chrome") or os.environ.get("CHROMIUM")
        browser = started.chromium.launch(executable_path=chromium, args=list(OPTIONS))
        strips = {name: strip(name, browser) for name in chosen or names()}
        browser.close()
    if chosen:
        for name, each in strips.items():
            each.save(folder / f"{name.replace('/', '_')}.png")
        return
    write_sheets(list(strips.values()), folder)


def write_sheets(every: list[Image.Image], folder: Path) -> None:
    """Strips in columns, one file for so many."""
    count = BESIDE * BELOW
    width, height = every[0].size
    for first in range(0, len(every), count):
        sheet = Image.new("RGB", (BESIDE * width, BELOW * height), "white")
        for k, each in enumerate(every[first : first + count]):
            sheet.paste(each, (k // BELOW * width, k % BELOW * height))
        sheet.save(folder / f"{first // count + 1}.webp", quality=60, method=6)


if __name__ == "__main__":
    main(sys.argv[1:-1], Path(sys.argv[-1]) if len(sys.argv) > 2 else FOLDER)
