"""`table(x, xs, ys)`: interpolation between points, expanded into polynomials chosen by balanced conditionals.

Derivatives, engines and derivations know nothing of tables. The xs are strictly increasing and known while compiling.

- `linear`: straight lines; the slope jumps at the points.
- `cubic`: Hermite's cubic on each interval, with the slope in a point that of the parabola through it and its
  neighbors (Bessel's slopes); the value and its derivative are continuous, quadratic functions are met exactly.
- `monotone`: the same with the slopes of F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300, as in
  PCHIP: no extremum between points where the data have none; the ys must be known, too.

Outside the points each goes on straight with the slope of its end.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.application import Application
from lagdsl.language.semantics.operators.arithmetic import negative
from lagdsl.language.semantics.operators.discontinuous import met
from lagdsl.language.semantics.operators.pieces import chosen
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.product import Pieces
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    Array,
    Poison,
    Scalar,
    Text,
    Value,
    highest,
    is_structural,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, report_unequal

METHODS = ("linear", "cubic", "monotone")


def table(call: Application) -> Value:
    """The value between the points; E0361 where they must be known, E0362 where they do not increase."""
    x, xs, ys = (item.value for item in call.arguments[:3])
    nodes = [item.node for item in call.arguments]
    method = method_of(call, 3, METHODS)
    if not _are_points(call) or method is None:
        return POISON
    assert isinstance(x, Scalar) and isinstance(xs, Array) and isinstance(ys, Array)
    if not fits(x.dimension, xs.dimension):
        report_unequal(call.ctx, "compare", call.scope, (nodes[0], x.dimension), (nodes[1], xs.dimension))
        return POISON
    if not is_structural(xs) or (method == "monotone" and not is_structural(ys)):
        place, which = (nodes[1], "points") if not is_structural(xs) else (nodes[2], "values of a monotone table")
        call.ctx.sink.report("E0361", place.span, which=which)
        return POISON
    places = numbers_of(call, 1, xs)
    if places is None or not points_increase(call, 1, places):
        return POISON
    known = numbers_of(call, 2, ys) if is_structural(ys) else None
    values: Sequence[FlatExpression] = ys.elements if known is None else [flat.Number(value) for value in known]
    pieces = interpolation(x.expression, places, values, method)
    expression = chosen(x.expression, pieces.borders, pieces.values)
    if pieces.borders:
        met(call.ctx, call.scope, call.node, call.name, expression, x, pieces=pieces)
    return Scalar(expression, ys.dimension, latest(x, ys), highest(x, ys))


def method_of(call: Application, position: int, methods: Sequence[str]) -> str | None:
    """The name of the method at this position, `linear` where there is none; None after E0312."""
    if len(call.arguments) <= position:
        return "linear"
    item = call.arguments[position]
    if isinstance(item.value, Text) and item.value.value in methods:
        return item.value.value
    if not isinstance(item.value, Poison):
        listed = " or ".join(f'"{method}"' for method in methods)
        found = f'"{item.value.value}"' if isinstance(item.value, Text) else kind_of(item.value)
        call.ctx.sink.report("E0312", item.node.span, expected=listed, found=found)
    return None


def _are_points(call: Application) -> bool:
    """True if the arguments are a scalar and two arrays of one size, of two points at least."""
    x, xs, ys = call.arguments[:3]
    if not isinstance(x.value, Scalar) or x.value.kind not in NUMERIC:
        call.ctx.sink.report("E0312", x.node.span, expected="a scalar", found=kind_of(x.value))
        return False
    for item in (xs, ys):
        fitting = isinstance(item.value, Array) and len(item.value.shape) == 1 and item.value.kind in NUMERIC
        if not fitting or len(item.value.elements) < 2:  # type: ignore[union-attr]
            expected = "an array of two numbers at least"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
            return False
    assert isinstance(xs.value, Array) and isinstance(ys.value, Array)
    if xs.value.shape != ys.value.shape:
        call.ctx.sink.report("E0313", ys.node.span, left=kind_of(xs.value), right=kind_of(ys.value))
        return False
    return True


def numbers_of(call: Application, position: int, array: Array) -> list[float] | None:
    """The elements of the argument of this position; E0323 where they have no value."""
    try:
        return [evaluate(element) for element in array.elements]
    except NoValue as fault:
        call.ctx.sink.report("E0323", call.arguments[position].node.span, reason=str(fault))
        return None


def points_increase(call: Application, position: int, places: list[float]) -> bool:
    """True if they do, else E0362 at the argument of this position."""
    for first, second in pairwise(places):
        if not first < second:
            span = call.arguments[position].node.span
            call.ctx.sink.report("E0362", span, first=f"{first:g}", second=f"{second:g}")
            return False
    return True


# ---- interpolation ---------------------------------------------------------------------------------------------------


def interpolation(x: FlatExpression, places: Sequence[float], values: Sequence[FlatExpression], method: str) -> Pieces:
    """The polynomials of the intervals, in `x`."""
    secants = [
        _times(1.0 / (b - a), _minus(after, before))
        for (a, b), (before, after) in zip(pairwise(places), pairwise(values), strict=True)
    ]
    if method == "linear":
        pieces = [_line(x, places[k], values[k], secants[k]) for k in range(len(secants))]
        return Pieces(x, tuple(places[1:-1]), tuple(pieces), sharp=True)
    widths = [b - a for a, b in pairwise(places)]
    slopes = _bessel(widths, secants) if method == "cubic" else _monotone(widths, secants)
    pieces = [_line(x, places[0], values[0], slopes[0])]
    for k, width in enumerate(widths):
        bend = _minus(_minus(_times(3.0, secants[k]), _times(2.0, slopes[k])), slopes[k + 1])
        twist = _minus(_plus(slopes[k], slopes[k + 1]), _times(2.0, secants[k]))
        t = _minus(x, flat.Number(places[k]))
        inner = _plus(_times(1.0 / width, bend), _product(t, _times(1.0 / width**2, twist)))
        pieces.append(_plus(values[k], _product(t, _plus(slopes[k], _product(t, inner)))))
    pieces.append(_line(x, places[-1], values[-1], slopes[-1]))
    return Pieces(x, tuple(places), tuple(pieces), sharp=False)


def _line(x: FlatExpression, place: float, value: FlatExpression, slope: FlatExpression) -> FlatExpression:
    return _plus(value, _product(_minus(x, flat.Number(place)), slope))


def _bessel(widths: Sequence[float], secants: Sequence[FlatExpression]) -> list[FlatExpression]:
    """Slopes of the parabolas through three neighbors, at the ends of the outermost ones."""
    if len(widths) == 1:
        return [secants[0], secants[0]]
    inner = [
        _plus(_times(after / (before + after), left), _times(before / (before + after), right))
        for (before, after), (left, right) in zip(pairwise(widths), pairwise(secants), strict=True)
    ]
    return [_minus(_times(2.0, secants[0]), inner[0]), *inner, _minus(_times(2.0, secants[-1]), inner[-1])]


def _monotone(widths: Sequence[float], secants: Sequence[FlatExpression]) -> list[FlatExpression]:
    """Weighted harmonic means of neighboring secants; 0 where they differ in sign; at the ends limited parabolas."""
    steps = [evaluate(secant) for secant in secants]
    if len(widths) == 1:
        return [secants[0], secants[0]]
    slopes = []
    for (before, after), (left, right) in zip(pairwise(widths), pairwise(steps), strict=True):
        one, two = 2 * after + before, after + 2 * before
        slopes.append((one + two) / (one / left + two / right) if left * right > 0 else 0.0)
    first = _end(widths[0], widths[1], steps[0], steps[1])
    last = _end(widths[-1], widths[-2], steps[-1], steps[-2])
    return [flat.Number(slope) for slope in (first, *slopes, last)]


def _end(near: float, far: float, step: float, following: float) -> float:
    slope = ((2 * near + far) * step - near * following) / (near + far)
    if slope * step <= 0:
        return 0.0
    return 3 * step if step * following <= 0 and abs(slope) > 3 * abs(step) else slope


# ---- sums and products, folded where both sides are numbers ----------------------------------------------------------


def _plus(left: FlatExpression, right: FlatExpression) -> FlatExpression:
    if isinstance(left, flat.Number) and isinstance(right, flat.Number):
        return flat.Number(left.value + right.value)
    return flat.Binary("+", left, right)


def _minus(left: FlatExpression, right: FlatExpression) -> FlatExpression:
    if isinstance(right, flat.Number) and (right.value == 0 or isinstance(left, flat.Number)):
        return left if right.value == 0 else _plus(left, negative(right))
    return flat.Binary("-", left, right)


def _times(factor: float, value: FlatExpression) -> FlatExpression:
    return flat.Number(factor * value.value) if isinstance(value, flat.Number) else _product(flat.Number(factor), value)


def _product(left: FlatExpression, right: FlatExpression) -> FlatExpression:
    return flat.Binary("*", left, right)
