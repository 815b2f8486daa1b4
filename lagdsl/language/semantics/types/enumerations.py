"""Enumerations: `type Gear = enumeration(low, high);` with the values `Gear.low`, `Gear.high`.

A value is the number of its place, from 1, of a kind of its own: values of one enumeration are compared with `==` and
`<>`, no other operation takes them.
"""

from __future__ import annotations

from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import TypeInfo, TypeSymbol, lookup_path
from lagdsl.language.semantics.scope.values import POISON, Scalar, Value
from lagdsl.language.syntax import nodes

_DEEPEST = 50


def type_of(ctx: Context, symbol: TypeSymbol) -> TypeInfo | None:
    """The type of a quantity; E0360 for a literal that is listed twice or none at all."""
    node = symbol.node
    assert isinstance(node, nodes.TypeDefinition)
    names = node.literals
    twice = next((name for place, name in enumerate(names) if name in names[:place]), None)
    if twice is not None:
        ctx.sink.report("E0360", node.span, name=twice)
        return None
    return TypeInfo(
        node.name,
        f"{symbol.scope.prefix}{node.name}",
        DIMENSIONLESS,
        "1",
        literals=names,
        literal_docs=node.literal_docs,
        doc=node.doc,
    )


def literal(ctx: Context, symbol: TypeSymbol, node: nodes.Member) -> Value:
    """The value that `Gear.low` means; poison after E0210."""
    names: tuple[str, ...] = ()
    found = _defining(symbol)
    if found is not None and isinstance(found.node, nodes.TypeDefinition):
        names = found.node.literals
    if found is not None and node.name in names:
        kind = f"{found.scope.prefix}{found.node.name}"
        return Scalar(flat.Number(float(names.index(node.name) + 1)), DIMENSIONLESS, kind=kind)
    listed = f"it has {listing(node.name, names, '`{}`')}" if names else None
    hint = did_you_mean(node.name, names, listed)
    ctx.sink.report("E0210", node.name_span, name=node.name, what=f"type `{node.target.span.text}`", help=hint)
    return POISON


def _defining(symbol: TypeSymbol) -> TypeSymbol | None:
    """The enumeration behind `type A = B;`."""
    for _ in range(_DEEPEST):
        if not isinstance(symbol.node, nodes.TypeDefinition) or symbol.node.base is None:
            return symbol
        entry = lookup_path(symbol.scope, symbol.node.base.parts)
        if not isinstance(entry, TypeSymbol):
            return None
        symbol = entry
    return None
