"""Selects the model of a file: by name, else the last non-partial one that nothing else in the file uses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.language.semantics.classes.library import item_head
from lagdsl.language.semantics.classes.packages import Library
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.imports import check_imports, declare_imports
from lagdsl.language.semantics.scope.scope import ClassSymbol, FunctionSymbol, Scope, TypeSymbol
from lagdsl.language.semantics.types.declarations import declared, enter
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

MODELS = ("model", "block")


def file_scope(ctx: Context, unit: nodes.Unit) -> Scope:
    """The names a file declares at its top level; packages hold theirs in a scope of their own."""
    library = Library(
        ctx.sink,
        lambda scope, node: _fill(ctx, scope, node),
        lambda scope, items: declare_imports(ctx.sink, scope, items),
    )
    scope = Scope("file", "this file")
    library.place(scope, unit)
    _declare_all(ctx, scope, unit.items)
    check_imports(scope)
    if unit.within is not None and scope.parent is not None:
        for name, entry in scope.entries.items():
            scope.parent.entries.setdefault(name, entry)  # the package knows this text of the class, not another one
    return scope


def _fill(ctx: Context, scope: Scope, package: nodes.Class) -> None:
    """Declare what a package holds; a name that stands in a file, too, is E0259."""
    _declare_all(ctx, scope, [*package.items, *(item for section in package.sections for item in section.items)])
    files = set(scope.outside.files.names()) if scope.outside.files is not None else set()
    for item in package.items:
        name = getattr(item, "name", None)
        if isinstance(name, str) and name in files:
            ctx.sink.report("E0259", item_head(item), name=name)


def _declare_all(ctx: Context, scope: Scope, items: Sequence[nodes.Item]) -> None:
    """Classes, types and imports before constants, which need them, so that the order in the text is free."""
    declare_imports(ctx.sink, scope, items)
    for item in items:
        if not isinstance(item, nodes.Component):
            _declare(ctx, scope, item)
    for item in items:
        if isinstance(item, nodes.Component):
            _declare(ctx, scope, item)


def _declare(ctx: Context, scope: Scope, item: nodes.Item) -> None:
    match item:
        case nodes.Class():
            symbol = ClassSymbol(item, scope)
            if enter(ctx, scope, item.name, symbol, item.name_span) and item.kind == "package":
                name = f"{scope.prefix}{item.name}"
                symbol.inner = Scope("file", f"package `{name}`", scope, f"{name}.")
                _fill(ctx, symbol.inner, item)
        case nodes.ShortClass():
            enter(ctx, scope, item.name, ClassSymbol(item, scope), item.span)
        case nodes.TypeDefinition():
            enter(ctx, scope, item.name, TypeSymbol(item, scope), item.span)
        case nodes.Function():
            enter(ctx, scope, item.name, FunctionSymbol(item, scope), item.span)
        case nodes.Import() | nodes.Annotation():
            pass
        case nodes.Component() if "constant" in item.prefixes:
            declared(ctx, scope, item)
        case nodes.Declaration() | nodes.Physics() | nodes.Relation() | nodes.Block() | nodes.Extends():
            hint = "packages hold classes, types, constants and functions"
            ctx.sink.report("E0311", item.span, what="this item in a package", hint=hint)
        case _:
            assert_never(item)


def select(ctx: Context, unit: nodes.Unit, scope: Scope, name: str | None) -> ClassSymbol | None:
    """The class to flatten, or None after E0217 or E0218."""
    models = {path: symbol for path, symbol in _classes(scope, "") if _is_model(symbol)}
    if name is not None:
        if name in models:
            return models[name]
        hint = did_you_mean(name, models, f"the file has {listing(name, models, '`{}`')}")
        ctx.sink.report("E0217", None, name=name, help=hint if models else None)
        return None
    used = _used(unit)
    complete = [symbol for symbol in models.values() if "partial" not in symbol.node.prefixes]
    free = [symbol for symbol in complete if symbol.node.name not in used]
    if free or complete:
        return (free or complete)[-1]
    first = next((item for item in unit.items if not isinstance(item, nodes.Import)), unit.items[0])
    ctx.sink.report("E0218", item_head(first), help=_way_to_a_model(first))
    return None


def _way_to_a_model(item: nodes.Item) -> str | None:
    if not isinstance(item, nodes.Class):
        return None
    if item.kind == "package":
        return "a package is checked where a model uses it: check that model"
    if "partial" in item.prefixes:
        return f"`{item.name}` is partial: a model that extends it can be checked"
    return f"a {item.kind} is checked where a model uses it: check that model"


def complete_models(unit: nodes.Unit) -> tuple[str, ...]:
    """Names of the file's top-level models that are not partial and that nothing else uses; the default one is last."""
    used = _used(unit)
    return tuple(
        item.name
        for item in unit.items
        if isinstance(item, nodes.Class)
        and item.kind in MODELS
        and "partial" not in item.prefixes
        and item.name not in used
    )


def _classes(scope: Scope, prefix: str) -> Iterator[tuple[str, ClassSymbol]]:
    for name, entry in scope.entries.items():
        if isinstance(entry, ClassSymbol):
            yield prefix + name, entry
            if entry.inner is not None:
                yield from _classes(entry.inner, f"{prefix}{name}.")


def _is_model(symbol: ClassSymbol) -> bool:
    return symbol.node.kind in MODELS


def _used(unit: nodes.Unit) -> set[str]:
    """Names of classes that stand as types, bases or short definitions anywhere in the file."""
    used: set[str] = set()
    for item in unit.items:
        for node in descendants(item):
            if isinstance(node, nodes.Component | nodes.RedeclareComponent | nodes.RedeclareClass):
                used.add(".".join(node.type_name.parts))
            if isinstance(node, nodes.Extends | nodes.ShortClass):
                used.add(".".join(node.base.parts))
    return used


def functions_of(scope: Scope) -> Iterator[FunctionSymbol]:
    """The functions of a file, those of its packages included."""
    for entry in scope.entries.values():
        if isinstance(entry, FunctionSymbol):
            yield entry
        elif isinstance(entry, ClassSymbol) and entry.inner is not None:
            yield from functions_of(entry.inner)
