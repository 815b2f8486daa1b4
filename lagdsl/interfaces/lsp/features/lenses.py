"""Lenses above each model: run, show, derive, verify."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.positions import range_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.semantics.classes.selection import MODELS
from lagdsl.language.syntax import nodes

COMMANDS = {
    "lagdsl.run": "run",
    "lagdsl.show": "show",
    "lagdsl.derive": "derive",
    "lagdsl.verify": "verify",
}


def lenses(snapshot: Snapshot, uri: str) -> list[lsp.CodeLens]:
    """One lens for each command above each model that is not partial."""
    return [
        lsp.CodeLens(range_of(item.name_span), lsp.Command(word, name, arguments=[uri, item.name]))
        for item in (snapshot.unit.items if snapshot.unit is not None else ())
        if isinstance(item, nodes.Class) and item.kind in MODELS and "partial" not in item.prefixes
        for name, word in COMMANDS.items()
    ]
