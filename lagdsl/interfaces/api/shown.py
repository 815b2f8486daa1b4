"""The living page of a model, in a browser or inside a notebook, its derivation, its certificate."""

from __future__ import annotations

import tempfile
import webbrowser
from collections.abc import Mapping
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.by_name import ByName
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import Value, known

if TYPE_CHECKING:
    import xarray

    from lagdsl.documents.plot.picture.wishes import Wishes
    from lagdsl.exchange.verify.certificate import Certificate
    from lagdsl.exchange.verify.conserved.quantity import ConservedQuantity
    from lagdsl.foundation.source import SourceFile
    from lagdsl.interfaces.api.derivation import Derivation
    from lagdsl.motion.signals.inputs import Signal

_FRAME_HEIGHT = 640  # pixels


class Shown(ByName):
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
        results: Path | str | None = None,
        sweep: xarray.Dataset | None = None,
        sink: Sink | None = None,
    ) -> Path:
        """Write a page that shows the machine moving, with sliders and equations, and open it in a browser.

        The page is one file that needs no network; it lies at `path`, else among the temporary files; returns its
        place. The other arguments are what the sliders begin with, as for `simulate`; inputs that vary with time are
        those of the recorded motion only. A run that ends early is shown as far as it went, its errors go to `sink`.

        `results` is a CSV file of `lag run -o`, whose rows are shown and not integrated. `sweep` is what `sweep` of
        this model returned, or a part of it: the page has a slider over its runs.
        """
        wishes = self._wishes(stop=stop, tolerance=tolerance, parameters=parameters, start=start, inputs=inputs)
        flat, source = self._compilation.flat, self._source
        if results is not None and sweep is not None:
            raise ValueError("a page shows the rows of a file or the runs of a sweep, not both")
        if results is not None:
            from lagdsl.documents.page.results import results_page

            text = results_page(flat, Path(results), wishes, source=source, sink=sink)
        elif sweep is not None:
            from lagdsl.documents.page.runs import sweep_page
            from lagdsl.interfaces.api.sweep import settings_of

            text = sweep_page(flat, settings_of(flat, sweep), wishes, source=source, sink=sink)
        else:
            text = self._page_of(wishes, sink)
        return write_page(text, self.name, path, browser=browser)

    def verify(self, *, fmu: bool = False) -> Certificate:
        """Everything that can be computed in two ways, compared: `.lines` with figures and limits, `.holds`.

        With `fmu` the model goes through FMUs of both versions and kinds and FMPy, too; these lines are left out, and
        say so, where FMPy is not installed.
        """
        from lagdsl.exchange.verify.certify import certify

        return certify(self._compilation, self._source, fmu=fmu)

    @cached_property
    def conserved_quantities(self) -> tuple[ConservedQuantity, ...]:
        """Quantities that stay constant along every motion, found without being claimed, simple ones first:
        `.expression` in the language, `.unit`, `.because`, `.statements`, `.for_all_parameters`.

        Searched are the energy and Jacobi's integral, momenta of coordinates and of the whole, and the combinations of
        momenta that belong to linear symmetries of the coordinates (Noether's theorem). There may be others.
        """
        from lagdsl.exchange.verify.conserved.find import conserved_quantities

        return conserved_quantities(self._compilation)

    def derive(self) -> Derivation:
        """The derivation of the equations of motion, step by step: `str` of it, `.to("latex")`, `.write(path)`.

        `.terms` are the terms of the equations with the statements that they come from.
        """
        from lagdsl.derivation.textbook.recipe import recipe
        from lagdsl.interfaces.api.derivation import Derivation

        return Derivation(recipe(self._compilation.flat))

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
        wishes = self._wishes(stop=stop, tolerance=tolerance, parameters=parameters, start=start, inputs=inputs)
        return self._page_of(wishes, sink)

    def _page_of(self, wishes: Wishes, sink: Sink | None) -> str:
        from lagdsl.documents.page.page import page

        made = self._compilation
        return page(made.flat, wishes, source=self._source, sink=sink, compilation=made)

    def _wishes(
        self,
        *,
        stop: float | None,
        tolerance: float | None,
        parameters: Mapping[str, Value] | None,
        start: Mapping[str, Value] | None,
        inputs: Mapping[str, Signal | str] | Path | str | None,
    ) -> Wishes:
        from lagdsl.documents.plot.picture.wishes import Wishes

        self._parameter_vector(parameters)
        return Wishes(
            stop=stop,
            tolerance=tolerance,
            parameters=known("parameter", parameters, self._named("parameter")),
            start=self._start_values(start),
            inputs=signals_of(self._compilation.flat, inputs) or {},
        )


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
