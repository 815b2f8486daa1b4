"""Modes that show themselves: what `Model.modes` returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.motion.analysis import modes

if TYPE_CHECKING:
    from lagdsl.foundation.diagnostics import Sink
    from lagdsl.foundation.source import SourceFile
    from lagdsl.motion.analysis.point import System
    from lagdsl.motion.analysis.where import Where


class Modes(modes.Modes):
    """`.eigenvalues .frequencies [Hz] .damping .shapes .stability`; a row of `shapes` is one mode over `places`."""

    __slots__ = ("_page",)
    _page: Callable[[modes.Modes], str]

    @classmethod
    def of(cls, found: modes.Modes, page: Callable[[modes.Modes], str]) -> Modes:
        """`page` makes the page of modes."""
        made = cls(**{field.name: getattr(found, field.name) for field in fields(found)})
        object.__setattr__(made, "_page", page)
        return made

    def show(self, path: Path | str | None = None, *, browser: bool = True) -> Path:
        """Write a page on which each mode moves about the point with its frequency and damping, and open it.

        The page is one file that needs no network; it lies at `path`, else among the temporary files; returns its
        place. Raises ValueError where all eigenvalues are zero.
        """
        from lagdsl.interfaces.api.shown import write_page

        return write_page(self._page(self), self.model, path, browser=browser)

    def _repr_html_(self) -> str:
        from lagdsl.interfaces.api.shown import framed

        return framed(self._page(self), self.model)


def modes_of(system: System, where: Where, sink: Sink, source: SourceFile | None) -> Modes:
    """See `Model.modes`; `source` is the text that the page shows. Raises CompilationFailed."""
    from lagdsl.motion.analysis.where import modes as modes_at

    def page(found: modes.Modes) -> str:
        from lagdsl.documents.page.modes import modes_page

        names = [slot.name for slot in system.engine.layout.parameters]
        return modes_page(system.flat, found, names=names, source=source)

    return Modes.of(modes_at(system, where, sink), page)
