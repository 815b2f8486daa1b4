"""Physics items: energies, masses, bodies, gravity, constraints, invariants, assertions, initial equations."""

from __future__ import annotations

from dataclasses import field
from typing import Literal, assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.units.dimension import ACCELERATION, DIMENSIONLESS, MASS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.semantics.events.whens import elaborate_when
from lagdsl.language.semantics.items import constraints, contacts, drawings, frictions, labels, loads
from lagdsl.language.semantics.items.bodies import rigid_body
from lagdsl.language.semantics.operators.assertions import asserted
from lagdsl.language.semantics.operators.conditions import condition_of, structural_condition, where_active
from lagdsl.language.semantics.operators.geometry import as_direction, as_point
from lagdsl.language.semantics.scope.constants import structural_number
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, name_span
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Order, Poison, Scalar
from lagdsl.language.semantics.types.dimensions import require
from lagdsl.language.syntax import nodes


@mutable_record()
class Physics:
    """The physics of one model, in source order."""

    energies: list[flat_model.EnergyTerm] = field(default_factory=list)
    masses: list[flat_model.PointMass] = field(default_factory=list)
    bodies: list[flat_model.RigidBody] = field(default_factory=list)
    gravity: flat.FlatExpression | None = None
    gravity_node: nodes.Gravity | None = None
    loads: list[flat_model.Load] = field(default_factory=list)
    invariants: list[flat_model.Invariant] = field(default_factory=list)
    assertions: list[flat_model.Assertion] = field(default_factory=list)
    initial: list[flat_model.InitialEquation] = field(default_factory=list)
    drawings: list[flat_model.Drawing] = field(default_factory=list)


def elaborate_item(ctx: Context, physics: Physics, placed: Placed) -> None:
    """Add the item to the physics, or report why not."""
    node, scope = placed.node, placed.scope
    if isinstance(node, nodes.Constraint):
        _constraint(ctx, placed, node)
    elif isinstance(node, nodes.Gravity):
        _gravity(ctx, physics, scope, node)
    elif isinstance(node, nodes.CallEquation):
        _call(ctx, physics, scope, node)
    elif isinstance(node, nodes.When):
        elaborate_when(ctx, placed)
    elif isinstance(node, nodes.Contact):
        _contact(ctx, placed, node)
    elif isinstance(node, nodes.Friction):
        _friction(ctx, placed, node)
    elif condition_of(ctx, scope, _condition(node)) not in (False, None):
        _conditional_item(ctx, physics, placed)


def _condition(node: nodes.Item) -> nodes.Expression | None:
    found = getattr(node, "condition", None)
    return found if isinstance(found, nodes.Node) else None  # type: ignore[return-value]


def _conditional_item(ctx: Context, physics: Physics, placed: Placed) -> None:
    scope = placed.scope
    match placed.node:
        case nodes.Energy() as node:
            _energy(ctx, physics, placed, node)
        case nodes.PointMass() as node:
            _mass(ctx, physics, scope, node)
        case nodes.RigidBody() as node:
            body = rigid_body(ctx, scope, node, placed.symbol)
            if body is not None:
                physics.bodies.append(body)
        case nodes.Load() as node:
            load = loads.load(ctx, scope, node, placed.symbol)
            if load is not None:
                physics.loads.append(load)
        case nodes.Invariant() as node:
            _invariant(ctx, physics, scope, node)
        case nodes.Draw() as node:
            drawing = drawings.drawing(ctx, scope, node)
            if drawing is not None:
                physics.drawings.append(drawing)
        case nodes.Gravity() | nodes.Constraint() | nodes.Contact() | nodes.Friction() | nodes.Measure():
            raise AssertionError(f"{placed.node!r} has no condition")
        case (
            nodes.Import()
            | nodes.Definition()
            | nodes.Declaration()
            | nodes.Relation()
            | nodes.Block()
            | nodes.Extends()
            | nodes.Annotation()
        ):
            raise AssertionError(f"no physics item: {placed.node!r}")
        case _:
            assert_never(placed.node)


