"""Coordinates that follow from others for good, so that importers need not integrate them.

A row of constraints ties rates for good where its Jacobian is made of numbers and nothing else stands in its rate:
J qd = 0, and J q stays what it is between events. Kirchhoff's laws of the nodes of a network are such rows; a tree of
the network is a choice of coordinates that follow.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.foundation.record import record
from lagdsl.language.flat.model import FlatModel

# Coefficients by coordinate.
_Row: TypeAlias = dict[int, Fraction]
# Elimination lengthens coefficients that are no small numbers; a row with longer ones is left to the importer.
_MOST_BITS = 512


@record()
class DependentCoordinate:
    """q[place] = sum of weight * q[other] over `terms` + an offset, constant between events; rates without it."""

    place: int
    terms: tuple[tuple[int, float], ...]


def dependent_coordinates(flat: FlatModel, program: Program) -> tuple[DependentCoordinate, ...]:
    """Terms are independent coordinates, or dependent ones that come before.

    Coordinates that forces do not read follow first: the charge of a capacitor is not the small difference of two large
    ones. Then those without inertia, those whose start is not given, and those declared early.
    """
    rows = dict(enumerate(_constant_rows(flat, program)))
    if not rows:
        return ()
    found = []
    for place in sorted(range(len(flat.coordinates)), key=_preference(flat, program)):
        holding = [index for index, row in rows.items() if place in row]
        if not holding:
            continue
        pivot = rows.pop(min(holding, key=lambda index: (len(rows[index]), index)))
        scale = -pivot.pop(place)
        own = {other: value / scale for other, value in pivot.items()}
        found.append(DependentCoordinate(place, tuple((other, float(value)) for other, value in sorted(own.items()))))
        for index in holding:
            if index in rows:
                _substitute(rows, index, place, own)
    return tuple(reversed(found))


def leading(dependent: tuple[DependentCoordinate, ...]) -> Mapping[int, tuple[int, ...]]:
    """By dependent coordinate, the independent ones that it follows from."""
    found: dict[int, tuple[int, ...]] = {}
    for each in dependent:
        own = {leader for other, _ in each.terms for leader in found.get(other, (other,))}
        found[each.place] = tuple(sorted(own))
    return found


def _substitute(rows: dict[int, _Row], index: int, place: int, own: _Row) -> None:
    """Row `index` without the coordinate `place`, which is `own`; rows that say nothing more are dropped."""
    row = rows[index]
    factor = row.pop(place)
    for other, value in own.items():
        row[other] = row.get(other, Fraction(0)) + factor * value
        if row[other] == 0:
            del row[other]
    longest = max((value.numerator.bit_length() + value.denominator.bit_length() for value in row.values()), default=0)
    if not row or longest > _MOST_BITS:
        del rows[index]


def _constant_rows(flat: FlatModel, program: Program) -> Iterator[_Row]:
    """Of rows that do not come and go."""
    graph, n = program.graph, len(flat.coordinates)
    residuals, jacobian = (block.elements for block in program.function("velocity_constraint").results)
    switched = contact_rows(flat)
    for row, residual in enumerate(residuals):
        own = jacobian[row * n : (row + 1) * n]
        if row in switched or not all(graph.is_constant(node) for node in own):
            continue
        still = {Group.QD: np.zeros(n)}
        if graph.groups[residual] == 1 << Group.QD and evaluate(graph, [residual], still) == [0.0]:
            yield {place: Fraction(graph.value[node]) for place, node in enumerate(own) if graph.value[node] != 0.0}


def _preference(flat: FlatModel, program: Program) -> Callable[[int], tuple[bool, bool, bool, int]]:
    """Key of a coordinate: the least follows first."""
    graph = program.graph
    forces = program.function("inverse_dynamics").results[0].elements
    read = {node for node in graph.live(forces) if graph.op[node] is Op.SYMBOL}

    def key(place: int) -> tuple[bool, bool, bool, int]:
        item = flat.coordinates[place]
        given = item.fixed or item.rate_fixed or item.start_explicit or item.rate_start_explicit
        moved, accelerated = graph.symbol(Group.Q, place), graph.symbol(Group.QDD, place)
        return moved in read, accelerated in read, given, place

    return key
