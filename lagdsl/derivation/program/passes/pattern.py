"""Entries of matrices that can be nonzero: what shares nothing is solved apart."""

from __future__ import annotations

from lagdsl.derivation.program.program import Program

# Rows and columns of entries, row by row.
Pattern = tuple[list[int], list[int]]


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
    zero, width = program.graph.zero, len(program.layout.coordinates)
    one, other = (program.function(name).results[1].elements for name in ("position_constraint", "velocity_constraint"))
    places = [i for i, (x, y) in enumerate(zip(one, other, strict=True)) if x != zero or y != zero]
    return [place // width for place in places], [place % width for place in places]


def kept_patterns(program: Program) -> tuple[Pattern, Pattern]:
    """Of the rows that elimination leaves to run time: what a multiplier of each accelerates, and whose accelerations
    move which row, itself among them. None where nothing is zero."""
    kept = program.kept_rows
    if not kept or not program.has("elimination"):
        return ([], []), ([], [])
    zero, width = program.graph.zero, len(program.layout.coordinates)
    elements = program.function("elimination").results[2].elements
    moved = [{j for j in range(width) if elements[i * width + j] != zero} for i in range(len(kept))]
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
