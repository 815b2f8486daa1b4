"""A picture of a machine: faces from the back to the front, names, the ground behind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.derivation.scene.stage import Stage
from lagdsl.documents.plot.picture.shapes import GAUGES, Color, Faces, Painted, Words, parts_of
from lagdsl.documents.plot.picture.view import View, steps_of, view_of
from lagdsl.documents.plot.sheet import escaped, save, sheet
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_INCHES = 6.4  # wide
_DPI = 100
_GHOST = 0.25
PAPER, GRID, INK = "#f8fafc", "#dbe3ec", "#475569"
# Over the left shoulder of the viewer: right, up, back.
_SUN = np.array([0.35, 0.6, 0.72]) / np.linalg.norm([0.35, 0.6, 0.72])


@record(kw_only=True)
class Drawn:
    """A picture that can be changed from row to row: all it knows of the motion. `steps` (rows, 3) [m] are those of the
    view, if it goes with the machine."""

    stage: Stage
    view: View
    steps: Floats | None
    figure: Figure
    axes: Axes

    def at(self, row: int) -> Drawn:
        return self if self.steps is None else replace(self, view=self.view.beside(self.steps[row]), steps=None)


def prepared(stage: Stage, title: str = "", *, follow: bool = False) -> Drawn:
    """An empty picture; its view may `follow` the machine. Raises ModuleNotFoundError without Matplotlib."""
    steps = steps_of(stage) if follow else None
    view = view_of(stage, steps)
    width, height = view.high - view.low
    size = (_INCHES, round(_INCHES * float(height / width), 2))
    with sheet(size, layout=None, dpi=_DPI, facecolor=PAPER) as figure:
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        if title:
            figure.text(0.015, 0.98, title, va="top", fontsize=9, color=INK)
    return Drawn(stage=stage, view=view, steps=steps, figure=figure, axes=axes)


def draw(picture: Drawn, row: int, ghosts: Sequence[int] = (), caption: str = "") -> None:
    """Show the machine at a row of its motion, and pale at others."""
    picture = picture.at(row)
    axes, view, stage = picture.axes, picture.view, picture.stage
    axes.clear()
    axes.set_axis_off()
    axes.set(xlim=(view.low[0], view.high[0]), ylim=(view.low[1], view.high[1]))
    _ruled(picture)
    for ghost in ghosts:
        _paint(picture, parts_of(stage, ghost, without=GAUGES), _GHOST)
    _paint(picture, parts_of(stage, row), 1.0)
    if caption:
        axes.text(0.985, 0.02, caption, transform=axes.transAxes, ha="right", va="bottom", fontsize=9, color=INK)


def save_picture(picture: Drawn, path: Path | str, pixels: int = 1280) -> None:
    """In the form of the suffix, PNG without one, `pixels` wide."""
    save(picture.figure, path, pixels / _INCHES)


def _paint(picture: Drawn, parts: Sequence[Painted], opacity: float) -> None:
    """Parts from the back to the front, face by face."""
    from matplotlib.collections import PolyCollection

    for part in parts:
        if isinstance(part, Words):
            _write(picture, part, opacity)
    seen = [_faces(picture.view, part) for part in parts if isinstance(part, Faces)]
    if not seen:
        return
    places, inks, depth = (np.concatenate(each) for each in zip(*seen, strict=True))
    order = np.argsort(depth, kind="stable")
    # Seams between faces show in pale pictures where faces have edges, in full ones where they have none.
    edge = inks[order]
    edge[:, 3] = (inks[order, 3] == 1.0) & (opacity == 1.0)
    inks[:, 3] *= opacity
    picture.axes.add_collection(
        PolyCollection(places[order], facecolors=inks[order], edgecolors=edge, linewidths=0.4, closed=True),  # type: ignore[arg-type]
        autolim=False,
    )


def _faces(view: View, part: Faces) -> tuple[Floats, Floats, Floats]:
    places, depth, _ = view.seen(part.corners)
    turned = (part.corners - view.center) @ view.turn.T
    normals = np.cross(turned[:, 2] - turned[:, 0], turned[:, 3] - turned[:, 1])
    sizes = np.linalg.norm(normals, axis=1)
    normals /= np.where(sizes > 0.0, sizes, 1.0)[:, None]
    # The signed area of what is seen tells the side that is seen, in perspective too.
    (ax, ay), (bx, by) = (places[:, 2] - places[:, 0]).T, (places[:, 3] - places[:, 1]).T
    front = (ax * by - ay * bx > 0.0) if part.closed else np.ones(len(places), dtype=bool)
    shades = np.broadcast_to(part.color, (len(places), 3)) if part.flat else _lit(part.color, normals)
    inks = np.concatenate([shades, np.full((len(places), 1), part.opacity)], axis=1)
    return places[front], inks[front], _middles(part.corners, depth)[front]


def _middles(corners: Floats, depth: Floats) -> Floats:
    """Depths (n,) of the centres of area of faces, whatever corner a triangle has twice."""
    one, other = corners[:, 1:3] - corners[:, :1], corners[:, 2:] - corners[:, :1]
    areas = np.linalg.norm(np.cross(one, other), axis=2) + 1e-300
    return np.asarray(np.average((depth[:, :1] + depth[:, 1:3] + depth[:, 2:]) / 3.0, axis=1, weights=areas))


def _lit(color: Color, normals: Floats) -> Floats:
    """Colors (n, 3) of faces whose unit normals (n, 3) are in the viewer's axes."""
    bright = np.clip(normals @ _SUN, 0.0, 1.0)[:, None]
    shade = np.array(color) * (0.62 + 0.43 * bright)
    return np.asarray(np.clip(shade + 0.10 * bright**8, 0.0, 1.0))


