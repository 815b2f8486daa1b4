"""Contacts: `contact name: gap >= 0 with restitution = e`, or with a stiffness and a damping in its place; one-way
contacts `contact name: rate >= 0`.

The compliant one is the force of Hunt and Crossley, *Coefficient of restitution interpreted as damping in vibroimpact*,
J. Appl. Mech. 42 (1975): k d^n (1 + c d') at the penetration d, never pulling.
"""

from __future__ import annotations

from fractions import Fraction

from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, POWER, TIME
from lagdsl.language.flat import events
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.items.frictions import UNDER_CONTACT
from lagdsl.language.semantics.items.options import option_value, options_of
from lagdsl.language.semantics.operators.angles import check_beside
from lagdsl.language.semantics.operators.arithmetic import Operand, added
from lagdsl.language.semantics.operators.conditions import structural_condition
from lagdsl.language.semantics.operators.discontinuous import met, relation
from lagdsl.language.semantics.operators.geometry import operand, time_derivative
from lagdsl.language.semantics.scope.constants import structural_number
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, name_span
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import ContactValue, Order, Poison, Scalar
from lagdsl.language.syntax import nodes

_RIGID = ("restitution", "v_stick", "t_eps")
_COMPLIANT = ("compliance", "damping", "exponent")
OPTIONS = (*_RIGID, *_COMPLIANT, *UNDER_CONTACT)


def make(ctx: Context, scope: Scope, node: nodes.Contact, name: str) -> ContactValue | None:
    """Adds the contact to the model if its condition is true; None after a diagnostic."""
    condition = structural_condition(ctx, scope, node.condition, "a contact")
    if condition is None:
        return None
    if not condition:
        return ContactValue(name, flat.ZERO, flat.ZERO, Scalar(flat.ZERO, None), present=False)
    gap = _gap(ctx, scope, node)
    if gap is None:
        return None
    options = _options(ctx, node, one_way=gap.order == Order.RATE)
    if options is None:
        return None
    if gap.order == Order.RATE:
        return _one_way(ctx, scope, node, name, gap)
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
    if gap.order not in (Order.CONFIGURATION, Order.RATE):
        ctx.sink.report("E0382", node.value.span)
        return None
    return gap


def _options(ctx: Context, node: nodes.Contact, *, one_way: bool) -> dict[str, nodes.Named] | None:
    """The options by name: those of one of the two laws with those of friction, none for a contact of a rate."""
    found = options_of(ctx, node, "contact", OPTIONS)
    if found is None:
        return None
    if one_way:
        for option in found.values():
            ctx.sink.report("E0389", name_span(option), name=option.name)
            return None
        return found
    complete = _complete(ctx, found)
    law = _COMPLIANT if "compliance" in found else _RIGID
    odd = next((option for name, option in found.items() if name not in (*law, *UNDER_CONTACT)), None)
    if odd is not None or law[0] not in found:
        span = name_span(odd) if odd is not None else node.span
        ctx.sink.report("E0383", span)
        return None
    return found if complete else None


def _complete(ctx: Context, options: dict[str, nodes.Named]) -> bool:
    """True if friction has a coefficient and a slip; False after E0388."""
    first = next((option for name, option in options.items() if name in UNDER_CONTACT), None)
    lacking = next((name for name in ("friction", "slip") if name not in options), None)
    if first is None or lacking is None:
        return True
    lacks, why, hint = _LACKING[lacking]
    ctx.sink.report("E0388", name_span(first), what="friction under a contact", lacks=lacks, why=why, help=hint)
    return False


_LACKING = {
    "slip": (
        "a slip",
        "a contact knows its gap, not the direction in which the bodies slide",
        "add `slip = der(s)`, the rate at which the bodies slide on each other; in a plane two, `{der(x), der(y)}`",
    ),
    "friction": ("a coefficient", "nothing says how large the force is", "add `friction = mu`"),
}
"""Of an option that is left out: its name, a reason, and a way out."""


# ---- rigid -----------------------------------------------------------------------------------------------------------


