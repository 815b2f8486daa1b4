"""From space to the picture: planar machines square on, spatial ones in perspective, always
whole. The view may go with a machine that drives away, as on the living page."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from lagdsl.derivation.scene.shapes import ShapeKind
from lagdsl.derivation.scene.stage import Stage, places_of
from lagdsl.documents.plot.picture.shapes import GAUGES, Faces, parts_of
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_MARGIN = 0.07
_ROWS = 24
_ENDLESS: tuple[ShapeKind, ...] = ("ground", "rail", "track", "trace")
# Of a picture: height over width. It is neither a strip nor a pillar.
_LOWEST, _HIGHEST = 0.45, 1.25


@record(kw_only=True)
class View:
    """`turn` (3, 3) has the directions right, up and towards the viewer as rows; `eye` [m], none from infinitely far.

    `low` and `high` (2,) bound the picture in projected units.
    """

    turn: Floats
    eye: Floats | None
    center: Floats
    low: Floats
    high: Floats

    def seen(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Points (..., 3) as places (..., 2), depths (...,), larger ones in front, and magnifications (...,)."""
        own = (points - self.center) @ self.turn.T
        if self.eye is None:
            return own[..., :2], own[..., 2], np.ones(own.shape[:-1])
        away = float(np.linalg.norm(self.eye - self.center))
        scale = away / np.maximum(away - own[..., 2], 0.05 * away)
        return own[..., :2] * scale[..., None], own[..., 2], scale

    def beside(self, step: Floats) -> View:
        """The same view from a place that is `step` (3,) [m] further."""
        return replace(self, center=self.center + step, eye=None if self.eye is None else self.eye + step)


def steps_of(stage: Stage) -> Floats:
    """Steps (rows, 3) [m] from the middle of the whole way to the machine."""
    places = [places_of(stage.scene, row[None, :]) for row in stage.rows]
    return np.array([(each.min(axis=0) + each.max(axis=0)) / 2.0 for each in places]) - stage.center


def view_of(stage: Stage, steps: Floats | None = None) -> View:
    """The picture that holds the whole motion, or with `steps` (rows, 3) [m] that of a machine that it goes with."""
    every = _solid(stage, steps)
    if not len(every):
        every = stage.points
    turn, eye = stage.turn, None
    if not stage.scene.planar:
        size = float(np.linalg.norm(np.ptp(every, axis=0) if steps is not None else stage.high - stage.low))
        eye = stage.center + 1.75 * max(size, 0.5 * stage.length if steps is None else 0.0) * turn[2]
    whole = View(turn=turn, eye=eye, center=stage.center, low=np.zeros(2), high=np.zeros(2))
    places = whole.seen(every)[0]
    margin = _MARGIN * (stage.length if steps is None else float(np.linalg.norm(np.ptp(every, axis=0))))
    low, high = places.min(axis=0) - margin, places.max(axis=0) + margin
    width, height = high - low
    more = np.array([max(height / _HIGHEST - width, 0.0), max(_LOWEST * width - height, 0.0)]) / 2.0
    return replace(whole, low=low - more, high=high + more)


def _solid(stage: Stage, steps: Floats | None) -> Floats:
    """Corners (n, 3) of everything at some rows, and the places of traces; the ground may reach beyond the picture, and
    gauges do not go with the machine."""
    found = [np.zeros((0, 3))]
    without = (*_ENDLESS, *(() if steps is None else GAUGES))
    for row in np.unique(np.linspace(0, len(stage.rows) - 1, _ROWS).round().astype(int)).tolist():
        parts = parts_of(stage, row, without=without)
        own = [part.corners.reshape(-1, 3) if isinstance(part, Faces) else part.at[None, :] for part in parts]
        found += own if steps is None else [points - steps[row] for points in own]
    shapes = (shape for shape in stage.scene.shapes if shape.kind != "frame")
    placed = any(role in ("at", "to") for shape in shapes for role in shape.numbers)
    return np.concatenate([*found, stage.points] if placed and steps is None else found)
