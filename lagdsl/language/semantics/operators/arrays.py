"""Array constructors, subscripts, ranges, comprehensions and reductions."""

from __future__ import annotations

from typing import assert_never

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.arithmetic import Operand, added, multiplied
from lagdsl.language.semantics.operators.discontinuous import met
from lagdsl.language.semantics.operators.geometry import operand
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.limits import another_turn, range_fits
from lagdsl.language.semantics.scope.naming import an, kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    AnyDimension,
    Array,
    Poison,
    Scalar,
    Value,
    Vector,
    components,
    element_at,
    highest,
    is_zero,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, joined, report_unequal
from lagdsl.language.syntax import nodes

# ---- constructors ----------------------------------------------------------------------------------------------------


def stacked(ctx: Context, scope: Scope, node: nodes.Node, parts: list[tuple[nodes.Node, Value]]) -> Value:
    """`{a, b, c}`: values of one shape and dimension become an array with one dimension more."""
    values = []
    for part, value in parts:
        found = operand(ctx, value, part.span)
        if isinstance(found, Poison):
            return POISON
        if not isinstance(found, Scalar | Vector | Array):
            ctx.sink.report("E0312", part.span, expected="a number or a vector", found=kind_of(found))
            return POISON
        values.append(components(found) if isinstance(found, Vector) else found)
    dimension: AnyDimension = None
    first = parts[0][0]
    for (part, _), value in zip(parts, values, strict=True):
        if not fits(dimension, value.dimension):
            report_unequal(ctx, "put together in one array", scope, (first, dimension), (part, value.dimension))
            return POISON
        if dimension is None:
            dimension, first = value.dimension, part
    return _stack(ctx, node, values, dimension)


def _stack(ctx: Context, node: nodes.Node, values: list[Scalar | Array], dimension: AnyDimension) -> Value:
    shapes = [value.shape if isinstance(value, Array) else () for value in values]
    for value, shape in zip(values, shapes, strict=True):
        if shape != shapes[0]:
            ctx.sink.report("E0313", node.span, left=kind_of(values[0]), right=kind_of(value))
            return POISON
    elements: list[FlatExpression] = []
    for value in values:
        elements.extend(value.elements if isinstance(value, Array) else (value.expression,))
    kinds = {value.kind for value in values}
    if len(kinds) > 1 and not kinds <= set(NUMERIC):
        odd = next(value for value in values[1:] if value.kind != values[0].kind)
        ctx.sink.report(
            "E0312", node.span, expected=f"elements of one kind, such as {an(values[0].kind)}", found=an(odd.kind)
        )
        return POISON
    kind = kinds.pop() if len(kinds) == 1 else "Real"
    return Array(tuple(elements), (len(values), *shapes[0]), dimension, latest(*values), highest(*values), kind)


def matrix(ctx: Context, scope: Scope, node: nodes.Matrix, adopt: bool) -> Value:
    """`[a, b; c, d]`."""
    rows: list[tuple[nodes.Node, Value]] = []
    for row in node.rows:
        parts: list[tuple[nodes.Node, Value]] = [(part, ctx.elaborate(ctx, scope, part, adopt)) for part in row]
        rows.append((row[0], stacked(ctx, scope, node, parts)))
    return stacked(ctx, scope, node, rows)


# ---- subscripts ------------------------------------------------------------------------------------------------------


def subscript_indices(
    ctx: Context, scope: Scope, subscripts: tuple[nodes.Subscript, ...], shape: tuple[int, ...], node: nodes.Node
) -> list[int | tuple[int, ...]] | None:
    """1-based indices, one number or (for a slice) a tuple for each subscript; None after a diagnostic."""
    if len(subscripts) > len(shape):
        ctx.sink.report("E0341", node.span, index=len(subscripts), extent=len(shape))
        return None
    result: list[int | tuple[int, ...]] = []
    for subscript, extent in zip(subscripts, shape, strict=False):
        match subscript:
            case nodes.All():
                found: int | tuple[int, ...] | None = tuple(range(1, extent + 1))
            case nodes.Range():
                found = range_values(ctx, scope, subscript)
            case nodes.Literal() | nodes.Designator() | nodes.Compound() | nodes.Parenthesized():
                value = ctx.elaborate(ctx, scope, subscript, False)
                if isinstance(value, Array) and value.kind == "Integer":
                    numbers = [
                        structural_integer(ctx, element_at(value, k), subscript, "E0333") for k in range(value.shape[0])
                    ]
                    found = tuple(number for number in numbers if number is not None)
                else:
                    found = structural_integer(ctx, value, subscript, "E0333")
            case _:
                assert_never(subscript)
        if found is None:
            return None
        for index in (found,) if isinstance(found, int) else found:
            if not 1 <= index <= extent:
                ctx.sink.report("E0316", subscript.span, index=index, extent=extent)
                return None
        result.append(found)
    return result


