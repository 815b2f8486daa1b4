"""Equations give definitions: `y = e` and `der(x) = e`, with either side first."""

from __future__ import annotations

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.diagnostics.catalog.habits import OF_MOTION, constraint_help, value_help
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.constants import structural_integer
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Binding, Indices, Scope, Symbol, is_guess, lookup
from lagdsl.language.semantics.scope.values import Poison
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_DEFINED = ("algebraic", "output", "point", "frame")


def attach(ctx: Context, scope: Scope, item: nodes.Equation) -> None:
    """Give the equation to the variable or state it defines, or report that it defines none."""
    sides = ((item.left, item.right), (item.right, item.left))
    for side, other in sides:
        target = derivative_of(side)
        symbol = _symbol(ctx, scope, target) if target is not None else None
        if target is not None and symbol is not None and symbol.kind == "state":
            _bind(ctx, scope, symbol, target, Binding(other, scope, side.span), derivative=True)
            return
    defined = [(side, other, symbol) for side, other in sides if (symbol := _symbol(ctx, scope, side)) is not None]
    fitting = [entry for entry in defined if entry[2].kind in _DEFINED or _is_port(entry[2])]
    free = [entry for entry in fitting if not entry[2].given.bindings or isinstance(entry[0], nodes.Index)]
    for side, other, symbol in free[:1] or fitting[:1]:
        if _is_port(symbol) and all(binding.scope is symbol.scope for binding in symbol.given.bindings.values()):
            symbol.given.bindings.clear()  # the equation stands in the place of the default
        _bind(ctx, scope, symbol, side, Binding(other, scope, item.span), derivative=False)
        return
    _report(ctx, scope, item, defined[0][2] if defined else None)


def _is_port(symbol: Symbol) -> bool:
    return symbol.kind == "input" and bool(symbol.scope.spans)


def derivative_of(node: nodes.Node) -> nodes.Expression | None:
    """The x of `der(x)`."""
    if not (isinstance(node, nodes.Call) and isinstance(node.function, nodes.Reference)):
        return None
    if node.function.name != "der" or len(node.arguments) != 1:
        return None
    (argument,) = node.arguments
    return None if isinstance(argument, nodes.Named) else argument


def _symbol(ctx: Context, scope: Scope, node: nodes.Expression) -> Symbol | None:
    target = node.target if isinstance(node, nodes.Index) else node
    entry = designated(ctx, scope, target) if isinstance(target, nodes.Reference | nodes.Member) else None
    return entry if isinstance(entry, Symbol) else None


def _report(ctx: Context, scope: Scope, item: nodes.Equation, symbol: Symbol | None) -> None:
    target = derivative_of(item.left) or derivative_of(item.right)
    found = _symbol(ctx, scope, target) if target is not None else None
    unknown = _undeclared(scope, item.left) or _undeclared(scope, item.right)
    if found is not None and unknown is not None:
        assert target is not None
        way = f"declare it with its type: `Real {unknown.name} = {_other(item, unknown).span.text};`"
        ctx.sink.report("E0201", unknown.span, name=unknown.name, scope=scope.title, help=way)
        return
    if target is not None and found is not None and found.kind != "unknown":
        ctx.sink.report("E0321", target.span, Label(found.span, f"{found.title}"), name=found.short, kind=found.title)
        if found.kind in _DEFINED and not found.given.bindings:
            found.kind = "unknown"
        return
    if symbol is not None and symbol.kind == "unknown":
        return
    for node in (*descendants(item.left), *descendants(item.right)):
        unsolved = _symbol(ctx, scope, node) if isinstance(node, nodes.Reference) else None
        rate = derivative_of(node)
        state = _symbol(ctx, scope, rate) if rate is not None else None
        if state is not None and state.kind == "state" and not state.given.derivatives:
            state.kind = "unknown"
        if unsolved is not None and unsolved.kind in _DEFINED and not unsolved.given.bindings:
            # It was meant to get its value here: nothing more is said about it.
            unsolved.kind = "unknown"
    hint = None
    if _acceleration(ctx, scope, item):
        hint = OF_MOTION
    elif symbol is not None and symbol.kind == "coordinate":
        hint = constraint_help(item.span.text)
    elif symbol is not None and symbol.kind == "discrete":
        hint = f"`{symbol.short}` changes at events: write the equation in a `when` clause"
    elif symbol is not None and symbol.kind in ("parameter", "constant", "structural"):
        hint = value_help(symbol.short)
    ctx.sink.report("E0322", item.span, help=hint)


