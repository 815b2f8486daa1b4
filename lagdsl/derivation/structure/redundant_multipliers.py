"""Choice of multipliers to eliminate with the accelerations, from numbers at points of the constraint set: rows may
depend on each other there and nowhere else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from lagdsl.algebra.eliminate.form import AccelerationForm
from lagdsl.algebra.eliminate.pivots import Loop, weakest
from lagdsl.algebra.eliminate.rows import Row, Rows, components, row_of
from lagdsl.algebra.eliminate.solve import Factor
from lagdsl.algebra.eliminate.steps import strength
from lagdsl.algebra.eliminate.weightless import reduce
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.structure.mass_augmentation import power_of_two, stiffened
from lagdsl.derivation.structure.points import Geometry, Probe
from lagdsl.derivation.structure.structure import Structure
from lagdsl.foundation.numerics.rank import Floats

# The least part of a multiplier's pivot, at the points looked at, with which it is eliminated.
_WELL_CONDITIONED = 1e-4


# By row: the pivot of its multiplier and what it would be without others, each by point (k,).
Strengths: TypeAlias = Mapping[int, tuple[Floats, Floats]]


def choose_rows(form: AccelerationForm, rates: Sequence[int], rows: Sequence[Row], structure: Structure) -> Rows:
    """Rows that depend on no others are solved for; those of contacts come and go, which run time sees."""
    redundant, contacts = structure.redundant, structure.contacts
    coming = [row for row in rows if row.terms and row.index in contacts]
    solved = [row for row in rows if row.terms and not redundant[row.index] and row.index not in contacts]
    others = [row for row in rows if row.terms and redundant[row.index]]
    chosen = _divided(solved, others, coming, {})
    reduced = reduce(form, rates, chosen)
    columns = {rate: column for column, rate in enumerate(rates)}
    exchanged = [(row_of(step.multiplier), columns[step.rate]) for step in reduced.steps]
    independent = [row.index for row in reduced.left.solved]
    weights = stiffened(independent, structure.space, structure.points, exchanged)
    return replace(chosen, stiffened={index: form.graph.constant(weight) for index, weight in weights.items()})


def _divided(solved: list[Row], following: list[Row], kept: list[Row], stiffened: Mapping[int, int]) -> Rows:
    """Without any solved row there is nothing that others can follow from, or be short against."""
    if not solved:
        following, kept = [], [*following, *kept]
    order = sorted(kept, key=lambda row: row.index)
    return Rows(solved=tuple(solved), following=tuple(following), kept=tuple(order), stiffened=stiffened)


def without_weak_rows(factor: Factor, strengths: Strengths) -> Rows | None:
    """The rows of a factor, those of loops in which a multiplier had a small pivot at some point left to run time; None
    where there are none."""
    rows, left = factor.rows, factor.left
    given = {row.index: row for row in (*rows.solved, *rows.following)}
    kept = {row.index: row for row in rows.kept}
    independent = {row.index for row in left.solved}
    for members in components((*left.solved, *left.following)):
        solved = [row.index for row in members if row.index in independent]
        sizes = {index: strengths[index][1] / _usual(strengths[index][1]) for index in solved}
        largest = np.max(list(sizes.values()), axis=0, initial=0.0)
        for index in solved:
            pivot, size = strengths[index]
            if not np.all(pivot / _usual(size) > _WELL_CONDITIONED * largest):
                kept |= {row.index: given[row.index] for row in members}
    if len(kept) == len(rows.kept):
        return None
    return _divided(
        [row for row in rows.solved if row.index not in kept],
        [row for row in rows.following if row.index not in kept],
        list(kept.values()),
        rows.stiffened,
    )


def least_pivot(factor: Factor, strengths: Strengths) -> int:
    """The smallest of three kinds of measures, as a node: the part that subtraction left of a pivot, the strength of
    a row against the others of its loop, and zero where a row left to run time follows from solved ones.

    Rows are compared in their usual sizes: one that is short is no row in a singular position, whatever its direction.
    """
    rows, left = factor.rows, factor.left
    solved = {row.index: _usual(strengths[row.index][1]) for row in left.solved}
    groups = []
    for members in components((*left.solved, *left.following)):
        indices = [row.index for row in members]
        usual = {index: solved[index] for index in indices if index in solved}
        following = [index for index in indices if index not in solved]
        groups.append(Loop(solved=list(usual), following=following, usual=usual))
    kept = [strength(factor.graph, factor.steps, row.terms) for row in rows.kept]
    return weakest(factor.graph, factor.pivot, factor.strengths, groups, kept)


def _usual(sizes: Floats) -> float:
    """A power of two near the median: multiplying by it is exact."""
    return power_of_two(float(np.median(sizes)))


def strengths_at_points(factor: Factor, structure: Structure) -> Strengths:
    """Strengths of the factor in numbers."""
    nodes = [node for pair in factor.strengths.values() for node in pair]
    values = evaluate(factor.graph, nodes, _symbols(structure.space, structure.points))
    count = len(structure.points)
    found = [np.broadcast_to(np.asarray(value, dtype=np.float64), count) for value in values]
    return {index: (found[2 * i], found[2 * i + 1]) for i, index in enumerate(factor.strengths)}


def _symbols(space: Geometry, points: Sequence[Probe]) -> Mapping[Group, object]:
    return {
        Group.TIME: space.t,
        Group.Q: np.array([point.q for point in points]),
        Group.QD: space.qd,
        Group.Z: space.z,
        Group.U: space.u,
        Group.W: space.w,
        Group.P: space.p,
    }
