"""A call in Python that cannot be carried out."""

from __future__ import annotations

from typing import Any

from lagdsl.foundation.diagnostics.diagnostic import Diagnostic
from lagdsl.foundation.diagnostics.sink import Sink


class CallRefused(ValueError):  # noqa: N818 the public name says what happened
    """A call that does not fit the present state of a session, or a value that it cannot take: nothing has changed.
    `diagnostics` say why, `str()` is the rendered text."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        from lagdsl.foundation.diagnostics.render import render_all

        return render_all(self.diagnostics)


def refused(code: str, **arguments: Any) -> CallRefused:
    """The exception of the row `code` of the catalog."""
    sink = Sink()
    sink.report(code, None, **arguments)
    return CallRefused(sink.diagnostics)
