"""Built-in functions of numbers and vectors: arguments are values already."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import pi

from lagdsl.foundation.diagnostics.catalog.habits import count_help
from lagdsl.foundation.units.definition import UnitDefinition
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators import array_functions
from lagdsl.language.semantics.operators.application import Application, same, scalars
from lagdsl.language.semantics.operators.arithmetic import divided, dot
from lagdsl.language.semantics.operators.arrays import extreme
from lagdsl.language.semantics.operators.columns import column
from lagdsl.language.semantics.operators.discontinuous import met, moves
from lagdsl.language.semantics.operators.surfaces import surface
from lagdsl.language.semantics.operators.tables import table
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import arguments_text, kind_of, quantity, row_in_braces
from lagdsl.language.semantics.scope.values import (
    POISON,
    AnyDimension,
    Array,
    Kind,
    Order,
    Poison,
    Scalar,
    Text,
    Value,
    Vector,
    as_vector,
    highest,
    latest,
)
from lagdsl.language.semantics.types.bare_numbers import warn_turns
from lagdsl.language.semantics.types.dimensions import bare_number, fits, joined, product
from lagdsl.language.syntax import nodes

Builtin = Callable[[Application], Value]

# ---- functions of numbers --------------------------------------------------------------------------------------------


def _of_scalars(function: Callable[..., Value]) -> Builtin:
    """The function of a call and of its arguments as real scalars."""

    def apply(call: Application) -> Value:
        values = scalars(call)
        return POISON if values is None else function(call, *values)

    return apply


def _of_number(call: Application, argument: Scalar) -> Value:
    """`sin` and its kind: argument and value without a dimension."""
    if not fits(argument.dimension, DIMENSIONLESS):
        span = call.arguments[0].node.span
        way = f"the time needs a frequency: `{call.name}(2*pi*1 Hz*time)`" if argument.dimension == TIME else None
        call.ctx.sink.report("E0402", span, function=f"`{call.name}`", found=quantity(argument.dimension), help=way)
        return POISON
    if call.name in ("floor", "ceil"):
        return _rounded(call, argument)
    if call.name in ("sin", "cos", "tan"):
        _warn_degrees(call.ctx, call.arguments[0].node)
    return _function(call, call.name, (argument.expression,), DIMENSIONLESS)


def _warn_degrees(ctx: Context, node: nodes.Node) -> None:
    """A number of more than one turn in radians, as an angle or in a sum, was meant in degrees."""
    if isinstance(node, nodes.Binary) and node.operator in ("+", "-"):
        _warn_degrees(ctx, node.left)
        _warn_degrees(ctx, node.right)
    elif (bare := bare_number(node)) is not None:
        warn_turns(ctx, node, float(bare.replace("--", "")))


def _rounded(call: Application, x: Scalar) -> Scalar:
    """`floor` and `ceil`: of time alone a number that is constant between instants known ahead."""
    rounded = _met(call, _function(call, call.name, (x.expression,), DIMENSIONLESS))
    timed = x.order == Order.STILL and not call.ctx.current.quiet
    return replace(rounded, variability=Variability.DISCRETE) if timed and moves(x) else rounded


def _met(call: Application, value: Scalar) -> Scalar:
    met(call.ctx, call.scope, call.node, call.name, value.expression, *call.numeric)
    return value


def _function(
    call: Application, name: str, arguments: tuple[FlatExpression, ...], dimension: AnyDimension, kind: Kind = "Real"
) -> Scalar:
    numeric = call.numeric
    return Scalar(flat.Function(name, arguments), dimension, latest(*numeric), highest(*numeric), kind)


def _joint_kind(*values: Scalar) -> Kind:
    """Integer where all are."""
    return "Integer" if all(value.kind == "Integer" for value in values) else "Real"


def _root(call: Application, x: Scalar) -> Value:
    dimension = x.dimension
    return _function(call, "sqrt", (x.expression,), dimension ** Fraction(1, 2) if dimension else dimension)


def _preserving(call: Application, x: Scalar) -> Value:
    """`abs`: the dimension of the argument."""
    kind = _joint_kind(x)
    return _met(call, _function(call, call.name, (x.expression,), x.dimension, kind))


def _sign(call: Application, value: Scalar) -> Value:
    """Of what moves: two relations, so that its jumps are events."""
    sign = _function(call, "sign", (value.expression,), DIMENSIONLESS, "Integer")
    text = call.arguments[0].node.span.text
    met(call.ctx, call.scope, call.node, call.name, sign.expression, value, text=text)
    if call.ctx.current.quiet or not moves(value):
        return sign
    return Scalar(sign.expression, DIMENSIONLESS, Variability.DISCRETE, kind="Integer")


def _pair(call: Application, *values: Scalar) -> Value:
    """`atan2` and `mod`."""
    if not same(call, values):
        return POISON
    arguments = (values[0].expression, values[1].expression)
    if call.name == "atan2":
        angle = _function(call, call.name, arguments, DIMENSIONLESS)
        met(call.ctx, call.scope, call.node, call.name, angle.expression, *values, located=False)
        return angle
    dimension, kind = joined(values[0].dimension, values[1].dimension), _joint_kind(*values)
    return _met(call, _function(call, call.name, arguments, dimension, kind))


def _log10(call: Application, x: Scalar) -> Value:
    value = _of_number(Application(call.ctx, call.scope, "log", call.node, call.arguments), x)
    if not isinstance(value, Scalar):
        return POISON
    quotient = flat.Binary("/", value.expression, flat.Function("log", (flat.Number(10.0),)))
    return Scalar(quotient, DIMENSIONLESS, value.variability, value.order)


def _limit(call: Application, x: Scalar, low: Scalar, high: Scalar) -> Value:
    """`limit(x, low, high)`."""
    values = (x, low, high)
    if not same(call, values):
        return POISON
    inner = Scalar(extreme(call.ctx, call.scope, call.node, "min", x, high), None, latest(x, high), highest(x, high))
    dimension = joined(x.dimension, joined(low.dimension, high.dimension))
    value = extreme(call.ctx, call.scope, call.node, "max", low, inner)
    return Scalar(value, dimension, latest(*values), highest(*values), _joint_kind(*values))


def _wrap(call: Application, x: Scalar) -> Value:
    """The angle in [-pi, pi)."""
    if not fits(x.dimension, DIMENSIONLESS):
        span = call.arguments[0].node.span
        call.ctx.sink.report("E0402", span, function="`wrap`", found=quantity(x.dimension))
        return POISON
    turned = flat.Binary("+", x.expression, flat.Number(pi))
    wrapped = flat.Function("mod", (turned, flat.Number(2 * pi)))
    met(call.ctx, call.scope, call.node, call.name, wrapped, x)
    shifted = flat.Binary("-", wrapped, flat.Number(pi))
    return Scalar(shifted, DIMENSIONLESS, x.variability, x.order)


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
    if not fits(x.dimension, call.ctx.conventions.dimension(unit.dimension)):
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
            way = row_in_braces(item.node)
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value), help=way)
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


def _table(call: Application) -> Value:
    """Over one quantity, or over two."""
    return table(call) if len(call.arguments) < 5 else surface(call)


# name: (function, least and most number of arguments)
BUILTINS: dict[str, tuple[Builtin, int, int]] = {
    **dict.fromkeys(
        ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "floor", "ceil"),
        (_of_scalars(_of_number), 1, 1),
    ),
    "log10": (_of_scalars(_log10), 1, 1),
    "sqrt": (_of_scalars(_root), 1, 1),
    "abs": (_of_scalars(_preserving), 1, 1),
    "sign": (_of_scalars(_sign), 1, 1),
    "atan2": (_of_scalars(_pair), 2, 2),
    "mod": (_of_scalars(_pair), 2, 2),
    "limit": (_of_scalars(_limit), 3, 3),
    "wrap": (_of_scalars(_wrap), 1, 1),
    "value": (_value, 2, 2),
    "cross": (_cross, 2, 2),
    "norm": (norm, 1, 1),
    "unit": (_unit_vector, 1, 1),
    "sum": (array_functions.reduction, 1, 1),
    "product": (array_functions.reduction, 1, 1),
    "min": (array_functions.reduction, 1, 2),
    "max": (array_functions.reduction, 1, 2),
    "zeros": (array_functions.filled, 1, 3),
    "ones": (array_functions.filled, 1, 3),
    "fill": (array_functions.filled, 2, 4),
    "identity": (array_functions.identity, 1, 1),
    "diagonal": (array_functions.diagonal, 1, 1),
    "transpose": (array_functions.transpose, 1, 1),
    "size": (array_functions.size, 1, 2),
    "linspace": (array_functions.linspace, 3, 3),
    "gauss_points": (array_functions.gauss, 1, 1),
    "gauss_weights": (array_functions.gauss, 1, 3),
    "legendre": (array_functions.legendre, 2, 2),
    "table": (_table, 3, 6),
    "column": (column, 2, 2),
}


def apply(call: Application) -> Value:
    """The value of a built-in function; the number of arguments is checked here."""
    function, least, most = BUILTINS[call.name]
    if not least <= len(call.arguments) <= most:
        expected = str(least) if least == most else f"{least} to {most}"
        way = count_help(call.name, tuple(item.node.span.text for item in call.arguments))
        texts = arguments_text(expected)
        found = len(call.arguments)
        call.ctx.sink.report("E0315", call.node.span, help=way, function=call.name, expected=texts, found=found)
        return POISON
    if any(isinstance(item.value, Poison) for item in call.arguments):
        return POISON
    return function(call)
