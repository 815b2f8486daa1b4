"""Functions of events: `pre`, `edge`, `change`, `sample`, `initial`, `terminal`, `closed`, `impacts`,
`sticks`, `delay`."""

from __future__ import annotations

from collections.abc import Callable

from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.events import INITIAL, TERMINAL
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.events.delays import delayed
from lagdsl.language.semantics.operators.arguments import labelled_one, named_element, positional
from lagdsl.language.semantics.operators.event_limits import require
from lagdsl.language.semantics.operators.frictions import friction_named
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import POISON, Order, Poison, Scalar, Value, rank
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.syntax import nodes


def before(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`pre(v)`: the value before the event; of what moves continuously, the one before `reinit`."""
    arguments = positional(ctx, node, 1, 1)
    if arguments is None or not _at_an_event(ctx, node):
        return POISON
    value = ctx.elaborate(ctx, scope, arguments[0], False)
    if not isinstance(value, Scalar):
        if not isinstance(value, Poison):
            ctx.sink.report("E0312", arguments[0].span, expected="a variable", found=kind_of(value))
        return POISON
    if isinstance(value.expression, flat.Variable | flat.Derivative) and _moves(value):
        return value
    previous = _previous(ctx, scope, arguments[0], value)
    if previous is None:
        return POISON
    return Scalar(previous, value.dimension, value.variability, value.order, value.kind)


def _moves(value: Scalar) -> bool:
    return value.variability == Variability.CONTINUOUS and value.order in (Order.CONFIGURATION, Order.RATE)


def _previous(ctx: Context, scope: Scope, node: nodes.Expression, value: Scalar) -> flat.FlatExpression | None:
    """Value before the event: of a discrete variable, of a truth that changes at events, of an input or another name
    whose value changes at events only; None after E0376."""
    found = named_element(ctx, scope, node) if isinstance(node, _NAMES) else None
    if found is not None and found[0].kind == "discrete" and isinstance(value.expression, flat.Variable):
        return flat.Previous(value.expression.name)
    truth = value.kind == "Boolean"
    if value.variability == Variability.DISCRETE and (truth or found is not None):
        spans = (node.span, *scope.spans)
        text = " ".join((scope.owner.prefix + node.span.text).split())
        return flat.Previous(ctx.product.occurrences.memory(text, spans, value.expression, truth=truth), text)
    ctx.sink.report("E0376", node.span, name=node.span.text)
    return None


_NAMES = (nodes.Reference, nodes.Member, nodes.Index)


def changed(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`edge(b)`: b and not pre(b); `change(v)`: v <> pre(v)."""
    arguments = positional(ctx, node, 1, 1)
    if arguments is None or not _at_an_event(ctx, node):
        return POISON
    value = ctx.elaborate(ctx, scope, arguments[0], False)
    if isinstance(value, Poison):
        return POISON
    edge = node.function.span.text == "edge"
    if not isinstance(value, Scalar) or (edge and value.kind != "Boolean"):
        expected = "a Boolean" if edge else "a variable"
        ctx.sink.report("E0312", arguments[0].span, expected=expected, found=kind_of(value))
        return POISON
    previous = _previous(ctx, scope, arguments[0], value)
    if previous is None:
        return POISON
    if edge:
        truth: flat.FlatExpression = flat.Binary("and", value.expression, flat.Unary("not", previous))
    else:
        truth = flat.Binary("<>", value.expression, previous)
    return Scalar(truth, DIMENSIONLESS, Variability.DISCRETE, Order.STILL, "Boolean")


def sample(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`sample(start, period)`: true at the ticks of a clock."""
    arguments = positional(ctx, node, 2, 2)
    if arguments is None or not _at_an_event(ctx, node):
        return POISON
    parts: list[flat.FlatExpression] = []
    for what, argument in zip(("the first tick", "the period"), arguments, strict=True):
        value = ctx.elaborate(ctx, scope, argument, True)
        found = conform(ctx, scope, argument, value, Expected(what, ctx.conventions.dimension(TIME), (), code="E0415"))
        if not isinstance(found, Scalar):
            return POISON
        if rank(found.variability) > rank(Variability.PARAMETER):
            ctx.sink.report("E0317", argument.span, what=f"{what} of a clock", allowed="parameters and constants")
            return POISON
        if what == "the period" and not require(ctx, scope, argument, what, found, strict=True):
            return POISON
        parts.append(found.expression)
    spans = (node.span, *scope.spans)
    name = ctx.product.occurrences.clock(scope.owner.prefix + node.span.text, spans, parts[0], parts[1])
    return _truth(name)


def instant(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`initial()`, `terminal()`."""
    if positional(ctx, node, 0, 0) is None or not _at_an_event(ctx, node):
        return POISON
    name = INITIAL if node.function.span.text == "initial" else TERMINAL
    ctx.product.occurrences.instants.add(name)
    return _truth(name)


def of_contact(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`closed(c)`: whether the contact is; `impacts(c)`: how often it closed or bounced so far."""
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    found = labelled_one(ctx, scope, arguments[0], "contact")
    if found is None:
        return POISON
    symbol, indices = found
    contact = ctx.resolver.contact(ctx, symbol, indices)
    if contact is None:
        return POISON
    function = node.function.span.text
    if function == "closed":
        return _boolean(contact.closed)
    if contact.impacts is None:
        ctx.sink.report("E0380", node.span, name=contact.name)
        return POISON
    return Scalar(contact.impacts, DIMENSIONLESS, Variability.DISCRETE, Order.STILL, "Integer")


def sticks(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`sticks(f)`: whether friction holds; of the friction under the contact `sticks(c)`."""
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    friction = friction_named(ctx, scope, arguments[0])
    return _boolean(friction.sticks) if friction is not None else POISON


def action(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`reinit`, `terminate`, `impact` as a value: they are equations of a `when`."""
    ctx.sink.report("E0377", node.span, name=node.function.span.text)
    return POISON


OF_EVENTS: dict[str, Callable[[Context, Scope, nodes.Call], Value]] = {
    "pre": before,
    "edge": changed,
    "change": changed,
    "sample": sample,
    "initial": instant,
    "terminal": instant,
    "closed": of_contact,
    "impacts": of_contact,
    "sticks": sticks,
    "delay": delayed,
    "reinit": action,
    "terminate": action,
    "impact": action,
}


def _truth(name: str) -> Scalar:
    return _boolean(flat.Variable(name))


def _boolean(truth: flat.FlatExpression) -> Scalar:
    """`false` of what is not there is a constant."""
    changes = Variability.CONSTANT if truth == flat.ZERO else Variability.DISCRETE
    return Scalar(truth, DIMENSIONLESS, changes, Order.STILL, "Boolean")


def _at_an_event(ctx: Context, node: nodes.Call) -> bool:
    """E0375 outside of `when`."""
    if ctx.current.in_clause:
        return True
    ctx.sink.report("E0375", node.span, name=node.function.span.text)
    return False
