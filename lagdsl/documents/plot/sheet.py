"""Parts of all figures: Matplotlib without a window, colors, style, files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Endings of files that a figure can be written to.
FORMS = (".eps", ".jpg", ".pdf", ".png", ".svg", ".webp")
# Okabe and Ito's colors, told apart with any kind of color vision.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
LINES: tuple[Literal["-", "--", ":", "-."], ...] = ("-", "--", ":", "-.")
DARK = "#333333"
_MOST_LINES = 100
_MARKS = "#999999"
_STYLE: dict[str, Any] = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#666666",
    "axes.labelcolor": DARK,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "xtick.color": "#666666",
    "ytick.color": "#666666",
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
}


@contextmanager
def sheet(size: tuple[float, float], path: Path | str | None = None, **given: Any) -> Iterator[Figure]:
    """A figure of `size` [inch] that belongs to no window and needs no display; at the end it is written to `path`, if
    given. Raises ModuleNotFoundError without Matplotlib."""
    try:
        import matplotlib as mpl
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(f"figures need matplotlib: pip install matplotlib ({missing})") from missing
    with mpl.rc_context(cast(Any, _STYLE)):
        figure = Figure(figsize=size, **{"layout": "constrained", **given})
        FigureCanvasAgg(figure)
        yield figure
        if path is not None:
            save(figure, path)


def save(figure: Figure, path: Path | str) -> None:
    """In the form of the suffix; a file without one, as drafts of atomic writing have, is a PNG."""
    suffix = Path(path).suffix.lstrip(".").lower()
    known = suffix in figure.canvas.get_supported_filetypes()
    figure.savefig(path, dpi=150, format=suffix if known else "png")


def title(panel: Axes, text: str) -> None:
    panel.set_title(text, loc="left", fontweight="bold", color=DARK)


def mark_events(panel: Axes, times: Sequence[float], length: float) -> None:
    """Lines at `times`, or dashes at the bottom if lines would hide the curves; `length` of the motion, all in s."""
    apart = [t for k, t in enumerate(times) if k == 0 or t - times[k - 1] > length / _MOST_LINES]
    if len(apart) < len(times) or len(times) > _MOST_LINES // 4:
        (marks,) = panel.plot(times, np.zeros(len(times)), marker="|", linestyle="", color=_MARKS, markersize=5)
        marks.set(transform=panel.get_xaxis_transform(), clip_on=False, zorder=1)
    else:
        for time in times:
            panel.axvline(time, color=_MARKS, linewidth=0.7, linestyle=(0, (4, 3)), zorder=0.9)


def in_brackets(unit: str, before: str = " ") -> str:
    """The unit behind the name of an axis; nothing where there is none."""
    return f"{before}[{unit}]" if unit not in ("", "1") else ""


def escaped(name: str) -> str:
    """Names are plain text: `$` would start a formula, a leading `_` would hide a legend entry."""
    text = name.replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text
