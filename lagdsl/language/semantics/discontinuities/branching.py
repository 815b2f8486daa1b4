"""Functions of the motion of which the branches are relations, as if an `if` wrote them: those that jump, and those
over whose corners velocities jump."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.reached import Below, reached
from lagdsl.language.flat.traversal import operands
from lagdsl.language.flat.ways import held, ways
from lagdsl.language.semantics.discontinuities.corners import what_moves
from lagdsl.language.semantics.scope.product import Met
from lagdsl.language.semantics.scope.values import Order

_JUMPING = ("floor", "ceil", "mod", "wrap")


def branching(flat: fm.FlatModel, functions: Sequence[Met], truths: Sequence[Met]) -> frozenset[int]:
    """Identities of those of the `functions` of the motion that jump in what moves or in a relation of the `truths`,
    and of those with a corner in the way of a mass, in a constraint or in a gap. The sides of relations do not bend
    what they choose."""
    if not functions:
        return frozenset()
    relations = {id(each.expression) for each in truths}

    def below(x: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:
        return () if id(x) in relations else operands(x)

    gaps = [contact.gap for contact in flat.events.contacts if not contact.one_way]
    bending = {id(x) for x in reached(flat, [*ways(flat), *gaps], below)}
    rows = held(flat)
    met_in_rows = {id(each.expression) for each in functions} & {id(x) for x in reached(flat, rows, below)}
    for row in rows if met_in_rows else ():
        inside = {id(x) for x in reached(flat, [row], below)}
        met = (each.expression for each in functions if id(each.expression) in inside)
        bending |= {id(corner) for corner in met if _stands_beside(flat, row, corner, below)}
    jumping = {
        id(x) for x in reached(flat, [*what_moves(flat), *(each.expression for each in truths)], _but_for_turns(flat))
    }
    return frozenset(
        id(each.expression)
        for each in functions
        if (id(each.expression) in jumping and each.function in _JUMPING)
        or (id(each.expression) in bending and each.order >= Order.CONFIGURATION and _is_sharp(each))
    )


def _is_sharp(met: Met) -> bool:
    return met.pieces is None or met.pieces.sharp


def _stands_beside(flat: fm.FlatModel, row: fx.FlatExpression, corner: fx.FlatExpression, below: Below) -> bool:
    """True if the row has this corner beside other quantities that move, as a track has; where there is nothing else,
    `max(l - l0, 0) = 0`, the row has no gradient on one side."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    beside = reached(flat, [row], lambda x: () if x is corner else below(x))
    return any(isinstance(x, fx.Variable) and x.name in moving for x in beside)


def _but_for_turns(flat: fm.FlatModel) -> Below:
    """What stands below; the angle in place of its `wrap`, where a sine or a cosine of it does not jump."""
    values = {item.name: item.value for item in flat.named if isinstance(item, fm.Definition)}
    seen: set[int] = set()  # angles of chains share their summands

    def below(x: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:
        match x:
            case fx.Function("sin" | "cos", (angle,)):
                return tuple(summands(angle))
            case _:
                return operands(x)

    def summands(angle: fx.FlatExpression) -> Iterator[fx.FlatExpression]:
        stack = [angle]
        while stack:
            each = stack.pop()
            if id(each) in seen:
                continue
            seen.add(id(each))
            match each:
                case fx.Binary("+" | "-", left, right):
                    stack += [left, right]
                case fx.Unary("-", turned):
                    stack.append(turned)
                case fx.Function("mod", (turned, fx.Number(period))) if period == 2 * math.pi:
                    stack.append(turned)
                case fx.Binary("*", fx.Number(times), turned) if times == round(times):
                    stack.append(turned)
                case fx.Variable(name) if name in values:
                    stack.append(values[name])
                case _:
                    yield each

    return below
