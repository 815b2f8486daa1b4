"""Names with dots and subscripts: `Lag.Planar`, `arm.q`, `wheel[2].spin`."""

from __future__ import annotations

from typing import assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.operators import arrays
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import (
    ClassSymbol,
    Entry,
    FunctionSymbol,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    TypeSymbol,
    lookup,
)
from lagdsl.language.semantics.scope.values import POISON, AnyValue, Component, Poison
from lagdsl.language.syntax import nodes


def designated(ctx: Context, scope: Scope, node: nodes.Expression) -> Entry | None:
    """The symbol, component or class that `node` names; poison after a diagnostic, None where it is no such name.

    `arm.q`, `wheel[2]`, `wheel[2].hub.frame_a`; subscripts of quantities are not part of the name.
    """
    match node:
        case nodes.Reference():
            return lookup(scope, node.name, node.span)
        case nodes.Member():
            return _member(ctx, node, designated(ctx, scope, node.target))
        case nodes.Index():
            target = designated(ctx, scope, node.target)
            return _indexed(ctx, scope, node, target) if isinstance(target, InstanceArray | Poison) else None
        case nodes.Literal() | nodes.Compound() | nodes.Parenthesized():
            return None
        case _:
            assert_never(node)


def _member(ctx: Context, node: nodes.Member, target: Entry | None) -> Entry | None:
    match target:
        case Poison():
            return POISON
        case Component(instance=Instance() as inner) | (Instance() as inner):
            return member_of(ctx, inner, node.name, node.name_span)
        case InstanceArray():
            hint = f"say of which one: `{node.target.span.text}[1].{node.name}`"
            what = f"`{node.target.span.text}`"
            ctx.sink.report("E0228", node.name_span, Label(target.span, "declared here"), what=what, help=hint)
            return POISON
        case ClassSymbol() if target.inner is not None:
            return target.inner.find(node.name, node.span)
        case Symbol() | FunctionSymbol() | TypeSymbol() | ClassSymbol() | AnyValue() | None:
            return None
        case _:
            assert_never(target)


def member_of(ctx: Context, instance: Instance, name: str, span: Span) -> Entry:
    """The entry of a component; poison after E0210 (no such name), E0229 (protected), E0230 (not there)."""
    short = instance.name.rpartition(".")[2]
    entry = instance.scope.entries.get(name)
    if not instance.present:
        ctx.sink.report("E0230", span, Label(instance.span, "declared here"), name=instance.name)
        return POISON
    if entry is None:
        names = [known for known in instance.scope.entries if known not in instance.protected]
        listed = f"it has {listing(name, names, '`.{}`')}" if names else None
        hint = did_you_mean(name, names, listed, mark=".")
        label = Label(instance.span, f"a component of class {instance.scope.title}")
        ctx.sink.report("E0210", span, label, name=name, what=f"`{short}`", help=hint)
        return POISON
    if name in instance.protected:
        place = entry.span if isinstance(entry, Symbol | Instance | InstanceArray) else None
        labels = (Label(place, "declared here"),) if place is not None else ()
        ctx.sink.report("E0229", span, *labels, name=name, what=instance.scope.title)
        return POISON
    return entry


def _indexed(ctx: Context, scope: Scope, node: nodes.Index, target: InstanceArray | Poison) -> Entry:
    if isinstance(target, Poison):
        return POISON
    found = arrays.subscript_indices(ctx, scope, node.subscripts, target.shape, node)
    if found is None:
        return POISON
    indices = tuple(index for index in found if isinstance(index, int))
    if len(indices) < len(target.shape):
        if len(indices) < len(found):
            ctx.sink.report("E0312", node.span, expected="one component", found="several")
        else:
            ctx.sink.report("E0341", node.span, index=len(found), extent=len(target.shape))
        return POISON
    return target.elements.get(indices, POISON)
