"""Pages in a real browser: one that is ready, and what it said."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import pytest
from choice import ALL

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome") or os.environ.get("CHROMIUM")
NEEDED = [
    pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed"),
    pytest.mark.skipif(not ALL, reason="opens a browser: make page-check"),
]
# WebGL by software; a browser for tests needs no sandbox of its own.
OPTIONS = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")
MOST_MILLISECONDS = 60_000


class Opened:
    """A page that is ready, with what it said to the console and asked for."""

    def __init__(
        self, browser: Any, path: Path, width: int = 1280, height: int = 800, before: str = "", *, still: bool = False
    ) -> None:
        """`before` is a script that runs first. A `still` page does not play by itself."""
        motion = "reduce" if still else "no-preference"
        self.page = browser.new_page(viewport={"width": width, "height": height}, reduced_motion=motion)
        self.page.add_init_script(before)
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
