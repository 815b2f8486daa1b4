"""From space to the picture: planar machines square on, spatial ones in perspective, always whole."""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.stage import TILT, Stage
from lagdsl.documents.plot.picture.faces import Faces, Ribbon
from lagdsl.documents.plot.picture.gauges import reach
from lagdsl.documents.plot.picture.shapes import parts_of
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_MARGIN = 0.07
_ROWS = 24
# Of a picture: height over width.
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


def view_of(stage: Stage) -> View:
    """The picture that holds the whole motion."""
    right, up, back = stage.axes
    every = np.concatenate([_solid(stage), reach(stage)])
    if not len(every):
        every = stage.points
    if stage.scene.planar:
        turn, eye = np.array([right, up, back]), None
    else:
        towards = back + TILT * up
        towards /= np.linalg.norm(towards)
        turn = np.array([right, np.cross(towards, right), towards])
        far = max(float(np.linalg.norm(stage.high - stage.low)), 0.5 * stage.length) * 1.75
        eye = stage.center + far * towards
    whole = View(turn=turn, eye=eye, center=stage.center, low=np.zeros(2), high=np.zeros(2))
    places = whole.seen(every)[0]
    margin = _MARGIN * stage.length
    low, high = places.min(axis=0) - margin, places.max(axis=0) + margin
    return View(turn=turn, eye=eye, center=stage.center, **_widened(low, high))


def _solid(stage: Stage) -> Floats:
    """Corners (n, 3) of everything at some rows, and the places of traces; the ground may reach beyond the picture."""
    rows = np.unique(np.linspace(0, len(stage.rows) - 1, _ROWS).round().astype(int))
    parts = [
        part for row in rows.tolist() for part in parts_of(stage, row, without=("ground", "rail", "track", "trace"))
    ]
    found = [part.corners.reshape(-1, 3) for part in parts if isinstance(part, Faces)]
    found += [part.points for part in parts if isinstance(part, Ribbon)]
    placed = any(
        role in ("at", "to") for shape in stage.scene.shapes for role, _ in shape.numbers if shape.kind != "frame"
    )
    return np.concatenate([*found, stage.points] if placed else [np.zeros((0, 3))])


def _widened(low: Floats, high: Floats) -> dict[str, Floats]:
    """To a picture that is neither a strip nor a pillar."""
    width, height = high - low
    more = np.array([max(height / _HIGHEST - width, 0.0), max(_LOWEST * width - height, 0.0)]) / 2.0
    return {"low": low - more, "high": high + more}
