"""From the one tolerance of the user to absolute tolerances of every component.

A component is as accurate as `tolerance` times its scale. The scale is the largest magnitude seen so far among the
components of the same kind (coordinates of one dimension, their rates, one state), at least 1e-4 of the natural
size, and for angles at most 1: an angle that has turned a thousand times still enters through its sine. Relative
error control of single components would waste steps where one of them passes through zero.
"""

from __future__ import annotations

import numpy as np

from lagdsl.flat.model import FlatModel
from lagdsl.mechanics.rank import Floats

_FLOOR = 1e-4
_ROUNDING = 1e-15


class Accuracy:
    """Absolute tolerances that follow the motion. `groups`, `sizes` and `caps` are those of every component."""

    def __init__(self, flat: FlatModel, sizes: Floats, relative: float) -> None:
        n = len(flat.coordinates)
        kinds: dict[object, int] = {}
        groups = [kinds.setdefault(c.dimension, len(kinds)) for c in flat.coordinates]
        first = len(kinds)
        self.groups = np.array(
            [*groups, *(g + first for g in groups), *range(2 * first, 2 * first + len(flat.states))], dtype=int
        )
        state_sizes = np.array([abs(s.nominal) if s.nominal else 1.0 for s in flat.states])
        self.sizes = np.concatenate([sizes, sizes, state_sizes])
        angles = np.array([c.dimension.is_dimensionless for c in flat.coordinates], dtype=bool)
        self.caps = np.concatenate([np.where(angles, 1.0, np.inf), np.full(n + len(flat.states), np.inf)])
        self._largest = np.zeros(2 * first + len(flat.states))
        self.relative = relative

    def after(self, y: Floats) -> Floats:
        """Absolute tolerances (2 nq + nz,) now that state `y` was reached."""
        np.maximum.at(self._largest, self.groups, np.abs(y))
        floor = _FLOOR * self.sizes
        scale = np.clip(self._largest[self.groups], floor, np.maximum(self.caps, floor))
        return np.asarray(np.maximum(self.relative * scale, _ROUNDING * self.sizes))
