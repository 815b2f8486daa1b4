"""Frictions by name: `hold`, and `floor.friction` of a contact."""

from __future__ import annotations

from lagdsl.foundation.source import Span
from lagdsl.language.semantics.operators.arguments import labelled_one
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Indices, Scope, Symbol
from lagdsl.language.semantics.scope.values import FrictionValue
from lagdsl.language.syntax import nodes

MEMBER = "friction"
"""Name of the friction under a contact, behind that of the contact."""


def names_friction(ctx: Context, scope: Scope, node: nodes.Expression) -> bool:
    """True for the label of a friction, with indices or not, and for `c.friction` of a contact."""
    return _kind(ctx, scope, node) == "friction" or _contact_before(ctx, scope, node) is not None


def friction_named(ctx: Context, scope: Scope, node: nodes.Expression) -> FrictionValue | None:
    """The friction of that name, or under the contact of that name; None after a diagnostic."""
    around = _contact_before(ctx, scope, node)
    found = labelled_one(ctx, scope, around or node, "friction", "contact")
    return _value(ctx, *found, node.span) if found is not None else None


def _kind(ctx: Context, scope: Scope, node: nodes.Expression) -> str | None:
    target = node.target if isinstance(node, nodes.Index) else node
    symbol = designated(ctx, scope, target) if isinstance(target, nodes.Reference | nodes.Member) else None
    return symbol.kind if isinstance(symbol, Symbol) else None


def _contact_before(ctx: Context, scope: Scope, node: nodes.Expression) -> nodes.Expression | None:
    """`c` of `c.friction`, if it is the label of a contact."""
    if not isinstance(node, nodes.Member) or node.name != MEMBER:
        return None
    return node.target if _kind(ctx, scope, node.target) == "contact" else None


def _value(ctx: Context, symbol: Symbol, indices: Indices, span: Span) -> FrictionValue | None:
    instance = symbol.made.labels.get(indices)
    if instance is None:
        return None
    if isinstance(instance.node, nodes.Contact) and not any(each.name == MEMBER for each in instance.node.options):
        hint = "write `with friction = mu, slip = ...` at the contact"
        found = f"`{symbol.short}`, which has none"
        ctx.sink.report("E0312", span, expected="a contact with friction", found=found, help=hint)
        return None
    return ctx.resolver.friction(ctx, symbol, indices, span)
