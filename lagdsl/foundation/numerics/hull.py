"""The convex hull of points in a plane."""

from __future__ import annotations

from lagdsl.foundation.numerics.rank import Floats

_DIGITS = 12


def hull(points: Floats) -> list[int]:
    """Numbers of the corners of points (n, 2), counterclockwise, without those on an edge (A. M. Andrew, Information
    Processing Letters 9 (1979) 216). One of two equal points is taken; points on one line have two corners."""
    places = {(round(x, _DIGITS), round(y, _DIGITS)): k for k, (x, y) in reversed([*enumerate(points.tolist())])}
    ordered = sorted(places)
    chain: list[tuple[float, float]] = []
    for way in (ordered, ordered[::-1]):
        kept = len(chain)
        for x, y in way:
            while len(chain) - kept >= 2:
                (ax, ay), (bx, by) = chain[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0:
                    break
                chain.pop()
            chain.append((x, y))
        if len(ordered) > 1:
            chain.pop()
    return [places[corner] for corner in chain[: len(ordered)]]
