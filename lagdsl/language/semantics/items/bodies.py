"""Rigid bodies: mass, mass centre and inertia in the axes of the frame that carries them."""

from __future__ import annotations

from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, INERTIA, LENGTH, MASS
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.semantics.operators.conditions import where_active
from lagdsl.language.semantics.operators.geometry import as_frame
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.values import Array, Scalar, Vector, components, element_at
from lagdsl.language.semantics.types.bindings import Expected, conform
from lagdsl.language.syntax import nodes

MOMENTS = ("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
PROPERTIES = ("m", "com", "I", *MOMENTS)
_MEANT = {
    "mass": "m",
    "inertia": "I",
    "j": "I",
    "r_cm": "com",
    "cog": "com",
    "center": "com",
    "jxx": "Ixx",
    "jyy": "Iyy",
    "jzz": "Izz",
}


def rigid_body(ctx: Context, scope: Scope, node: nodes.RigidBody, symbol: Symbol | None) -> flat_model.RigidBody | None:
    """The body; properties not given are zero."""
    frame = as_frame(ctx, node.on, ctx.elaborate(ctx, scope, node.on, False))
    given = _given(ctx, node)
    mass = _property(ctx, scope, given.get("m"), "m", MASS, ())
    com = _center(ctx, scope, given.get("com"), along_world=frame is not None and frame.name == "world")
    inertia = _inertia(ctx, scope, given)
    if frame is None or mass is None or com is None or inertia is None:
        return None
    switch = [_where_active(ctx, scope, node, part) for part in (*mass, *inertia)]
    return flat_model.RigidBody(
        spans=(node.span, *scope.spans),
        label=symbol.made.labels[scope.path].name if symbol is not None else None,
        frame=frame.name,
        mass=switch[0],
        com=(com[0], com[1], com[2]),
        inertia=(switch[1], switch[2], switch[3], switch[4], switch[5], switch[6]),
    )


def _where_active(ctx: Context, scope: Scope, node: nodes.RigidBody, part: FlatExpression) -> FlatExpression:
    if part == flat.ZERO:
        return part
    value = where_active(ctx, scope, node.condition, Scalar(part, DIMENSIONLESS))
    return value.expression if value is not None else part


def _given(ctx: Context, node: nodes.RigidBody) -> dict[str, nodes.Expression]:
    """The properties by name; what is none is E0202."""
    given: dict[str, nodes.Expression] = {}
    for modifier in node.modifiers:
        if not isinstance(modifier, nodes.Modifier):
            ctx.sink.report("E0240", modifier.span, what="a body")
            continue
        name = ".".join(modifier.name.parts)
        if name not in PROPERTIES:
            meant = _MEANT.get(name.lower())
            hint = did_you_mean(name, PROPERTIES) if meant is None else f"write `{meant} = ...`"
            listed = ", ".join(PROPERTIES)
            ctx.sink.report("E0202", modifier.name.span, name=name, type="body", attributes=listed, help=hint)
        elif modifier.value is None or modifier.modifiers or modifier.subscripts or modifier.prefixes:
            ctx.sink.report("E0220", modifier.span, name=name)
        elif name in given:
            ctx.sink.report("E0212", modifier.span, name=name)
        else:
            given[name] = modifier.value
    if "I" in given:
        for name in MOMENTS[:3]:
            if name in given:
                ctx.sink.report("E0212", given[name].span, name=name)
    return given


def _property(
    ctx: Context, scope: Scope, node: nodes.Expression | None, name: str, dimension: Dimension, shape: tuple[int, ...]
) -> list[FlatExpression] | None:
    """The elements of a property, zeros where it is not given; None after a diagnostic."""
    count = shape[0] if shape else 1
    if node is None:
        return [flat.ZERO] * count
    value = ctx.elaborate(ctx, scope, node, True)
    found = conform(
        ctx,
        scope,
        node,
        value,
        Expected(f"`{name}` of a body", ctx.conventions.dimension(dimension), shape, code="E0415"),
    )
    if found is None:
        return None
    return [found.expression] if isinstance(found, Scalar) else list(found.elements)


def _center(
    ctx: Context, scope: Scope, node: nodes.Expression | None, *, along_world: bool
) -> list[FlatExpression] | None:
    """`com` with two or three components in the frame's axes."""
    if node is None:
        return [flat.ZERO] * 3
    value = ctx.elaborate(ctx, scope, node, True)
    if isinstance(value, Vector) and not (along_world and isinstance(value.expression, flat.Vector)):
        ctx.sink.report("E0332", node.span, what="`com`")
        return None
    value = components(value) if isinstance(value, Vector) else value
    size = 2 if isinstance(value, Array) and value.shape == (2,) else 3
    found = conform(
        ctx, scope, node, value, Expected("`com` of a body", ctx.conventions.dimension(LENGTH), (size,), code="E0415")
    )
    if not isinstance(found, Array):
        return None
    return [*found.elements, flat.ZERO][:3]


def _inertia(ctx: Context, scope: Scope, given: dict[str, nodes.Expression]) -> list[FlatExpression] | None:
    """Ixx, Iyy, Izz, Ixy, Ixz, Iyz."""
    entries: list[FlatExpression] = [flat.ZERO] * 6
    ok = True
    whole = given.get("I")
    if whole is not None:
        value = ctx.elaborate(ctx, scope, whole, True)
        if isinstance(value, Array) and value.shape == (3, 3):
            diagonal = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
            rows = [element_at(value, k) for k in range(3)]
            picked = tuple(row.elements[j] for i, j in diagonal if isinstance(row := rows[i], Array))
            below = tuple(row.elements[j] for i, j in ((1, 0), (2, 0), (2, 1)) if isinstance(row := rows[i], Array))
            if below != picked[3:]:
                ctx.sink.report("E0334", whole.span, what="`I` of a body", expected="symmetric", found=kind_of(value))
                return None
            value = Array(picked, (6,), value.dimension, value.variability, value.order)
        size = 6 if isinstance(value, Array) and value.shape == (6,) else 3
        found = conform(
            ctx,
            scope,
            whole,
            value,
            Expected("`I` of a body", ctx.conventions.dimension(INERTIA), (size,), code="E0415"),
        )
        ok = isinstance(found, Array)
        if isinstance(found, Array):
            entries[:size] = found.elements
        for name in MOMENTS[3:] if size == 6 else ():
            if name in given:
                ctx.sink.report("E0212", given[name].span, name=name)
                return None
    for position, name in enumerate(MOMENTS):
        if name in given:
            part = _property(ctx, scope, given[name], name, INERTIA, ())
            ok = ok and part is not None
            if part is not None:
                entries[position] = part[0]
    return entries if ok else None
