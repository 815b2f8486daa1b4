"""Entries of the constraint Jacobian that can be nonzero: searches split it into parts that share nothing."""

from __future__ import annotations

from lagdsl.program.program import Program


def jacobian_pattern(program: Program) -> tuple[list[int], list[int]]:
    """Rows and columns of the entries that are not zero by themselves, row by row."""
    zero, width = program.graph.zero, len(program.layout.coordinates)
    blocks = [program.function(name).results[1].elements for name in ("position_constraint", "velocity_constraint")]
    places = [index for index, nodes in enumerate(zip(*blocks, strict=True)) if any(node != zero for node in nodes)]
    return [place // width for place in places], [place % width for place in places]
