"""Functions that know the mechanism: `der`, `omega`, `vel`, `reaction`, `multiplier`, `momentum`, `energy` ..."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, FORCE, TIME, VELOCITY
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.expressions import required_forces
from lagdsl.language.semantics.operators.arguments import is_one, labelled, named, named_element, positional
from lagdsl.language.semantics.operators.arrays import select, subscript_indices
from lagdsl.language.semantics.operators.conditions import condition_of
from lagdsl.language.semantics.operators.frictions import friction_named, names_friction
from lagdsl.language.semantics.operators.geometry import (
    ANGULAR_MOMENTUM,
    MOMENTUM,
    as_direction,
    as_frame,
    as_point,
    operand,
    time_derivative,
)
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Indices, Instance, Scope, Symbol
from lagdsl.language.semantics.scope.values import (
    POISON,
    Array,
    Component,
    Order,
    Poison,
    Reaction,
    Scalar,
    Value,
    Vector,
    as_vector,
)
from lagdsl.language.syntax import nodes

Special = Callable[[Context, Scope, nodes.Call], Value]


def _der(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    value = operand(ctx, ctx.elaborate(ctx, scope, arguments[0], False), arguments[0].span)
    if isinstance(value, Poison):
        return POISON
    if not isinstance(value, Scalar | Vector | Array) or getattr(value, "kind", "Real") == "Boolean":
        ctx.sink.report("E0312", arguments[0].span, expected="a quantity to differentiate", found=kind_of(value))
        return POISON
    if value.order >= Order.ACCELERATION:
        ctx.sink.report("E0342", arguments[0].span)
        return POISON
    return time_derivative(ctx, value)


def _unlocated(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`noEvent(x)`, `smooth(p, x)`: the value of x, its relations taken as they stand on purpose."""
    smooth = node.function.span.text == "smooth"
    arguments = positional(ctx, node, 2, 2) if smooth else positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    if smooth:
        order = structural_integer(ctx, ctx.elaborate(ctx, scope, arguments[0], False), arguments[0], "E0333")
        if order is None:
            return POISON
    with ctx.current.without_relations():
        return ctx.elaborate(ctx, scope, arguments[-1], False)


