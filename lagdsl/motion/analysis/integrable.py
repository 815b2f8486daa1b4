"""Rows of velocity level that are integrable: each stands for a position that keeps its value.

A set of rows w_i = a_i dq + b_i dt is integrable if dw_i(V, W) = 0 for all V, W that all rows of the set allow
(Frobenius). Rows that fail are taken out until the set stands. Derivatives are those of the program.
"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.names import balance_rows
from lagdsl.derivation.structure.points import Probe, geometry, probes
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.motion.analysis.point import Directions, Point, System, constraint_changes, coordinate_sizes

_CLOSED = 1e-9


def integrable_rows(system: System, point: Point) -> list[int]:
    """Indices of the integrable rows of velocity level, at general points of the constraint set. Balances of forces are
    none: what they move approaches its place at rates of its own."""
    layout = system.engine.layout
    if all(layout.position_level):
        return []
    space = geometry(system.flat, system.engine, point.p)
    places = probes(system.flat, space, space.position_rows)
    moving = balance_rows(system.flat)
    found = [
        row
        for row, level in enumerate(layout.position_level)
        if not level and not layout.redundant[row] and row not in moving
    ]
    curls = [_curls(system, point, place, found) for place in places]
    forms = [_forms(system, point, place) for place in places]
    while found:
        rows = [*space.position_rows, *found]
        failing = [row for row in found if not all(_closed(f, c[row], rows) for f, c in zip(forms, curls, strict=True))]
        if not failing:
            break
        found = [row for row in found if row not in failing]
    return found


def _closed(forms: Floats, curl: Floats, rows: list[int]) -> bool:
    free = null_space(forms[rows])
    size = max(float(np.linalg.norm(curl)), float(np.max(np.abs(forms[rows]), initial=0.0)))
    return bool(np.max(np.abs(free.T @ curl @ free), initial=0.0) <= _CLOSED * size)


def _scale(system: System, point: Point) -> Floats:
    return np.append(coordinate_sizes(system, point.p), 1.0)


def _forms(system: System, point: Point, place: Probe) -> Floats:
    """Rows (a, b) of a dq + b dt, shape (nc, nq + 1), in natural sizes."""
    rest = (point.z, point.u, point.w, point.p)
    b, a = system.engine.evaluate("velocity_constraint", point.t, place.q, np.zeros_like(place.q), *rest)
    return np.hstack([a, b[:, None]]) * _scale(system, point)


def _curls(system: System, point: Point, place: Probe, rows: list[int]) -> dict[int, Floats]:
    """dw(e_k, e_l) of each row, shape (nq + 1, nq + 1), in natural sizes; the last axis is time."""
    n = len(place.q)
    count = len(system.engine.layout.constraints)
    rest = (point.z, point.u, point.w, point.p)
    gradient = np.zeros((n + 1, n + 1, count))  # d(component l)/d(variable k) of every row
    fields = np.vstack([np.eye(n), np.zeros((1, n))])  # a_l + b and, last, b
    for component, rates in enumerate(fields):
        at = Point(t=point.t, q=place.q, qd=rates, z=point.z, u=point.u, w=point.w, p=point.p)
        unit = np.eye(n)
        along = Directions(q=unit, qd=np.zeros((n, n)), z=np.zeros((n, len(point.z))), u=np.zeros((n, len(point.u))))
        change = constraint_changes(system, at, along)[1]
        gradient[:n, component] = change
        # gamma = -(dc/dq qd + dc/dt)
        gamma = system.engine.evaluate("dynamics", point.t, place.q, rates, *rest)[3]
        gradient[n, component] = -gamma - rates @ change
    gradient[:, :n] -= gradient[:, n:]
    scale = _scale(system, point)
    curl = (gradient - gradient.transpose(1, 0, 2)) * scale[:, None, None] * scale[:, None]
    return {row: curl[:, :, row] for row in rows}
