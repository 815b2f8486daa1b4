"""Arguments of functions that take them as they are written: by position, by name, names of things."""

from __future__ import annotations

from typing import Literal, TypeAlias

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog.habits import count_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.language.semantics.operators.arrays import subscript_indices
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import arguments_text, kind_of, name_span
from lagdsl.language.semantics.scope.scope import Indices, Scope, Symbol
from lagdsl.language.semantics.scope.values import Poison
from lagdsl.language.syntax import nodes


def positional(
    ctx: Context, node: nodes.Call, least: int, most: int, keywords: tuple[str, ...] = ()
) -> list[nodes.Expression] | None:
    """The positional arguments, or None after E0315 or E0211."""
    found: list[nodes.Expression] = []
    for argument in node.arguments:
        if not isinstance(argument, nodes.Named):
            found.append(argument)
        elif argument.name not in keywords:
            listed = f"it takes {', '.join(f'`{name} =`' for name in keywords)}" if keywords else None
            hint = did_you_mean(argument.name, keywords, listed)
            ctx.sink.report(
                "E0211", name_span(argument), name=argument.name, function=node.function.span.text, help=hint
            )
            return None
    if not least <= len(found) <= most:
        expected = str(least) if least == most else f"{least} to {most}"
        name = node.function.span.text
        way = count_help(name, tuple(item.span.text for item in found))
        texts = arguments_text(expected)
        ctx.sink.report("E0315", node.span, help=way, function=name, expected=texts, found=len(found))
        return None
    return found


def named(node: nodes.Call, name: str) -> nodes.Expression | None:
    for argument in node.arguments:
        if isinstance(argument, nodes.Named) and argument.name == name:
            return argument.value
    return None


def named_element(ctx: Context, scope: Scope, node: nodes.Expression) -> tuple[Symbol, Indices] | None:
    """The symbol and indices that `name` or `name[i, j]` stands for; None if it is no such thing."""
    target = node.target if isinstance(node, nodes.Index) else node
    symbol = designated(ctx, scope, target)
    if not isinstance(symbol, Symbol):
        return None
    if not isinstance(node, nodes.Index):
        return symbol, ()
    shape = ctx.resolver.shape(ctx, symbol)
    found = subscript_indices(ctx, scope, node.subscripts, shape, node) if shape is not None else None
    if found is None or not all(isinstance(index, int) for index in found):
        return None
    symbol.made.used = True
    return symbol, tuple(index for index in found if isinstance(index, int))


Labelled: TypeAlias = Literal["constraint", "body", "contact", "friction"]


def labelled_one(ctx: Context, scope: Scope, node: nodes.Expression, *kinds: Labelled) -> tuple[Symbol, Indices] | None:
    """The label of one thing of one of `kinds`: a label in a loop needs its indices."""
    found = labelled(ctx, scope, node, *kinds)
    return found if found is not None and is_one(ctx, node, *found) else None


def is_one(ctx: Context, node: nodes.Expression, symbol: Symbol, indices: Indices) -> bool:
    """True if `node` names one of the things of this label; False after E0312."""
    if indices in symbol.made.labels or not symbol.made.labels:
        return True
    hint = f"write `{symbol.short}[{', '.join('1' for _ in next(iter(symbol.made.labels)))}]`"
    what = f"all of `{symbol.short}`"
    ctx.sink.report("E0312", node.span, expected=f"one {symbol.kind}", found=what, help=hint)
    return False


def labelled(ctx: Context, scope: Scope, node: nodes.Expression, *kinds: Labelled) -> tuple[Symbol, Indices] | None:
    """The label of something of one of `kinds` in an argument; a label in a loop may stand without indices for all."""
    target = node.target if isinstance(node, nodes.Index) else node
    entry = designated(ctx, scope, target) if isinstance(target, nodes.Reference | nodes.Member) else None
    if isinstance(entry, Symbol) and entry.kind in kinds:
        entry.made.used = True
        if not isinstance(node, nodes.Index):
            return entry, ()
        return named_element(ctx, scope, node)
    if isinstance(target, nodes.Reference) and entry is None:
        absent = ctx.reports.absent.get(scope.owner.qualify(target.name))
        if absent is not None:
            ctx.sink.report("E0230", target.span, Label(absent, "declared here"), name=target.name)
            return None
        labels = [
            name
            for step in scope.chain()
            for name, each in step.entries.items()
            if isinstance(each, Symbol) and each.kind in kinds
        ]
        hint = did_you_mean(target.name, labels)
        ctx.sink.report("E0201", target.span, name=target.name, scope=scope.title, help=hint)
        return None
    value = ctx.elaborate(ctx, scope, node, False)
    if isinstance(value, Poison) and not isinstance(entry, Symbol):
        return None
    found = entry.title if isinstance(entry, Symbol) else kind_of(value)
    kind = kinds[0]
    hint = "name the body: `body b(...) on F`" if kind == "body" else f"name the {kind}: `{kind} c: ...`"
    ctx.sink.report("E0312", node.span, expected=f"the name of a {' or '.join(kinds)}", found=found, help=hint)
    return None
