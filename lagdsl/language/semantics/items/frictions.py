"""Dry friction: `friction name: slip with limit = r, sticking = r0`; under a contact `with friction = mu, slip = s`.

Coulomb's law, with the force along the slip g: while it slides it is -R sign(g), in a plane -R g/|g|; while it sticks
it holds g = 0 with any force up to R0. `docs/explanation/hybrid_model.md` has the law with its modes.
"""

from __future__ import annotations

from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, POWER
from lagdsl.language.flat import events
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Spans, Variability
from lagdsl.language.semantics.items.constraints import row_name
from lagdsl.language.semantics.items.options import option_value, options_of
from lagdsl.language.semantics.operators.conditions import structural_condition
from lagdsl.language.semantics.operators.event_limits import require_least
from lagdsl.language.semantics.operators.geometry import operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import (
    Array,
    ContactValue,
    FrictionValue,
    Order,
    Poison,
    Scalar,
    Vector,
    highest,
    latest,
)
from lagdsl.language.syntax import nodes

OPTIONS = ("limit", "sticking")
UNDER_CONTACT = ("friction", "sticking", "slip")


def make(ctx: Context, scope: Scope, node: nodes.Friction, name: str) -> FrictionValue | None:
    """Adds the friction to the model if its condition is true; None after a diagnostic."""
    condition = structural_condition(ctx, scope, node.condition, "friction")
    if condition is None:
        return None
    if not condition:
        return _absent(node.value)
    slip = _slip(ctx, scope, node.value)
    options = options_of(ctx, node, "friction", OPTIONS)
    if slip is None or options is None:
        return None
    if "limit" not in options:
        hint = "write `with limit = R`, the force while it slides; optionally `sticking = R_0`, the largest one at rest"
        why = "nothing says how large the force is"
        ctx.sink.report("E0388", node.value.span, what="friction", lacks="a limit", why=why, help=hint)
        return None
    unit = ctx.conventions.dimension(POWER) / slip.dimension
    named = "a moment [N.m]" if ctx.conventions.units and unit == ENERGY else None
    limit = option_value(ctx, scope, options["limit"], "the limit", unit, named=named)
    sticking = option_value(ctx, scope, options.get("sticking"), "`sticking`", unit, named=named)
    if limit is None or (sticking is None) != ("sticking" not in options):
        return None
    if sticking is not None and not require_least(ctx, scope, options["sticking"].value, "`sticking`", sticking, limit):
        return None
    return _add(ctx, slip, _Force(name, (node.span, *scope.spans), limit, sticking, None))


def under(ctx: Context, scope: Scope, node: nodes.Contact, contact: ContactValue) -> FrictionValue | None:
    """Adds the friction that the options of a contact ask for; None if they ask for none, or after a diagnostic."""
    options = {option.name: option for option in node.options if option.name in UNDER_CONTACT}
    if not options:
        return None
    if not contact.present:
        return _absent(options["slip"].value) if "slip" in options else None
    slip = _slip(ctx, scope, options["slip"].value)
    coefficient = option_value(ctx, scope, options["friction"], "the coefficient of friction", DIMENSIONLESS)
    sticking = option_value(ctx, scope, options.get("sticking"), "`sticking`", DIMENSIONLESS)
    if slip is None or coefficient is None or (sticking is None) != ("sticking" not in options):
        return None
    if sticking is not None and not require_least(
        ctx, scope, options["sticking"].value, "`sticking`", sticking, coefficient, than="`friction`"
    ):
        return None
    limit = _times(coefficient, contact.multiplier)
    most = _times(sticking, contact.multiplier) if sticking is not None else None
    rigid = contact.name if contact.impacts is not None else None
    force = _Force(f"{contact.name}.friction", (options["slip"].span, *scope.spans), limit, most, rigid)
    return _add(ctx, slip, force)


def _absent(slip: nodes.Expression) -> FrictionValue:
    zeros = Array((flat.ZERO, flat.ZERO), (2,), None) if isinstance(slip, nodes.Array) else Scalar(flat.ZERO, None)
    return FrictionValue(flat.ZERO, zeros)


def _times(factor: Scalar, force: Scalar) -> Scalar:
    product = flat.Binary("*", factor.expression, force.expression)
    return Scalar(product, force.dimension, latest(factor, force), highest(factor, force))


# ---- slip ------------------------------------------------------------------------------------------------------------


@record()
class _Slip:
    """One or two components."""

    parts: tuple[FlatExpression, ...]
    dimension: Dimension