def _omega(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    frame = as_frame(ctx, arguments[0], ctx.elaborate(ctx, scope, arguments[0], False))
    if frame is None:
        return POISON
    dimension = DIMENSIONLESS / ctx.conventions.dimension(TIME)
    if frame.name == "world":
        return Vector(flat.ZERO_VECTOR, dimension, Variability.CONSTANT, Order.STILL)
    order = Order.RATE if frame.order > Order.GIVEN else frame.order
    return Vector(flat.AngularVelocity(frame.name), dimension, frame.variability, order)


def _vel(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`vel(P)`: of the point; `vel(P, B)`: of the material point of B that is at P."""
    arguments = positional(ctx, node, 1, 2)
    if arguments is None:
        return POISON
    point = as_point(ctx, scope, arguments[0], ctx.elaborate(ctx, scope, arguments[0], False))
    if point is None:
        return POISON
    if len(arguments) == 1:
        return time_derivative(ctx, point)
    frame = as_frame(ctx, arguments[1], ctx.elaborate(ctx, scope, arguments[1], False))
    if frame is None:
        return POISON
    known = max(frame.order, point.order)
    order = Order.RATE if known > Order.GIVEN else known
    velocity = flat.MaterialVelocity(point.expression, frame.name)
    if frame.name == "world":
        return Vector(flat.ZERO_VECTOR, ctx.conventions.dimension(VELOCITY), Variability.CONSTANT, Order.STILL)
    return Vector(velocity, ctx.conventions.dimension(VELOCITY), Variability.CONTINUOUS, order)


def _energy(kind: Literal["total", "kinetic", "potential", "jacobi"]) -> Special:
    def energy(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
        if positional(ctx, node, 0, 0) is None:
            return POISON
        return Scalar(
            flat.SystemEnergy(kind), ctx.conventions.dimension(ENERGY), Variability.CONTINUOUS, Order.SOLUTION
        )

    return energy


def _momentum(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    value = ctx.elaborate(ctx, scope, arguments[0], False)
    if isinstance(value, Poison):
        return POISON
    found = named_element(ctx, scope, arguments[0])
    coordinate = found is not None and found[0].kind == "coordinate"
    if not coordinate or not isinstance(value, Scalar) or not isinstance(value.expression, flat.Variable):
        ctx.sink.report("E0312", arguments[0].span, expected="a coordinate", found=_what(found, value))
        return POISON
    dimension = ctx.conventions.dimension(ENERGY) * ctx.conventions.dimension(TIME) / (value.dimension or DIMENSIONLESS)
    momentum = flat.GeneralizedMomentum(value.expression.name)
    return Scalar(momentum, dimension, Variability.CONTINUOUS, Order.SOLUTION)


def _what(found: tuple[Symbol, Indices] | None, value: Value) -> str:
    return found[0].title if found is not None else kind_of(value)


def _reaction(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`reaction(F)` of a frame, `reaction(J)` of a component, `reaction(P, along = e)` of a point."""
    arguments = positional(ctx, node, 1, 1, ("along",))
    if arguments is None:
        return POISON
    target = arguments[0]
    value = ctx.elaborate(ctx, scope, target, False)
    along = named(node, "along")
    if isinstance(value, Poison):
        return POISON
    if along is None and isinstance(value, Component) and isinstance(value.instance, Instance):
        return ctx.assembly.reaction(value.instance, target.span) if ctx.assembly is not None else POISON
    if along is None:
        frame = as_frame(ctx, target, value)
        if frame is None:
            return POISON
        if frame.name == "world":
            ctx.sink.report("E0312", target.span, expected="a moving frame", found="the world")
            return POISON
        return Reaction(frame.name)
    direction = as_direction(ctx, scope, along, ctx.elaborate(ctx, scope, along, False), "a direction", DIMENSIONLESS)
    vector = as_vector(value)
    if direction is None or vector is None or not isinstance(vector.expression, flat.PointReference):
        if direction is not None:
            hint = "declare the position, and let the mass stand there: `point P = ...;`, `mass m at P;`"
            ctx.sink.report("E0312", target.span, expected="the name of a point", found=kind_of(value), help=hint)
        return POISON
    reaction = flat.ReactionAlong(vector.expression.name, direction.expression)
    return Scalar(reaction, ctx.conventions.dimension(FORCE), Variability.CONTINUOUS, Order.SOLUTION)


def _multiplier(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """`multiplier(c)`: J/[g] for a position row, J/([g].s) for a velocity row and for friction; an array for a vector
    constraint, of which `multiplier(c[2])` is one, and for friction in a plane."""
    arguments = positional(ctx, node, 1, 1)
    if arguments is None:
        return POISON
    label, rows = _rows_apart(ctx, scope, arguments[0])
    if names_friction(ctx, scope, label):
        friction = friction_named(ctx, scope, label)
        value: Value = friction.multiplier if friction is not None else POISON
    else:
        found = labelled(ctx, scope, label, "constraint", "contact", "friction")
        value = _multiplier_of(ctx, label, *found) if found is not None else POISON
    if not rows or isinstance(value, Poison):
        return value
    if not isinstance(value, Array):
        hint = f"write `multiplier({label.span.text})`"
        what = f"`{label.span.text}`, which is one equation"
        ctx.sink.report("E0312", arguments[0].span, expected="an array", found=what, help=hint)
        return POISON
    chosen = subscript_indices(ctx, scope, rows, value.shape, arguments[0])
    return POISON if chosen is None else select(value, chosen)


def _rows_apart(
    ctx: Context, scope: Scope, node: nodes.Expression
) -> tuple[nodes.Expression, tuple[nodes.Subscript, ...]]:
    """`c[i, k]` as the label `c[i]` of a loop and the rows `k` of its vector."""
    if not isinstance(node, nodes.Index):
        return node, ()
    if isinstance(node.target, nodes.Member) and names_friction(ctx, scope, node.target):
        return node.target, node.subscripts  # `c.friction[1]`
    symbol = designated(ctx, scope, node.target)
    if not isinstance(symbol, Symbol) or symbol.kind not in ("constraint", "friction"):
        return node, ()
    rank = len(ctx.resolver.shape(ctx, symbol) or ())
    if len(node.subscripts) <= rank:
        return node, ()
    label = replace(node, subscripts=node.subscripts[:rank]) if rank else node.target
    return label, node.subscripts[rank:]


def _multiplier_of(ctx: Context, node: nodes.Expression, symbol: Symbol, indices: Indices) -> Value:
    if symbol.kind == "contact":
        contact = ctx.resolver.contact(ctx, symbol, indices) if is_one(ctx, node, symbol, indices) else None
        return contact.multiplier if contact is not None else POISON
    places = [indices] if indices in symbol.made.labels else list(symbol.made.labels)
    rows = [ctx.resolver.constraint(ctx, symbol, each) for each in places]
    known = [constraint for constraint in rows if constraint is not None]
    if not known or len(known) < len(rows):
        return POISON
    parts = tuple(
        flat.Multiplier(row) if _present(ctx, symbol, place) else flat.ZERO
        for place, constraint in zip(places, known, strict=True)
        for row in constraint.rows
    )
    dimension = _multiplier_dimension(ctx, known[0].dimension, known[0].level)
    if len(parts) == 1 and len(known) == 1 and known[0].rows == (known[0].name,):
        return Scalar(parts[0], dimension, Variability.CONTINUOUS, Order.SOLUTION)
    return Array(parts, (len(parts),), dimension, Variability.CONTINUOUS, Order.SOLUTION)


def _present(ctx: Context, symbol: Symbol, indices: Indices) -> bool:
    """False where the condition of the labelled item leaves it out: it exerts nothing then and has no momentum."""
    instance = symbol.made.labels[indices]
    return condition_of(ctx, instance.scope, instance.node.condition) is not False


def _multiplier_dimension(ctx: Context, row: Dimension, level: str) -> Dimension:
    dimension = ctx.conventions.dimension(ENERGY) / row
    return dimension if level == "position" else dimension / ctx.conventions.dimension(TIME)


def _linear_momentum(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    if positional(ctx, node, 0, 0) is None:
        return POISON
    return Vector(flat.LinearMomentum(), ctx.conventions.dimension(MOMENTUM), Variability.CONTINUOUS, Order.SOLUTION)


def _angular_momentum(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """Of the named body or of everything, about a point (default: the world origin)."""
    arguments = positional(ctx, node, 0, 1, ("about",))
    if arguments is None:
        return POISON
    body = None
    if arguments:
        found = labelled(ctx, scope, arguments[0], "body")
        if found is None:
            return POISON
        symbol, indices = found
        if indices not in symbol.made.labels:
            ctx.sink.report("E0312", arguments[0].span, expected="one body", found=f"all bodies `{symbol.name}`")
            return POISON
        body = symbol.made.labels[indices].name
        if not _present(ctx, symbol, indices):
            return Vector(
                flat.ZERO_VECTOR, ctx.conventions.dimension(ANGULAR_MOMENTUM), Variability.CONTINUOUS, Order.SOLUTION
            )
    about = named(node, "about")
    point = Vector(flat.ZERO_VECTOR, None)
    if about is not None:
        position = as_point(ctx, scope, about, ctx.elaborate(ctx, scope, about, False))
        if position is None:
            return POISON
        point = position
    momentum = flat.AngularMomentum(body, point.expression)
    return Vector(momentum, ctx.conventions.dimension(ANGULAR_MOMENTUM), Variability.CONTINUOUS, Order.SOLUTION)


SPECIALS: dict[str, Special] = {
    "der": _der,
    "noEvent": _unlocated,
    "smooth": _unlocated,
    "omega": _omega,
    "vel": _vel,
    "energy": _energy("total"),
    "kinetic_energy": _energy("kinetic"),
    "potential_energy": _energy("potential"),
    "jacobi_integral": _energy("jacobi"),
    "momentum": _momentum,
    "inverse_dynamics": required_forces.inverse_dynamics,
    "bias": required_forces.bias,
    "reaction": _reaction,
    "multiplier": _multiplier,
    "linear_momentum": _linear_momentum,
    "angular_momentum": _angular_momentum,
}
