"""Diagnostics as notebooks show them: excerpt, carets and help in colour, as text and as HTML."""

from __future__ import annotations

import re
from html import escape

from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.foundation.diagnostics.render import render_all

_CODE = re.compile(r"\x1b\[([0-9;]*)m")
_EXCERPT = "font-family: monospace; line-height: 1.25"  # pages of notebooks have fonts of their own for `pre`
_STYLES = {
    "1": "font-weight: bold",
    "1;31": "font-weight: bold; color: #c62828",
    "1;33": "font-weight: bold; color: #a66a00",
    "1;34": "font-weight: bold; color: #1f5fbf",
    "1;36": "font-weight: bold; color: #00767a",
}


class Told:
    """Diagnostics below a line of summary."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...], summary: str = "") -> None:
        self._text = render_all(diagnostics, color=True)
        self._summary = summary

    def __repr__(self) -> str:
        return "\n".join(part for part in (self._summary, _CODE.sub("", self._text)) if part)

    def _repr_html_(self) -> str:
        summary = f"<div>{escape(self._summary)}</div>" if self._summary else ""
        return summary + (f'<pre style="{_EXCERPT}">{_painted(self._text)}</pre>' if self._text else "")


def _painted(text: str) -> str:
    """The text with styles in the place of the codes of terminals."""
    pieces, last, open_ = [], 0, False
    for code in _CODE.finditer(text):
        pieces.append(escape(text[last : code.start()]))
        pieces.append("</span>" * open_)
        open_ = code[1] in _STYLES
        pieces.append(f'<span style="{_STYLES[code[1]]}">' if open_ else "")
        last = code.end()
    return "".join([*pieces, escape(text[last:]), "</span>" * open_])
