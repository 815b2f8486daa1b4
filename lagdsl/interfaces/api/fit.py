"""A fit that shows and writes itself: what `Model.fit` returns."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.fit import result
from lagdsl.motion.fit.words import fit_text


class Fit(result.Fit):
    """`.values`, `.intervals`, `.covariance`, `.correlation`, `.series` with residuals, `.motions`, `.hidden` (what the
    data do not show one by one), `.notes`; `.parameters` and `.start` as `simulate` takes them."""

    __slots__ = ("_flat", "_source")
    _flat: FlatModel
    _source: SourceFile | None

    @classmethod
    def of(cls, found: result.Fit, flat: FlatModel, source: SourceFile | None) -> Fit:
        """`source` is the text of the model `flat`."""
        made = cls(**{each.name: getattr(found, each.name) for each in fields(result.Fit)})
        object.__setattr__(made, "_flat", flat)
        object.__setattr__(made, "_source", source)
        return made

    def __str__(self) -> str:
        return fit_text(self)

    def __repr__(self) -> str:
        return fit_text(self)

    @property
    def text(self) -> str:
        """The text of the model with the values that all runs share. Raises CompilationFailed (E1116) where a value has
        no place in it, ValueError without a text."""
        from lagdsl.motion.fit.written import written

        if self._source is None:
            raise ValueError("this model has no text")
        sink = Sink()
        shared = [(each.unknown.target, each.value) for each in self.estimates if each.unknown.run is None]
        text = written(self._source, self._flat, shared, sink)
        sink.raise_if_errors()
        assert text is not None
        return text

    def write(self, path: Path | str) -> None:
        """Write `text` to `path`. Raises as `text`, and OSError."""
        text = self.text
        with whole_file(Path(path)) as draft:
            draft.write_text(text, encoding="utf-8", newline="\n")

    def report(self, path: Path | str) -> None:
        """Write a page with values, residuals and the motions over the data to `path`. Raises OSError."""
        from lagdsl.documents.report.fits.fit_page import fit_page

        with whole_file(Path(path)) as draft:
            draft.write_text(fit_page(self), encoding="utf-8", newline="\n")

    def _repr_html_(self) -> str:
        from lagdsl.documents.report.fits.fit_page import fit_page
        from lagdsl.interfaces.api.shown import framed

        return framed(fit_page(self), self.model)
