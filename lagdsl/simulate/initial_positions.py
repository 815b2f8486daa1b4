"""Start positions: as near as possible to the starts, on the constraints, fixed coordinates untouched."""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.flat.model import Coordinate
from lagdsl.mechanics.partition import partition
from lagdsl.mechanics.rank import Floats, rank
from lagdsl.mechanics.structure_names import Located, configuration, located, place, seat, unit_suffix
from lagdsl.mechanics.structure_points import HOLDS, random_points
from lagdsl.simulate.initial_problem import Problem
from lagdsl.simulate.nearest import search

_TRIES = 24
_MOST_JOINTS = 6
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")


def positions(task: Problem, sink: Sink) -> Floats:
    """Minimise sum (q - start)^2 / width^2 subject to phi(q, t0) = 0; E0801 or E0802 where that cannot be done."""
    space, rows = task.space, task.space.position_rows
    if not rows or _already_there(task, rows):
        return space.q
    free = np.flatnonzero(~task.fixed)
    widths = task.widths

    def placed(y: Floats) -> Floats:
        q = space.q.copy()
        q[free] += widths[free] * y
        return q

    def equations(y: Floats) -> tuple[Floats, Floats]:
        phi, jacobian = space.position(placed(y))
        scale = space.row_sizes[rows]
        return phi[rows] / scale, (jacobian[rows] * widths / scale[:, None])[:, free]

    others = [
        ((other - space.q) / widths)[free]
        for other in random_points(task.flat.coordinates, space.q, space.sizes, _TRIES, task.seed)
    ]
    split = partition(space.pattern[rows][:, free])
    found = search(equations, len(free), others, holds=HOLDS, partition=split)
    if found.size > HOLDS:
        _report(task, placed(found.point), rows, free, sink)
    return placed(found.point)


def _already_there(task: Problem, rows: list[int]) -> bool:
    phi = task.space.position(task.space.q)[0]
    return bool(np.all(np.abs(phi[rows]) <= 1e-15 * task.space.row_sizes[rows]))


def _report(task: Problem, q: Floats, rows: list[int], free: np.ndarray, sink: Sink) -> None:
    """E0801 where fixed starts leave the constraints too few coordinates to move, else E0802."""
    space = task.space
    phi = space.position(q)[0]
    # Ranks of general positions: where a search stalls, the mechanism is stretched out and loses rank.
    samples = [
        space.position(point)[1][rows] * space.sizes / space.row_sizes[rows, None]
        for point in random_points(task.flat.coordinates, space.q, space.sizes, 3, task.seed)
    ]
    excess = min(rank(sample) - rank(sample[:, free]) for sample in samples)
    if excess > 0:
        report_overdetermined(task, excess, len(q) - max(rank(sample) for sample in samples), sink)
        return
    sizes = np.where(np.isfinite(phi), np.abs(phi) / space.row_sizes, np.inf)
    worst = max(rows, key=lambda row: float(sizes[row]))
    items = located(task.flat)
    item = next(item for item in items if worst in item.rows)
    sink.report(
        "E0802",
        place(item.constraint),
        notes=(f"configuration reached: {configuration(task.flat, q)}", *_left_over(items, phi, sizes, rows)),
        residual=f"{abs(float(phi[worst])):.3g}{unit_suffix(item.constraint)}",
        name=seat(item.constraint) if item.constraint.closure else space.functions.layout.constraints[worst].name,
    )


def _left_over(items: list[Located], phi: Floats, sizes: Floats, rows: list[int]) -> tuple[str, ...]:
    """What is left over at each joint or constraint, the largest first, if there are several."""
    held = set(rows)
    open_ = [item for item in items if any(sizes[row] > HOLDS for row in item.rows if row in held)]
    open_.sort(key=lambda item: -max(float(sizes[row]) for row in item.rows))
    parts = [
        f"{float(np.linalg.norm(phi[list(item.rows)])):.3g}{unit_suffix(item.constraint)} at `{seat(item.constraint)}`"
        for item in open_[:_MOST_JOINTS]
    ]
    more = f" and at {len(open_) - _MOST_JOINTS} more" if len(open_) > _MOST_JOINTS else ""
    return (f"left over: {', '.join(parts)}{more}",) if len(parts) > 1 else ()


def report_overdetermined(task: Problem, excess: int, freedom: int, sink: Sink) -> None:
    """E0801 at the last fixed start, the others as labels."""
    fixed = [c for c in task.flat.coordinates if c.fixed]
    spans = [span for c in fixed if (span := c.start_span or (c.spans[0] if c.spans else None)) is not None]
    degrees = f"{freedom} degree{'s' if freedom != 1 else ''} of freedom"
    many = "one coordinate" if freedom == 1 else f"{freedom} coordinates"
    can = f"so {many} can be fixed" if freedom else "so no coordinate can be fixed"
    shown = [f"`{c.name}`" for c in fixed[:_MOST_JOINTS]]
    more = f" and {len(fixed) - _MOST_JOINTS} more" if len(fixed) > _MOST_JOINTS else ""
    sink.report(
        "E0801",
        Label(spans[-1], _ordinal(len(fixed), fixed[-1])) if spans else None,
        *(Label(span, "fixed as well") for span in dict.fromkeys(spans[:-1]) if span != spans[-1]),
        notes=(f"the mechanism has {degrees}, {can}; fixed are {', '.join(shown)}{more}",),
        excess=excess,
    )


def _ordinal(number: int, coordinate: Coordinate) -> str:
    """`second fixed angle`."""
    noun = "angle" if coordinate.type_name == "Angle" else "coordinate"
    if number == 1:
        return f"fixed {noun}"
    return f"{_ORDINALS[number - 1]} fixed {noun}" if number <= len(_ORDINALS) else "one fixed start too many"
