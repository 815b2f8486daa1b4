"""Discontinuities over which velocities or energies jump: their branches are relations, as if an `if` wrote them."""

from __future__ import annotations

from collections.abc import Sequence, Set

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.reached import Below, reached
from lagdsl.language.flat.traversal import operands
from lagdsl.language.flat.ways import held, ways
from lagdsl.language.semantics.scope.product import Met

_JUMPING = ("floor", "ceil", "mod", "wrap")


def branching(flat: fm.FlatModel, functions: Sequence[Met], truths: Set[int]) -> frozenset[int]:
    """Identities of those of the `functions` of the motion with a corner in the way of a mass, in a constraint or in a
    gap, or with a jump in these, in a row of velocity level, in an energy or in a relation of these. The sides of
    relations, which are the nodes `truths`, do not bend what they choose."""
    if not functions:
        return frozenset()

    def below(x: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:
        return () if id(x) in truths else operands(x)

    gaps = [contact.gap for contact in flat.events.contacts if not contact.one_way]
    bending = {id(x) for x in reached(flat, [*ways(flat), *gaps], below)}
    rows = held(flat)
    met_in_rows = {id(each.expression) for each in functions} & {id(x) for x in reached(flat, rows, below)}
    for row in rows if met_in_rows else ():
        inside = {id(x) for x in reached(flat, [row], below)}
        met = (each.expression for each in functions if id(each.expression) in inside)
        bending |= {id(corner) for corner in met if _stands_beside(flat, row, corner, below)}
    energies = [term.value for term in flat.energies if term.kind != "dissipation"]
    residuals = [x for each in flat.constraints for x in each.residuals]
    jumping = {id(x) for x in reached(flat, [*ways(flat), *gaps, *energies, *residuals])}
    return frozenset(
        id(each.expression)
        for each in functions
        if (id(each.expression) in bending and (each.pieces is None or each.pieces.sharp))
        or (id(each.expression) in jumping and each.function in _JUMPING)
    )


def _stands_beside(flat: fm.FlatModel, row: fx.FlatExpression, corner: fx.FlatExpression, below: Below) -> bool:
    """True if the row has this corner beside other quantities that move, as a track has; where there is nothing else,
    `max(l - l0, 0) = 0`, the row has no gradient on one side."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    beside = reached(flat, [row], lambda x: () if x is corner else below(x))
    return any(isinstance(x, fx.Variable) and x.name in moving for x in beside)
