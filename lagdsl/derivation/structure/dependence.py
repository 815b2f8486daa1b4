"""Do the constraints repeat each other?

Rows of J are judged at points of the constraint set itself: an overconstrained linkage (Bennett's, Bricard's, a
parallelogram with a third bar) is mobile only there, and has full rank beside it.
"""

from __future__ import annotations

import numpy as np

from lagdsl.derivation.structure.count import balance_text, counted
from lagdsl.derivation.structure.names import comes_and_goes, joint_text, listed, located, loop_text, place
from lagdsl.derivation.structure.points import Geometry, Probe
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.connected_blocks import Partition, entries
from lagdsl.foundation.numerics.rank import RANK_TOLERANCE, Floats, independent_rows, minimum_norm
from lagdsl.foundation.numerics.sparse_pivots import FEW, independent
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import Closure, FlatModel

_MOST_NAMED = 4
_RESIDUAL_FACTOR = 1e3
# Rows are scaled to size one; a part whose largest singular value is below this has no content but round-off.
_ROW = 1e-3
_GROUND = "the equations determine the potentials up to a constant only; in a circuit, connect a `Ground` to one node"


@record()
class Dependence:
    """Flags over all declared rows: dependent on others, and identically zero (a part of the dependent ones)."""

    redundant: tuple[bool, ...]
    empty: tuple[bool, ...]


def dependence(space: Geometry, points: list[Probe], contacts: frozenset[int]) -> Dependence:
    """Rows that add nothing at the probed points. Holonomic rows come first, so a velocity row that repeats the
    derivative of one is the redundant one; those that come and go (`contacts`) are last, so a row that is always there
    does not depend on what one branch of them says.

    Each independent part is judged at the point where its rank is largest: that is its rank in general.
    """
    count = len(space.functions.layout.constraints)
    if not points:
        return Dependence((False,) * count, (False,) * count)
    rows = list(range(count))
    split = space.parts(rows)
    ranks = np.array([_ranks(space, point, rows, split) for point in points])
    most = np.max(ranks, axis=0)
    kept = np.asarray(most == np.bincount(split.row_labels, minlength=split.count))[split.row_labels]
    level = space.functions.layout.position_level
    for parts in split.parts:
        sizes = most[parts.labels]
        open_ = parts.only((sizes > 0) & (sizes < parts.rows.shape[1]))  # some of their rows depend on others
        stacks = [entries(point.rows, open_) for point in points]
        for index, label in enumerate(open_.labels.tolist()):
            best = int(np.argmax(ranks[:, label]))
            members = open_.rows[index]
            order = sorted(range(len(members)), key=lambda row: (members[row] in contacts, not level[members[row]]))
            kept[members] = independent_rows(stacks[best][index], order, int(ranks[best, label]))
    largest = np.max([point.rows.largest() for point in points], axis=0)
    return Dependence(tuple((~kept).tolist()), tuple((largest < 1e-11).tolist()))


def _ranks(space: Geometry, probe: Probe, rows: list[int], split: Partition) -> Floats:
    """Rank of each independent part of the rows at a probed point.

    J is known there to the residual times the bend of the rows, so singular values below a thousand residuals are
    none. Elimination shows the rank of many rows sooner where they are independent.
    """
    tolerance = max(RANK_TOLERANCE, _RESIDUAL_FACTOR * probe.residual)
    ranks = np.zeros(split.count)
    matrix = probe.rows.taken(rows).nonzero()
    moved = np.zeros(split.count, dtype=np.bool_)
    moved[split.row_labels[matrix.rows]] = True
    for parts in split.parts:
        live, count = parts.only(moved[parts.labels]), parts.rows.shape[1]  # open contacts are zero
        if not len(live.labels):
            continue
        if count > FEW and tolerance <= _ROW:
            own = (matrix.taken(*each) for each in zip(live.rows, live.columns, strict=True))
            if all(independent(each) for each in own):
                ranks[live.labels] = count
                continue
        values = np.linalg.svd(entries(matrix, live), compute_uv=False)
        ranks[live.labels] = np.sum(values > tolerance * np.maximum(values[:, :1], _ROW), axis=1)
    return ranks


