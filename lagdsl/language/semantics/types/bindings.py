"""A value against a declaration: shape, kind, dimension."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from lagdsl.foundation.record import record
from lagdsl.foundation.units.parse import counts_angles, counts_turns
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.admissible import EXACT_INTEGERS
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import an, kind_of, row_in_braces
from lagdsl.language.semantics.scope.prelude import BaseType
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    POISON,
    AnyDimension,
    Array,
    Poison,
    Scalar,
    Text,
    Value,
    Vector,
    components,
    is_zero,
)
from lagdsl.language.semantics.types.bare_numbers import collect
from lagdsl.language.semantics.types.dimensions import fits, require
from lagdsl.language.syntax import nodes


@record()
class Expected:
    """Expected value of a declaration. `dimension` None: to be inferred. `unit`: as declared, to tell Hz from rad/s."""

    what: str
    dimension: AnyDimension
    shape: tuple[int, ...] = ()
    base: BaseType = "Real"
    unit: str = "1"
    code: str = "E0407"


def conform(ctx: Context, scope: Scope, node: nodes.Node, value: Value, expected: Expected) -> Scalar | Array | None:
    """The value in the declared shape, with the declared dimension; None after a diagnostic (or for poison)."""
    if isinstance(value, Poison):
        return None
    shaped = _shaped(ctx, node, value, expected)
    if shaped is None or not _kind_fits(ctx, node, shaped, expected):
        return None
    if expected.dimension is None:
        return shaped
    if expected.unit in ("rad/s", "rpm") and (literal := _literal(node, counts_turns)) is not None:
        ctx.sink.report("E0411", literal[0].span, what=expected.what)
        return None
    if expected.unit == "Hz" and (literal := _literal(node, counts_angles)) is not None:
        ctx.sink.report("E0420", literal[0].span, what=expected.what, unit=literal[1])
        return None
    if not fits(shaped.dimension, expected.dimension):
        require(ctx, scope, node, shaped.dimension, expected.dimension, expected.code, what=expected.what)
        return None
    collect(ctx, scope, node, shaped, expected.unit)
    return shaped if shaped.dimension is not None else replace(shaped, dimension=expected.dimension)


def _shaped(ctx: Context, node: nodes.Node, value: Value, expected: Expected) -> Scalar | Array | None:
    if isinstance(value, Vector) and expected.shape == (3,):
        value = components(value)
    if isinstance(value, Scalar) and not expected.shape:
        return value
    if isinstance(value, Array) and value.shape == expected.shape:
        return value
    if is_zero(value):
        count = 1
        for extent in expected.shape:
            count *= extent
        return Array((flat.ZERO,) * count, expected.shape, None)
    size = " by ".join(str(extent) for extent in expected.shape)
    wanted = (
        f"an array of {size}"
        if expected.shape
        else f"{an(expected.base)} scalar"
        if expected.base != "Real"
        else "a scalar"
    )
    hint = None
    if isinstance(value, Scalar) and len(expected.shape) == 1:
        hint = f"write `fill({node.span.text}, {expected.shape[0]})` to repeat it"
        if expected.what == "`I` of a body":
            hint = f"a body that moves in a plane has `Izz = {node.span.text}`"
    elif isinstance(node, nodes.Matrix) and len(expected.shape) == 1:
        hint = row_in_braces(node)
    elif isinstance(value, Text) and not expected.shape:
        hint = f"write it without quotes: `{value.value}`" if value.value[:1].isalnum() else None
    ctx.sink.report("E0334", node.span, what=expected.what, expected=wanted, found=kind_of(value), help=hint)
    return None


def _kind_fits(ctx: Context, node: nodes.Node, value: Scalar | Array, expected: Expected) -> bool:
    fitting = value.kind == expected.base or (expected.base == "Real" and value.kind == "Integer")
    if not fitting:
        found = an(value.kind)
        if expected.base == "Integer" and isinstance(node, nodes.Number | nodes.Quantity):
            found = f"`{node.span.text}`"
        ctx.sink.report("E0334", node.span, what=expected.what, expected=an(expected.base), found=found)
    elif expected.base == "Integer" and any(map(_is_rounded, value.elements if isinstance(value, Array) else [value])):
        ctx.sink.report("E0326", node.span, what=expected.what, most="2^53 - 1", help="use a smaller number")
        return False
    return fitting


def _is_rounded(value: Scalar | flat.FlatExpression) -> bool:
    """True for a whole number that may stand for its neighbors, too."""
    expression = value.expression if isinstance(value, Scalar) else value
    return isinstance(expression, flat.Number) and abs(expression.value) >= EXACT_INTEGERS


def _literal(node: nodes.Node, counts: Callable[[str], bool]) -> tuple[nodes.Node, str] | None:
    """The literal, with its sign, that is the value or an element or branch of it and whose unit `counts`; the unit."""
    if isinstance(node, nodes.Quantity):
        return (node, node.unit) if counts(node.unit) else None
    if isinstance(node, nodes.Unary | nodes.Parenthesized):
        inner = node.operand if isinstance(node, nodes.Unary) else node.inner
        found = _literal(inner, counts)
        return (node, found[1]) if found is not None and found[0] is inner else found
    parts: list[nodes.Expression] = []
    if isinstance(node, nodes.Array):
        parts = [*node.elements]
    if isinstance(node, nodes.Matrix):
        parts = [part for row in node.rows for part in row]
    if isinstance(node, nodes.Conditional):
        parts = [*(branch.value for branch in node.branches), node.otherwise]
    return next((found for part in parts if (found := _literal(part, counts)) is not None), None)


def bound(ctx: Context, scope: Scope, node: nodes.Expression, expected: Expected) -> Scalar | Array | Value:
    """The elaborated binding in its declared shape, or poison."""
    return conform(ctx, scope, node, ctx.elaborate(ctx, scope, node, True), expected) or POISON
