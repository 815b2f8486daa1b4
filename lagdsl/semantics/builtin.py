"""Built-in functions of numbers and vectors: arguments are values already."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import pi, prod

from lagdsl.diagnostics.suggest import nearest
from lagdsl.flat import expression as flat
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.quantity import Variability
from lagdsl.semantics import corners
from lagdsl.semantics.application import Application
from lagdsl.semantics.arithmetic import Located, Operand, divided, dot, joint_kind, negative
from lagdsl.semantics.arrays import elements_of, extreme, linspace, reduced
from lagdsl.semantics.constants import structural_integer
from lagdsl.semantics.dimensions import fits, joined, product, report_unequal
from lagdsl.semantics.limits import array_fits
from lagdsl.semantics.naming import arguments_text, kind_of, quantity
from lagdsl.semantics.scope import InstanceArray
from lagdsl.semantics.tables import table
from lagdsl.semantics.values import (
    NUMERIC,
    POISON,
    AnyDimension,
    Array,
    Component,
    Poison,
    Scalar,
    Text,
    Value,
    Vector,
    as_vector,
    components,
    element_at,
    highest,
    latest,
)
from lagdsl.units.definition import UnitDefinition
from lagdsl.units.dimension import DIMENSIONLESS
from lagdsl.units.parse import UnknownUnit, parse_unit


def scalars(call: Application) -> list[Scalar] | None:
    """All arguments as real scalars, or None after a diagnostic."""
    found: list[Scalar] = []
    for item in call.arguments:
        if isinstance(item.value, Scalar) and item.value.kind in NUMERIC:
            found.append(item.value)
        elif not isinstance(item.value, Poison):
            expected = f"a scalar in `{call.name}`"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
    return found if len(found) == len(call.arguments) else None


# ---- functions of numbers --------------------------------------------------------------------------------------------


def _of_number(call: Application) -> Value:
    """`sin` and its kind: argument and value without a dimension."""
    values = scalars(call)
    if values is None:
        return POISON
    argument = values[0]
    if not fits(argument.dimension, DIMENSIONLESS):
        span = call.arguments[0].node.span
        call.ctx.sink.report("E0402", span, function=f"`{call.name}`", found=quantity(argument.dimension))
        return POISON
    if call.name in ("floor", "ceil"):
        return _rounded(call, argument)
    return _function(call, call.name, (argument.expression,), DIMENSIONLESS)


def _rounded(call: Application, x: Scalar) -> Scalar:
    """`floor` and `ceil`: of time alone a number that is constant between events."""
    if not corners.has_corner(call.ctx, x):
        _note_jumps(call)
        return _function(call, call.name, (x.expression,), DIMENSIONLESS)
    if call.name == "floor":
        below: FlatExpression = corners.whole(call.ctx, call.scope, call.node, x.expression)
    else:
        below = negative(corners.whole(call.ctx, call.scope, call.node, negative(x.expression)))
    return Scalar(below, DIMENSIONLESS, Variability.DISCRETE)


def _note_jumps(call: Application) -> None:
    """The first function whose jumps are met as they come."""
    moving = any(value.variability == Variability.CONTINUOUS for value in call.numeric)
    if moving and call.name in ("floor", "ceil", "mod") and not call.ctx.quiet and call.ctx.jump is None:
        call.ctx.jump = call.node


def _function(call: Application, name: str, arguments: tuple[FlatExpression, ...], dimension: AnyDimension) -> Scalar:
    numeric = call.numeric
    return Scalar(flat.Function(name, arguments), dimension, latest(*numeric), highest(*numeric))


def _root(call: Application) -> Value:
    values = scalars(call)
    if values is None:
        return POISON
    dimension = values[0].dimension
    return _function(call, "sqrt", (values[0].expression,), dimension ** Fraction(1, 2) if dimension else dimension)


def _preserving(call: Application) -> Value:
    """`abs`: the dimension of the argument."""
    values = scalars(call)
    if values is None:
        return POISON
    x = values[0]
    if not corners.has_corner(call.ctx, x):
        return _function(call, call.name, (x.expression,), x.dimension)
    positive = corners.of_call(call.ctx, call.scope, call.node, x.expression)
    value = flat.Conditional(positive, x.expression, negative(x.expression))
    return Scalar(value, x.dimension, x.variability, x.order)


def _sign(call: Application) -> Value:
    """Of what moves: two relations, so that its jumps are events."""
    values = scalars(call)
    if values is None:
        return POISON
    if call.ctx.quiet or values[0].variability != Variability.CONTINUOUS:
        return _function(call, "sign", (values[0].expression,), DIMENSIONLESS)
    text, x = f"{call.scope.owner.prefix}{call.arguments[0].node.span.text}", values[0].expression
    place = Located(call.ctx, (call.node.span, *call.scope.spans), values[0].dimension or DIMENSIONLESS)
    timed = corners.is_timed(call.ctx, values[0])
    above = place.truth(f"{text} > 0", x, strict=True, timed=timed)
    below = place.truth(f"{text} < 0", flat.Unary("-", x), strict=True, timed=timed)
    value = flat.Conditional(above, flat.ONE, flat.Conditional(below, flat.Number(-1.0), flat.ZERO))
    return Scalar(value, DIMENSIONLESS, Variability.DISCRETE)


def _same(call: Application, values: list[Scalar]) -> bool:
    """All arguments of one dimension, or E0401."""
    for item, value in zip(call.arguments[1:], values[1:], strict=True):
        if not fits(values[0].dimension, value.dimension):
            left, right = (call.arguments[0].node, values[0].dimension), (item.node, value.dimension)
            report_unequal(call.ctx, f"use together in `{call.name}`", call.scope, left, right)
            return False
    return True


def _pair(call: Application) -> Value:
    """`atan2` and `mod`."""
    values = scalars(call)
    if values is None or not _same(call, values):
        return POISON
    dimension = DIMENSIONLESS if call.name == "atan2" else joined(values[0].dimension, values[1].dimension)
    if call.name == "mod" and corners.has_corner(call.ctx, *values):
        left = _remainder(call, values[0].expression, values[1].expression)
        return Scalar(left, dimension, latest(*values), highest(*values), joint_kind(*values))
    _note_jumps(call)
    return _function(call, call.name, (values[0].expression, values[1].expression), dimension)


def _remainder(call: Application, x: FlatExpression, y: FlatExpression) -> FlatExpression:
    """x - floor(x/y)*y, of time alone."""
    turns = corners.whole(call.ctx, call.scope, call.node, flat.Binary("/", x, y))
    return flat.Binary("-", x, flat.Binary("*", turns, y))


def _log10(call: Application) -> Value:
    value = _of_number(Application(call.ctx, call.scope, "log", call.node, call.arguments))
    if not isinstance(value, Scalar):
        return POISON
    return Scalar(
        flat.Binary("/", value.expression, flat.Function("log", (flat.Number(10.0),))),
        DIMENSIONLESS,
        value.variability,
        value.order,
    )


def _limit(call: Application) -> Value:
    """`limit(x, low, high)`."""
    values = scalars(call)
    if values is None or not _same(call, values):
        return POISON
    x, low, high = values
    inner = Scalar(extreme(call.ctx, call.scope, call.node, "min", x, high), None, latest(x, high), highest(x, high))
    dimension = joined(x.dimension, joined(low.dimension, high.dimension))
    value = extreme(call.ctx, call.scope, call.node, "max", low, inner)
    return Scalar(value, dimension, latest(*values), highest(*values))


def _wrap(call: Application) -> Value:
    """The angle in [-pi, pi)."""
    values = scalars(call)
    if values is None:
        return POISON
    if not fits(values[0].dimension, DIMENSIONLESS):
        span = call.arguments[0].node.span
        call.ctx.sink.report("E0402", span, function="`wrap`", found=quantity(values[0].dimension))
        return POISON
    turned = flat.Binary("+", values[0].expression, flat.Number(pi))
    turn = flat.Number(2 * pi)
    timed = corners.has_corner(call.ctx, values[0])
    wrapped = _remainder(call, turned, turn) if timed else flat.Function("mod", (turned, turn))
    shifted = flat.Binary("-", wrapped, flat.Number(pi))
    return Scalar(shifted, DIMENSIONLESS, values[0].variability, values[0].order)


def _value(call: Application) -> Value:
    """`value(x, "unit")`: the number of units in x."""
    x, text = (item.value for item in call.arguments)
    if not isinstance(x, Scalar) or not isinstance(text, Text):
        if not isinstance(x, Poison) and not isinstance(text, Poison):
            wrong = call.arguments[0 if not isinstance(x, Scalar) else 1]
            expected = "a scalar" if wrong is call.arguments[0] else 'a unit such as "mm"'
            call.ctx.sink.report("E0312", wrong.node.span, expected=expected, found=kind_of(wrong.value))
        return POISON
    unit = _unit(call, text.value)
    if unit is None:
        return POISON
    if not fits(x.dimension, call.ctx.dimension(unit.dimension)):
        words = quantity(unit.dimension)
        call.ctx.sink.report(
            "E0415", call.arguments[0].node.span, what="the value", expected=words, found=quantity(x.dimension)
        )
        return POISON
    number = x.expression
    if unit.offset:
        number = flat.Binary("-", number, flat.Number(unit.offset))
    if unit.factor != 1.0:
        number = flat.Binary("/", number, flat.Number(unit.factor))
    return Scalar(number, DIMENSIONLESS, x.variability, x.order)


def _unit(call: Application, text: str) -> UnitDefinition | None:
    try:
        return parse_unit(text)
    except UnknownUnit as fault:
        hint = f"did you mean `{fault.suggestion}`?" if fault.suggestion else None
        call.ctx.sink.report("E0413", call.arguments[1].node.span, unit=text, help=hint)
        return None


# ---- vectors ---------------------------------------------------------------------------------------------------------


def vectors(call: Application) -> list[Vector] | None:
    found = []
    for item in call.arguments:
        vector = as_vector(item.value)
        if vector is not None:
            found.append(vector)
        elif not isinstance(item.value, Poison):
            expected = f"a vector in `{call.name}`"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
    return found if len(found) == len(call.arguments) else None


def _cross(call: Application) -> Value:
    pair = vectors(call)
    if pair is None:
        return POISON
    left, right = pair
    dimension = product(left.dimension, right.dimension)
    return Vector(flat.Cross(left.expression, right.expression), dimension, latest(*pair), highest(*pair))


def norm(call: Application) -> Value:
    """Euclidean length of a vector or of an array of any length."""
    value = call.arguments[0].value
    if isinstance(value, Array) and len(value.shape) == 1 and value.shape[0] > 3:
        squares = dot(value.elements, value.elements)
        return _function(call, "sqrt", (squares,), value.dimension)
    found = vectors(call)
    if found is None:
        return POISON
    vector = found[0]
    length = flat.Norm(vector.expression, call.node.span.text)
    return Scalar(length, vector.dimension, vector.variability, vector.order)


def _unit_vector(call: Application) -> Value:
    length = norm(call)
    if not isinstance(length, Scalar):
        return POISON
    value = call.arguments[0].value
    assert isinstance(value, Vector | Array | Scalar)
    return divided(call.ctx, call.node, value, length)


# ---- arrays ----------------------------------------------------------------------------------------------------------


def _reduction(call: Application) -> Value:
    """`sum`, `product`, `min`, `max` of an array, or `min(a, b)`."""
    if len(call.arguments) > 1 and call.name in ("min", "max"):
        return reduced(call.ctx, call.scope, call.name, list(call.arguments), call.node)
    item = call.arguments[0]
    value = components(item.value) if isinstance(item.value, Vector) else item.value
    if len(call.arguments) != 1 or not isinstance(value, Array):
        if not isinstance(value, Poison):
            expected = f"an array in `{call.name}`"
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(value))
        return POISON
    operands = [Operand(item.node, part) for part in elements_of(value)]
    return reduced(call.ctx, call.scope, call.name, operands, call.node)


def _sizes(call: Application, items: tuple[Operand, ...]) -> list[int] | None:
    sizes = []
    for item in items:
        number = structural_integer(call.ctx, item.value, item.node, "E0301", name=item.node.span.text)
        if number is None:
            return None
        if number < 1:
            call.ctx.sink.report("E0334", item.node.span, what="an array size", expected="positive", found=str(number))
            return None
        sizes.append(number)
    square = sizes * 2 if call.name == "identity" else sizes
    if not array_fits(call.ctx, call.node.span, tuple(square)):
        return None
    return sizes


def _filled(call: Application) -> Value:
    """`zeros(n, m)`, `ones(n)`, `fill(x, n, m)`."""
    sizes = _sizes(call, call.arguments[1:] if call.name == "fill" else call.arguments)
    filler = (
        call.arguments[0].value
        if call.name == "fill"
        else Scalar(flat.ZERO if call.name == "zeros" else flat.ONE, None)
    )
    if sizes is None or not isinstance(filler, Scalar):
        return POISON
    dimension = DIMENSIONLESS if call.name == "ones" else filler.dimension
    return Array(
        (filler.expression,) * prod(sizes), tuple(sizes), dimension, filler.variability, filler.order, filler.kind
    )


def _identity(call: Application) -> Value:
    sizes = _sizes(call, call.arguments)
    if sizes is None:
        return POISON
    n = sizes[0]
    parts = tuple(flat.ONE if row == column else flat.ZERO for row in range(n) for column in range(n))
    return Array(parts, (n, n), DIMENSIONLESS)


def _diagonal(call: Application) -> Value:
    array = _array(call, 1)
    if array is None:
        return POISON
    n = array.shape[0]
    if not array_fits(call.ctx, call.node.span, (n, n)):
        return POISON
    parts = tuple(array.elements[row] if row == column else flat.ZERO for row in range(n) for column in range(n))
    return Array(parts, (n, n), array.dimension, array.variability, array.order, array.kind)


def _transpose(call: Application) -> Value:
    array = _array(call, 2)
    if array is None:
        return POISON
    rows, columns = array.shape
    parts = tuple(array.elements[row * columns + column] for column in range(columns) for row in range(rows))
    return Array(parts, (columns, rows), array.dimension, array.variability, array.order, array.kind)


def _array(call: Application, rank: int) -> Array | None:
    value = call.arguments[0].value
    if isinstance(value, Array) and len(value.shape) == rank:
        return value
    if not isinstance(value, Poison):
        expected = "a matrix" if rank == 2 else "an array"
        call.ctx.sink.report("E0312", call.arguments[0].node.span, expected=expected, found=kind_of(value))
    return None


def _size(call: Application) -> Value:
    """`size(a)` or `size(a, k)`."""
    value = call.arguments[0].value
    if isinstance(value, Poison):
        return POISON
    shape = value.shape if isinstance(value, Array) else (3,) if isinstance(value, Vector) else ()
    if isinstance(value, Component) and isinstance(value.instance, InstanceArray):
        shape = value.instance.shape
    sizes = Array(tuple(flat.Number(float(n)) for n in shape), (len(shape),), DIMENSIONLESS, kind="Integer")
    if len(call.arguments) == 1:
        return sizes
    item = call.arguments[1]
    index = structural_integer(call.ctx, item.value, item.node, "E0333")
    if index is None:
        return POISON
    if not 1 <= index <= len(shape):
        call.ctx.sink.report("E0341", item.node.span, index=index, extent=len(shape))
        return POISON
    return element_at(sizes, index - 1)


def _linspace(call: Application) -> Value:
    ends = call.arguments[:2]
    values = scalars(Application(call.ctx, call.scope, call.name, call.node, ends))
    sizes = _sizes(call, call.arguments[2:])
    if (
        values is None
        or sizes is None
        or not _same(Application(call.ctx, call.scope, call.name, call.node, ends), values)
    ):
        return POISON
    if sizes[0] < 2:
        call.ctx.sink.report("E0323", call.node.span, reason="`linspace` needs at least two values")
        return POISON
    start, stop = values
    parts = tuple(linspace(start, stop, sizes[0]))
    return Array(parts, (sizes[0],), joined(start.dimension, stop.dimension), latest(*values), highest(*values))


Builtin = Callable[[Application], Value]

# name: (function, least and most number of arguments)
BUILTINS: dict[str, tuple[Builtin, int, int]] = {
    **dict.fromkeys(
        ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "floor", "ceil"),
        (_of_number, 1, 1),
    ),
    "log10": (_log10, 1, 1),
    "sqrt": (_root, 1, 1),
    "abs": (_preserving, 1, 1),
    "sign": (_sign, 1, 1),
    "atan2": (_pair, 2, 2),
    "mod": (_pair, 2, 2),
    "limit": (_limit, 3, 3),
    "wrap": (_wrap, 1, 1),
    "value": (_value, 2, 2),
    "cross": (_cross, 2, 2),
    "norm": (norm, 1, 1),
    "unit": (_unit_vector, 1, 1),
    "sum": (_reduction, 1, 1),
    "product": (_reduction, 1, 1),
    "min": (_reduction, 1, 2),
    "max": (_reduction, 1, 2),
    "zeros": (_filled, 1, 3),
    "ones": (_filled, 1, 3),
    "fill": (_filled, 2, 4),
    "identity": (_identity, 1, 1),
    "diagonal": (_diagonal, 1, 1),
    "transpose": (_transpose, 1, 1),
    "size": (_size, 1, 2),
    "linspace": (_linspace, 3, 3),
    "table": (table, 3, 4),
}


def apply(call: Application) -> Value:
    """The value of a built-in function; the number of arguments is checked here."""
    function, least, most = BUILTINS[call.name]
    if not least <= len(call.arguments) <= most:
        expected = str(least) if least == most else f"{least} to {most}"
        call.ctx.sink.report(
            "E0315", call.node.span, function=call.name, expected=arguments_text(expected), found=len(call.arguments)
        )
        return POISON
    if any(isinstance(item.value, Poison) for item in call.arguments):
        return POISON
    return function(call)


def meant_function(name: str, others: list[str]) -> str | None:
    return nearest(name, [*BUILTINS, *others])
