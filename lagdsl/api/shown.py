"""The living page of a model, in a browser or inside a notebook, and its certificate."""

from __future__ import annotations

import tempfile
import webbrowser
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.api.described import Described
from lagdsl.api.inputs import signals_of
from lagdsl.api.names import Value, known
from lagdsl.diagnostics import Sink

if TYPE_CHECKING:
    from lagdsl.signals.inputs import Signal
    from lagdsl.source import SourceFile
    from lagdsl.verify.certificate import Certificate

_FRAME_HEIGHT = 640  # pixels


class Shown(Described):
    """A model that can be looked at and verified. `_source` is the text that the page shows."""

    _source: SourceFile | None

    def show(
        self,
        path: Path | str | None = None,
        *,
        browser: bool = True,
        stop: float | None = None,
        tolerance: float | None = None,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        sink: Sink | None = None,
    ) -> Path:
        """Write a page that shows the machine moving, with sliders and equations, and open it in a browser.

        The page is one file that needs no network; it lies at `path`, else among the temporary files; returns its
        place. The other arguments are what the sliders begin with, as for `simulate`; inputs that vary with time are
        those of the recorded motion only. A run that ends early is shown as far as it went, its errors go to `sink`.
        """
        text = self._page(stop=stop, tolerance=tolerance, parameters=parameters, start=start, inputs=inputs, sink=sink)
        return write_page(text, self.name, path, browser=browser)

    def verify(self) -> Certificate:
        """Everything that can be computed in two ways, compared: `.lines` with figures and limits, `.holds`."""
        from lagdsl.verify.certify import certify

        return certify(self._compilation, self._source)

    def _repr_html_(self) -> str:
        return framed(self._page(), self.name)

    def _page(
        self,
        *,
        stop: float | None = None,
        tolerance: float | None = None,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        sink: Sink | None = None,
    ) -> str:
        from lagdsl.page.page import Wishes, page

        self._parameter_vector(parameters)
        wishes = Wishes(
            stop=stop,
            tolerance=tolerance,
            parameters=known("parameter", parameters, self._named("parameter")),
            start=self._start_values(start),
            inputs=signals_of(self._compilation.flat, inputs) or {},
        )
        return page(self._compilation.flat, wishes, source=self._source, sink=sink)


def write_page(text: str, name: str, path: Path | str | None, *, browser: bool) -> Path:
    """Write a page to `path`, or to a temporary file, and open it; returns where it lies."""
    if path is None:
        with tempfile.NamedTemporaryFile(
            "w", encoding="utf-8", newline="\n", prefix=f"{name}-", suffix=".html", delete=False
        ) as file:
            file.write(text)
        target = Path(file.name)
    else:
        target = Path(path)
        target.write_text(text, encoding="utf-8", newline="\n")
    if browser:
        webbrowser.open(target.resolve().as_uri())
    return target


def framed(text: str, name: str) -> str:
    """A page in a frame of its own, as notebooks show it: neither sees the other's scripts and styles."""
    return (
        f'<iframe title="{escape(name)}" sandbox="allow-scripts allow-downloads" '
        f'style="width: 100%; height: {_FRAME_HEIGHT}px; border: 0" srcdoc="{escape(text)}"></iframe>'
    )