def _constraint(ctx: Context, placed: Placed, node: nodes.Constraint) -> None:
    if not structural_condition(ctx, placed.scope, node.condition, "a constraint"):
        return
    if placed.symbol is not None:
        made = ctx.resolver.constraint(ctx, placed.symbol, placed.scope.path)
    else:
        made = constraints.make(ctx, placed.scope, node, ctx.product.number("constraint"))
    if made is not None:
        ctx.product.constraints.append(made)


def _contact(ctx: Context, placed: Placed, node: nodes.Contact) -> None:
    if placed.symbol is not None:
        ctx.resolver.contact(ctx, placed.symbol, placed.scope.path)
        ctx.resolver.friction(ctx, placed.symbol, placed.scope.path, node.span)
        return
    made = contacts.make(ctx, placed.scope, node, ctx.product.number("contact"))
    if made is not None:
        frictions.under(ctx, placed.scope, node, made)


def _friction(ctx: Context, placed: Placed, node: nodes.Friction) -> None:
    if placed.symbol is not None:
        ctx.resolver.friction(ctx, placed.symbol, placed.scope.path, node.span)
    else:
        frictions.make(ctx, placed.scope, node, ctx.product.number("friction"))


def _energy(ctx: Context, physics: Physics, placed: Placed, node: nodes.Energy) -> None:
    scope = placed.scope
    if placed.symbol is not None:
        value = ctx.resolver.element(ctx, placed.symbol, scope.path, node.span)
        label: str | None = placed.symbol.made.labels[scope.path].name
        if isinstance(value, Scalar) and isinstance(value.expression, flat.Variable):
            value = Scalar(_definition(ctx, value.expression.name), value.dimension, value.variability, value.order)
    else:
        found = labels.energy_value(ctx, scope, node)
        value, label = found if found is not None else Poison(), None
    if isinstance(value, Scalar):
        kind = _ENERGIES[node.keyword]
        term = flat_model.EnergyTerm(spans=(node.span, *scope.spans), kind=kind, label=label, value=value.expression)
        physics.energies.append(term)


_ENERGIES: dict[str, Literal["kinetic", "potential", "lagrangian", "dissipation"]] = {
    "kinetic": "kinetic",
    "potential": "potential",
    "lagrangian": "lagrangian",
    "dissipation": "dissipation",
}


def _definition(ctx: Context, name: str) -> flat.FlatExpression:
    """Meaning of a label: the energy keeps its expression, readers of the label share it."""
    for item in reversed(ctx.product.named):
        if isinstance(item, flat_model.Definition) and item.name == name:
            return item.value
    return flat.Variable(name)


def _mass(ctx: Context, physics: Physics, scope: Scope, node: nodes.PointMass) -> None:
    mass = ctx.elaborate(ctx, scope, node.mass, False)
    point = as_point(ctx, scope, node.at, ctx.elaborate(ctx, scope, node.at, False))
    if isinstance(mass, Poison):
        return
    if not isinstance(mass, Scalar) or mass.kind == "Boolean":
        ctx.sink.report("E0312", node.mass.span, expected="a mass", found=kind_of(mass))
        return
    if not require(ctx, scope, node.mass, mass.dimension, MASS, "E0415", what="`mass`"):
        return
    if point is None:
        return
    value = where_active(ctx, scope, node.condition, mass)
    if value is not None:
        spans = (node.span, *scope.spans)
        physics.masses.append(flat_model.PointMass(spans=spans, mass=value.expression, position=point.expression))


def _gravity(ctx: Context, physics: Physics, scope: Scope, node: nodes.Gravity) -> None:
    if physics.gravity_node is not None:
        ctx.sink.report("E0325", node.span, Label(physics.gravity_node.span, "gravity is given here"))
        return
    physics.gravity_node = node
    value = ctx.elaborate(ctx, scope, node.value, False)
    vector = as_direction(ctx, scope, node.value, value, "gravity", ACCELERATION)
    if vector is not None:
        physics.gravity = vector.expression


