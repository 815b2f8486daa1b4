"""Written start rates beside each other: those of quaternions at positions that have moved, and contradictions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_view import Found
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import Coordinate
from lagdsl.motion.signals.moved import NOTICED, Starts

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
            inverse = before * [1.0, -1.0, -1.0, -1.0] / np.sqrt(before @ before)  # rates are written for the unit one
            found[rates] = _product(now, _product(inverse, starts[rates]))
    return found


def _product(a: Floats, b: Floats) -> Floats:
    """Hamilton's product, scalar first."""
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.array([scalar, *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])


def report_contradictions(starts: Starts, run: Run, t: float, found: Found, sink: Sink) -> None:
    """E0887 for written rates that are not held because another one that was written determines them. Of more than two
    that the constraints do not allow together the nearest ones are taken, and told as moved."""
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
        second = starts.flat.coordinates[j]
        others = [starts.flat.coordinates[i] for i in held[part > _SHARE]]
        others = [each for each in others if not _is_one_statement(each, second)]
        if np.abs(basis.T @ shares - unit[j]).max() > _SHARE or not others:
            continue
        if not all(_is_one_statement(others[0], each) for each in others):
            continue
        first = others[0]
        pair = (id(first.rate_start_span), id(second.rate_start_span))
        if pair not in told:
            told.add(pair)
            _report(first, second, sink)


def _is_one_statement(first: Coordinate, second: Coordinate) -> bool:
    return first is second or (first.rate_start_span is not None and first.rate_start_span == second.rate_start_span)


def _report(first: Coordinate, second: Coordinate, sink: Sink) -> None:
    spans = [each.rate_start_span or (each.spans[0] if each.spans else None) for each in (first, second)]
    labels = [Label(spans[0], "the other start rate")] if spans[0] is not None else []
    sink.report("E0887", spans[1], *labels, name=f"der({second.name})", other=f"der({first.name})")
