"""Pages taken apart: what lies in the elements of one."""

from __future__ import annotations

import json
import zlib
from base64 import b85decode
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from lagdsl.documents.page.page import page
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import flatten_file, read

MODELS = Path(__file__).parents[3] / "models"


@cache
def page_of(source: str, stop: float | None = None) -> str:
    """Of a text, or of a model of models/ by its name."""
    sink = Sink()
    file = read(source if "\n" in source else MODELS / f"{source}.lag", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None, sink.diagnostics
    return page(flat, Wishes(stop=stop), source=file, sink=sink)


def inflated(digits: str) -> bytes:
    return zlib.decompress(b85decode(digits.replace(",", "<")))


class Elements(HTMLParser):
    """Texts of the elements with an id, and every tag with its attributes."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.texts: dict[str, str] = {}
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self._open: str | None = None
        self._in_script = False
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        self._open = dict(attrs).get("id")
        self._in_script = tag == "script" and "type" not in dict(attrs)

    def handle_endtag(self, tag: str) -> None:
        self._open, self._in_script = None, False

    def handle_data(self, data: str) -> None:
        if self._open is not None:
            self.texts[self._open] = self.texts.get(self._open, "") + data
        if self._in_script:
            self.scripts.append(data)

    @property
    def head(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(self.texts["head"])
        return found

    def inflated(self, name: str) -> bytes:
        return inflated(self.texts[name])
