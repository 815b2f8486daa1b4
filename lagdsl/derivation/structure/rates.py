"""Constraints of velocity level: are they linear in the rates, and are they holonomic ones in disguise?"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.names import located, place
from lagdsl.derivation.structure.points import Geometry, Probe, random_rates
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.model import FlatModel


def report_nonlinear(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> bool:
    """E0604 for velocity constraints that are not linear in the rates: r(v + w) = r(v) + r(w) - r(0) must hold."""
    found = False
    for point in points[:1]:
        v, w = random_rates(flat.coordinates, space.sizes, 2)
        at = [space.velocity(point.q, rates)[0] for rates in (v + w, v, w, np.zeros_like(v))]
        # A row without content is zero but for round-off of the size of its neighbours.
        size = np.maximum.reduce([np.abs(values) for values in at])
        size = np.maximum(size, 1e-3 * np.max(size, initial=0.0))
        curved = np.abs(at[0] - at[1] - at[2] + at[3]) > 1e-9 * size
        for item in located(flat):
            if item.constraint.level == "velocity" and any(curved[row] for row in item.rows):
                sink.report("E0604", place(item.constraint), name=item.constraint.name)
                found = True
    return found


def report_integrable(
    flat: FlatModel, space: Geometry, points: list[Probe], redundant: tuple[bool, ...], sink: Sink
) -> None:
    """N0606 for velocity rows a(q, t).dq + b(q, t) dt = 0 that are integrable.

    Frobenius' theorem: da(v, w) vanishes for all v, w in the null space of the row itself and the holonomic ones.
    Tested in (q, t) at the probed points, derivatives by central differences.
    """
    for item in located(flat):
        if item.constraint.level != "velocity" or item.constraint.node:  # Kirchhoff's law is known to be
            continue
        if balanced(item.constraint):  # nobody wrote it
            continue
        if item.constraint.switched:  # it may be there at some times only
            continue
        if item.constraint.spans and item.constraint.spans[0].file is not item.constraint.spans[-1].file:
            continue  # the text of a library: not the user's to restate
        rows = [row for row in item.rows if not redundant[row]]
        if rows and points and all(_closed(space, point.q, row) for point in points for row in rows):
            sink.report("N0606", place(item.constraint), name=item.constraint.name)


def _closed(space: Geometry, q: Floats, row: int) -> bool:
    forms = _forms(space, q, space.t)
    n = len(q) + 1
    sizes = np.append(space.sizes, 1.0)
    gradient = np.zeros((n, n))
    for k in range(n):
        step = 1e-5 * sizes[k]
        ahead, behind = (_shifted(space, q, k, sign * step)[row] for sign in (1.0, -1.0))
        gradient[:, k] = (ahead - behind) / (2.0 * step)
    curl = (gradient - gradient.T) * sizes[:, None] * sizes
    free = null_space(forms[[*space.position_rows, row]] * sizes)
    size = max(float(np.linalg.norm(gradient * sizes[:, None] * sizes)), float(np.linalg.norm(forms[row] * sizes)))
    return bool(np.max(np.abs(free.T @ curl @ free), initial=0.0) <= 1e-7 * size)


def _shifted(space: Geometry, q: Floats, k: int, step: float) -> Floats:
    if k == len(q):
        return _forms(space, q, space.t + step)
    moved = q.copy()
    moved[k] += step
    return _forms(space, moved, space.t)


def _forms(space: Geometry, q: Floats, t: float) -> Floats:
    """Rows (a, b) of a.dq + b dt, shape (nc, nq + 1)."""
    b, a = space.functions.evaluate("velocity_constraint", t, q, np.zeros_like(q), space.z, space.u, space.w, space.p)
    return np.hstack([a, b[:, None]])
