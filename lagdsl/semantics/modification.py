"""Modifiers from outside: `model S = Pendulum(l = 2 m, theta(start = 10 deg));`."""

from __future__ import annotations

from lagdsl.diagnostics import Label
from lagdsl.diagnostics.suggest import nearest
from lagdsl.semantics.context import Context
from lagdsl.semantics.scope import Binding, ClassSymbol, Scope, Symbol, lookup
from lagdsl.syntax import nodes

_REBOUND = ("parameter", "structural", "input", "algebraic", "output")


def expand_short(ctx: Context, symbol: ClassSymbol) -> tuple[nodes.Class, list[tuple[nodes.Modifier, Scope]]] | None:
    """The class behind a short definition and the modifiers on the way, outermost last; None after a diagnostic."""
    found: list[tuple[nodes.Modifier, Scope]] = []
    seen: list[str] = []
    while isinstance(symbol.node, nodes.ShortClass):
        node = symbol.node
        if node.subscripts:
            ctx.sink.report("E0311", node.span, what="an array of models", hint="arrays of components come later")
            return None
        if node.name in seen:
            ctx.sink.report("E0305", node.span, path=f"model `{node.name}` is defined by itself")
            return None
        seen.append(node.name)
        given: set[str] = set()
        for modifier in node.modifiers:
            name = ".".join(modifier.name.parts) if isinstance(modifier, nodes.Modifier) else modifier.name
            if name in given:
                ctx.sink.report("E0212", modifier.span, name=name)
            given.add(name)
            if isinstance(modifier, nodes.Modifier):
                found.insert(0, (modifier, symbol.scope))
            else:
                ctx.sink.report("E0311", modifier.span, what="`redeclare`", hint="it comes with components")
        base = lookup(symbol.scope, node.base.parts[0])
        if not isinstance(base, ClassSymbol) or len(node.base.parts) > 1:
            ctx.sink.report("E0208", node.base.span, name=".".join(node.base.parts), help=None)
            return None
        symbol = base
    return symbol.node, found


def modify(ctx: Context, scope: Scope, modifiers: list[tuple[nodes.Modifier, Scope]]) -> None:
    """Apply modifiers to the symbols of a class before anything is evaluated; later ones win."""
    for modifier, outer in modifiers:
        name = ".".join(modifier.name.parts)
        symbol = scope.entries.get(name)
        if not isinstance(symbol, Symbol) or symbol.declarator is None:
            names = [known for known, entry in scope.entries.items() if isinstance(entry, Symbol) and entry.declarator]
            meant = nearest(name, names)
            hint = f"did you mean `{meant}`?" if meant else None
            ctx.sink.report("E0223", modifier.name.span, name=name, model=scope.title, help=hint)
            continue
        for nested in modifier.modifiers:
            if isinstance(nested, nodes.Modifier):
                symbol.overrides.append((nested, outer))
        if modifier.value is None:
            continue
        if symbol.final or symbol.kind not in _REBOUND:
            label = Label(symbol.span, f"declared as {symbol.title}")
            ctx.sink.report("E0224", modifier.span, label, name=name)
            continue
        symbol.bindings = {None: Binding(modifier.value, outer, modifier.span)}
