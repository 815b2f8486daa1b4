"""Discontinuities over which velocities or energies jump: their branches are relations, as if an `if` wrote them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.reached import reached
from lagdsl.flat.ways import held, ways
from lagdsl.semantics.scope.product import Met
from lagdsl.semantics.scope.values import Order

_JUMPING = ("floor", "ceil", "mod", "wrap")
_Below: TypeAlias = Callable[[fx.FlatExpression], tuple[fx.FlatExpression, ...]]


def branching(flat: fm.FlatModel, met: Sequence[Met], below: _Below) -> frozenset[int]:
    """Identities of functions with a corner in the way of a mass, in a constraint or in a gap, or with a jump in these,
    in a row of velocity level, in an energy or in a relation of these. `below` ends at relations: their sides do not
    bend what they choose."""
    functions = [each for each in met if each.located and each.order >= Order.CONFIGURATION]
    if not functions:
        return frozenset()
    gaps = [contact.gap for contact in flat.events.contacts if not contact.one_way]
    bending = {id(x) for x in reached(flat, [*ways(flat), *gaps], below)}
    bending |= {id(each.expression) for row in held(flat) for each in functions if _bends_row(flat, row, each, below)}
    energies = [term.value for term in flat.energies if term.kind != "dissipation"]
    rows = [x for each in flat.constraints for x in each.residuals]
    jumping = {id(x) for x in reached(flat, [*ways(flat), *gaps, *energies, *rows])}
    return frozenset(
        id(each.expression)
        for each in functions
        if (id(each.expression) in bending and (each.pieces is None or each.pieces.sharp))
        or (id(each.expression) in jumping and each.function in _JUMPING)
    )


def _bends_row(flat: fm.FlatModel, row: fx.FlatExpression, each: Met, below: _Below) -> bool:
    """True if the row has this corner beside other quantities that move, as a track has; where there is nothing else,
    `max(l - l0, 0) = 0`, the row has no gradient on one side."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    if all(x is not each.expression for x in reached(flat, [row], below)):
        return False
    beside = reached(flat, [row], lambda x: () if x is each.expression else below(x))
    return any(isinstance(x, fx.Variable) and x.name in moving for x in beside)
