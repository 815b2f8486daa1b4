"""Prefixes of declarations: which combinations mean what, and which types they go with."""

from __future__ import annotations

from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import an
from lagdsl.language.semantics.scope.scope import SymbolKind, TypeInfo
from lagdsl.language.syntax import nodes

_KINDS: dict[frozenset[str], SymbolKind] = {
    frozenset(): "algebraic",
    frozenset({"parameter"}): "parameter",
    frozenset({"structural", "parameter"}): "structural",
    frozenset({"structural"}): "structural",
    frozenset({"constant"}): "constant",
    frozenset({"input"}): "input",
    frozenset({"output"}): "output",
    frozenset({"state"}): "state",
    frozenset({"discrete"}): "discrete",
    frozenset({"discrete", "output"}): "discrete",
    frozenset({"flow"}): "algebraic",
}
_MEANINGS = {
    "parameter": "is set before a run",
    "structural": "parameter shapes the model before it is compiled",
    "constant": "never changes",
    "input": "is given from outside during a run",
    "output": "is computed and shown",
    "state": "changes by its `der`",
    "discrete": "variable changes in `when` clauses",
    "flow": "variable belongs to a port, where those of connected ports sum up to zero",
}
_SHOWN = ("parameter", "structural", "constant", "state")
_LATER = {
    "replaceable": "components and classes are replaceable; a quantity gets another value by a modifier",
    "redeclare": "redeclare in a modifier: `extends Base(redeclare model Part = Other)`",
    "stream": "streams are not part of mechanics",
}


def kind_of_component(ctx: Context, item: nodes.Component) -> SymbolKind | None:
    """Kind of a declaration by its prefixes; None after E0214 or E0311."""
    words = frozenset(item.prefixes)
    kind = _KINDS.get(words - {"final"})
    if kind is not None and len(words) == len(item.prefixes):
        return kind
    span = Span(item.span.file, item.span.start, item.type_name.span.start)
    text = span.text.rstrip()
    span = Span(span.file, span.start, span.start + len(text)) if text else item.type_name.span
    for prefix in item.prefixes:
        if prefix in _LATER:
            ctx.sink.report("E0311", span, what=f"`{prefix}`", hint=_LATER[prefix])
            return None
    ctx.sink.report("E0214", span, prefixes=" ".join(item.prefixes), hint=_way_out(item))
    return None


def _way_out(item: nodes.Component) -> str:
    """The prefixes by their meanings, and which of them to keep."""
    words = [word for word in dict.fromkeys(item.prefixes) if word != "final"]
    if len(set(item.prefixes)) < len(item.prefixes):
        return f"each of them is written once: `{' '.join(dict.fromkeys(item.prefixes))}`"
    strangers = [word for word in words if word not in _MEANINGS]
    if strangers:
        return f"`{strangers[0]}` is for classes: leave it out"
    told = ", ".join(f"{an(word).removesuffix(word)}`{word}` {_MEANINGS[word]}" for word in words)
    kept = next((word for word in words if word in _SHOWN), None)
    if "output" in words and len(words) == 2 and kept is not None:
        name, of = item.declarators[0].name, ".".join(item.type_name.parts)
        return f"{told}: keep `{kept}`, and show it by an output of another name, `output {of} y = {name};`"
    if set(words) == {"discrete", "input"}:
        reads = "`when sample(...)` reads it at instants, Integers and Booleans change at instants by themselves"
        return f"{told}: keep `input`; {reads}"
    return f"{told}: keep one of them"


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
