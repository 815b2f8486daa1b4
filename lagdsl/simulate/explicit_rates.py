"""Written start rates beside each other: those of quaternions at positions that have moved, and contradictions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.model import Coordinate
from lagdsl.numerics.rank import Floats
from lagdsl.runtime.run import Run
from lagdsl.runtime.run_view import Found
from lagdsl.signals.moved import NOTICED, Starts

# Shares of rows in a rate, in natural sizes, below which they have none.
_SHARE = 1e-6


def turned_rates(starts: Floats, x: Floats, first: NDArray[np.intp], count: int) -> Floats:
    """Start values (2 nq + nz,) with the rates of the quaternions that begin at coordinates `first`: they belong to the
    same angular velocities in own axes at the positions in x. `count` is nq."""
    found = starts.copy()
    for place in first.tolist():
        before, now = starts[place : place + 4], x[place : place + 4]
        rates = slice(count + place, count + place + 4)
        if not np.array_equal(before, now):
            inverse = before * [1.0, -1.0, -1.0, -1.0] / (before @ before)
            found[rates] = _product(now, _product(inverse, starts[rates]))
    return found


def _product(a: Floats, b: Floats) -> Floats:
    """Hamilton's product, scalar first."""
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.array([scalar, *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])


def report_contradictions(starts: Starts, run: Run, t: float, found: Found, sink: Sink) -> None:
    """E0887 for written rates that are not held because others that were written are."""
    n, rows = starts.count, len(found.row_sizes)
    rates = slice(n, 2 * n)
    wanted, x, sizes = starts.x[rates], found.x[rates], starts.sizes[rates]
    fixed = starts.fixed[rates]
    written = starts.written[rates] & ~fixed
    moved = written & (np.abs(x - wanted) > NOTICED * np.maximum(np.abs(wanted), sizes))
    if not moved.any():
        return
    jacobian = run.evaluate("velocity_constraint", t, found.x, rows * (1 + n))[rows:].reshape(rows, n)
    unit = np.eye(n)
    held = np.flatnonzero(written & ~moved)
    basis = np.vstack([jacobian * sizes / found.row_sizes[:, None], unit[fixed], unit[held]])
    told: set[tuple[int, int]] = set()
    for j in np.flatnonzero(moved).tolist():
        shares = np.linalg.lstsq(basis.T, unit[j], rcond=None)[0]
        part = np.abs(shares[len(basis) - len(held) :])
        others = held[part > _SHARE]
        if not len(others) or np.abs(basis.T @ shares - unit[j]).max() > _SHARE:
            continue
        other = int(held[int(np.argmax(part))])
        first, second = (starts.flat.coordinates[place] for place in (other, j))
        pair = (id(first.rate_start_span), id(second.rate_start_span))
        if pair not in told:
            told.add(pair)
            _report(first, second, sink)


def _report(first: Coordinate, second: Coordinate, sink: Sink) -> None:
    spans = [each.rate_start_span or (each.spans[0] if each.spans else None) for each in (first, second)]
    labels = [Label(spans[0], "the other start rate")] if spans[0] is not None else []
    sink.report("E0887", spans[1], *labels, name=f"der({second.name})", other=f"der({first.name})")
