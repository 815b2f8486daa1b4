"""Places of declarations: go to definition, of names and of their types."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.names.classes import of_entry
from lagdsl.interfaces.lsp.positions import location_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.semantics.scope.scope import lookup_path
from lagdsl.language.syntax import nodes


def definition(snapshot: Snapshot, offset: int) -> lsp.Location | None:
    """The place where the name at `offset` is declared, in this text, another file or the library."""
    found = snapshot.occurrence_at(offset)
    return None if found is None or found.declaration is None else location_of(found.declaration.span)


def type_definition(snapshot: Snapshot, offset: int) -> lsp.Location | None:
    """The place of the class or type of what is declared."""
    found = snapshot.occurrence_at(offset)
    if found is None or found.declaration is None or found.declaration.scope is None:
        return None
    node = found.declaration.node
    if not isinstance(node, nodes.Component | nodes.Coordinate | nodes.FunctionParameter):
        return None
    meant = of_entry(node.type_name.parts[-1], lookup_path(found.declaration.scope, node.type_name.parts))
    return None if meant is None else location_of(meant.span)
