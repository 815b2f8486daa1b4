"""Prefixes of declarations: which combinations mean what, and which types they go with."""

from __future__ import annotations

from lagdsl.semantics.scope.context import Context
from lagdsl.semantics.scope.naming import an
from lagdsl.semantics.scope.scope import SymbolKind, TypeInfo
from lagdsl.source import Span
from lagdsl.syntax import nodes

_KINDS: dict[tuple[str, ...], SymbolKind] = {
    (): "algebraic",
    ("parameter",): "parameter",
    ("final", "parameter"): "parameter",
    ("structural", "parameter"): "structural",
    ("final", "structural", "parameter"): "structural",
    ("structural",): "structural",
    ("constant",): "constant",
    ("final", "constant"): "constant",
    ("input",): "input",
    ("output",): "output",
    ("state",): "state",
    ("discrete",): "discrete",
    ("discrete", "output"): "discrete",
    ("output", "discrete"): "discrete",
    ("final",): "algebraic",
    ("final", "output"): "output",
    ("flow",): "algebraic",
}
_LATER = {
    "replaceable": "components and classes are replaceable; a quantity gets another value by a modifier",
    "redeclare": "redeclare in a modifier: `extends Base(redeclare model Part = Other)`",
    "stream": "streams are not part of mechanics",
}


def kind_of_component(ctx: Context, item: nodes.Component) -> SymbolKind | None:
    """Kind of a declaration by its prefixes; None after E0214 or E0311."""
    kind = _KINDS.get(item.prefixes)
    if kind is not None:
        return kind
    span = Span(item.span.file, item.span.start, item.type_name.span.start)
    text = span.text.rstrip()
    span = Span(span.file, span.start, span.start + len(text)) if text else item.type_name.span
    for prefix in item.prefixes:
        if prefix in _LATER:
            ctx.sink.report("E0311", span, what=f"`{prefix}`", hint=_LATER[prefix])
            return None
    ctx.sink.report("E0214", span, prefixes=" ".join(item.prefixes))
    return None


def check_component(ctx: Context, item: nodes.Component) -> None:
    """E0238 for prefixes of quantities at a component of a class."""
    for prefix in item.prefixes:
        if prefix not in ("final", "replaceable"):
            start = item.span.start + item.span.text.find(prefix)
            ctx.sink.report("E0238", Span(item.span.file, start, start + len(prefix)), prefix=prefix)


def check_modifier(ctx: Context, modifier: nodes.AnyModifier) -> None:
    """E0212 for `each each R = 1`, in the modifier or in those inside it."""
    if isinstance(modifier, nodes.Modifier):
        for prefix in sorted({each for each in modifier.prefixes if modifier.prefixes.count(each) > 1}):
            ctx.sink.report("E0212", modifier.span, name=prefix)
    for nested in modifier.modifiers:
        check_modifier(ctx, nested)


def type_fits(ctx: Context, kind: SymbolKind, info: TypeInfo, span: Span) -> bool:
    """Motion is real; texts are parameters."""
    if kind in ("coordinate", "state") and info.base != "Real":
        ctx.sink.report("E0312", span, expected=f"a Real type for {an(kind)}", found=an(info.base))
        return False
    if info.base == "String" and kind not in ("parameter", "structural", "constant"):
        ctx.sink.report("E0312", span, expected=f"a numeric type for {an(kind)}", found=an(info.base))
        return False
    return True
