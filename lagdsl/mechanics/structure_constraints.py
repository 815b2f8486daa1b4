"""What can be said of the constraints before the first step: do they hold, do they repeat or contradict each
other?"""

from __future__ import annotations

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.mechanics.rank import Floats, independent_rows, minimum_norm
from lagdsl.mechanics.structure_display import quantity_text
from lagdsl.mechanics.structure_newton import Descent
from lagdsl.mechanics.structure_points import HOLDS, Geometry, Probe, random_points
from lagdsl.record import record
from lagdsl.semantics.flat_model import Constraint, FlatModel
from lagdsl.units.dimension import BASE_UNITS

_TRIES = 24
_MOST_SHOWN = 6


@record()
class Located:
    """A declared constraint and the indices of its rows."""

    constraint: Constraint
    rows: tuple[int, ...]


def located(flat: FlatModel) -> list[Located]:
    """All constraints with the indices of their rows, in source order."""
    result, first = [], 0
    for constraint in flat.constraints:
        result.append(Located(constraint, tuple(range(first, first + len(constraint.rows)))))
        first += len(constraint.rows)
    return result


# ---- do they hold? --------------------------------------------------------------------------------------------------


def closest(flat: FlatModel, space: Geometry, rows: list[int]) -> Descent:
    """The best of several searches for a configuration in which the position rows hold."""
    best = space.project(space.q, rows)
    for start in random_points(flat.coordinates, space.q, space.sizes, _TRIES):
        if best.size <= HOLDS:
            break
        found = space.project(start, rows)
        if found.size < best.size:
            best = found
    return best


def report_impossible(flat: FlatModel, space: Geometry, sink: Sink) -> bool:
    """E0602 for constraints that never hold, E0603 for such as never hold together. True if there are any."""
    position = [item for item in located(flat) if item.constraint.level == "position"]
    together = closest(flat, space, [row for item in position for row in item.rows])
    if together.size <= HOLDS or not np.isfinite(together.size):
        return False
    alone = [(item, closest(flat, space, list(item.rows))) for item in position]
    impossible = [(item, found) for item, found in alone if found.size > HOLDS]
    for item, found in impossible:
        _never_holds(flat, item.constraint, found, sink)
    if not impossible:
        _contradiction(flat, space, position, sink)
    return True


def _never_holds(flat: FlatModel, constraint: Constraint, found: Descent, sink: Sink) -> None:
    span = constraint.spans[0] if constraint.spans else None
    size = float(np.max(np.abs(found.residual)))
    sink.report(
        "E0602",
        span,
        notes=(f"closest approach is {size:.3g}{unit_suffix(constraint)}, at {configuration(flat, found.point)}",),
        name=constraint.name,
    )


def _contradiction(flat: FlatModel, space: Geometry, position: list[Located], sink: Sink) -> None:
    """Name the first constraint that cannot be added to those before it, and the one it contradicts if that is a
    single one."""
    taken: list[Located] = []
    for item in position:
        rows = [row for other in taken for row in other.rows]
        found = closest(flat, space, [*rows, *item.rows])
        if found.size > HOLDS:
            partners = [o for o in taken if closest(flat, space, [*o.rows, *item.rows]).size > HOLDS][:1] or taken
            note = f"they come closest at {configuration(flat, found.point)}"
            _report_contradiction([other.constraint for other in partners], item.constraint, sink, note)
            return
        taken.append(item)


def _report_contradiction(others: list[Constraint], constraint: Constraint, sink: Sink, note: str) -> None:
    names = " and ".join(f"`{other.name}`" for other in others)
    labels = [Label(other.spans[0], "each holds alone") for other in others if other.spans]
    span = constraint.spans[0] if constraint.spans else None
    sink.report("E0603", span, *labels, notes=(note,), name=constraint.name, others=names)


