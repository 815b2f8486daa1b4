"""Operators: shapes, kinds and dimensions of `+ - * / ^`, relations and logic."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.discontinuous import met, moves, relation
from lagdsl.language.semantics.operators.powers import power
from lagdsl.language.semantics.scope.constants import NoValue, evaluate
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    POISON,
    Array,
    Kind,
    Numeric,
    Order,
    Poison,
    Scalar,
    Value,
    Vector,
    as_vector,
    balanced_sum,
    components,
    highest,
    is_structural,
    is_zero,
    latest,
)
from lagdsl.language.semantics.types.dimensions import fits, joined, product, quotient, report_unequal
from lagdsl.language.syntax import nodes

RELATIONS = ("<", "<=", ">", ">=", "==", "<>")


@record()
class Operand:
    """A value and the text it comes from."""

    node: nodes.Node
    value: Value


def negated(value: Numeric) -> Numeric:
    if isinstance(value, Array):
        return replace(value, elements=tuple(map(negative, value.elements)))
    return replace(value, expression=negative(value.expression))


def negative(expression: FlatExpression) -> FlatExpression:
    """The negative; of the number 0 the number 0."""
    if isinstance(expression, flat.Number):
        return flat.Number(-expression.value) if expression.value else expression
    return flat.Unary("-", expression)


def binary(ctx: Context, scope: Scope, node: nodes.Binary, left: Value, right: Value) -> Value:
    """The value of `left operator right`."""
    if isinstance(left, Poison) or isinstance(right, Poison):
        return POISON
    one, two = Operand(node.left, left), Operand(node.right, right)
    if node.operator in ("and", "or"):
        return _logic(ctx, node, one, two)
    if node.operator in RELATIONS:
        return _relation(ctx, scope, node, one, two)
    checked = [_numeric(ctx, operand) for operand in (one, two)]
    if checked[0] is None or checked[1] is None:
        return POISON
    match node.operator:
        case "+" | "-":
            return added(ctx, scope, node.operator, one, two, node)
        case "*":
            return multiplied(ctx, node, checked[0], checked[1])
        case "/":
            return divided(ctx, node, checked[0], checked[1])
        case "^":
            return power(ctx, node, checked[0], checked[1])
        case _:
            return _elementwise(ctx, node, checked[0], checked[1])


def _numeric(ctx: Context, operand: Operand) -> Numeric | None:
    value = operand.value
    if isinstance(value, Scalar | Vector | Array) and getattr(value, "kind", "Real") in NUMERIC:
        return value
    ctx.sink.report("E0312", operand.node.span, expected="a number or a vector", found=kind_of(value))
    return None


def joint_kind(left: Numeric, right: Numeric) -> Kind:
    """Integer where both are."""
    both = getattr(left, "kind", "Real") == "Integer" and getattr(right, "kind", "Real") == "Integer"
    return "Integer" if both else "Real"


# ---- sums ------------------------------------------------------------------------------------------------------------


def aligned(ctx: Context, left: Operand, right: Operand, node: nodes.Node) -> tuple[Numeric, Numeric] | None:
    """Both values in one shape: 2-vectors promoted beside geometric vectors, `0` spread. None after E0313."""
    one, two = left.value, right.value
    if isinstance(one, Scalar) and isinstance(two, Scalar):
        return one, two
    if isinstance(one, Array) and isinstance(two, Array) and one.shape == two.shape:
        return one, two
    if isinstance(one, Array) and is_zero(two):
        return one, _zeros(one)
    if isinstance(two, Array) and is_zero(one):
        return _zeros(two), two
    if isinstance(one, Vector) or isinstance(two, Vector):
        first, second = as_vector(one), as_vector(two)
        if first is not None and second is not None:
            return first, second
    ordered = left.node.span.start < right.node.span.start
    span = left.node.span.to(right.node.span) if ordered else node.span
    ctx.sink.report("E0313", span, left=kind_of(one), right=kind_of(two))
    return None


def _zeros(like: Array) -> Array:
    return Array((flat.ZERO,) * len(like.elements), like.shape, None)


def added(ctx: Context, scope: Scope, operator: str, left: Operand, right: Operand, node: nodes.Node) -> Value:
    """Sum or difference; dimensions must be equal."""
    pair = aligned(ctx, left, right, node)
    if pair is None:
        return POISON
    one, two = pair
    if not fits(one.dimension, two.dimension):
        verb = "add" if operator == "+" else "subtract"
        report_unequal(ctx, verb, scope, (left.node, one.dimension), (right.node, two.dimension))
        return POISON
    dimension, variability, order = joined(one.dimension, two.dimension), latest(one, two), highest(one, two)
    sign: flat.BinaryOperator = "+" if operator == "+" else "-"
    if isinstance(one, Scalar) and isinstance(two, Scalar):
        expression = _integer(sign, one, two) or flat.Binary(sign, one.expression, two.expression)
        return Scalar(expression, dimension, variability, order, joint_kind(one, two))
    if isinstance(one, Array) and isinstance(two, Array):
        parts = tuple(_plus(sign, a, b) for a, b in zip(one.elements, two.elements, strict=True))
        return Array(parts, one.shape, dimension, variability, order, joint_kind(one, two))
    assert isinstance(one, Vector) and isinstance(two, Vector), "aligned gives equal shapes"
    if is_zero(left.value) or is_zero(right.value):
        return one if is_zero(right.value) else two if sign == "+" else negated(two)
    return Vector(flat.Binary(sign, one.expression, two.expression), dimension, variability, order)


def _plus(sign: flat.BinaryOperator, left: FlatExpression, right: FlatExpression) -> FlatExpression:
    """A sum of elements, without the zeros that spreading brings in."""
    if right == flat.ZERO:
        return left
    if left == flat.ZERO:
        return right if sign == "+" else negative(right)
    return flat.Binary(sign, left, right)


def _integer(operator: flat.BinaryOperator, left: Scalar, right: Scalar) -> FlatExpression | None:
    """Integer arithmetic on known numbers is done at once, so that `i - 1` is a number."""
    if left.kind == right.kind == "Integer" and is_structural(left) and is_structural(right):
        try:
            return flat.Number(evaluate(flat.Binary(operator, left.expression, right.expression)))
        except NoValue:
            return None
    return None


# ---- products --------------------------------------------------------------------------------------------------------


def multiplied(ctx: Context, node: nodes.Node, one: Numeric, two: Numeric) -> Value:
    """Product of numbers, scaling, scalar product of vectors, matrix product."""
    dimension, variability, order = product(one.dimension, two.dimension), latest(one, two), highest(one, two)
    if isinstance(one, Scalar) and isinstance(two, Scalar):
        if one.is_nothing or two.is_nothing:
            return one if one.is_nothing else two
        if is_zero(one) or is_zero(two):
            return Scalar(flat.ZERO, dimension, kind=joint_kind(one, two))
        expression = _integer("*", one, two) or flat.Binary("*", one.expression, two.expression)
        return Scalar(expression, dimension, variability, order, joint_kind(one, two))
    if isinstance(one, Scalar) or isinstance(two, Scalar):
        factor, scaled = (one, two) if isinstance(one, Scalar) else (two, one)
        assert isinstance(factor, Scalar) and not isinstance(scaled, Scalar)
        if isinstance(scaled, Vector):
            return Vector(flat.Binary("*", factor.expression, scaled.expression), dimension, variability, order)
        parts = tuple(times(factor.expression, part) for part in scaled.elements)
        return Array(parts, scaled.shape, dimension, variability, order, joint_kind(one, two))
    if isinstance(one, Array) and isinstance(two, Array):
        return _matrix_product(ctx, node, one, two)
    if isinstance(one, Array) and one.shape == (3, 3) and isinstance(two, Vector):
        column = components(two)
        x, y, z = (_row_times(one, row, column.elements) for row in range(3))
        return Vector(flat.Vector(x, y, z), dimension, variability, order)
    left, right = as_vector(one), as_vector(two)
    if left is None or right is None:
        ctx.sink.report("E0313", node.span, left=kind_of(one), right=kind_of(two))
        return POISON
    return Scalar(flat.Dot(left.expression, right.expression), dimension, variability, order)


def times(left: FlatExpression, right: FlatExpression) -> FlatExpression:
    """A product of elements; a literal zero stays one."""
    return flat.ZERO if flat.ZERO in (left, right) else flat.Binary("*", left, right)


def dot(left: tuple[FlatExpression, ...], right: tuple[FlatExpression, ...]) -> FlatExpression:
    terms = [times(a, b) for a, b in zip(left, right, strict=True)]
    return balanced_sum([term for term in terms if term != flat.ZERO] or [flat.ZERO])


def _row_times(matrix: Array, row: int, column: tuple[FlatExpression, ...]) -> FlatExpression:
    width = matrix.shape[1]
    return dot(matrix.elements[row * width : (row + 1) * width], column)


def _matrix_product(ctx: Context, node: nodes.Node, one: Array, two: Array) -> Value:
    dimension, variability, order = product(one.dimension, two.dimension), latest(one, two), highest(one, two)
    if one.shape[-1] != two.shape[0] or len(one.shape) > 2 or len(two.shape) > 2:
        ctx.sink.report("E0313", node.span, left=kind_of(one), right=kind_of(two))
        return POISON
    if len(one.shape) == len(two.shape) == 1:
        return Scalar(dot(one.elements, two.elements), dimension, variability, order, joint_kind(one, two))
    inner = one.shape[-1]
    rows = [one.elements[k * inner : (k + 1) * inner] for k in range(len(one.elements) // inner)]
    width = two.shape[1] if len(two.shape) == 2 else 1
    columns = [two.elements[k::width] for k in range(width)]
    parts = tuple(dot(row, column) for row in rows for column in columns)
    return Array(parts, one.shape[:-1] + two.shape[1:], dimension, variability, order, joint_kind(one, two))


def divided(ctx: Context, node: nodes.Node, one: Numeric, two: Numeric) -> Value:
    if not isinstance(two, Scalar):
        ctx.sink.report("E0312", _right(node).span, expected="a scalar divisor", found=kind_of(two))
        return POISON
    if two.expression == flat.ZERO:
        ctx.sink.report("E0323", _right(node).span, reason="division by zero")
        return POISON
    dimension, variability, order = quotient(one.dimension, two.dimension), latest(one, two), highest(one, two)
    match one:
        case Scalar(is_nothing=True):
            return one
        case Scalar():
            return Scalar(flat.Binary("/", one.expression, two.expression), dimension, variability, order)
        case Vector():
            return Vector(flat.Binary("/", one.expression, two.expression), dimension, variability, order)
        case Array():
            parts = tuple(flat.Binary("/", part, two.expression) for part in one.elements)
            return Array(parts, one.shape, dimension, variability, order)


def _elementwise(ctx: Context, node: nodes.Binary, one: Numeric, two: Numeric) -> Value:
    """`.*` and `./`."""
    if isinstance(one, Array) and isinstance(two, Array) and one.shape == two.shape:
        pairs = zip(one.elements, two.elements, strict=True)
        variability, order = latest(one, two), highest(one, two)
        if node.operator == ".*":
            parts = tuple(times(a, b) for a, b in pairs)
            dimension = product(one.dimension, two.dimension)
            return Array(parts, one.shape, dimension, variability, order, joint_kind(one, two))
        quotients = tuple(flat.Binary("/", a, b) for a, b in pairs)
        return Array(quotients, one.shape, quotient(one.dimension, two.dimension), variability, order)
    if isinstance(one, Scalar) or isinstance(two, Scalar):
        return multiplied(ctx, node, one, two) if node.operator == ".*" else divided(ctx, node, one, two)
    ctx.sink.report("E0313", node.span, left=kind_of(one), right=kind_of(two))
    return POISON


def _right(node: nodes.Node) -> nodes.Node:
    return node.right if isinstance(node, nodes.Binary) else node


# ---- relations and logic ---------------------------------------------------------------------------------------------


def _relation(ctx: Context, scope: Scope, node: nodes.Binary, left: Operand, right: Operand) -> Value:
    one, two = left.value, right.value
    for operand in (left, right):
        if not isinstance(operand.value, Scalar):
            ctx.sink.report("E0312", operand.node.span, expected="a scalar", found=kind_of(operand.value))
            return POISON
    assert isinstance(one, Scalar) and isinstance(two, Scalar)
    if not (one.kind in NUMERIC and two.kind in NUMERIC) and (
        one.kind != two.kind or node.operator not in ("==", "<>")
    ):
        blame_left = one.kind not in NUMERIC and (two.kind in NUMERIC or two.kind == one.kind)
        wrong, other = (left, two) if blame_left else (right, one)
        expected = "a number" if blame_left or other.kind in NUMERIC else kind_of(other)
        ctx.sink.report("E0312", wrong.node.span, expected=expected, found=kind_of(wrong.value))
        return POISON
    if not fits(one.dimension, two.dimension):
        report_unequal(ctx, "compare", scope, (left.node, one.dimension), (right.node, two.dimension))
        return POISON
    truth = flat.Binary(_OPERATORS[node.operator], one.expression, two.expression)
    # An Integer that somebody gives changes at events, too: the clauses and rows that it switches act then.
    given = highest(one, two) == Order.GIVEN
    if (moves(one, two) or given) and not ctx.current.quiet:
        return _located(ctx, scope, node, one, two, truth)
    met(ctx, scope, node, "", truth, one, two)
    return Scalar(truth, DIMENSIONLESS, latest(one, two), highest(one, two), "Boolean")


def _located(ctx: Context, scope: Scope, node: nodes.Binary, one: Scalar, two: Scalar, truth: FlatExpression) -> Value:
    """The truth of a relation between what moves: discrete. Real numbers are the same at single instants only."""
    text = node.span.text
    if node.operator in ("==", "<>"):
        if "Real" in (one.kind, two.kind):
            ctx.sink.report("E0379", node.span, operator=node.operator)
            return POISON
        text = f"{node.left.span.text} == {node.right.span.text}"
    spans, dimension = (node.span, *scope.spans), joined(one.dimension, two.dimension)
    relation(ctx, spans, scope.owner.prefix + text, truth, dimension, highest(one, two))
    return Scalar(truth, DIMENSIONLESS, Variability.DISCRETE, Order.STILL, "Boolean")


_OPERATORS: dict[str, flat.BinaryOperator] = {
    "<": "<", "<=": "<=", ">": ">", ">=": ">=", "==": "==", "<>": "<>", "and": "and", "or": "or",
}  # fmt: skip


def boolean(ctx: Context, operand: Operand) -> Scalar | None:
    value = operand.value
    if isinstance(value, Scalar) and value.kind == "Boolean":
        return value
    if not isinstance(value, Poison):
        ctx.sink.report("E0312", operand.node.span, expected="a Boolean", found=kind_of(value))
    return None


def _logic(ctx: Context, node: nodes.Binary, left: Operand, right: Operand) -> Value:
    one, two = boolean(ctx, left), boolean(ctx, right)
    if one is None or two is None:
        return POISON
    expression = flat.Binary(_OPERATORS[node.operator], one.expression, two.expression)
    return Scalar(expression, DIMENSIONLESS, latest(one, two), highest(one, two), "Boolean")


def unary(ctx: Context, node: nodes.Unary, value: Value) -> Value:
    if isinstance(value, Poison):
        return POISON
    if node.operator == "not":
        truth = boolean(ctx, Operand(node.operand, value))
        if truth is None:
            return POISON
        inverse = flat.Unary("not", truth.expression)
        return Scalar(inverse, DIMENSIONLESS, truth.variability, truth.order, "Boolean")
    number = _numeric(ctx, Operand(node.operand, value))
    if number is None:
        return POISON
    return negated(number) if node.operator == "-" else number
