"""Names that are declared or imported and never used."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.imports import imported, package_of, root_of
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_WARNED = {
    "parameter": "parameter",
    "structural": "structural parameter",
    "constant": "constant",
    "input": "input",
    "algebraic": "definition",
    "point": "point",
    "frame": "frame",
    "state": "state",
}


def warn_unused(ctx: Context, symbols: Iterable[Symbol]) -> None:
    """W0206 for each declared name of the model's file that nothing reads in any instance of its class; E0329 instead
    for a parameter that is infinite: it is no bound of anything."""
    own = [symbol for symbol in symbols if symbol.span.file is ctx.conventions.home]
    done = {symbol.span.start for symbol in own if symbol.made.used}
    for symbol in own:
        kind = _WARNED.get(symbol.kind)
        if kind is not None and symbol.span.start not in done and not _is_offered(symbol):
            done.add(symbol.span.start)
            if _is_infinite(ctx, symbol):
                ctx.sink.report("E0329", symbol.span, subject=f"`{symbol.short}`", conditions="")
            else:
                ctx.sink.report("W0206", symbol.span, kind=kind, name=symbol.short)


def _is_infinite(ctx: Context, symbol: Symbol) -> bool:
    """True for a parameter, or an array of them, that has an infinite value."""
    infinite = {parameter.name for parameter in ctx.product.parameters if math.isinf(parameter.value)}
    return symbol.name in infinite or any(name.startswith(f"{symbol.name}[") for name in infinite)


def _is_offered(symbol: Symbol) -> bool:
    """True if a component shows it to the outside: ports, and public variables, points and frames that it defines."""
    instance = symbol.scope.owner.instance
    if instance is None or instance.around is None or symbol.short in instance.protected:
        return False
    given = symbol.declarator is not None and symbol.declarator.value is not None
    return symbol.kind == "frame" or instance.kind == "connector" or (given and symbol.kind in ("algebraic", "point"))


def warn_unused_imports(ctx: Context, scope: Scope, unit: nodes.Unit) -> None:
    """W0257 for each import of a file that no name of the text needs; `scope` is that of the file."""
    for around in _importing(unit):
        used = _names(around)
        for name, target in (
            pair for item in _items(around) if isinstance(item, nodes.Import) for pair in imported(item)
        ):
            if name is None:
                package = package_of(ctx.sink, root_of(scope), target)
                needed = package is None or not used.isdisjoint(package.names())
            else:
                needed = name in used
            if not needed:
                what = "class" if isinstance(around, nodes.Class) else "file"
                text = ".".join(target.parts) + (".*" if name is None else "")
                ctx.sink.report("W0257", target.span, name=text, scope=what)


def _importing(around: nodes.Unit | nodes.Class) -> Iterator[nodes.Unit | nodes.Class]:
    """The file and its classes, of those with imports."""
    if any(isinstance(item, nodes.Import) for item in _items(around)):
        yield around
    for item in _items(around):
        if isinstance(item, nodes.Class):
            yield from _importing(item)


def _items(around: nodes.Unit | nodes.Class) -> list[nodes.Item]:
    sections = around.sections if isinstance(around, nodes.Class) else ()
    return [*around.items, *(item for section in sections for item in section.items)]


def _names(around: nodes.Unit | nodes.Class) -> set[str]:
    """The plain names, and the first parts of dotted ones, that the text reads."""
    used: set[str] = set()
    for item in _items(around):
        for node in descendants(item) if not isinstance(item, nodes.Import) else ():
            if isinstance(node, nodes.Reference):
                used.add(node.name)
            if isinstance(node, nodes.Name):
                used.add(node.parts[0])
    return used