def _slip(ctx: Context, scope: Scope, node: nodes.Expression) -> _Slip | None:
    """The slip, as far as its order tells that it is one: that it is linear is seen in the whole model."""
    value = operand(ctx, ctx.elaborate(ctx, scope, node, False), node.span)
    if isinstance(value, Poison):
        return None
    if not isinstance(value, Scalar) and not (isinstance(value, Array) and value.shape == (2,)):
        text = node.span.text
        hint = f"name two components: `{{{text}.x, {text}.y}}`" if isinstance(value, Vector) else None
        ctx.sink.report("E0387", node.span, found=kind_of(value), help=hint)
        return None
    if value.kind == "Boolean":
        ctx.sink.report("E0387", node.span, found=kind_of(value))
        return None
    if value.order != Order.RATE:
        hint = f"write `der({node.span.text})`" if value.order == Order.CONFIGURATION else None
        if hint is not None and isinstance(node, nodes.Array):
            hint = f"write `{{{', '.join(f'der({each.span.text})' for each in node.elements)}}}`"
        ctx.sink.report("E0387", node.span, found=_ORDERS[value.order], help=hint)
        return None
    parts = (value.expression,) if isinstance(value, Scalar) else value.elements
    return _Slip(parts, value.dimension or DIMENSIONLESS)


_ORDERS = {
    Order.STILL: "does not move",
    Order.GIVEN: "depends on time and inputs only",
    Order.CONFIGURATION: "a position",
    Order.ACCELERATION: "an acceleration",
    Order.SOLUTION: "known only after the equations are solved",
}


# ---- force -----------------------------------------------------------------------------------------------------------


@record()
class _Force:
    """`contact`: the rigid contact under which it acts."""

    name: str
    spans: Spans
    limit: Scalar
    sticking: Scalar | None
    contact: str | None


def _add(ctx: Context, slip: _Slip, force: _Force) -> FrictionValue:
    """The friction, the rows that hold while it sticks and the loads that act while it slides."""
    made = events.Friction(
        spans=force.spans,
        name=force.name,
        slips=slip.parts,
        dimension=slip.dimension,
        limit=force.limit.expression,
        sticking=force.sticking.expression if force.sticking is not None else None,
        contact=force.contact,
    )
    ctx.product.occurrences.laws.frictions.append(made)
    planar = len(slip.parts) > 1
    rows = tuple(row_name(force.name, k) for k in range(1, len(slip.parts) + 1)) if planar else (force.name,)
    sticks = flat.Variable(made.sticks)
    ctx.product.constraints.append(
        flat_model.Constraint(
            spans=force.spans,
            name=force.name,
            rows=rows,
            residuals=tuple(flat.Binary("*", sticks, part) for part in slip.parts),
            dimension=slip.dimension,
            level="velocity",
            friction=True,
        )
    )
    unit = ctx.conventions.dimension(POWER) / slip.dimension
    limit = force.limit.expression
    if force.limit.order >= Order.ACCELERATION:
        limit = ctx.product.occurrences.laws.feedback(f"limit({force.name})", force.spans, limit, unit)
    for part, way in zip(slip.parts, _ways(made), strict=True):
        value = flat.Conditional(sticks, flat.ZERO, _against(limit, way))
        load = flat_model.RateForce(spans=force.spans, label=force.name, value=value, rate=part)
        ctx.product.forces.append(load)
    found = tuple(
        flat.Conditional(sticks, flat.Multiplier(row), _against(force.limit.expression, way))
        for row, way in zip(rows, _ways(made), strict=True)
    )
    multiplier: Scalar | Array = Scalar(found[0], unit, Variability.CONTINUOUS, Order.SOLUTION)
    if planar:
        multiplier = Array(found, (len(found),), unit, Variability.CONTINUOUS, Order.SOLUTION)
    return FrictionValue(sticks, multiplier)


def _against(limit: FlatExpression, way: FlatExpression) -> FlatExpression:
    return flat.Unary("-", flat.Binary("*", limit, way))


def _ways(friction: events.Friction) -> list[FlatExpression]:
    """Direction of the slip: the entry for it, or in a plane the components of a unit vector. There the entries are a
    speed that the slip has where it begins; without it a slip of zero has no direction, and no force."""
    entries: list[FlatExpression] = [flat.Variable(name) for name in friction.directions]
    if len(entries) == 1:
        return entries
    moved = [flat.Binary("+", part, entry) for part, entry in zip(friction.slips, entries, strict=True)]
    first, second = (flat.Binary("*", each, each) for each in moved)
    square = flat.Binary("+", first, second)
    speed = flat.Function("sqrt", (flat.Conditional(flat.Binary(">", square, flat.ZERO), square, flat.ONE),))
    return [flat.Binary("/", each, speed) for each in moved]