# ---- claims and conditions -------------------------------------------------------------------------------------------


def _invariant(ctx: Context, physics: Physics, scope: Scope, node: nodes.Invariant) -> None:
    if isinstance(condition_of(ctx, scope, node.condition), Scalar):
        assert node.condition is not None
        ctx.sink.report("E0330", node.condition.span, what="an invariant")
        return
    tolerance = _tolerance(ctx, scope, node)
    value = labels.invariant_value(ctx, scope, node)
    if value is None:
        return
    name = node.label if node.label is not None else node.value.span.text
    if scope.path and node.label is not None:
        name = f"{name}[{','.join(str(index) for index in scope.path)}]"
    physics.invariants.append(
        flat_model.Invariant(
            spans=(node.span, *scope.spans),
            name=name,
            value=value.expression,
            dimension=value.dimension or DIMENSIONLESS,
            tolerance=tolerance,
        )
    )


def _tolerance(ctx: Context, scope: Scope, node: nodes.Invariant) -> float | None:
    for option in node.options:
        if option.name != "tol":
            hint = did_you_mean(option.name, ["tol"])
            ctx.sink.report("E0202", name_span(option), name=option.name, type="invariant", attributes="tol", help=hint)
            continue
        value = ctx.elaborate(ctx, scope, option.value, False)
        if isinstance(value, Scalar) and not require(
            ctx, scope, option.value, value.dimension, DIMENSIONLESS, "E0415", what="a tolerance"
        ):
            return None
        number = structural_number(
            ctx, value, option.value, "E0317", what="a tolerance", allowed="constants and structural parameters"
        )
        if number is not None and not number > 0.0:
            ctx.sink.report("E0334", option.value.span, what="a tolerance", expected="positive", found=f"{number:g}")
            return None
        return number
    return None


def _call(ctx: Context, physics: Physics, scope: Scope, node: nodes.CallEquation) -> None:
    """`assert(condition, "message", level)`; other calls belong into `when`."""
    call = node.call
    if not isinstance(call, nodes.Call) or call.function.span.text != "assert":
        if (
            isinstance(call, nodes.Call) and not isinstance(ctx.elaborate(ctx, scope, call, False), Poison)
        ) or not isinstance(call, nodes.Call):
            ctx.sink.report("E0322", node.span, help=_equality(call))
        return
    found = asserted(ctx, scope, call)
    if found is not None:
        spans = (node.span, *scope.spans)
        assertion = flat_model.Assertion(
            spans=spans, condition=found.condition, message=found.message, warning=found.warning
        )
        physics.assertions.append(assertion)


def _equality(node: nodes.Expression) -> str | None:
    """Help for `x == y;`."""
    if isinstance(node, nodes.Binary) and node.operator == "==":
        return f"an equation has one `=`: `{node.left.span.text} = {node.right.span.text};`"
    return None


def initial_equation(ctx: Context, physics: Physics, placed: Placed) -> None:
    """Each row of an equation that holds at the start."""
    node = placed.node
    if not isinstance(node, nodes.Equation):
        assert isinstance(node, nodes.CallEquation)
        ctx.sink.report("E0322", node.span)
        return
    residual = constraints.difference(ctx, placed.scope, node)
    if residual is None:
        return
    if residual.order == Order.SOLUTION:
        ctx.sink.report("E0324", node.span, what="an initial equation")
        return
    parts = (residual.expression,) if isinstance(residual, Scalar) else residual.elements
    for part in parts:
        spans = (node.span, *placed.scope.spans)
        dimension = residual.dimension or DIMENSIONLESS
        physics.initial.append(flat_model.InitialEquation(spans=spans, residual=part, dimension=dimension))