def _rigid(
    ctx: Context, scope: Scope, node: nodes.Contact, name: str, gap: Scalar, options: dict[str, nodes.Named]
) -> ContactValue | None:
    dimension = gap.dimension or DIMENSIONLESS
    known = Variability.PARAMETER
    restitution = option_value(ctx, scope, options["restitution"], "the restitution", DIMENSIONLESS, known, most=1.0)
    capture_speed = option_value(
        ctx, scope, options.get("v_stick"), "`v_stick`", dimension / ctx.conventions.dimension(TIME), known
    )
    zeno_time = option_value(ctx, scope, options.get("t_eps"), "`t_eps`", ctx.conventions.dimension(TIME), known)
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
        restitution=restitution.expression,
        capture_speed=capture_speed.expression if capture_speed is not None else None,
        zeno_time=zeno_time.expression if zeno_time is not None else None,
    )
    return _present(ctx, contact, _force(ctx, dimension))


def _one_way(ctx: Context, scope: Scope, node: nodes.Contact, name: str, rate: Scalar) -> ContactValue:
    """A freewheel or a ratchet: the rate is never negative. It does not bounce."""
    contact = events.Contact(
        spans=(node.span, *scope.spans),
        name=name,
        gap=rate.expression,
        dimension=rate.dimension or DIMENSIONLESS,
        restitution=flat.ZERO,
        capture_speed=None,
        zeno_time=None,
        one_way=True,
    )
    return _present(ctx, contact, ctx.conventions.dimension(POWER) / contact.dimension)


def _present(ctx: Context, contact: events.Contact, force: Dimension) -> ContactValue:
    """Adds the contact and the row that holds while it is closed."""
    ctx.product.occurrences.laws.contacts.append(contact)
    residual = flat.Binary("*", flat.Variable(contact.closed), contact.gap)
    ctx.product.constraints.append(
        flat_model.Constraint(
            spans=contact.spans,
            name=contact.name,
            rows=(contact.name,),
            residuals=(residual,),
            dimension=contact.dimension,
            level="velocity" if contact.one_way else "position",
            contact=True,
        )
    )
    multiplier = Scalar(flat.Multiplier(contact.name), force, Variability.CONTINUOUS, Order.SOLUTION)
    return ContactValue(contact.name, flat.Variable(contact.closed), flat.Variable(contact.impacts), multiplier)


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
    stiffness = option_value(
        ctx, scope, options["compliance"], "the stiffness", stiffness_dimension, continuous, strict=True
    )
    slow = ctx.conventions.dimension(TIME) / dimension
    damping = option_value(ctx, scope, options.get("damping"), "the damping", slow, continuous)
    if stiffness is None or (damping is None) != ("damping" not in options):
        return None
    spans = (node.span, *scope.spans)
    depth: FlatExpression = flat.Unary("-", gap.expression)
    pressed = flat.Binary(">", depth, flat.ZERO)
    touching = relation(ctx, spans, f"closed({name})", pressed, dimension, gap.order)
    force: FlatExpression = depth
    if power != 1.0:  # where the event is located the penetration may be a negative round-off, which has no such power
        force = flat.Binary("^", flat.Function("max", (depth, flat.ZERO)), flat.Number(power))
    force = flat.Binary("*", stiffness.expression, force)
    if damping is not None:
        speed = time_derivative(ctx, gap)
        assert isinstance(speed, Scalar)
        loss = flat.Binary("-", flat.ONE, flat.Binary("*", damping.expression, speed.expression))
        pushes = flat.Function("max", (loss, flat.ZERO))
        share = Scalar(loss, DIMENSIONLESS, continuous, Order.RATE)
        force = flat.Binary("*", force, met(ctx, scope, node, "max", pushes, share, text=f"loss({name})"))
    force = flat.Conditional(touching, force, flat.ZERO)
    load = flat_model.GeneralizedForce(
        spans=spans, label=name, keyword="force", value=force, target=gap.expression, origin=None
    )
    ctx.product.forces.append(load)
    pressing = Scalar(force, _force(ctx, dimension), continuous, Order.RATE)
    return ContactValue(name, touching, None, pressing)


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
