"""Where in a step something changes first."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from lagdsl.mechanics.rank import Floats

# Places inside a step at which it is looked whether something changed.
PLACES = (0.0, 0.25, 0.5, 0.75, 1.0)
# What comes and goes between them shows as a parabola whose vertex is this much nearer to zero than what was seen. So
# near to the beginning of the step, as a part of it, there are no vertices: there it is what has just happened.
_NEARER = 0.3
_BEGINNING = 0.01
# So often an interval is halved before nothing is left of it. At least this part of the other is no round-off.
_HALVINGS = 60
_ALIKE = 1e-6
# Roots that differ by less than so many roundings of time are one.
_TOGETHER = 8.0


class Look(NamedTuple):
    """What there is at a time: values that pass zero where something changes, and the indices of what is other than at
    the beginning of the step."""

    values: Floats
    changed: list[int]


def first_change(before: float, after: float, look: Callable[[float], Look]) -> tuple[float, list[int]] | None:
    """The earliest time in (before, after] at which something has changed, and all that changes there but for round-off
    of time. None where nothing changes."""
    found = earlier = _scan(before, after, look, PLACES)
    while earlier is not None:
        found = earlier
        late = found[0] - before > _BEGINNING * (after - before)
        earlier = _scan(before, found[0], look, PLACES[:-1]) if late else None  # what has changed back at the place
    return found


def _scan(
    before: float, after: float, look: Callable[[float], Look], places: tuple[float, ...]
) -> tuple[float, list[int]] | None:
    """The first change that shows at one of the places, or between them as a vertex."""
    times: list[float] = []
    seen: list[Look] = []
    for place in places:
        times.append(before + place * (after - before) if place < 1.0 else after)
        seen.append(look(times[-1]))
        if len(seen) > 2:
            vertex = _vertex(times[-3:], seen[-3:], before + _BEGINNING * (after - before), look)
            if vertex is not None:
                return _earliest(times[-3] if vertex[0] <= times[-2] else times[-2], *vertex, look)
        if len(seen) > 1 and seen[-1].changed:
            return _earliest(times[-2], times[-1], seen[-1], look)
    return None


def _vertex(
    times: list[float], seen: list[Look], first: float, look: Callable[[float], Look]
) -> tuple[float, Look] | None:
    """Where something has changed that is as ever at three equidistant times."""
    a, b, c = (each.values for each in seen)
    bend = a - 2.0 * b + c
    with np.errstate(all="ignore"):
        part = 0.5 * (a - c) / bend  # of the distance, from the middle
        height = b - 0.25 * (a - c) * part
    least = np.minimum(np.abs(a), np.minimum(np.abs(b), np.abs(c)))
    near = (
        (np.abs(part) < 1.0) & ((np.abs(height) < _NEARER * least) | (height * b < 0.0)) & (a * b > 0.0) & (b * c > 0.0)
    )
    for index in np.flatnonzero(near).tolist():
        time = times[1] + float(part[index]) * (times[2] - times[1])
        if first < time < times[2]:
            there = look(time)
            if index in there.changed:
                return time, there
    return None


def _earliest(left: float, right: float, seen: Look, look: Callable[[float], Look]) -> tuple[float, list[int]]:
    """The first root of all that has changed at `right`, and what changes there."""
    roots = [_root(index, left, right, look) for index in seen.changed]
    together = min(roots) + _TOGETHER * _rounding(left, right)
    return min(roots), [index for index, root in zip(seen.changed, roots, strict=True) if root <= together]


def _root(index: int, left: float, right: float, look: Callable[[float], Look]) -> float:
    """Where `index`, changed at `right`, changes. A value that is zero but for round-off at the left, as after an
    impact, tells nothing: the interval is halved until its ends have different signs and alike sizes."""
    from scipy.optimize import brentq

    low, high = float(look(left).values[index]), float(look(right).values[index])
    for _ in range(_HALVINGS):
        if low * high < 0.0 and abs(low) >= _ALIKE * abs(high):
            xtol = _rounding(left, right)
            root = float(brentq(lambda t: float(look(t).values[index]), left, right, xtol=xtol, rtol=9e-16))
            return root if abs(look(root).values[index]) <= _ALIKE * abs(low) else _behind(index, left, right, look)
        middle = 0.5 * (left + right)
        if not left < middle < right:
            break
        there = look(middle)
        if index in there.changed:
            right, high = middle, float(there.values[index])
        else:
            left, low = middle, float(there.values[index])
    return right


def _behind(index: int, left: float, right: float, look: Callable[[float], Look]) -> float:
    """The first time behind a jump of the value: before it nothing has changed yet."""
    while left < (middle := 0.5 * (left + right)) < right:
        if index in look(middle).changed:
            right = middle
        else:
            left = middle
    return right


def _rounding(left: float, right: float) -> float:
    return 4e-16 * max(abs(left), abs(right), right - left)
