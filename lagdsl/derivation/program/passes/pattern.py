"""Entries of matrices that can be nonzero: what shares nothing is solved apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.algebra.graph.occurrence import dependences, members
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.numerics.disjoint_columns import disjoint_columns
from lagdsl.foundation.numerics.reverse_cuthill_mckee import reverse_cuthill_mckee

# Rows and columns of entries, row by row.
Pattern = tuple[Sequence[int], Sequence[int]]


@dataclass(frozen=True)
class RatesPattern:
    """Entries of d(qdd, zd)/d(q, qd, z), (nq + nz, 2 nq + nz); all empty where they are not told.

    `places` (nq + nz) of its rows, and of the columns of rates and states, in an order in which entries lie near the
    diagonal, columns of coordinates under those of their rates. `groups` (2 nq + nz): columns of one share no row.
    """

    entries: Pattern = ((), ())
    places: tuple[int, ...] = ()
    groups: tuple[int, ...] = ()


def patterns(program: Program) -> dict[str, tuple[tuple[int, int], Pattern]]:
    """Shapes and entries by name: `jacobian` (nc, nq); `response` (nk, nq) and `coupling` (nk, nk) of the rows that are
    left to run time, see lag/model.h. A pattern without entries is not told."""
    nc, nq, nk = len(program.layout.constraints), len(program.layout.coordinates), len(program.kept_rows)
    response, coupling = kept_patterns(program)
    return {
        "jacobian": ((nc, nq), jacobian_pattern(program)),
        "response": ((nk, nq), response),
        "coupling": ((nk, nk), coupling),
    }


def jacobian_pattern(program: Program) -> Pattern:
    """Entries of the constraint Jacobian that are not zero by themselves."""
    width = len(program.layout.coordinates)
    both = (program.function(name).results[1] for name in ("position_constraint", "velocity_constraint"))
    places = sorted({place for block in both for place, _ in block.entries})
    return [place // width for place in places], [place % width for place in places]


def kept_patterns(program: Program) -> tuple[Pattern, Pattern]:
    """Of the rows that elimination leaves to run time: what a multiplier of each accelerates, and whose accelerations
    move which row, itself among them. None where nothing is zero."""
    kept = program.kept_rows
    if not kept or not program.has("elimination"):
        return ([], []), ([], [])
    width = len(program.layout.coordinates)
    moved: list[set[int]] = [set() for _ in kept]
    for place, _ in program.function("elimination").results[2].entries:
        moved[place // width].add(place % width)
    movers: list[list[int]] = [[] for _ in range(width)]
    for i, columns in enumerate(moved):
        for j in columns:
            movers[j].append(i)
    number = {row: i for i, row in enumerate(kept)}
    beside: list[set[int]] = [{i} for i in range(len(kept))]
    for row, column in zip(*jacobian_pattern(program), strict=True):
        for other in movers[column] if row in number else ():
            beside[number[row]].add(other)
            beside[other].add(number[row])
    return _listed(moved, width), _listed(beside, len(kept))


def _listed(rows: list[set[int]], width: int) -> Pattern:
    """A pattern that leaves nothing out tells nothing."""
    if all(len(row) == width for row in rows):
        return [], []
    entries = [(i, j) for i, row in enumerate(rows) for j in sorted(row)]
    return [i for i, _ in entries], [j for _, j in entries]


def rates_pattern(program: Program) -> RatesPattern:
    """Told where accelerations are expressions and groups of columns are fewer than columns: each derivative of a group
    takes as long as that of a single one. Multipliers that are left to run time, or a system that is, join all of a
    component. Loads that depend on accelerations are not followed."""
    rows = _rates_rows(program)
    nq, count = len(program.layout.coordinates), len(rows)
    if any(row.bit_count() == nq + count for row in rows):  # no two columns form a group
        return RatesPattern()
    own = [members(row) for row in rows]
    places = np.repeat(np.arange(count), [len(row) for row in own])
    columns = np.concatenate([np.zeros(0, dtype=np.intp), *own])
    groups = disjoint_columns(places, columns, (count, nq + count)).tolist()
    if not columns.size or len(set(groups)) == nq + count:
        return RatesPattern()
    entries = places.tolist(), columns.tolist()
    others = (column - nq if column >= nq else column for column in entries[1])
    order = reverse_cuthill_mckee(count, zip(entries[0], others, strict=True))
    return RatesPattern(entries, tuple(np.argsort(order).tolist()), tuple(groups))


def _rates_rows(program: Program) -> list[int]:
    """Row by row the variables (q, qd, z) that it depends on, as bits; empty where that is not known."""
    layout = program.layout
    nq, nz, nc = len(layout.coordinates), len(layout.states), len(layout.constraints)
    if program.has("load") or not program.has("residual"):
        return []
    components = layout.components or (0,) * (nq + nz)  # none are told: all are one
    whole: dict[int, int] = {}
    for place, component in enumerate(components):
        whole[component] = whole.get(component, 0) | (1 << nq + place) | (1 << place if place < nq else 0)
    first = {Group.Q: 0, Group.QD: nq, Group.Z: 2 * nq}
    if program.has("elimination") and not program.kept_rows:
        accelerations, multipliers = (block.elements for block in program.function("elimination").results[:2])
        solved = dependences(program.graph, [*accelerations, *multipliers], first)
    else:
        own = [whole[components[i]] for i in range(nq)]
        solved = own + [sum(set(whole.values()))] * nc
    if nz == 0:
        return solved[:nq]
    first |= {Group.QDD: 2 * nq + nz, Group.LAMBDA: 3 * nq + nz}
    given = (1 << 2 * nq + nz) - 1
    rates = []
    for bits in dependences(program.graph, program.function("state_derivative").results[0].elements, first):
        row = bits & given
        for place in members(bits >> 2 * nq + nz):
            row |= solved[place]
        rates.append(row)
    return solved[:nq] + rates
