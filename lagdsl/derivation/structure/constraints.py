"""Do the constraints hold anywhere, each for itself and all together?"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.derivation.structure.names import (
    Located,
    configuration,
    grammatical_subject,
    listed,
    located,
    place,
    unit_suffix,
)
from lagdsl.derivation.structure.points import HOLDS, Geometry, Probe, random_points
from lagdsl.derivation.structure.restated import is_steep, restated
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.connected_blocks import Partition
from lagdsl.foundation.numerics.levenberg_marquardt import Minimizer
from lagdsl.foundation.numerics.part_by_part import solved
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.model import Constraint, FlatModel

_TRIES = 24
# Beyond so many coordinates one evaluation costs so much that fewer beginnings are tried.
_MANY = 60
_FEWER_TRIES = 8
_LEAST_TRIES = 2
# A bias rate below this part of its size per second is zero: in a loop on a base that moves, the motion of the base
# cancels but for round-off.
_ROUNDING = 1e-12
# A step, in natural sizes, that does not lead to a zero nearby.
_LONG_STEP = 0.1
# A way, in natural sizes, that no search goes to a zero.
_FAR = 10.0
# Parts of the natural sizes at which a zero near zero is looked for.
_NEARER = (1.0, 0.1, 1e-2, 1e-3, 1e-5)
# So many independent parts of a mechanism that cannot be assembled are looked into.
_EXAMINED = 2


@record()
class Closest:
    """The best point found, and how far off the rows are there, part by part."""

    point: Floats
    residual: Floats
    split: Partition
    sizes: Floats

    @property
    def size(self) -> float:
        return float(np.max(self.sizes, initial=0.0))


def closest(flat: FlatModel, space: Geometry, rows: list[int], tries: int | None = None) -> Closest:
    """The best of several searches for a configuration in which the position rows hold; each independent part of the
    mechanism keeps its own best."""
    split = space.parts(rows)
    scale = space.row_sizes[rows]
    best = _closest(split, space.project(space.q, rows), scale)
    if tries is None:
        tries = _TRIES if len(space.q) <= _MANY else _FEWER_TRIES
    for start in random_points(flat.coordinates, space.q, space.sizes, tries):
        if best.size <= HOLDS:
            break
        beginning = split.mixed(best.sizes > HOLDS, start, best.point)
        found = _closest(split, space.project(beginning, rows), scale)
        better = found.sizes < best.sizes
        point = split.mixed(better, found.point, best.point)
        residual = np.where(better[split.row_labels], found.residual, best.residual)
        best = Closest(point, residual, split, np.minimum(found.sizes, best.sizes))
    return best


def _closest(split: Partition, found: Minimizer, scale: Floats) -> Closest:
    return Closest(found.point, found.residual, split, split.sizes(found.residual / scale))


def report_impossible(flat: FlatModel, space: Geometry, sink: Sink) -> bool:
    """E0602 for constraints that never hold, E0603 for such as never hold together. True if there are any."""
    position = [item for item in located(flat) if item.constraint.level == "position"]
    rows = [row for item in position for row in item.rows]
    together = closest(flat, space, rows)
    wrong = np.flatnonzero((together.sizes > HOLDS) & np.isfinite(together.sizes))
    part_of = dict(zip(rows, together.split.row_labels.tolist(), strict=True))
    for label in wrong[:_EXAMINED].tolist():
        items = [item for item in position if any(part_of[row] == label for row in item.rows)]
        columns = np.flatnonzero(together.split.column_labels == label).tolist()
        others = len(wrong) - _EXAMINED if label == wrong[:_EXAMINED][-1] else 0
        _explain(flat, space, items, columns, _more(others), sink)
    endless = [] if len(wrong) else _endless(space, together, rows)
    for item in position:
        if not item.constraint.of_law and any(row in endless for row in item.rows):
            _report_endless(flat, space, item, together, sink)
    return len(wrong) > 0 or len(endless) > 0


ENDLESS = "its residual goes to zero where coordinates grow without end, and the search meets no zero of it"


def _endless(space: Geometry, found: Closest, rows: list[int]) -> list[int]:
    """Rows such as 1/x that count as met where they are small only: the search has gone far, and the step along their
    gradient to a zero is as long as the motion itself."""
    if not np.any(np.abs(found.point - space.q) > _FAR * space.sizes):
        return []
    phi, jacobian = space.position(found.point)
    moved = np.abs(space.residuals(space.q)) > HOLDS * space.row_sizes
    steps = np.abs(phi) / jacobian.with_values(jacobian.values * space.sizes[jacobian.columns]).lengths()
    return [row for row in rows if moved[row] and steps[row] > _LONG_STEP]


def _report_endless(flat: FlatModel, space: Geometry, item: Located, found: Closest, sink: Sink) -> None:
    """E0602, or E0802 for a row such as x/(1 + x^2), where the search leads to the zero from small x only."""
    rows = list(item.rows)
    if _holds_elsewhere(flat, space, rows):
        residual = float(np.max(np.abs(space.residuals(found.point)[rows])))
        text, name = f"{residual:.3g}{unit_suffix(item.constraint)}", item.constraint.name
        sink.report("E0802", place(item.constraint), notes=(ENDLESS,), residual=text, name=name)
    else:
        subject = grammatical_subject(flat, item.constraint)
        sink.report("E0602", place(item.constraint), notes=(ENDLESS,), subject=subject, verb="hold")


def _holds_elsewhere(flat: FlatModel, space: Geometry, rows: list[int]) -> bool:
    """True if a search from elsewhere, near or far from zero, ends where the rows hold."""
    split, scale = space.parts(rows), space.row_sizes[rows]
    for start in random_points(flat.coordinates, space.q, space.sizes, _LEAST_TRIES):
        for beginning in (start, *(part * (start - space.q) for part in _NEARER)):
            found = _closest(split, space.project(beginning, rows), scale)
            if found.size <= HOLDS and not _endless(space, found, rows):
                return True
    return False


def _more(others: int) -> tuple[str, ...]:
    if others <= 0:
        return ()
    return (f"{others} other independent part{'' if others == 1 else 's'} of the mechanism cannot be assembled either",)


def _explain(
    flat: FlatModel, space: Geometry, items: list[Located], columns: list[int], more: tuple[str, ...], sink: Sink
) -> None:
    """Why these constraints, one part of the mechanism, cannot hold."""
    near = space.only([row for item in items for row in item.rows])
    tries = max(_LEAST_TRIES, _TRIES // len(items))  # many loops are looked into together for as long as one
    alone = [(item, closest(flat, near.only(list(item.rows)), list(item.rows))) for item in items]
    impossible = [(item, found) for item, found in alone if found.size > HOLDS]
    for item, found in impossible:
        if _report_steep(item, sink):
            continue
        text = f"{float(np.linalg.norm(found.residual)):.3g}{unit_suffix(item.constraint)}"
        where = f", at {configuration(flat, found.point, columns)}" if columns else ""
        note = f"closest approach is {text}{where}"
        verb = "hold" if item.constraint.closure is None else "close"
        sink.report(
            "E0602",
            place(item.constraint),
            notes=(note, *more),
            subject=grammatical_subject(flat, item.constraint),
            verb=verb,
        )
    if not impossible:
        _contradiction(flat, near, items, columns, (tries, more), sink)


def _report_steep(item: Located, sink: Sink) -> bool:
    """E0609 for a row such as sqrt(abs(x)) = 0, which no search along its gradient reaches, whether it holds or not."""
    for name, residual in zip(item.constraint.rows, item.constraint.residuals, strict=True):
        if is_steep(residual):
            rewrite = restated(residual, item.constraint.dimension)
            fault = "grows without bound toward where the constraint holds"
            hint = f"write {rewrite}" if rewrite else None
            sink.report("E0609", place(item.constraint), help=hint, name=name, fault=fault)
            return True
    return False


def _contradiction(
    flat: FlatModel,
    space: Geometry,
    position: list[Located],
    columns: list[int],
    effort: tuple[int, tuple[str, ...]],
    sink: Sink,
) -> None:
    """Name the first constraint that cannot be added to those before it, and the one it contradicts if that is a
    single one."""
    tries, more = effort
    taken: list[Located] = []
    for item in position:
        rows = [row for other in taken for row in other.rows]
        found = closest(flat, space, [*rows, *item.rows], tries)
        if found.size > HOLDS:
            partners = [o for o in taken if closest(flat, space, [*o.rows, *item.rows], tries).size > HOLDS][
                :1
            ] or taken
            note = f"they come closest at {configuration(flat, found.point, columns)}"
            _report_contradiction(flat, [other.constraint for other in partners], item.constraint, sink, (note, *more))
            return
        taken.append(item)


def _report_contradiction(
    flat: FlatModel, others: Sequence[Constraint], constraint: Constraint, sink: Sink, notes: tuple[str, ...]
) -> None:
    own = grammatical_subject(flat, constraint)
    # Rows of one closure are several constraints, and one thing to the reader.
    others = [other for other in others if grammatical_subject(flat, other) != own]
    if not others:
        verb = "hold" if constraint.closure is None else "close"
        sink.report("E0602", place(constraint), notes=notes, subject=own, verb=verb)
        return
    closures = [other.closure is not None for other in others]
    found = [
        grammatical_subject(flat, o) if closure else f"`{o.name}`" for o, closure in zip(others, closures, strict=True)
    ]
    names = listed(list(dict.fromkeys(found)))
    labels = [
        Label(span, "closes alone" if closure else "each holds alone")
        for other, closure in zip(others, closures, strict=True)
        if (span := place(other)) is not None and span != place(constraint)
    ]
    labels = list(dict.fromkeys(labels))
    sink.report("E0603", place(constraint), *labels, notes=notes, subject=own, others=names)


def report_inconsistent_rates(flat: FlatModel, space: Geometry, points: list[Probe], sink: Sink) -> bool:
    """E0603 where no rates satisfy the rows although each row holds alone; E0602 for a row that moves by itself."""
    for point in points[:1]:
        right = space.velocity(point.q, np.zeros_like(space.qd))[0] / space.row_sizes
        split = space.parts(list(range(len(right))))
        left_over = np.abs(point.rows @ solved(point.rows, right, split) - right)
        rounding = _ROUNDING * max(1.0, float(np.max(np.abs(right), initial=0.0)))
        most = np.maximum(1e-6 * split.sizes(right)[split.row_labels], rounding)
        if not np.all(np.isfinite(left_over)) or np.all(left_over <= most):
            continue
        items = [i for i in located(flat) if any(left_over[row] > most[row] for row in i.rows)]
        constraint = items[-1].constraint
        others = [item.constraint for item in items[:-1]]
        what = "all of them" if others else "it"
        _report_contradiction(flat, others, constraint, sink, (f"no rates of the coordinates satisfy {what}",))
        return True
    return False


def report_row_factors(flat: FlatModel, factors: Floats, sink: Sink) -> None:
    """N0612 for constraints with rows that are multiplied, so that they are not mistaken for round-off."""
    for item in located(flat):
        factor = float(np.max(factors[list(item.rows)], initial=1.0))
        if factor > 1.0 and not balanced(item.constraint):
            power, part = round(np.log2(factor)), f"{1.0 / factor:.0e}"
            sink.report("N0612", place(item.constraint), name=item.constraint.name, power=power, part=part)
