"""Events that crowd towards an instant, so that time does not get beyond it (Zeno)."""

from __future__ import annotations

# So many intervals in a row, each shorter than the one before, down to this part of the first.
_MANY, _PART = 20, 1e-6
# So many events at times that are the same but for round-off.
_SAME, _ROUNDING = 100, 1e-14


class Accumulation:
    """Watches the times of events that are located; clocks do not crowd, and contacts close when they do."""

    def __init__(self) -> None:
        self._last = -float("inf")
        self._first = self._interval = float("inf")
        self._shrinking = self._still = 0

    def reached(self, t: float, relations: bool) -> bool:
        """Whether the event at t, of `relations` or of contacts only, is one too many."""
        interval = t - self._last
        if relations and self._interval < float("inf") and interval < self._interval:
            self._shrinking += 1
        else:
            self._first, self._shrinking = interval, 1
        self._still = self._still + 1 if interval <= _ROUNDING * abs(t) else 0
        self._last, self._interval = t, interval
        crowded = self._shrinking > _MANY and interval < _PART * self._first
        return crowded or self._still > _SAME
