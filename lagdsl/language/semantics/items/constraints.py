"""Constraints: rows, names, level."""

from __future__ import annotations

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.angles import check_beside
from lagdsl.language.semantics.operators.arithmetic import Operand, added
from lagdsl.language.semantics.operators.geometry import operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Array, Order, Poison, Scalar, Value, Vector, components
from lagdsl.language.semantics.types.dimensions import fits, report_unequal
from lagdsl.language.syntax import nodes


def make(ctx: Context, scope: Scope, node: nodes.Constraint, name: str) -> flat_model.Constraint | None:
    """The rows `left - right = 0`, whatever the condition of the constraint; None after a diagnostic."""
    residual = difference(ctx, scope, node)
    if residual is None:
        return None
    parts: tuple[FlatExpression, ...] = (residual.expression,) if isinstance(residual, Scalar) else residual.elements
    if residual.order >= Order.ACCELERATION:
        code = "E0339" if residual.order == Order.ACCELERATION else "E0324"
        ctx.sink.report(code, node.span, what="a constraint")
        return None
    velocity = residual.order == Order.RATE
    rows = (name,) if isinstance(residual, Scalar) else tuple(row_name(name, k) for k in range(1, len(parts) + 1))
    return flat_model.Constraint(
        spans=(node.span, *scope.spans),
        name=name,
        rows=rows,
        residuals=parts,
        dimension=residual.dimension or DIMENSIONLESS,
        level="velocity" if velocity else "position",
    )


def row_name(name: str, row: int) -> str:
    """`pin[2]`; `pin[3,2]` for the second row of the third constraint of a loop."""
    return f"{name[:-1]},{row}]" if name.endswith("]") else f"{name}[{row}]"


def difference(ctx: Context, scope: Scope, node: nodes.Constraint | nodes.Equation) -> Scalar | Array | None:
    """left - right as a scalar or rows; None after a diagnostic."""
    left, right = (
        Operand(side, operand(ctx, ctx.elaborate(ctx, scope, side, False), side.span))
        for side in (node.left, node.right)
    )
    for side in (left, right):
        if isinstance(side.value, Poison):
            return None
        if not isinstance(side.value, Scalar | Vector | Array) or getattr(side.value, "kind", "Real") == "Boolean":
            ctx.sink.report("E0312", side.node.span, expected="a number or a vector", found=kind_of(side.value))
            return None
    dimensions = [getattr(side.value, "dimension", None) for side in (left, right)]
    if not fits(*dimensions):
        report_unequal(ctx, "equate", scope, (left.node, dimensions[0]), (right.node, dimensions[1]))
        return None
    check_beside(ctx, scope, node.left, node.right)
    residual = _subtracted(ctx, scope, left, right, node)
    if isinstance(residual, Vector):
        return components(residual)
    return residual if isinstance(residual, Scalar | Array) else None


def _subtracted(ctx: Context, scope: Scope, left: Operand, right: Operand, node: nodes.Node) -> Value:
    """`x = 0` has the residual x."""
    if isinstance(right.value, Scalar) and right.value.expression == flat.ZERO:
        return left.value
    return added(ctx, scope, "-", left, right, node)
