"""Measurements: `measure theta with sigma = 0.2 deg;`, `measure encoder: theta;`, `measure floor;` of the instants of a
contact."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Measurement, Variability
from lagdsl.language.semantics.items.options import option_value, options_of
from lagdsl.language.semantics.operators.arguments import labelled
from lagdsl.language.semantics.operators.arrays import subscript_indices
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.constants import structural_number
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.values import AnyDimension, Array, Poison, Scalar
from lagdsl.language.syntax import nodes

OPTIONS = ("sigma",)


def make(ctx: Context, scope: Scope, node: nodes.Measure) -> list[Measurement]:
    """One for each element of what is measured; E0363 for what is no column, none after a diagnostic."""
    found = _measured(ctx, scope, node)
    options = options_of(ctx, node, "measure", OPTIONS)
    if found is None or options is None:
        return []
    names, dimension, event = found
    own = dimension or DIMENSIONLESS
    option = options.get("sigma")
    value = option_value(ctx, scope, option, "a standard deviation", own, Variability.STRUCTURAL, strict=True)
    sigma = None
    if option is not None:
        if value is None:
            return []
        what, allowed = "a standard deviation", "constants and structural parameters"
        sigma = structural_number(ctx, value, option.value, "E0317", what=what, allowed=allowed)
    if node.column is not None and len(names) > 1:
        ctx.sink.report("E0363", node.value.span, text=node.value.span.text, why="it is an array: measure each element")
        return []
    return [
        Measurement(
            spans=(node.span, *scope.spans),
            name=name if node.column is None else node.column,
            of=name,
            event=event,
            dimension=own,
            sigma=sigma,
            stated=node.column is not None,
        )
        for name in names
    ]


def _measured(ctx: Context, scope: Scope, node: nodes.Measure) -> tuple[list[str], AnyDimension, bool] | None:
    """Names of result columns, or of a contact or a friction, with their dimension."""
    base = node.value.target if isinstance(node.value, nodes.Index) else node.value
    symbol = designated(ctx, scope, base)
    if isinstance(symbol, Symbol) and symbol.kind in ("contact", "friction"):
        chosen = labelled(ctx, scope, node.value, symbol.kind)
        if chosen is None:
            return None
        labels = chosen[0].made.labels
        places = [chosen[1]] if chosen[1] in labels else list(labels)
        return [labels[place].name for place in places], ctx.conventions.dimension(TIME), True
    found = columns_of(ctx, scope, node.value)
    if found is None:
        ctx.sink.report("E0363", node.value.span, text=node.value.span.text, why="it is no name")
    return None if found is None or isinstance(found, Poison) else (*found, False)


def columns_of(ctx: Context, scope: Scope, node: nodes.Expression) -> tuple[list[str], AnyDimension] | Poison | None:
    """Names of the quantities that `node` designates, and their dimension; None if it designates none."""
    base = node.target if isinstance(node, nodes.Index) else node
    symbol = designated(ctx, scope, base)
    value = ctx.elaborate(ctx, scope, node, False)
    if isinstance(value, Poison):
        return value
    if not isinstance(value, Scalar | Array):
        return None
    if isinstance(symbol, Symbol) and symbol.kind == "output":
        return _elements(ctx, scope, node, symbol), value.dimension
    names = [_name(part) for part in ((value.expression,) if isinstance(value, Scalar) else value.elements)]
    known = [name for name in names if name is not None]
    return (known, value.dimension) if known and len(known) == len(names) else None


def _elements(ctx: Context, scope: Scope, node: nodes.Expression, symbol: Symbol) -> list[str]:
    """Names of an output, or of those of its elements that `node` designates without fault."""
    shape = ctx.resolver.shape(ctx, symbol) or ()
    chosen: Sequence[int | tuple[int, ...]] = ()
    if isinstance(node, nodes.Index):
        chosen = subscript_indices(ctx, scope, node.subscripts, shape, node) or ()
    full = [*chosen, *(tuple(range(1, extent + 1)) for extent in shape[len(chosen) :])]
    ways = [(found,) if isinstance(found, int) else found for found in full]
    return [element_name(symbol.name, indices) for indices in product(*ways)]


def _name(expression: flat.FlatExpression) -> str | None:
    if isinstance(expression, flat.Derivative) and isinstance(expression.operand, flat.Variable):
        return f"der({expression.operand.name})"
    return expression.name if isinstance(expression, flat.Variable) else None
