"""Contacts: `contact name: gap >= 0 with restitution = e`, or with a stiffness and a damping in its place.

The compliant one is the force of Hunt and Crossley, *Coefficient of restitution interpreted as damping in vibroimpact*,
J. Appl. Mech. 42 (1975): k d^n (1 + c d') at the penetration d, never pulling.
"""

from __future__ import annotations

import math
from fractions import Fraction

from lagdsl.diagnostics.suggest import did_you_mean
from lagdsl.flat import events
from lagdsl.flat import expression as flat
from lagdsl.flat import model as flat_model
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.quantity import Variability
from lagdsl.semantics.operators.angles import check_beside
from lagdsl.semantics.operators.arithmetic import Operand, added
from lagdsl.semantics.operators.conditions import structural_condition
from lagdsl.semantics.operators.event_limits import require
from lagdsl.semantics.operators.geometry import operand, time_derivative
from lagdsl.semantics.scope.constants import structural_number
from lagdsl.semantics.scope.context import Context
from lagdsl.semantics.scope.naming import kind_of, name_span
from lagdsl.semantics.scope.scope import Scope
from lagdsl.semantics.scope.values import ContactValue, Order, Poison, Scalar, rank
from lagdsl.semantics.types.bindings import Expected, conform
from lagdsl.syntax import nodes
from lagdsl.units import Dimension
from lagdsl.units.dimension import DIMENSIONLESS, ENERGY, TIME

_RIGID = ("restitution", "v_stick", "t_eps")
_COMPLIANT = ("compliance", "damping", "exponent")
OPTIONS = (*_RIGID, *_COMPLIANT)


def make(ctx: Context, scope: Scope, node: nodes.Contact, name: str) -> ContactValue | None:
    """Adds the contact to the model; None where its condition is false or after a diagnostic."""
    if not structural_condition(ctx, scope, node.condition, "a contact"):
        return None
    gap = _gap(ctx, scope, node)
    options = _options(ctx, node)
    if gap is None or options is None:
        return None
    if "compliance" in options:
        return _compliant(ctx, scope, node, name, gap, options)
    return _rigid(ctx, scope, node, name, gap, options)


def _gap(ctx: Context, scope: Scope, node: nodes.Contact) -> Scalar | None:
    """left - right of `left >= right`."""
    relation = node.value
    while isinstance(relation, nodes.Parenthesized):
        relation = relation.inner
    if not isinstance(relation, nodes.Binary) or relation.operator not in (">=", "<="):
        ctx.sink.report("E0381", node.value.span)
        return None
    pair = (relation.left, relation.right)
    sides = [Operand(side, operand(ctx, ctx.elaborate(ctx, scope, side, False), side.span)) for side in pair]
    if relation.operator == "<=":
        sides.reverse()
    left, right = sides
    for side in sides:
        if not isinstance(side.value, Scalar):
            if not isinstance(side.value, Poison):
                ctx.sink.report("E0312", side.node.span, expected="a scalar", found=kind_of(side.value))
            return None
    check_beside(ctx, scope, *pair)
    gap = added(ctx, scope, "-", left, right, relation)
    if not isinstance(gap, Scalar):
        return None
    if gap.order != Order.CONFIGURATION:
        ctx.sink.report("E0382", node.value.span)
        return None
    return gap


def _options(ctx: Context, node: nodes.Contact) -> dict[str, nodes.Named] | None:
    """The options by name, of one of the two laws."""
    found: dict[str, nodes.Named] = {}
    known = OPTIONS
    for option in node.options:
        if option.name not in known:
            hint = did_you_mean(option.name, known)
            listed = ", ".join(known)
            ctx.sink.report("E0202", name_span(option), name=option.name, type="contact", attributes=listed, help=hint)
            return None
        if option.name in found:
            ctx.sink.report("E0212", name_span(option), name=option.name)
            return None
        found[option.name] = option
    law = _COMPLIANT if "compliance" in found else _RIGID
    odd = next((option for name, option in found.items() if name not in law), None)
    if odd is not None or law[0] not in found:
        span = name_span(odd) if odd is not None else node.span
        ctx.sink.report("E0383", span)
        return None
    return found


def _option(
    ctx: Context,
    scope: Scope,
    option: nodes.Named | None,
    what: str,
    dimension: Dimension,
    latest: Variability,
    *,
    most: float = math.inf,
    strict: bool = False,
) -> FlatExpression | None:
    """The value of an option, of the dimension, that varies no more than `latest`; it is not negative."""
    if option is None:
        return None
    value = ctx.elaborate(ctx, scope, option.value, True)
    found = conform(ctx, scope, option.value, value, Expected(what, dimension, (), code="E0415"))
    if not isinstance(found, Scalar):
        return None
    if rank(found.variability) > rank(latest):
        allowed = "parameters and constants" if latest == Variability.PARAMETER else "what is known at an event"
        ctx.sink.report("E0317", option.value.span, what=what, allowed=allowed)
        return None
    known = rank(found.variability) <= rank(Variability.PARAMETER)
    if known and not require(ctx, scope, option.value, what, found, most=most, strict=strict):
        return None
    return found.expression


