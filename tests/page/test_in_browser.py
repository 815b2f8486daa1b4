"""Pages in a real browser: they ask for nothing, show something, and every control does its work."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from choice import ALL, chosen
from page.pages import MODELS, page_of

from lagdsl.api.shown import framed

playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make page-check")
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome") or os.environ.get("CHROMIUM")
pytestmark = [
    pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed"),
    pytest.mark.skipif(not ALL, reason="opens a browser: make page-check"),
]
# WebGL by software; a browser for tests needs no sandbox of its own.
OPTIONS = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")
EVERY = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))
MOST_MILLISECONDS = 60_000


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with playwright.sync_playwright() as started:
        found = started.chromium.launch(executable_path=CHROMIUM, args=list(OPTIONS))
        yield found
        found.close()


class Opened:
    """A page that is ready, with what it said to the console and asked for."""

    def __init__(self, browser: Any, path: Path, width: int = 1280, height: int = 800) -> None:
        self.page = browser.new_page(viewport={"width": width, "height": height})
        self.faults: list[str] = []
        self.page.on("console", lambda said: self.faults.append(said.text) if said.type == "error" else None)
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.on("request", self._ask)
        self.page.goto(path.as_uri())
        self.page.wait_for_selector("html[data-ready]", timeout=MOST_MILLISECONDS, state="attached")

    def _ask(self, request: Any) -> None:
        if not request.url.startswith(("file:", "blob:", "data:", "about:")):
            self.faults.append(f"asks for {request.url}")

    def colors(self) -> int:
        """Different colors among some pixels of the picture."""
        return int(
            self.page.evaluate("""() => {
                const from = document.querySelector('#stage canvas');
                const to = document.createElement('canvas');
                [to.width, to.height] = [160, 100];
                const pen = to.getContext('2d');
                pen.drawImage(from, 0, 0, 160, 100);
                const pixels = new Uint32Array(pen.getImageData(0, 0, 160, 100).data.buffer);
                return new Set(pixels).size;
            }""")
        )

    def ready(self) -> str:
        return str(self.page.evaluate("document.documentElement.dataset.ready"))


@pytest.mark.parametrize("name", chosen(EVERY, ("double_pendulum",)))
def test_every_page_is_shown_and_asks_for_nothing(name: str, browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of(name), encoding="utf-8")
    opened = Opened(browser, path)
    assert opened.ready() == "live"
    assert opened.colors() > 3
    bar = opened.page.locator("#sliders input[type=range]").first
    if bar.count():
        bar.evaluate("bar => { bar.value = 520; bar.dispatchEvent(new Event('input')); }")
        opened.page.wait_for_function("document.getElementById('said').textContent !== ''", timeout=MOST_MILLISECONDS)
    assert opened.faults == []
    opened.page.close()


def test_every_control_does_its_work(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("four_bar"), encoding="utf-8")
    opened = Opened(browser, path)
    page = opened.page
    clock = page.locator(".clock")
    page.keyboard.press("Space")  # it plays from the beginning: now it rests
    page.keyboard.press("Home")
    assert clock.inner_text() == "0.00 s"
    page.keyboard.press("ArrowRight")
    assert clock.inner_text() == "0.05 s"
    page.keyboard.press("End")
    assert clock.inner_text() == "5.00 s"
    for tab in page.locator("[role=tab]").all():
        tab.click()
        panel = page.locator(f"#{tab.get_attribute('aria-controls')}")
        assert panel.is_visible()
        assert page.locator("[role=tabpanel]:visible").count() == 1
    for name in ("frames", "forces", "view"):
        page.get_by_role("button", name=name).click()
    for name, suffix in (("PNG", ".png"), ("CSV", ".csv")):
        with page.expect_download() as download:
            page.get_by_role("button", name=name).click()
        assert download.value.suggested_filename == f"FourBar{suffix}"
    page.locator("#sliders-tab").click()
    page.get_by_role("button", name="Reset all").click()
    assert opened.faults == []
    page.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_page_fits_a_telephone(scheme: str, browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(page_of("double_pendulum"), encoding="utf-8")
    opened = Opened(browser, path, 390, 844)
    opened.page.emulate_media(color_scheme=scheme)
    assert opened.page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert opened.faults == []
    opened.page.close()


def test_a_notebook_shows_the_page_in_its_frame(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><html><body>{framed(page_of('pendulum'), 'p')}</body></html>", encoding="utf-8")
    page = browser.new_page()
    page.goto(path.as_uri())
    page.frame_locator("iframe").locator("html[data-ready]").wait_for(timeout=MOST_MILLISECONDS, state="attached")
    page.close()
