"""What time alone changes, in runs by NumPy: the next change is computed where it is affine, else looked for.

Momenta are not balanced here: the C runtime does that.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.right_hand_side import RightHandSide

_ULPS = 16.0
_PARTS, _HALVES = 512, 60


class TimeEvents:
    """The entries of kind `timed` of w."""

    def __init__(self, system: RightHandSide, span: tuple[float, float]) -> None:
        self._system, self._span = system, span
        kinds = system.engine.layout.kinds
        self.entries = np.array([k for k, kind in enumerate(kinds) if kind == "timed"], dtype=np.intp)
        self.next = np.inf

    def changed(self, t: float, w: Floats) -> Floats:
        """w just behind t."""
        if len(self.entries):
            w = w.copy()
            w[self.entries] = self._look(t + self._near(t), w)[0]
        return w

    def seek(self, t: float, w: Floats) -> None:
        """Finds the time `next` of the next change."""
        self.next = np.inf
        if not len(self.entries):
            return
        _, _, distance, rate, affine, _, _ = self._look(t, w)
        for i, slope in enumerate(rate):
            if affine[i] and np.isfinite(slope):
                self.next = min(self.next, max(t, t - distance[i] / slope)) if slope < 0.0 else self.next
        if not np.all(affine) or not np.all(np.isfinite(rate)):
            self._search(t, w)

    def _search(self, t: float, w: Floats) -> None:
        begin = t + self._near(t)
        times = np.linspace(begin, max(begin, min(self.next, self._span[1])), _PARTS)
        inside = self._inside(begin, w)
        for a, b in pairwise(times.tolist()):
            if self._inside(b, w) != inside:
                self.next = min(self.next, self._change(a, b, w))
                return

    def _change(self, a: float, b: float, w: Floats) -> float:
        inside = self._inside(a, w)
        for _ in range(_HALVES):
            middle = 0.5 * (a + b)
            a, b = (middle, b) if self._inside(middle, w) == inside else (a, middle)
        return b

    def _inside(self, t: float, w: Floats) -> bool:
        return bool(np.all(self._look(t, w)[2] > 0.0))

    def _look(self, t: float, w: Floats) -> tuple[Floats, ...]:
        return self._system.engine.evaluate("time_event", t, w, self._system.p)

    def _near(self, t: float) -> float:
        return _ULPS * float(np.finfo(float).eps) * max(abs(t), self._span[1] - self._span[0])