def _undeclared(scope: Scope, side: nodes.Expression) -> nodes.Reference | None:
    """The side if it is a name that nothing declares."""
    unknown = isinstance(side, nodes.Reference) and lookup(scope, side.name) is None and not is_guess(scope)
    return side if unknown and isinstance(side, nodes.Reference) else None


def _other(item: nodes.Equation, side: nodes.Expression) -> nodes.Expression:
    return item.right if side is item.left else item.left


def _acceleration(ctx: Context, scope: Scope, item: nodes.Equation) -> bool:
    """True if the second derivative of a coordinate occurs: an equation of motion, written by hand."""
    for node in (*descendants(item.left), *descendants(item.right)):
        rate = derivative_of(node)
        inner = derivative_of(rate) if rate is not None else None
        symbol = _symbol(ctx, scope, inner) if inner is not None else None
        if symbol is not None and symbol.kind == "coordinate":
            return True
    return False


def _bind(
    ctx: Context, scope: Scope, symbol: Symbol, side: nodes.Expression, binding: Binding, *, derivative: bool
) -> None:
    indices: Indices | None = None
    if isinstance(side, nodes.Index):
        indices = element_indices(ctx, scope, symbol, side.subscripts, side.span)
        if indices is None:
            if any(_is_unknown(ctx, scope, subscript) for subscript in side.subscripts):
                symbol.kind = "unknown"  # which element was meant to get its value here nobody knows
            return
    bind(ctx, symbol, indices, binding, derivative=derivative)


def _is_unknown(ctx: Context, scope: Scope, subscript: nodes.Subscript) -> bool:
    if isinstance(subscript, nodes.All | nodes.Range):
        return False
    return isinstance(ctx.elaborate(ctx, scope, subscript, False), Poison)


def bind(ctx: Context, symbol: Symbol, indices: Indices | None, binding: Binding, *, derivative: bool = False) -> None:
    """Record what gives the element (indices None: the whole) its value; E0319 where something did already."""
    if symbol.kind in ("point", "frame") and indices is None and not _subscripted(symbol):
        indices = ()
    table = symbol.given.derivatives if derivative else symbol.given.bindings
    taken = table.get(indices) or table.get(None) or (next(iter(table.values()), None) if indices is None else None)
    taken = taken or _overlapping(table, indices or (), len(symbol.made.shape or ()))
    if taken is not None:
        name = element_name(symbol.short, indices or ())
        shown = f"der({name})" if derivative else name
        ctx.sink.report("E0319", binding.span, Label(taken.span, "defined here first"), name=shown)
        return
    table[indices] = binding


def _overlapping(table: dict[Indices | None, Binding], indices: Indices, rank: int) -> Binding | None:
    """The equation that defines a row with the element in it, or an element of the row."""
    around = next((table[indices[:n]] for n in range(1, len(indices)) if indices[:n] in table), None)
    if around is not None or not 0 < len(indices) < rank:
        return around
    return next((each for key, each in table.items() if key is not None and key[: len(indices)] == indices), None)


def _subscripted(symbol: Symbol) -> bool:
    return symbol.declarator is not None and bool(symbol.declarator.subscripts)


def element_indices(
    ctx: Context, scope: Scope, symbol: Symbol, subscripts: tuple[nodes.Subscript, ...], span: Span
) -> Indices | None:
    """The indices of one element, or the leading ones of a row, that is being defined; None after a diagnostic."""
    shape = ctx.resolver.shape(ctx, symbol)
    if shape is None:
        return None
    rows = symbol.kind in ("algebraic", "output")
    while rows and len(subscripts) > 1 and len(subscripts) <= len(shape) and isinstance(subscripts[-1], nodes.All):
        subscripts = subscripts[:-1]
    found: list[int] = []
    for subscript in subscripts:
        if isinstance(subscript, nodes.All | nodes.Range):
            ctx.sink.report("E0312", subscript.span, expected="one index", found="a range")
            return None
        number = structural_integer(ctx, ctx.elaborate(ctx, scope, subscript, False), subscript, "E0333")
        if number is None:
            return None
        found.append(number)
    for index, extent in zip(found, shape, strict=False):
        if not 1 <= index <= extent:
            ctx.sink.report("E0316", span, index=index, extent=extent)
            return None
    if len(found) > len(shape) or (len(found) < len(shape) and not rows):
        ctx.sink.report("E0341", span, index=len(found), extent=len(shape))
        return None
    return tuple(found)
