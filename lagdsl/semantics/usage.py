"""What is declared and never used."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.semantics.context import Context
from lagdsl.semantics.scope import Symbol

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
    """W0206 for each declared name that nothing reads."""
    for symbol in symbols:
        kind = _WARNED.get(symbol.kind)
        if kind is not None and not symbol.used:
            ctx.sink.report("W0206", symbol.span, kind=kind, name=symbol.short)
