"""Do the constraints determine forces where they hold?

A row such as (x - l)^2 = 0 holds where x = l, and its gradient vanishes there: it restricts the motion, and no
multiplier can enforce it. Two circles that touch do the same together. Both are seen from the values about a point of
the constraint set: they are not those that the gradient foretells, or they lead back to the point itself.
Source of the condition that such rows violate (the Jacobian has full rank on the set): Haug, Computer Aided Kinematics
and Dynamics of Mechanical Systems, section 3.4.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np

from lagdsl.derivation.structure.names import (
    Located,
    comes_and_goes,
    configuration,
    grammatical_subject,
    listed,
    located,
    place,
)
from lagdsl.derivation.structure.points import HOLDS, SEED, Geometry, Probe
from lagdsl.derivation.structure.restated import restated
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import Flags, entries
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.reached import switch

# Distances, in natural sizes, at which the values about a point are compared with its gradient. A row that bends
# within the smaller one is none that a time step could follow.
_NEAR = (1e-3, 1e-4)
# A part of the value about a point that the gradient leaves unexplained only if it explains nothing: the gradient of a
# square explains half at most.
_UNEXPLAINED = 0.25
# The same for rows with branches: gradients on two sides may differ by a factor, as long as both lead the same way.
_UNEXPLAINED_BRANCH = 0.9
_DIRECTIONS = 2
_STARTS = 3
_ASIDE = 0.1
# Singular values below this, as a part of the largest, belong to rows that nearly depend on each other; where
# constraints touch, they are as large as the way to the point itself, the root of the residual.
_NEARLY_DEPENDENT = 1e-4
_WAY = 3.0
# A step along the tangent comes back by the square of its length; where it is a step into nowhere, by a part of it.
_STEPS = (1e-2, 1e-3)
_LOST = 0.02
_MOST_NAMED = 3

# Distances at which a row that is zero about a point is looked for elsewhere.
_FAR = (0.3, 1.0, 3.0, 10.0)

_Fault: TypeAlias = Literal["vanishes", "corner", "none", "slack"]


def report_degenerate(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> bool:
    """E0609 for rows whose gradient vanishes, jumps or does not exist wherever they hold; E0610 for constraints that
    touch. True if there are any."""
    rows = space.position_rows
    if not rows:
        return False
    bases = [point.q for point in points] or [space.project(space.q, rows).point]
    parts, tied = _unexplained(flat), space.pattern.counts()
    suspected = np.logical_and.reduce([_unforetold(space, base, parts) for base in bases])
    slack = np.logical_or.reduce([_slack(space, base) for base in bases])
    found = False
    for item in located(flat):
        constraint = item.constraint
        if constraint.level != "position" or constraint.contact or constraint.closure is not None:
            continue
        for index, row in enumerate(item.rows):
            off = bool(slack[row]) and switch(constraint.residuals[index]) is not None
            if off or not (suspected[row] or slack[row]) or not tied[row]:
                continue
            fault: _Fault | None = "slack" if slack[row] else _fault(space, bases[-1], row, parts)
            if fault is not None and not _follows(space, bases[-1], row, rows):
                rewrite = restated(constraint.residuals[index], constraint.dimension)
                sink.report(
                    "E0609",
                    place(constraint),
                    help=_CONTACT if slack[row] else f"write {rewrite}" if rewrite else None,
                    name=constraint.rows[index],
                    fault=_WORDS[fault],
                )
                found = True
    return found or _report_touching(flat, space, points, sink)


_WORDS: dict[_Fault, str] = {
    "vanishes": "vanishes wherever the constraint holds",
    "corner": "jumps wherever the constraint holds",
    "none": "does not exist where the constraint holds",
    "slack": "vanishes in a whole region where the constraint holds",
}
_CONTACT = (
    "write what must not be exceeded as a contact, `contact c: x <= l with restitution = 0`, not as `max(x - l, 0) = 0`"
)


def _unexplained(flat: FlatModel) -> Floats:
    """Parts (nc,) of changes that gradients may leave unexplained."""
    return np.array(
        [_UNEXPLAINED_BRANCH if item.constraint.switched else _UNEXPLAINED for item in located(flat) for _ in item.rows]
    )


def _unforetold(space: Geometry, base: Floats, parts: Floats) -> Flags:
    """The rows whose values about `base` are not those that J there foretells, at every distance."""
    phi, jacobian = space.position(base)
    result = np.ones(len(phi), dtype=np.bool_)
    generator = np.random.default_rng(SEED)
    for distance in _NEAR:
        unlike = np.zeros(len(phi), dtype=np.bool_)
        for _ in range(_DIRECTIONS):
            direction = generator.standard_normal(len(base))
            direction /= max(float(np.max(np.abs(direction))), 1e-3)
            step = distance * space.sizes * direction
            with np.errstate(invalid="ignore"):
                ahead = jacobian @ step
            for sign in (1.0, -1.0):
                change = space.residuals(base + sign * step) - phi
                with np.errstate(invalid="ignore"):
                    foretold = sign * ahead
                    unlike |= ~(np.abs(change - foretold) <= parts * np.maximum(np.abs(change), np.abs(foretold)))
        result &= unlike
    return result


def _slack(space: Geometry, base: Floats) -> Flags:
    """The rows that are zero in a neighborhood of a point about `base`, and not everywhere."""
    generator = np.random.default_rng(SEED + 3)
    steps = space.sizes * generator.standard_normal((_DIRECTIONS, len(base)))
    around = np.concatenate([steps, -steps])
    points = [base, *(base + far * step for far in _FAR for step in around)]
    looked = [space.residuals(point) for point in points]
    somewhere = np.logical_or.reduce([np.abs(phi) > 0.0 for phi in looked])
    result: Flags = np.zeros(len(looked[0]), dtype=np.bool_)
    for point, phi in zip(points, looked, strict=True):
        still = somewhere & (phi == 0.0)
        if np.any(still):
            still &= space.position(point)[1].nonzero().counts() == 0
        for near in _NEAR if np.any(still) else ():
            still &= np.logical_and.reduce([space.residuals(point + near * step) == 0.0 for step in around])
        result |= still
    return result


def _fault(space: Geometry, base: Floats, row: int, parts: Floats) -> _Fault | None:
    """Fault of the gradient of `row` on its own set; None if it is as it should be anywhere there."""
    alone = space.only([row])
    generator = np.random.default_rng(SEED + 1)
    fault: _Fault | None = None
    for _ in range(_STARTS):
        aside = base + _ASIDE * space.sizes * generator.standard_normal(len(base))
        reached = alone.project(aside, [row])
        if reached.size > HOLDS:
            continue
        if not _unforetold(alone, reached.point, parts)[row]:
            return None
        fault = _kind(alone, reached.point, row)
    return fault


def _follows(space: Geometry, base: Floats, row: int, rows: list[int]) -> bool:
    """True if `row` holds wherever the other rows do, as one of three components of a unit vector."""
    others = [other for other in rows if other != row]
    generator = np.random.default_rng(SEED + 2)
    for _ in range(_STARTS if others else 0):
        aside = base + _ASIDE * space.sizes * generator.standard_normal(len(base))
        reached = space.project(aside, others)
        if reached.size <= HOLDS:
            phi = space.residuals(reached.point)
            if not abs(phi[row]) <= HOLDS * space.row_sizes[row]:
                return False
    return bool(others)


def _kind(space: Geometry, point: Floats, row: int) -> _Fault:
    if not np.all(np.isfinite(space.position(point)[1].row(row))):
        return "none"
    step = space.sizes * np.random.default_rng(SEED).standard_normal(len(point))
    far, near = (
        float(np.linalg.norm(space.position(point + distance * step)[1].row(row) * space.sizes)) for distance in _NEAR
    )
    return "vanishes" if near < 0.5 * far else "corner"


def _report_touching(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> bool:
    """E0610 for each independent part of the mechanism whose rows nearly depend on each other and whose tangents lead
    nowhere."""
    rows = space.position_rows
    if not points:
        return False
    split = space.parts(rows)
    label_of = dict(zip(rows, split.row_labels.tolist(), strict=True))
    items_of: dict[int, list[Located]] = {}
    for item in located(flat):
        if item.constraint.level == "position":
            for label in {label_of[row] for row in item.rows}:
                items_of.setdefault(label, []).append(item)
    lasting = np.ones(split.count, dtype=np.bool_)
    lasting[[label for label, items in items_of.items() if any(comes_and_goes(i.constraint) for i in items)]] = False
    found = False
    for every in split.parts:
        parts = every.only(lasting[every.labels])
        blocks = [entries(point.rows.taken(rows), parts) for point in points]
        for index, label in enumerate(parts.labels.tolist()):
            columns, items = parts.columns[index], items_of.get(label, [])
            tried = zip(points, blocks, strict=True)
            if not all(_touches(space, point, rows, columns, block[index]) for point, block in tried):
                continue
            _report_touch(flat, items, configuration(flat, points[0].q, columns.tolist()), sink)
            found = True
    return found


def _touches(space: Geometry, point: Probe, rows: list[int], columns: np.ndarray, block: Floats) -> bool:
    """True if steps along the near null space of `block` lead back."""
    values = np.linalg.svd(block, compute_uv=False)
    tolerance = max(_NEARLY_DEPENDENT, _WAY * point.residual**0.5)
    if len(values) == 0 or values[-1] > tolerance * values[0]:
        return False
    free = null_space(block, tolerance)
    if free.shape[1] == 0:
        return False
    direction = free @ np.random.default_rng(SEED).standard_normal(free.shape[1])
    direction /= float(np.linalg.norm(direction))
    lost = []
    for length in _STEPS:
        start = point.q.copy()
        start[columns] += length * direction * space.sizes[columns]
        reached = space.project(start, rows)
        back = (reached.point - start)[columns] / space.sizes[columns]
        lost.append(float(np.linalg.norm(back)) / length)
    return lost[1] > max(_LOST, 0.5 * lost[0])


def _report_touch(flat: FlatModel, items: list[Located], where: str, sink: Sink) -> None:
    own = grammatical_subject(flat, items[-1].constraint)
    others = [grammatical_subject(flat, item.constraint) for item in items[:-1]]
    others = [other for other in dict.fromkeys(others) if other != own]
    subject = listed([*others[-_MOST_NAMED:], own])
    sink.report("E0610", place(items[-1].constraint), subject=subject, notes=(f"they touch at {where}",))
