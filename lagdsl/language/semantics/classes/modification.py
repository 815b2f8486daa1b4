"""Modifiers from outside: `Arm a(l = 2 m, q(start = 10 deg));`, `model S = Arm(l = 2 m);`, `extends Arm(l = 2 m);`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field, replace
from typing import TypeAlias

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.record import mutable_record
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import without_each
from lagdsl.language.semantics.scope.scope import (
    Binding,
    ClassSymbol,
    Entry,
    Instance,
    InstanceArray,
    Scope,
    Symbol,
    bindings_of,
)
from lagdsl.language.semantics.types.prefixes import check_modifier
from lagdsl.language.syntax import nodes

Given: TypeAlias = "tuple[nodes.AnyModifier, Scope]"

_REBOUND = ("parameter", "structural", "input", "algebraic", "output", "point", "frame", "coordinate")


@mutable_record()
class Changes:
    """Modifiers of one instance by the name they go to, the innermost first: outer ones win."""

    by_name: dict[str, list[Given]] = field(default_factory=dict)

    def add(self, given: Iterable[Given]) -> None:
        for modifier, scope in given:
            self.by_name.setdefault(target(modifier), []).append((_unfolded(modifier), scope))

    def take(self, name: str) -> list[Given]:
        """The modifiers of `name`, which is thereby known."""
        return self.by_name.pop(name, [])


def target(modifier: nodes.AnyModifier) -> str:
    """The name of the class that the modifier goes to: `q` of `q.start = 1`."""
    return modifier.name.parts[0] if isinstance(modifier, nodes.Modifier) else modifier.name


def _unfolded(modifier: nodes.AnyModifier) -> nodes.AnyModifier:
    """`a.b = 1` as `a(b = 1)`."""
    if not isinstance(modifier, nodes.Modifier) or len(modifier.name.parts) == 1:
        return modifier
    first, rest = modifier.name.parts[:1], modifier.name.parts[1:]
    own = tuple(prefix for prefix in modifier.prefixes if prefix != "each")
    inner = replace(modifier, name=replace(modifier.name, parts=rest), prefixes=own)
    outer = tuple(prefix for prefix in modifier.prefixes if prefix == "each")
    name = replace(modifier.name, parts=first)
    return nodes.Modifier(
        span=modifier.span, prefixes=outer, name=name, subscripts=(), modifiers=(_unfolded(inner),), value=None
    )


def check_duplicates(ctx: Context, modifiers: Iterable[nodes.AnyModifier]) -> None:
    """E0212 where one list says two things about the same."""
    whole: dict[str, Span] = {}
    values: list[tuple[Place, Span]] = []
    for modifier in modifiers:
        check_modifier(ctx, modifier)
        name = ".".join(modifier.name.parts) if isinstance(modifier, nodes.Modifier) else modifier.name
        plain = not isinstance(modifier, nodes.Modifier) or not modifier.subscripts
        if plain and name in whole:
            ctx.sink.report("E0212", modifier.span, Label(whole[name], "given here first"), name=name)
            continue
        for place, span in _valued(modifier, ()):
            first = next((known for other, known in values if _meet(place, other)), None)
            if first is not None:
                ctx.sink.report("E0212", span, Label(first, "given here first"), name=place[-1][0])
            values.append((place, span))
        if plain:
            whole[name] = modifier.span


# Target of a modifier: the names on the way, each with its subscripts as written.
Place: TypeAlias = "tuple[tuple[str, str], ...]"


def _valued(modifier: nodes.AnyModifier, around: Place) -> Iterator[tuple[Place, Span]]:
    if not isinstance(modifier, nodes.Modifier):
        for nested in modifier.modifiers:
            yield from _valued(nested, (*around, (modifier.name, "")))
        return
    subscripts = ",".join(subscript.span.text for subscript in modifier.subscripts)
    names = modifier.name.parts
    place = (*around, *((name, "") for name in names[:-1]), (names[-1], subscripts))
    if modifier.value is not None:
        yield place, modifier.span
    for nested in modifier.modifiers:
        yield from _valued(nested, place)


def _meet(one: Place, two: Place) -> bool:
    """True if two places may be the same: no subscripts stand for all elements."""
    return len(one) == len(two) and all(
        name == other and (at == there or not at or not there)
        for (name, at), (other, there) in zip(one, two, strict=True)
    )


def modify(ctx: Context, symbol: Symbol, given: Iterable[Given]) -> None:
    """Apply the modifiers of one quantity, point or frame, before anything is evaluated."""
    for modifier, outer in given:
        if not isinstance(modifier, nodes.Modifier):
            ctx.sink.report("E0240", modifier.span, Label(symbol.span, "declared here"), what="a quantity")
            continue
        if modifier.subscripts:
            label = Label(symbol.span, "declared here")
            ctx.sink.report("E0241", modifier.span, label, name=symbol.short)
            continue
        if symbol.given.sealed is not None:
            label = Label(symbol.given.sealed, "given as `final` here")
            ctx.sink.report("E0224", modifier.span, label, name=symbol.short)
            continue
        if "each" in modifier.prefixes and not _is_array(symbol):
            ctx.sink.report("E0344", modifier.span, edit=without_each(modifier.span), what=f"`{symbol.short}`")
        if modifier.modifiers:
            symbol.given.overrides.append((modifier.modifiers, outer))
        if modifier.value is not None:
            _rebind(ctx, symbol, modifier, modifier.value, outer)
        if "final" in modifier.prefixes:
            symbol.given.sealed = modifier.name.span
            symbol.given.final = True


def _is_array(symbol: Symbol) -> bool:
    declared = symbol.declarator is not None and bool(symbol.declarator.subscripts)
    return declared or (symbol.info is not None and bool(symbol.info.shape))


def _rebind(ctx: Context, symbol: Symbol, modifier: nodes.Modifier, value: nodes.Expression, outer: Scope) -> None:
    if symbol.kind == "unknown":
        return
    if (symbol.given.final and symbol.given.sealed is None) or symbol.kind not in _REBOUND:
        label = Label(symbol.span, f"declared as {symbol.title}")
        ctx.sink.report("E0224", modifier.span, label, name=symbol.short)
        return
    binding = Binding(value, outer, modifier.span)
    symbol.given.bindings = bindings_of(symbol.kind, binding, array=_is_array(symbol))


def report_unknown(ctx: Context, changes: Changes, instance: Instance) -> None:
    """E0223 for modifiers of what the class does not have."""
    entries = instance.scope.entries.items()
    known = [name for name, entry in entries if _is_modifiable(entry) and name not in instance.protected]
    for name, given in changes.by_name.items():
        instance.misfit = True
        for modifier, _ in given:
            report_no_such(ctx, modifier, name, instance.definition.node, known)


def report_no_such(
    ctx: Context, modifier: nodes.AnyModifier, name: str, node: nodes.Class | nodes.ShortClass, known: list[str]
) -> None:
    """E0223 for a modifier of `name`, which the class does not have; `known` are the names that it has."""
    hint = did_you_mean(name, known, f"it has {listing(name, known, '`{}`')}" if known else None)
    span = modifier.name.span if isinstance(modifier, nodes.Modifier) else modifier.span
    place = node.name_span if isinstance(node, nodes.Class) else node.span
    label = Label(place, f"`{node.name}` is declared here")
    ctx.sink.report("E0223", span, label, name=name, model=f"`{node.name}`", help=hint)


def _is_modifiable(entry: Entry) -> bool:
    if isinstance(entry, Symbol):
        return entry.declarator is not None
    return isinstance(entry, Instance | InstanceArray | ClassSymbol)