def report_dependence(flat: FlatModel, space: Geometry, points: list[Probe], found: Dependence, sink: Sink) -> None:
    """N0701 for loops with more equations than they need, N0605 for rows without content, N0607 for rows that follow
    from others."""
    split, tied = space.parts(list(range(len(found.redundant)))), space.pattern.counts()
    for item in located(flat):
        for component, row in enumerate(item.rows):
            if not found.redundant[row] or item.constraint.closure is not None or comes_and_goes(item.constraint):
                continue
            if found.empty[row] and not tied[row]:
                part = f"component {component + 1} of " if len(item.rows) > 1 else ""
                sink.report("N0605", place(item.constraint), subject=f"{part}`{item.constraint.name}`")
            else:
                others = _sources(space, points[-1], found, split, row)
                if not others:
                    name = item.constraint.rows[component]
                    sink.report("E0609", place(item.constraint), name=name, fault="vanishes toward where it holds")
                    continue
                help = _GROUND if item.constraint.node else None
                name = item.constraint.rows[component]
                sink.report("N0607", place(item.constraint), help=help, name=name, others=others)
    alike: dict[tuple[object, ...], list[_Loop]] = {}
    for loop in _loops(flat):
        excess = sum(found.redundant[row] for row in loop.rows)
        if excess:
            alike.setdefault((loop.closure.span, excess), []).append(loop)
    for loops in alike.values():
        _report_loop(flat, found, loops, sink)


# Equations of a loop in a plane, or about a point, that hold by themselves.
_OUT_OF_PLANE = 3


@record()
class _Loop:
    """All rows that close one loop."""

    closure: Closure
    rows: tuple[int, ...]


def _loops(flat: FlatModel) -> list[_Loop]:
    found: dict[tuple[object, ...], _Loop] = {}
    for item in located(flat):
        closure = item.constraint.closure
        if closure is not None:
            key = (closure.joint, closure.loop, closure.span)
            before = found[key].rows if key in found else ()
            found[key] = _Loop(closure, (*before, *item.rows))
    return list(found.values())


def _report_loop(flat: FlatModel, found: Dependence, alike: list[_Loop], sink: Sink) -> None:
    loop = alike[0]
    # Of the whole model: the part of the rows that tie something misses coordinates, or is empty, and the count of its
    # freedoms contradicts that of the model.
    first = balance_text(len(flat.coordinates), found.redundant.count(False))
    excess = sum(found.redundant[row] for row in loop.rows)
    usual = ("this is usual and harmless: in a planar loop, three of the spatial closure equations hold identically",)
    if loop.closure.joint is not None:
        unknown = "is not determined in the directions left out and is reported in minimum norm"
        first = f"{first}; reaction({loop.closure.joint}) {unknown}"
    more = (f"the same holds for {counted(len(alike) - 1, 'other loop')}",) if len(alike) > 1 else ()
    sink.report(
        "N0701",
        loop.closure.span,
        notes=(*(usual if excess == _OUT_OF_PLANE else ()), first, *more),
        count=excess,
        total=len(loop.rows),
        joint=joint_text(flat, loop.closure),
        loop=loop_text(flat, loop.closure),
    )


def _sources(space: Geometry, point: Probe, found: Dependence, split: Partition, row: int) -> str:
    """Names of the kept rows that a redundant one is a combination of."""
    part = split.row_labels[row]
    kept = [index for index, other in enumerate(found.redundant) if not other and split.row_labels[index] == part]
    weights = minimum_norm(point.rows.taken(kept).dense().T, point.rows.row(row))
    constraints = space.functions.layout.constraints
    if found.empty[row]:  # its gradient tells nothing of them
        names = [f"`{constraints[index].name}`" for index in kept]
        return listed(names if len(names) <= _MOST_NAMED else [*names[:_MOST_NAMED], "others"])
    names = [
        f"`{constraints[index].name}`"
        for index, weight in zip(kept, weights.tolist(), strict=True)
        if abs(weight) > 1e-7
    ]
    return listed(names)
