"""`table(x, y, xs, ys, zs)`: interpolation on a grid, by tables over y of the rows and one over x through them.

So bilinear and bicubic surfaces have the properties of `tables` in both directions, and continue straight outside. A
row is a function of y only: all of them share its borders, and so their corners.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.application import Application
from lagdsl.language.semantics.operators.discontinuous import met
from lagdsl.language.semantics.operators.pieces import chosen
from lagdsl.language.semantics.operators.tables import interpolation, method_of, numbers_of, points_increase
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    Array,
    Numeric,
    Scalar,
    Value,
    highest,
    is_structural,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, report_unequal

_METHODS = ("linear", "cubic")


def surface(call: Application) -> Value:
    """The value at (x, y); E0312 and E0313 for what is no grid, E0361 where points must be known, E0362 where they do
    not increase."""
    method = method_of(call, 5, _METHODS)
    if not _is_grid(call) or method is None:
        return POISON
    x, y, xs, ys, zs = (item.value for item in call.arguments[:5])
    assert isinstance(x, Scalar) and isinstance(y, Scalar)
    assert isinstance(xs, Array) and isinstance(ys, Array) and isinstance(zs, Array)
    across, along = _places(call, 0, 2), _places(call, 1, 3)
    if across is None or along is None:
        return POISON
    known = numbers_of(call, 4, zs) if is_structural(zs) else None
    values: Sequence[FlatExpression] = zs.elements if known is None else [flat.Number(value) for value in known]
    width = len(along)
    rows = [values[k * width : (k + 1) * width] for k in range(len(across))]
    through = [_curve(call, (y,), y, along, row, method) for row in rows]
    expression = _curve(call, (x,), x, across, through, method)
    numeric = (x, y, zs)
    return Scalar(expression, zs.dimension, latest(*numeric), highest(*numeric))


def _curve(
    call: Application,
    moving: tuple[Numeric, ...],
    x: Scalar,
    places: list[float],
    values: Sequence[FlatExpression],
    method: str,
) -> FlatExpression:
    pieces = interpolation(x.expression, places, values, method)
    expression = chosen(x.expression, pieces.borders, pieces.values)
    if pieces.borders:
        met(call.ctx, call.scope, call.node, call.name, expression, *moving, pieces=pieces)
    return expression


def _places(call: Application, scalar: int, points: int) -> list[float] | None:
    """The points of one direction."""
    x, xs = call.arguments[scalar], call.arguments[points]
    assert isinstance(x.value, Scalar) and isinstance(xs.value, Array)
    if not fits(x.value.dimension, xs.value.dimension):
        sides = ((x.node, x.value.dimension), (xs.node, xs.value.dimension))
        report_unequal(call.ctx, "compare", call.scope, *sides)
        return None
    if not is_structural(xs.value):
        call.ctx.sink.report("E0361", xs.node.span, which="points")
        return None
    places = numbers_of(call, points, xs.value)
    return places if places is not None and points_increase(call, points, places) else None


def _is_grid(call: Application) -> bool:
    """True if the arguments are two scalars, two arrays of two points at least, and an array over both."""
    for item in call.arguments[:2]:
        if not isinstance(item.value, Scalar) or item.value.kind not in NUMERIC:
            call.ctx.sink.report("E0312", item.node.span, expected="a scalar", found=kind_of(item.value))
            return False
    for item, rank, expected in (
        (call.arguments[2], 1, "an array of two numbers at least"),
        (call.arguments[3], 1, "an array of two numbers at least"),
        (call.arguments[4], 2, "an array of rows of numbers"),
    ):
        value = item.value
        if (
            not isinstance(value, Array)
            or len(value.shape) != rank
            or value.kind not in NUMERIC
            or min(value.shape) < 2
        ):
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(value))
            return False
    xs, ys, zs = (item.value for item in call.arguments[2:5])
    assert isinstance(xs, Array) and isinstance(ys, Array) and isinstance(zs, Array)
    if zs.shape != (*xs.shape, *ys.shape):
        wanted = f"a grid of {xs.shape[0]} rows and {ys.shape[0]} columns"
        call.ctx.sink.report("E0313", call.arguments[4].node.span, left=wanted, right=kind_of(zs))
        return False
    return True
