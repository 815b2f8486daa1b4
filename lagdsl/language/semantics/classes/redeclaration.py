"""`redeclare`: another class in the place of one, and whether it has what is used of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.classes.array_modifiers import Said
from lagdsl.language.semantics.classes.inheritance import Part, body_of, class_at, names_in, steps_to
from lagdsl.language.semantics.classes.modification import Given, target
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import without_each
from lagdsl.language.semantics.scope.scope import ClassSymbol, Scope
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_MOST_SHOWN = 3


def replaced(
    ctx: Context, part: Part, declarator: nodes.Declarator, symbol: ClassSymbol, outer: list[Given], given: list[Said]
) -> ClassSymbol:
    """The class of a component, which the modifiers `outer` may redeclare; what else they say is added to `given`."""
    assert isinstance(part.item, nodes.Component)
    many = bool(declarator.subscripts) or is_sized(ctx, symbol)
    sealed: Span | None = None
    label = Label(declarator.name_span, "declared here")
    for modifier, scope in outer:
        if sealed is not None or "final" in part.item.prefixes:
            place = Label(sealed, "given as `final` here") if sealed is not None else label
            ctx.sink.report("E0224", modifier.span, place, name=declarator.name)
            continue
        match modifier:
            case nodes.Modifier():
                if modifier.value is not None:
                    ctx.sink.report("E0227", modifier.value.span, label, name=declarator.name)
                if "each" in modifier.prefixes and not many:
                    edit = without_each(modifier.span)
                    ctx.sink.report("E0344", modifier.span, label, edit=edit, what=f"component `{declarator.name}`")
                nested = _for_each(modifier) if many else modifier.modifiers
                given += [(modifier.subscripts, inner, scope) for inner in nested]
                sealed = modifier.span if "final" in modifier.prefixes else None
            case nodes.RedeclareClass():
                hint = f"write `redeclare {modifier.type_name.span.text} {declarator.name}`"
                ctx.sink.report("E0236", modifier.span, label, name=declarator.name, help=hint)
            case nodes.RedeclareComponent() if "replaceable" not in part.item.prefixes:
                ctx.sink.report("E0235", modifier.span, label, name=declarator.name, kind="component")
            case nodes.RedeclareComponent():
                symbol = _redeclared(ctx, scope, modifier, symbol, label)
                given += [((), nested, scope) for nested in modifier.modifiers]
    return symbol


def is_sized(ctx: Context, symbol: ClassSymbol) -> bool:
    """True if the class stands for several components: `model Wheels = Wheel[4];`."""
    found = steps_to(ctx, symbol)
    return found is not None and any(node.subscripts for node, _ in found[1])


def _for_each(modifier: nodes.Modifier) -> tuple[nodes.AnyModifier, ...]:
    """Distributes `each` over an array: `each wheel(m = 2 kg)` becomes `wheel(each m = 2 kg)`."""
    if "each" not in modifier.prefixes:
        return modifier.modifiers
    return tuple(
        replace(inner, prefixes=("each", *inner.prefixes))
        if isinstance(inner, nodes.Modifier) and "each" not in inner.prefixes
        else inner
        for inner in modifier.modifiers
    )


def _redeclared(
    ctx: Context, scope: Scope, modifier: nodes.RedeclareComponent, symbol: ClassSymbol, label: Label
) -> ClassSymbol:
    if modifier.subscripts:
        ctx.sink.report("E0242", modifier.subscripts[0].span, label, name=modifier.name)
    found = class_at(ctx, scope, modifier.type_name)
    if found is None:
        return symbol
    return ClassSymbol(found.node, found.scope, instead=(modifier.span, symbol.node.name))


def stands_in(ctx: Context, symbol: ClassSymbol, declarator: nodes.Declarator, parts: list[Part]) -> bool:
    """True if a class put in by `redeclare` has what the class around says of the component; else E0244.

    `parts` are those of the class around. The uses of the members check these.
    """
    redeclared = _last_redeclared(ctx, symbol)
    expanded = steps_to(ctx, symbol)
    if redeclared is None or redeclared.instead is None or expanded is None:
        return True
    if is_sized(ctx, symbol):
        label = Label(declarator.name_span, "declared here")
        hint = f"put in a class of one component; `{redeclared.node.name}` stands for several"
        ctx.sink.report("E0242", redeclared.instead[0], label, name=declarator.name, help=hint)
        return False
    names = _public(ctx, expanded[0])
    missing: dict[str, Span] = {}
    for name, span in _used(declarator, parts):
        if name not in names:
            missing.setdefault(name, span)
    if not missing:
        return True
    place, old = redeclared.instead
    labels = [Label(span, f"`{name}` is used here") for name, span in missing.items()]
    shown = " and no ".join(f"`{name}`" for name in missing)
    hint = f"give `{expanded[0].node.name}` what is used of `{declarator.name}`, or put in another class"
    ctx.sink.report("E0244", place, *labels[:_MOST_SHOWN], new=expanded[0].node.name, old=old, missing=shown, help=hint)
    return False


def _last_redeclared(ctx: Context, symbol: ClassSymbol) -> ClassSymbol | None:
    """The outermost redeclaration on the way to the class behind the short ones."""
    found: ClassSymbol | None = None
    step: ClassSymbol | None = symbol
    seen: list[nodes.Class | nodes.ShortClass] = []
    while step is not None and all(step.node is not other for other in seen):
        found = step if step.instead is not None else found
        seen.append(step.node)
        step = class_at(ctx, step.scope, step.node.base) if isinstance(step.node, nodes.ShortClass) else None
    return found


def _public(ctx: Context, symbol: ClassSymbol) -> set[str]:
    """The names that a component of the class shows, inherited ones and labels included."""
    assert isinstance(symbol.node, nodes.Class)
    body = body_of(ctx, symbol.node, Scope("class", f"`{symbol.node.name}`", symbol.scope, text=symbol.node.span), [])
    items = [part.item for part in body.parts if not part.protected]
    labels = (getattr(node, "label", None) for item in items for node in descendants(item))
    return {*names_in(items), *(label for label in labels if label is not None)}


def _used(declarator: nodes.Declarator, parts: list[Part]) -> Iterator[tuple[str, Span]]:
    """The members of a component that its declaration modifies or the text around reads."""
    for modifier in declarator.modifiers:
        yield target(modifier), modifier.name.span if isinstance(modifier, nodes.Modifier) else modifier.span
    for part in parts:
        if isinstance(part.item, nodes.Class | nodes.Function):
            continue
        for node in descendants(part.item):
            if isinstance(node, nodes.Member):
                inner = node.target.target if isinstance(node.target, nodes.Index) else node.target
                if isinstance(inner, nodes.Reference) and inner.name == declarator.name:
                    yield node.name, node.name_span
