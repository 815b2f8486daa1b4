"""Where in a step something changes first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

# Places inside a step at which it is looked whether something changed: what changes and changes back within a quarter
# of a step is missed.
PLACES = (0.25, 0.5, 0.75, 1.0)


def first_change(
    before: float, after: float, changed: Callable[[float], Sequence[int]], value: Callable[[int, float], float]
) -> tuple[float, list[int]] | None:
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


def _earliest(
    left: float,
    right: float,
    indices: list[int],
    changed: Callable[[float], Sequence[int]],
    value: Callable[[int, float], float],
) -> tuple[float, list[int]]:
    """Roots of all that changed; what else changed at the first of them belongs to it."""
    times = [_root(left, right, lambda t, index=index: value(index, t)) for index in indices]  # type: ignore[misc]
    time = min(times)
    spacing = 4.0 * max(abs(time), right - left) * 2.0**-52
    for _ in range(60):
        found = list(changed(min(time, right)))
        if found:
            return min(time, right), found
        time += spacing
        spacing *= 2.0
    return right, indices


def _root(left: float, right: float, function: Callable[[float], float]) -> float:
    from scipy.optimize import brentq

    low, high = function(left), function(right)
    if not low * high < 0.0:
        return left if abs(low) <= abs(high) else right
    return float(brentq(function, left, right, xtol=4e-16 * max(abs(left), abs(right), right - left), rtol=9e-16))
