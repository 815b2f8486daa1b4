"""Where in a step something changes first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scipy.optimize import brentq

# Places inside a step at which it is looked whether something changed: what changes and changes back within a quarter
# of a step is missed.
PLACES = (0.25, 0.5, 0.75, 1.0)
# So often an interval is halved before nothing is left of it.
_HALVINGS = 60
# At least this part of the other is no round-off.
_ALIKE = 1e-6
# Roots that differ by less than so many roundings of time are one.
_TOGETHER = 8.0

Changed = Callable[[float], Sequence[int]]
Value = Callable[[int, float], float]


def first_change(before: float, after: float, changed: Changed, value: Value) -> tuple[float, list[int]] | None:
    """The earliest time in (before, after] at which something has changed, and all that has changed then.

    `changed(t)` are the indices of what is other than at the beginning, `value(index, t)` passes zero there. None where
    nothing changes.
    """
    left = before
    for place in PLACES:
        right = before + place * (after - before) if place < 1.0 else after
        found = changed(right)
        if found:
            return _earliest(left, right, list(found), changed, value)
        left = right
    return None


def _earliest(left: float, right: float, indices: list[int], changed: Changed, value: Value) -> tuple[float, list[int]]:
    """The first root of all that changed, and what changed there, but for round-off of time."""
    roots = [_root(index, left, right, changed, value) for index in indices]
    together = min(roots) + _TOGETHER * _rounding(left, right)
    return min(roots), [index for index, root in zip(indices, roots, strict=True) if root <= together]


def _root(index: int, left: float, right: float, changed: Changed, value: Value) -> float:
    """Where `index`, changed at `right`, changes. A value that is zero but for round-off at the left, as after an
    impact, tells nothing: the interval is halved until its ends have different signs and alike sizes."""
    low, high = value(index, left), value(index, right)
    for _ in range(_HALVINGS):
        if low * high < 0.0 and abs(low) >= _ALIKE * abs(high):
            return float(brentq(lambda t: value(index, t), left, right, xtol=_rounding(left, right), rtol=9e-16))
        middle = 0.5 * (left + right)
        if not left < middle < right:
            break
        if index in changed(middle):
            right, high = middle, value(index, middle)
        else:
            left, low = middle, value(index, middle)
    return right


def _rounding(left: float, right: float) -> float:
    return 4e-16 * max(abs(left), abs(right), right - left)
