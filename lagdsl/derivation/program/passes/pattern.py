"""Entries of matrices that can be nonzero: what shares nothing is solved apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.algebra.graph.occurrence import Dependences, Indices, dependences
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.foundation.numerics.disjoint_columns import disjoint_columns
from lagdsl.foundation.numerics.reverse_cuthill_mckee import reverse_cuthill_mckee
from lagdsl.foundation.record import record, remembered

# Rows and columns of entries, row by row.
Pattern = tuple[Sequence[int], Sequence[int]]


# Elimination in a band has to save so much of the multiplications of a dense one: its inner loops are short.
_WORTH_A_BAND = 4


@record()
class EquationsPattern:
    """Entries of the derivatives of r, of zd - g and of s by q, qd, z, qdd and lam, (nq + nz + nc, 3 nq + nz + nc); all
    empty where they are not told.

    `places` (nq + nz + nc) of its rows, and of qd, z and lam, in an order in which entries lie near the diagonal,
    columns of coordinates and accelerations under those of their rates. `groups` (2 nq + nz) of q, qd and z, and
    `value_groups` (nq + nc) of qdd and lam: columns of one share no row. Of lam, rows of zd count alone: the others are
    those of J.
    """

    entries: Pattern = ((), ())
    places: tuple[int, ...] = ()
    groups: tuple[int, ...] = ()
    value_groups: tuple[int, ...] = ()


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


@remembered
def equations_pattern(program: Program) -> EquationsPattern:
    """Told where elimination in a band is so much shorter than that of d(qdd, zd)/d(qd, z), which is dense in general.
    Loads that depend on accelerations are not followed."""
    layout = program.layout
    nq, nz, nc = len(layout.coordinates), len(layout.states), len(layout.constraints)
    if program.has("load") or not nq + nz:
        return EquationsPattern()
    state, count = 2 * nq + nz, nq + nz + nc
    half = (_coupled(program) + 1) // 2
    if not _is_worth_it(count, half, half, nq + nz):  # long lists and orders of entries are for nothing
        return EquationsPattern()
    rows, columns = _entries_of_equations(program)
    unknowns = np.concatenate([np.arange(nq), np.arange(nq + nz), np.arange(nq), np.arange(nq + nz, count)])[columns]
    order = reverse_cuthill_mckee(count, zip(rows.tolist(), unknowns.tolist(), strict=True))
    places = np.argsort(order)
    offsets = places[unknowns] - places[rows]
    lower, upper = int(np.max(-offsets, initial=0)), int(np.max(offsets, initial=0))
    if not len(rows) or not _is_worth_it(count, lower, upper, nq + nz):
        return EquationsPattern()
    of_state = columns < state
    of_values = ~of_state & ((rows >= nq) & (rows < nq + nz) | (rows < nq) & (columns < state + nq))
    return EquationsPattern(
        (rows.tolist(), columns.tolist()),
        tuple(places.tolist()),
        tuple(disjoint_columns(rows[of_state], columns[of_state], (count, state)).tolist()),
        tuple(disjoint_columns(rows[of_values], columns[of_values] - state, (count, nq + nc)).tolist()),
    )


def _is_worth_it(count: int, lower: int, upper: int, dense: int) -> bool:
    """True if elimination of so many rows in this band is much shorter than that of a dense matrix."""
    return 3 * _WORTH_A_BAND * count * lower * (lower + upper + 1) <= dense**3


def _coupled(program: Program) -> int:
    """With so many others the row of motion with most accelerations is coupled by accelerations of both: half of them
    lie on one side of it in any order, and so on both sides of the diagonal."""
    motion = dependences(program.graph, program.function("residual").results[0].elements, {Group.QDD: 0})
    longest = int(np.argmax(motion.counts)) if len(motion) else 0
    others = motion[longest] if len(motion) else ()
    return sum(other != longest and longest in motion[other] for other in others)


def _symbols_of_equations(program: Program) -> Dependences:
    """The columns of each row."""
    graph, layout = program.graph, program.layout
    nq, nz = len(layout.coordinates), len(layout.states)
    state = 2 * nq + nz
    first = {Group.Q: 0, Group.QD: nq, Group.Z: 2 * nq, Group.QDD: state, Group.LAMBDA: state + nq}
    motion, constraints = program.function("residual").results
    rates = program.function("state_derivative").results[0]
    return dependences(graph, [*motion.elements, *rates.elements, *constraints.elements], first)


def _entries_of_equations(program: Program) -> tuple[Indices, Indices]:
    """Rows and columns, row by row, and those of J."""
    found = _symbols_of_equations(program)
    layout = program.layout
    nq, nz, nc = len(layout.coordinates), len(layout.states), len(layout.constraints)
    state, width = 2 * nq + nz, 3 * nq + nz + nc
    own = np.repeat(np.arange(len(found)), found.counts) * width + np.concatenate(list(found))
    rows, columns = (np.array(numbers, dtype=np.intp) for numbers in jacobian_pattern(program))
    of_rows, of_multipliers = (nq + nz + rows) * width + state + columns, columns * width + state + nq + rows
    return np.divmod(np.unique(np.concatenate([own, of_rows, of_multipliers])), width)