def configuration(flat: FlatModel, q: Floats) -> str:
    """`x = 0.1 m, theta = 30 deg` in display units, the first few coordinates."""
    values = np.where(np.abs(q) > 1e-6, q, 0.0).tolist()  # what a search leaves of a zero
    shown = [f"{c.name} = {quantity_text(v, c)}" for c, v in zip(flat.coordinates, values, strict=True)]
    return ", ".join([*shown[:_MOST_SHOWN], *(["..."] if len(shown) > _MOST_SHOWN else [])])


def unit_suffix(constraint: Constraint) -> str:
    """The coherent unit of a constraint's rows, with a leading blank."""
    parts = [
        base if exponent == 1 else f"{base}{exponent}"
        for base, exponent in zip(BASE_UNITS, constraint.dimension.exponents, strict=True)
        if exponent
    ]
    return f" {'.'.join(parts)}" if parts else ""


# ---- do they repeat each other? -------------------------------------------------------------------------------------


@record()
class Dependence:
    """Flags over all declared rows: dependent on others, and identically zero (a part of the dependent ones)."""

    redundant: tuple[bool, ...]
    empty: tuple[bool, ...]


def dependence(space: Geometry, points: list[Probe]) -> Dependence:
    """Rows that add nothing at any probed point; holonomic rows come first, so a velocity row that repeats the
    derivative of one is the redundant one (ruling 22)."""
    count = len(space.functions.layout.constraints)
    if not points:
        return Dependence((False,) * count, (False,) * count)
    samples = [point.rows for point in points]
    holonomic = space.position_rows
    order = holonomic + [row for row in range(count) if row not in set(holonomic)]
    kept = independent_rows(samples, order)
    largest = np.max([np.max(np.abs(sample), axis=1, initial=0.0) for sample in samples], axis=0)
    empty = [bool(size < 1e-11) for size in largest]
    return Dependence(tuple(not keep for keep in kept), tuple(empty))


def report_dependence(flat: FlatModel, space: Geometry, points: list[Probe], found: Dependence, sink: Sink) -> None:
    """N0605 for rows without content, N0607 for rows that follow from others."""
    for item in located(flat):
        span = item.constraint.spans[0] if item.constraint.spans else None
        for component, row in enumerate(item.rows):
            if not found.redundant[row]:
                continue
            if found.empty[row]:
                sink.report("N0605", span, name=item.constraint.name, component=component + 1)
            else:
                others = _sources(space, points[-1], found, row)
                sink.report("N0607", span, name=item.constraint.rows[component], others=others)


def _sources(space: Geometry, point: Probe, found: Dependence, row: int) -> str:
    """Names of the kept rows that a redundant one is a combination of."""
    kept = [index for index, redundant in enumerate(found.redundant) if not redundant]
    weights = minimum_norm(point.rows[kept].T, point.rows[row])
    names = [
        f"`{space.functions.layout.constraints[index].name}`"
        for index, weight in zip(kept, weights.tolist(), strict=True)
        if abs(weight) > 1e-7
    ]
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def report_inconsistent_rates(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> bool:
    """E0603 where no rates satisfy the rows although each row holds alone; E0602 for a row that moves by itself."""
    for point in points[:1]:
        right = space.velocity(point.q, np.zeros_like(space.qd))[0] / space.row_sizes
        left_over = np.abs(point.rows @ minimum_norm(point.rows, right) - right)
        size = float(np.max(np.abs(right), initial=0.0))
        if not np.isfinite(size) or float(np.max(left_over, initial=0.0)) <= 1e-6 * size:
            continue
        items = [i for i in located(flat) if any(left_over[row] > 1e-6 * size for row in i.rows)]
        constraint = items[-1].constraint
        if len(items) == 1:
            span = constraint.spans[0] if constraint.spans else None
            sink.report("E0602", span, notes=("no rates of the coordinates satisfy it",), name=constraint.name)
        else:
            others = [item.constraint for item in items[:-1]]
            _report_contradiction(others, constraint, sink, "no rates of the coordinates satisfy all of them")
        return True
    return False
