"""The parts of a scene at their places at one row of a motion: one placement for pictures, films and figures.

`web/src/shapes.ts` of the page has its counterpart, for motions that are integrated there.
"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.scene.forms import coil
from lagdsl.derivation.scene.shapes import UPRIGHT, Part, Size, Value, axes_along
from lagdsl.derivation.scene.stage import Stage
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record

_SHORTEST = 1e-6
"""Of the machine: nothing is seen of a shorter arrow."""


@record()
class Posed:
    """A part at row `row` of the motion of a stage."""

    stage: Stage
    part: Part
    row: int

    def is_seen(self) -> bool:
        """Has it a place, and its axis a length?"""
        values = [np.ravel(self.value(each)) for each in self.part.read() if not isinstance(each, tuple)]
        if not np.isfinite(np.concatenate([np.zeros(0), *values])).all():
            return False
        return "at" not in self.part.numbers or self._shown() > (
            _SHORTEST * self.stage.length if self.part.scale else 0.0
        )

    def _shown(self) -> float:
        """The length of the axis, in the picture if it has another unit."""
        return float(np.linalg.norm(self.way())) * (self.stage.scales[self.part.scale] if self.part.scale else 1.0)

    def way(self) -> Floats:
        """The axis: to the other end, along z."""
        if "to" in self.part.numbers:
            return np.asarray(self.vector("to") - self.vector("at"))
        return self.vector("z") if "z" in self.part.numbers else UPRIGHT

    def value(self, value: Value) -> Floats:
        return self.stage.scene.values(self.stage.rows[self.row], value)

    def vector(self, role: str) -> Floats:
        own = self.value(self.part.numbers[role])
        if self.part.board is None:
            return own
        return np.asarray(self.stage.boards[self.part.board][:3] @ [*own, float(role in ("at", "to"))])

    def size(self, size: Size) -> float:
        value = 1.0 if size.value is None else float(self.value(size.value))
        return size.factor * value * (self.stage.length if size.relative else 1.0)

    def matrix(self) -> Floats:
        """The transformation (4, 4) of the unit form."""
        part, at, way = self.part, self.vector("at"), self.way()
        sizes = [self.size(size) for size in part.sizes]
        if part.scale:
            sizes = [own if size.relative else own * self._shown() for own, size in zip(sizes, part.sizes, strict=True)]
        elif "to" in self.part.numbers:
            sizes[2] = self._shown()
        x, y, z = axes_along(way, self.vector("x") if "x" in self.part.numbers else None)
        if part.still:
            at = self._beside(at, z, x if "x" in self.part.numbers else None)
        return matrix_of(x * sizes[0], y * sizes[1], z * sizes[2], at + part.offset * self.stage.length * z)

    def _beside(self, at: Floats, z: Floats, x: Floats | None) -> Floats:
        """The place of the plane, or of the line along x in it, that is nearest to the middle of the machine."""
        away = self.stage.center - at
        return np.asarray(at + (away - (away @ z) * z if x is None else (away @ x) * x))

    def line(self) -> Floats:
        """Points (n, 3)."""
        return placed(coil(), self.matrix()) if self.part.form == "coil" else self.value(self.part.points)


def placed(unit: Floats, matrix: Floats) -> Floats:
    """Corners or points (..., 3) of a unit body through a transformation (4, 4)."""
    return np.asarray(unit @ matrix[:3, :3].T + matrix[:3, 3])


def matrix_of(x: Floats, y: Floats, z: Floats, at: Floats) -> Floats:
    """The transformation (4, 4) with these axes and this origin."""
    made = np.eye(4)
    made[:3, 0], made[:3, 1], made[:3, 2], made[:3, 3] = x, y, z, at
    return made