# ---- rigid -----------------------------------------------------------------------------------------------------------


def _rigid(
    ctx: Context, scope: Scope, node: nodes.Contact, name: str, gap: Scalar, options: dict[str, nodes.Named]
) -> ContactValue | None:
    dimension = gap.dimension or DIMENSIONLESS
    known = Variability.PARAMETER
    restitution = _option(ctx, scope, options["restitution"], "the restitution", DIMENSIONLESS, known, most=1.0)
    capture_speed = _option(
        ctx, scope, options.get("v_stick"), "`v_stick`", dimension / ctx.conventions.dimension(TIME), known
    )
    zeno_time = _option(ctx, scope, options.get("t_eps"), "`t_eps`", ctx.conventions.dimension(TIME), known)
    if (
        restitution is None
        or (capture_speed is None) != ("v_stick" not in options)
        or (zeno_time is None) != ("t_eps" not in options)
    ):
        return None
    spans = (node.span, *scope.spans)
    contact = events.Contact(
        spans=spans,
        name=name,
        gap=gap.expression,
        dimension=dimension,
        restitution=restitution,
        capture_speed=capture_speed,
        zeno_time=zeno_time,
    )
    ctx.product.occurrences.contacts.append(contact)
    residual = flat.Binary("*", flat.Variable(contact.closed), gap.expression)
    ctx.product.constraints.append(
        flat_model.Constraint(
            spans=spans,
            name=name,
            rows=(name,),
            residuals=(residual,),
            dimension=dimension,
            level="position",
            contact=True,
        )
    )
    force = Scalar(flat.Multiplier(name), _force(ctx, dimension), Variability.CONTINUOUS, Order.SOLUTION)
    return ContactValue(name, contact.closed, contact.impacts, force)


def _force(ctx: Context, gap: Dimension) -> Dimension:
    return ctx.conventions.dimension(ENERGY) / gap


# ---- compliant -------------------------------------------------------------------------------------------------------


def _compliant(
    ctx: Context, scope: Scope, node: nodes.Contact, name: str, gap: Scalar, options: dict[str, nodes.Named]
) -> ContactValue | None:
    dimension = gap.dimension or DIMENSIONLESS
    power = _exponent(ctx, scope, options.get("exponent"))
    if power is None:
        return None
    continuous = Variability.CONTINUOUS
    stiffness_dimension = _force(ctx, dimension) / dimension ** Fraction(power).limit_denominator(12)
    stiffness = _option(
        ctx, scope, options["compliance"], "the stiffness", stiffness_dimension, continuous, strict=True
    )
    slow = ctx.conventions.dimension(TIME) / dimension
    damping = _option(ctx, scope, options.get("damping"), "the damping", slow, continuous)
    if stiffness is None or (damping is None) != ("damping" not in options):
        return None
    spans = (node.span, *scope.spans)
    depth: FlatExpression = flat.Unary("-", gap.expression)
    touching = flat.Variable(ctx.product.occurrences.relation(f"closed({name})", spans, depth, dimension, strict=True))
    force: FlatExpression = depth
    if power != 1.0:  # where the event is located the penetration may be a negative round-off, which has no such power
        force = flat.Binary("^", flat.Function("max", (depth, flat.ZERO)), flat.Number(power))
    force = flat.Binary("*", stiffness, force)
    if damping is not None:
        speed = time_derivative(ctx, gap)
        assert isinstance(speed, Scalar)
        loss = flat.Binary("-", flat.ONE, flat.Binary("*", damping, speed.expression))
        force = flat.Binary("*", force, flat.Function("max", (loss, flat.ZERO)))
    force = flat.Conditional(touching, force, flat.ZERO)
    load = flat_model.GeneralizedForce(
        spans=spans, label=name, keyword="force", value=force, target=gap.expression, origin=None
    )
    ctx.product.forces.append(load)
    pressing = Scalar(force, _force(ctx, dimension), continuous, Order.RATE)
    return ContactValue(name, touching.name, None, pressing)


def _exponent(ctx: Context, scope: Scope, option: nodes.Named | None) -> float | None:
    if option is None:
        return 1.0
    value = ctx.elaborate(ctx, scope, option.value, False)
    number = structural_number(
        ctx, value, option.value, "E0317", what="the exponent", allowed="constants and structural parameters"
    )
    if number is not None and not 1.0 <= number <= 10.0:
        ctx.sink.report("E0334", option.value.span, what="the exponent", expected="1 to 10", found=f"{number:g}")
        return None
    return number
