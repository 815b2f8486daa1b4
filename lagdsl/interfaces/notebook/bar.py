"""A bar of progress in a notebook, for what takes longer than a second."""

from __future__ import annotations

from html import escape
from time import monotonic
from typing import Any

_PATIENCE = 1.0  # seconds without a bar
_STEP = 0.01  # of the work, between two pictures


class Bar:
    """Called with the part of the work that is done, from 0 to 1; at 1 the bar disappears."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._began = monotonic()
        self._handle: Any = None
        self._drawn = 0.0

    def __call__(self, part: float) -> None:
        if self._handle is None:
            if part >= 1.0 or monotonic() - self._began < _PATIENCE:
                return
            from IPython.display import display

            self._handle = display(_Picture(self._title, part), display_id=True)
            self._drawn = part
        elif part >= 1.0:
            self._handle.update(_Picture("", 1.0))
        elif part - self._drawn >= _STEP:
            self._handle.update(_Picture(self._title, part))
            self._drawn = part


class _Picture:
    """The bar at one moment; without a title nothing is left of it."""

    def __init__(self, title: str, part: float) -> None:
        self._title, self._part = title, part

    def __repr__(self) -> str:
        return f"{self._title}: {100 * self._part:.0f} %" if self._title else ""

    def _repr_html_(self) -> str:
        if not self._title:
            return ""
        percent = f"{100 * self._part:.0f} %"
        bar = f'<progress value="{self._part:.3f}" max="1">{percent}</progress>'
        return f"<label>{escape(self._title)} {bar}</label>"