def select(array: Array, indices: list[int | tuple[int, ...]]) -> Scalar | Array:
    """The element or slice of the array."""
    full = [*indices, *(tuple(range(1, extent + 1)) for extent in array.shape[len(indices) :])]
    positions = [0]
    shape: list[int] = []
    for found, extent in zip(full, array.shape, strict=True):
        chosen = (found,) if isinstance(found, int) else found
        positions = [position * extent + index - 1 for position in positions for index in chosen]
        if not isinstance(found, int):
            shape.append(len(found))
    parts = tuple(array.elements[position] for position in positions)
    if not shape:
        return Scalar(parts[0], array.dimension, array.variability, array.order, array.kind)
    return Array(parts, tuple(shape), array.dimension, array.variability, array.order, array.kind)


# ---- ranges and loops ------------------------------------------------------------------------------------------------


def range_values(ctx: Context, scope: Scope, node: nodes.Expression | nodes.Range) -> tuple[int, ...] | None:
    """The values a loop index takes: `1:n`, `start:step:stop`, `n` (1 to n) or an array of Integers."""
    if not isinstance(node, nodes.Range):
        value = ctx.elaborate(ctx, scope, node, False)
        if isinstance(value, Array):
            found = [
                structural_integer(ctx, element_at(value, k), node, "E0301", name=node.span.text)
                for k in range(value.shape[0])
            ]
            return tuple(number for number in found if number is not None) if None not in found else None
        count = structural_integer(ctx, value, node, "E0301", name=node.span.text)
        return tuple(range(1, count + 1)) if count is not None and range_fits(ctx, node.span, count) else None
    numbers = []
    for part in (node.start, node.step, node.stop):
        if part is not None:
            value = ctx.elaborate(ctx, scope, part, False)
            numbers.append(structural_integer(ctx, value, part, "E0301", name=part.span.text))
    bounds = [number for number in numbers if number is not None]
    if len(bounds) < len(numbers):
        return None
    start, step, stop = bounds if len(bounds) == 3 else (bounds[0], 1, bounds[1])
    if step == 0:
        ctx.sink.report("E0323", node.span, reason="the step of a range is zero")
        return None
    values = range(start, stop + (1 if step > 0 else -1), step)
    count = max(0, (stop - start) // step + 1)  # len() refuses what no memory holds
    return tuple(values) if range_fits(ctx, node.span, count) else None


def index_value(number: int) -> Scalar:
    return Scalar(flat.Number(float(number)), DIMENSIONLESS, kind="Integer")


def turns(ctx: Context, scope: Scope, iterators: tuple[nodes.Iterator, ...]) -> list[Scope] | None:
    """A scope for each turn of nested loops; later ranges may use earlier indices. None after a diagnostic."""
    if not iterators:
        return [scope]
    first, *rest = iterators
    values = range_values(ctx, scope, first.range)
    if values is None:
        return None
    found: list[Scope] = []
    for number in values:
        if not another_turn(ctx, first.span):
            return None
        inner = turns(ctx, scope.local({first.name: index_value(number)}, (number,)), tuple(rest))
        if inner is None:
            return None
        found += inner
    return found


def comprehension(ctx: Context, scope: Scope, node: nodes.Comprehension, adopt: bool) -> Value:
    """`{body for i in 1:n, j in 1:m}`: the last index is the outermost dimension, as in Modelica."""
    *inner, outer = node.iterators
    parts: list[tuple[nodes.Node, Value]] = []
    found = turns(ctx, scope, (outer,))
    if found is None:
        return POISON
    for turn in found:
        if inner:
            part: nodes.Expression = nodes.Comprehension(span=node.span, body=node.body, iterators=tuple(inner))
            parts.append((node, ctx.elaborate(ctx, turn, part, adopt)))
        else:
            parts.append((node.body, ctx.elaborate(ctx, turn, node.body, adopt)))
    if not parts:
        ctx.sink.report("E0323", node.span, reason="the array has no elements")
        return POISON
    return stacked(ctx, scope, node, parts)


REDUCTIONS = ("sum", "product", "min", "max")


def reduction(ctx: Context, scope: Scope, node: nodes.Reduction) -> Value:
    """`sum(body for i in 1:n)` and its sisters."""
    name = node.function.name if isinstance(node.function, nodes.Reference) else ""
    if name not in REDUCTIONS:
        ctx.sink.report(
            "E0209", node.function.span, name=node.function.span.text, help=f"reductions are {', '.join(REDUCTIONS)}"
        )
        return POISON
    found = turns(ctx, scope, node.iterators)
    if found is None:
        return POISON
    values = [operand(ctx, ctx.elaborate(ctx, turn, node.body, False), node.body.span) for turn in found]
    operands = [Operand(node.body, value) for value in values]
    return reduced(ctx, scope, name, operands, node)


def reduced(ctx: Context, scope: Scope, name: str, operands: list[Operand], node: nodes.Node) -> Value:
    """The values combined pairwise, so that the depth of the result grows with the logarithm of their number."""
    if any(isinstance(item.value, Poison) for item in operands) or not _one_kind(ctx, name, operands):
        return POISON
    if not operands:
        if name in ("min", "max"):
            ctx.sink.report("E0323", node.span, reason=f"`{name}` of nothing")
            return POISON
        if name == "sum":
            return Scalar(flat.ZERO, None, kind="Integer", is_nothing=True)
        return Scalar(flat.ONE, DIMENSIONLESS, kind="Integer")
    while len(operands) > 1:
        paired = [
            Operand(item.node, combined(ctx, scope, name, item, operands[k + 1], node))
            if k + 1 < len(operands)
            else item
            for k, item in enumerate(operands)
            if k % 2 == 0
        ]
        if any(isinstance(item.value, Poison) for item in paired):
            return POISON
        operands = paired
    return operands[0].value


def _one_kind(ctx: Context, name: str, operands: list[Operand]) -> bool:
    """E0312 for truths and enumerations among numbers, or where they are to be added."""
    kinds = [getattr(item.value, "kind", "Real") for item in operands]
    for item, kind in zip(operands, kinds, strict=True):
        if kind in NUMERIC:
            continue
        if name in ("sum", "product") or any(other != kind for other in kinds):
            expected = f"numbers in `{name}`" if name in ("sum", "product") else f"values of one kind in `{name}`"
            ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
            return False
    return True


def combined(ctx: Context, scope: Scope, name: str, left: Operand, right: Operand, node: nodes.Node) -> Value:
    """One step of a reduction."""
    one, two = left.value, right.value
    if name == "sum":
        if is_zero(one) or is_zero(two):
            return two if is_zero(one) else one
        numeric = isinstance(one, Scalar | Vector | Array) and isinstance(two, Scalar | Vector | Array)
        if numeric:
            return added(ctx, scope, "+", left, right, node)
    for item in (left, right):
        if not isinstance(item.value, Scalar):
            ctx.sink.report("E0312", item.node.span, expected="a scalar", found=kind_of(item.value))
            return POISON
    assert isinstance(one, Scalar) and isinstance(two, Scalar)
    if name == "product":
        return multiplied(ctx, node, one, two)
    variability, order = latest(one, two), highest(one, two)
    if not fits(one.dimension, two.dimension):
        report_unequal(ctx, "compare", scope, (left.node, one.dimension), (right.node, two.dimension))
        return POISON
    expression = extreme(ctx, scope, node, name, one, two)
    kind = one.kind if one.kind == two.kind else "Real"
    return Scalar(expression, joined(one.dimension, two.dimension), variability, order, kind)


def extreme(ctx: Context, scope: Scope, node: nodes.Node, name: str, one: Scalar, two: Scalar) -> FlatExpression:
    """`min` or `max` of two."""
    return met(ctx, scope, node, name, flat.Function(name, (one.expression, two.expression)), one, two)


def elements_of(array: Array) -> list[Scalar]:
    return [Scalar(part, array.dimension, array.variability, array.order, array.kind) for part in array.elements]


def spaced(start: Scalar, stop: Scalar, count: int) -> list[FlatExpression]:
    """count values from start to stop."""
    step = flat.Binary("-", stop.expression, start.expression)
    return [
        flat.Binary("+", start.expression, flat.Binary("*", flat.Number(k / (count - 1)), step)) for k in range(count)
    ]
