"""`reinit(x, value)`: which state or rate it sets, by its own name or by that of a definition that stands for it."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import events
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.semantics.classes.equations import derivative_of
from lagdsl.language.semantics.operators.arguments import named_element, positional
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Array, Poison, Scalar, Vector, components
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.syntax import nodes

_STILL = ("parameter", "constant", "structural", "discrete")


def resets(
    ctx: Context, call: nodes.Call, scope: Scope, spans: Spans, guard: FlatExpression | None
) -> list[events.Reset]:
    """One for each element; none after a diagnostic."""
    arguments = positional(ctx, call, 2, 2)
    if arguments is None:
        return []
    target, value_node = arguments
    whole = ctx.elaborate(ctx, scope, target, False)
    whole = components(whole) if isinstance(whole, Vector) else whole
    if isinstance(whole, Poison):
        return []
    if not isinstance(whole, Scalar | Array) or not _may_jump(ctx, scope, target):
        ctx.sink.report("E0374", target.span, *what_it_is(ctx, scope, target), name=target.span.text)
        return []
    parts = (whole.expression,) if isinstance(whole, Scalar) else whole.elements
    known = [_set(ctx, part) for part in parts]
    with ctx.current.without_relations():
        value = ctx.elaborate(ctx, scope, value_node, True)
    shape = () if isinstance(whole, Scalar) else whole.shape
    expected = Expected(
        f"`{target.span.text}`", whole.dimension or DIMENSIONLESS, shape, unit=_unit(ctx, scope, target)
    )
    got = conform(ctx, scope, value_node, value, expected)
    if got is None:
        return []
    values = (got.expression,) if isinstance(got, Scalar) else got.elements
    found = []
    for each, part in zip(known, values, strict=True):
        if each is None:
            ctx.sink.report("E0374", target.span, *what_it_is(ctx, scope, target), name=target.span.text)
            return []
        name, rate = each
        found.append(events.Reset(spans=spans, name=name, rate=rate, value=part, guard=guard))
    return found


def _unit(ctx: Context, scope: Scope, target: nodes.Expression) -> str:
    """The declared unit of a state; that of a rate is not told."""
    found = named_element(ctx, scope, target) if derivative_of(target) is None else None
    return "1" if found is None or found[0].info is None else found[0].info.unit


def _may_jump(ctx: Context, scope: Scope, target: nodes.Expression) -> bool:
    """True if it is a state or a rate, as far as its declaration tells."""
    inner = derivative_of(target)
    found = named_element(ctx, scope, inner if inner is not None else target)
    if found is None:
        return False
    symbol = found[0]
    if symbol.kind in _STILL or (symbol.kind == "input" and not symbol.is_name):
        return False
    return symbol.kind != ("state" if inner is not None else "coordinate")


def _set(ctx: Context, expression: FlatExpression) -> tuple[str, bool] | None:
    """The state, or the coordinate whose rate it is; whether it is there is seen once the model is complete."""
    if isinstance(expression, flat.Derivative) and isinstance(expression.operand, flat.Variable):
        return expression.operand.name, True
    if not isinstance(expression, flat.Variable):
        return None
    name = expression.name
    named = (item for item in ctx.product.named if isinstance(item, flat_model.Definition) and item.name == name)
    definition = next(named, None)
    return (name, False) if definition is None else _set(ctx, definition.value)


def what_it_is(ctx: Context, scope: Scope, node: nodes.Expression) -> tuple[Label, ...]:
    """Label at the declaration of a target that cannot be set."""
    inner = derivative_of(node) or node
    named = isinstance(inner, nodes.Reference | nodes.Member | nodes.Index)
    found = named_element(ctx, scope, inner) if named else None
    return (Label(found[0].span, f"{found[0].title}, declared here"),) if found is not None else ()