def _write(picture: Drawn, part: Words, opacity: float) -> None:
    """Text as text: `$` starts no formula."""
    place, _, scale = picture.view.seen(part.at)
    points = _INCHES * 72.0 / float(picture.view.high[0] - picture.view.low[0])
    size = min(max(0.75 * part.size * float(scale) * points, 5.0), 14.0)
    style: dict[str, Any] = {"color": INK, "alpha": opacity, "ha": "center", "va": "center", "zorder": 5}
    picture.axes.text(float(place[0]), float(place[1]), escaped(part.text), fontsize=size, **style)


def _ruled(picture: Drawn) -> None:
    """Squares behind a planar machine, under a spatial one."""
    from matplotlib.collections import LineCollection

    stage, view = picture.stage, picture.view
    step = 10.0 ** np.floor(np.log10(stage.length / 2.0))
    right, up, back = stage.axes
    lowest = min(float(up @ stage.low), float(up @ stage.high)) - 0.02 * stage.length
    a, b, level = (right, up, 0.0 * up) if stage.scene.planar else (right, back, lowest * up)
    middle = level + sum(np.round(view.center @ axis / step) * step * axis for axis in (a, b))
    count = int(np.ceil(1.5 * stage.length / step))
    marks, reached = np.arange(-count, count + 1)[:, None] * step, count * step
    pairs = ((middle + marks * i, reached * j) for i, j in ((a, b), (b, a)))
    lines = [np.stack([mark - way, mark + way], axis=1) for mark, way in pairs]
    places = _clipped(view, np.concatenate(lines))
    picture.axes.add_collection(LineCollection(list(places), colors=GRID, linewidths=0.7, zorder=0.5), autolim=False)


def _clipped(view: View, lines: Floats) -> Floats:
    """Of lines (n, 2, 3) in perspective the pieces before the viewer."""
    if view.eye is None:
        return view.seen(lines)[0]
    parts = np.linspace(0.0, 1.0, 33)[:, None, None]
    points = lines[None, :, 0] + parts * (lines[None, :, 1] - lines[None, :, 0])
    places, depth, _ = view.seen(points)
    ahead = depth < 0.9 * float(np.linalg.norm(view.eye - view.center))
    pieces = np.stack([places[:-1], places[1:]], axis=2)
    return np.asarray(pieces[ahead[:-1] & ahead[1:]])
