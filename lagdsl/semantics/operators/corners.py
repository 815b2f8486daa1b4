"""Corners and jumps of time alone: they become entries of the discretes, whose changes are time events.

`max(a, b)` is `a` or `b` by the truth of `a - b >= 0`, `floor(x)` a whole number, a table the polynomial of one
interval. All of that is constant between events, so the equations are smooth there, and a derivative by time is that of
the present piece. Nothing is stepped over: the instants are computed ahead.

An argument that depends on the motion or on inputs is evaluated as it is (`sqrt(max(x, 0))` must not see a negative
number); for each such corner there is a distance that passes zero there, at which steps end. A corner or jump over
which velocities or energies jump is an event instead: its branch is a relation, as if it were written by an `if`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from lagdsl.flat import expression as flat
from lagdsl.flat.events import BRANCH, Timed
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.quantity import Spans, Variability
from lagdsl.semantics.scope.context import Context
from lagdsl.semantics.scope.occurrences import Mode
from lagdsl.semantics.scope.product import Met
from lagdsl.semantics.scope.scope import Scope
from lagdsl.semantics.scope.values import Numeric, Order, Scalar, highest, latest
from lagdsl.syntax import nodes
from lagdsl.units.dimension import DIMENSIONLESS

# Subtracted from zero, it makes a negative number.
_LEAST = 1e-300


def is_timed(ctx: Context, *values: Numeric) -> bool:
    """True if relations between these are of time alone, and are to be located."""
    moving = latest(*values) == Variability.CONTINUOUS and highest(*values) == Order.STILL
    return moving and not ctx.current.quiet


def has_corner(ctx: Context, *values: Numeric) -> bool:
    """True if a corner of a function of these is a time event. At an event functions are taken as they stand."""
    return is_timed(ctx, *values) and ctx.current.mode is not Mode.EVENT


def met(
    ctx: Context,
    scope: Scope,
    node: nodes.Node,
    expression: FlatExpression,
    distance: FlatExpression,
    *values: Numeric,
    sharp: bool = True,
    located: bool = True,
) -> FlatExpression:
    """The same expression, remembered as one with a corner where the motion or an input can meet it, or at an event the
    variables of a clause. Not `sharp`: its slope is continuous. Not `located`: steps do not end there."""
    at_event = ctx.current.mode is Mode.EVENT
    moving = latest(*values) == Variability.CONTINUOUS and highest(*values) > Order.STILL
    if moving or (at_event and latest(*values) in (Variability.DISCRETE, Variability.CONTINUOUS)):
        spans = (node.span, *scope.spans)
        located = located and not ctx.current.quiet and not at_event
        ctx.product.corners.append(Met(expression, distance, spans, highest(*values), sharp, located))
    return expression


def is_branch(ctx: Context, scope: Scope, node: nodes.Node, *values: Numeric) -> bool:
    """True if the branches of this function of the motion are those of a relation."""
    moving = latest(*values) == Variability.CONTINUOUS and highest(*values) > Order.STILL
    always = not ctx.current.quiet and ctx.current.mode is Mode.ALWAYS
    return moving and always and (node.span, *scope.spans) in ctx.conventions.branches


def at_whole_numbers(x: FlatExpression) -> FlatExpression:
    """A distance that passes zero where x is a whole number: parabolas in turn above and below, with slopes of 1 there.
    Zero is met exactly."""
    below = flat.Function("floor", (x,))
    beyond = flat.Binary("-", x, below)
    arc = flat.Binary("*", beyond, flat.Binary("-", flat.ONE, beyond))
    odd = flat.Function("mod", (below, flat.Number(2.0)))
    return flat.Binary("*", flat.Binary("-", flat.ONE, flat.Binary("*", flat.Number(2.0), odd)), arc)


def at_borders(x: FlatExpression, borders: Sequence[float]) -> list[FlatExpression]:
    """The same for given numbers, by several distances: their signs are the bits of a Gray code of the interval, so
    that no two intervals have the same signs. A step over a narrow one shows."""
    count = len(borders)
    return [_alternating(x, borders[(1 << k) - 1 :: 2 << k]) for k in range(count.bit_length())]


def _alternating(x: FlatExpression, borders: Sequence[float]) -> FlatExpression:
    """Parabolas between the borders, in turn above and below zero, with slopes of 1 there; straight outside."""
    pieces: list[FlatExpression] = [flat.Binary("-", flat.Number(borders[0]), x)]
    for k, (a, b) in enumerate(pairwise(borders)):
        sides = flat.Binary("-", x, flat.Number(a)), flat.Binary("-", x, flat.Number(b))
        arc = flat.Binary("*", flat.Binary("*", flat.Number((-1) ** k / (b - a)), sides[0]), sides[1])
        pieces.append(arc)
    sign = flat.Number((-1.0) ** len(borders))
    pieces.append(flat.Binary("*", sign, flat.Binary("-", x, flat.Number(borders[-1]))))
    return chosen(x, borders, pieces)


def truth(
    ctx: Context, text: str, spans: Spans, difference: FlatExpression, *, strict: bool, told: bool
) -> flat.Variable:
    """The entry that is the truth of `difference > 0` or, where it is not `strict`, of `difference >= 0`."""
    stands = flat.Binary(">" if strict else ">=", difference, flat.ZERO)

    def make(name: str) -> Timed:
        distance = flat.Conditional(flat.Variable(name), difference, flat.Unary("-", difference))
        return Timed(
            spans=spans,
            name=name,
            kind="relation" if told else "corner",
            value=stands,
            distances=(distance,),
            changes=(0,),
        )

    return flat.Variable(ctx.product.occurrences.entry(text, stands, make))


def of_call(
    ctx: Context, scope: Scope, node: nodes.Node, difference: FlatExpression, *values: Numeric
) -> flat.Variable | None:
    """The truth on which the value of a continuous function of these depends; None where it is taken as it stands."""
    text, spans = _place(scope, node, BRANCH)
    if has_corner(ctx, *values):
        return truth(ctx, text, spans, difference, strict=False, told=False)
    if not is_branch(ctx, scope, node, *values):
        return None
    dimension = next((value.dimension for value in values if value.dimension is not None), DIMENSIONLESS)
    name = ctx.product.occurrences.relation(text, spans, difference, dimension, strict=False)
    return flat.Variable(name)


def whole(ctx: Context, scope: Scope, node: nodes.Node, x: FlatExpression) -> flat.Variable:
    """floor(x)."""
    text, spans = _place(scope, node)
    stands = flat.Function("floor", (x,))

    def make(name: str) -> Timed:
        beyond = flat.Binary("-", x, flat.Variable(name))
        return Timed(
            spans=spans,
            name=name,
            kind="jump",
            value=stands,
            distances=(beyond, flat.Binary("-", flat.ONE, beyond)),
            changes=(-1, 1),
        )

    return flat.Variable(ctx.product.occurrences.entry(text, stands, make))


def whole_by_parity(ctx: Context, scope: Scope, node: nodes.Node, x: FlatExpression) -> FlatExpression:
    """floor(x) where it is an event: the nearest even or odd number, by a relation that turns at each whole number.
    Near such a number neither of them jumps."""
    text, spans = _place(scope, node, BRANCH)
    half, two = flat.Binary("/", x, flat.Number(2.0)), flat.Number(2.0)
    odd_now = flat.Function("mod", (flat.Function("floor", (x,)), two))
    even = flat.Binary("-", at_whole_numbers(x), flat.Binary("*", flat.Number(_LEAST), odd_now))
    name = ctx.product.occurrences.relation(text, spans, even, DIMENSIONLESS, strict=False)

    def nearest(shift: float) -> FlatExpression:
        return flat.Binary("*", two, flat.Function("floor", (flat.Binary("+", half, flat.Number(shift)),)))

    odd = flat.Binary("+", nearest(-0.25), flat.ONE)
    return flat.Conditional(flat.Variable(name), nearest(0.25), odd)


def piece(ctx: Context, scope: Scope, node: nodes.Node, x: FlatExpression, borders: Sequence[float]) -> flat.Variable:
    """The number of the interval between `borders` in which x is: k from borders[k - 1] on, up to borders[k]."""
    text, spans = _place(scope, node, "piece of ")
    count = len(borders)
    stands = chosen(x, borders, [flat.Number(float(k)) for k in range(count + 1)])

    def make(name: str) -> Timed:
        ends = [flat.Number(border) for border in borders]
        below = chosen_by_number(flat.Variable(name), [flat.Number(-float("inf")), *ends])
        above = chosen_by_number(flat.Variable(name), [*ends, flat.Number(float("inf"))])
        return Timed(
            spans=spans,
            name=name,
            kind="corner",
            value=stands,
            distances=(flat.Binary("-", x, below), flat.Binary("-", above, x)),
            changes=(-1, 1),
        )

    return flat.Variable(ctx.product.occurrences.entry(text, stands, make))


def branch_number(ctx: Context, scope: Scope, node: nodes.Node, x: Scalar, borders: Sequence[float]) -> FlatExpression:
    """The same of a place: the number of relations that hold."""
    number: FlatExpression = flat.ZERO
    for border in borders:
        beyond = of_call(ctx, scope, node, flat.Binary("-", x.expression, flat.Number(border)), x)
        assert beyond is not None
        number = flat.Binary("+", number, flat.Conditional(beyond, flat.ONE, flat.ZERO))
    return number


def chosen(x: FlatExpression, borders: Sequence[float], pieces: Sequence[FlatExpression]) -> FlatExpression:
    """`pieces[k]` below `borders[k]`, the last one beyond them all: a balanced tree of conditionals."""
    if not borders:
        return pieces[0]
    middle = len(borders) // 2
    below = chosen(x, borders[:middle], pieces[: middle + 1])
    above = chosen(x, borders[middle + 1 :], pieces[middle + 1 :])
    return flat.Conditional(flat.Binary("<", x, flat.Number(borders[middle])), below, above)


def chosen_by_number(number: FlatExpression, pieces: Sequence[FlatExpression]) -> FlatExpression:
    """`pieces[number]`."""
    return chosen(number, [k - 0.5 for k in range(1, len(pieces))], pieces)


def _place(scope: Scope, node: nodes.Node, part: str = "") -> tuple[str, Spans]:
    return f"{part}{scope.owner.prefix}{node.span.text}", (node.span, *scope.spans)
