"""Figures as pictures: `motion.plot()` gives a figure that pyplot does not know, so its backend does not draw it."""

from __future__ import annotations

from io import BytesIO
from typing import Any

_FIGURE = "matplotlib.figure.Figure"
_DOTS_PER_INCH = 80


def show_figures(shell: Any) -> None:
    """Draw figures that are results of cells, unless the notebook has a form for them already."""
    forms = shell.display_formatter.formatters["image/png"]
    try:
        forms.lookup_by_type(_FIGURE)
    except KeyError:
        module, _, name = _FIGURE.rpartition(".")
        forms.for_type_by_name(module, name, png)


def without_figures(shell: Any) -> None:
    """Take back what `show_figures` did."""
    forms = shell.display_formatter.formatters["image/png"]
    try:
        is_ours = forms.lookup_by_type(_FIGURE) is png
    except KeyError:
        return
    if is_ours:
        forms.pop(_FIGURE)


def png(figure: Any) -> bytes:
    """The bytes of a PNG, the same for the same figure."""
    buffer = BytesIO()
    figure.savefig(buffer, format="png", dpi=_DOTS_PER_INCH, metadata={"Software": None})
    return buffer.getvalue()
