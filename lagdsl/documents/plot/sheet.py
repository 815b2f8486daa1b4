"""Parts of all figures: Matplotlib without a window, colors, style, files; the icon of a model."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from lagdsl.motion.signals.trajectory import Trajectory

# Endings of files that a figure can be written to.
FORMS = (".eps", ".jpg", ".pdf", ".png", ".svg", ".webp")
# Okabe and Ito's colors, told apart with any kind of color vision.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
LINES: tuple[Literal["-", "--", ":", "-."], ...] = ("-", "--", ":", "-.")
DARK = "#333333"
_MOST_LINES = 100
_MARKS = "#999999"
_STAMPS: dict[str, Any] = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {"Software": None}}
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


# Of an icon; the largest letters that still leave a long name within it.
_CURVES, _INCHES, _DOTS = 3, 2.0, 128
_LARGEST, _WIDTH = 16.0, 210.0


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


def save(figure: Figure, file: Path | str | BytesIO, dpi: float = 150.0) -> None:
    """In the form of the suffix; a file without one, as drafts of atomic writing have, is a PNG. The same figure gives
    the same bytes at any time, and does not tell which version of Matplotlib made a PNG."""
    import matplotlib as mpl

    suffix = "" if isinstance(file, BytesIO) else Path(file).suffix.lstrip(".").lower()
    form = suffix if suffix in figure.canvas.get_supported_filetypes() else "png"
    with mpl.rc_context({"svg.hashsalt": "lagdsl"}):
        figure.savefig(file, dpi=dpi, format=form, metadata=_STAMPS.get(form))


def icon(trajectory: Trajectory) -> bytes:
    """A small square picture of a model for lists and diagrams of other tools: its first curves, without axes, as a PNG
    of 256 x 256 pixels. Needs the extra `plot`."""
    with sheet((_INCHES, _INCHES), layout=None) as figure:
        axes = figure.add_axes((0.08, 0.2, 0.84, 0.72))
        axes.set_axis_off()
        for color, column in zip(COLORS, trajectory.columns[1 : 1 + _CURVES], strict=False):
            low, high = np.min(column.values), np.max(column.values)
            heights = (column.values - low) / (high - low) if high > low else np.full(len(trajectory), 0.5)
            axes.plot(trajectory.time, heights, color=color, linewidth=2.2, solid_capstyle="round")
        name = escaped(trajectory.model)
        size = min(_LARGEST, _WIDTH / max(len(name), 1))
        figure.text(0.5, 0.06, name, ha="center", va="bottom", fontsize=size, fontweight="bold", color=DARK)
        return png(figure, _DOTS)


def png(figure: Figure, dots: int = 110) -> bytes:
    file = BytesIO()
    save(figure, file, dots)
    return file.getvalue()


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
