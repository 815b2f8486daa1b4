"""Values of labelled items: `kinetic T = ...`, `force F = ...`, `invariant E: ...` may be read by name."""

from __future__ import annotations

from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, FORCE, LENGTH, POWER
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.conditions import condition_of, where_active
from lagdsl.language.semantics.operators.geometry import as_direction, operand
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.scope import Indices, LabelInstance, Scope, Symbol
from lagdsl.language.semantics.scope.values import POISON, Array, Order, Poison, Scalar, Value, Vector, rank
from lagdsl.language.semantics.types.dimensions import require
from lagdsl.language.syntax import nodes

MOMENT = FORCE * LENGTH


def value(ctx: Context, symbol: Symbol, indices: Indices) -> Value:
    """The value behind a label; a scalar energy or load becomes a definition of that name."""
    instance = symbol.made.labels.get(indices)
    if instance is None:
        return POISON
    node = instance.node
    if condition_of(ctx, instance.scope, node.condition) is False:
        # A label that is switched off contributes nothing, whatever its unit.
        return Scalar(flat.ZERO, None)
    if isinstance(node, nodes.Invariant):
        return invariant_value(ctx, instance.scope, node) or POISON
    if isinstance(node, nodes.Energy):
        found: Scalar | Vector | None = energy_value(ctx, instance.scope, node)
    else:
        assert isinstance(node, nodes.Load)
        found = load_value(ctx, instance.scope, node)
    if not isinstance(found, Scalar):
        return found or POISON
    definition = _definition(instance, node, found)
    if found.order >= Order.ACCELERATION:
        ctx.product.observed.append(definition)
        return found
    ctx.product.named.append(definition)
    return Scalar(flat.Variable(instance.name), found.dimension or DIMENSIONLESS, definition.variability, found.order)


def _definition(instance: LabelInstance, node: nodes.Energy | nodes.Load, found: Scalar) -> flat_model.Definition:
    dimension = found.dimension or DIMENSIONLESS
    variability = max(found.variability, Variability.PARAMETER, key=rank)
    return flat_model.Definition(
        spans=(node.span, *instance.scope.spans),
        name=instance.name,
        dimension=dimension,
        unit=unit_text(dimension),
        doc=node.doc,
        type_name="Real" if isinstance(node, nodes.Load) else "Power" if node.keyword == "dissipation" else "Energy",
        value=found.expression,
        variability=variability,
    )


# ---- energies --------------------------------------------------------------------------------------------------------


def energy_value(ctx: Context, scope: Scope, node: nodes.Energy) -> Scalar | None:
    """The checked value of `kinetic`, `potential`, `lagrangian` [J] or `dissipation` [W]."""
    value_ = ctx.elaborate(ctx, scope, node.value, False)
    if isinstance(value_, Poison):
        return None
    if not isinstance(value_, Scalar) or value_.kind == "Boolean":
        hint = "for the square of a velocity write `v*v`" if isinstance(value_, Vector | Array) else None
        ctx.sink.report(
            "E0312", node.value.span, expected=f"a scalar after `{node.keyword}`", found=kind_of(value_), help=hint
        )
        return None
    expected = POWER if node.keyword == "dissipation" else ENERGY
    hint_ = _energy_hint(node.keyword, value_)
    if not require(ctx, scope, node.value, value_.dimension, expected, "E0404", keyword=node.keyword, help=hint_):
        return None
    if value_.order == Order.SOLUTION:
        ctx.sink.report("E0324", node.value.span, what=f"`{node.keyword}`")
        return None
    return where_active(ctx, scope, node.condition, value_)


def _energy_hint(keyword: str, found: Scalar) -> str | None:
    if keyword == "dissipation" and found.dimension == ENERGY:
        return "is a `der(...)` missing?"
    if keyword != "dissipation" and found.dimension == POWER:
        return "is there a `der(...)` too many, or is `dissipation` meant?"
    return None


# ---- loads -----------------------------------------------------------------------------------------------------------


def load_value(ctx: Context, scope: Scope, node: nodes.Load) -> Scalar | Vector | None:
    """The checked value of a force or torque: a vector at a point or on a frame, a scalar on a scalar."""
    found = operand(ctx, ctx.elaborate(ctx, scope, node.value, False), node.value.span)
    if isinstance(found, Poison):
        return None
    if node.at is None and isinstance(found, Scalar) and found.kind != "Boolean":
        return where_active(ctx, scope, node.condition, found)
    dimension = MOMENT if node.keyword == "torque" else FORCE
    vector = as_direction(ctx, scope, node.value, found, f"a {node.keyword}", dimension)
    return where_active(ctx, scope, node.condition, vector) if vector is not None else None


def invariant_value(ctx: Context, scope: Scope, node: nodes.Invariant) -> Scalar | None:
    found = ctx.elaborate(ctx, scope, node.value, False)
    if isinstance(found, Poison):
        return None
    if isinstance(found, Scalar) and found.kind != "Boolean":
        return found
    hint = "take a component: `.x`, or `v*v`" if isinstance(found, Vector | Array) else None
    ctx.sink.report("E0312", node.value.span, expected="a scalar that stays constant", found=kind_of(found), help=hint)
    return None
