"""References to a declaration, in all texts that are given."""

from __future__ import annotations

from collections.abc import Iterable

from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.snapshot import Snapshot


def declaration_at(snapshot: Snapshot, offset: int) -> Declaration | None:
    """The declaration that the name at `offset` means."""
    found = snapshot.occurrence_at(offset)
    return None if found is None else found.declaration


def references(snapshots: Iterable[Snapshot], wanted: Declaration, *, with_declaration: bool = True) -> list[Span]:
    """The places at which the texts name the declaration, file by file."""
    found: list[Span] = []
    for snapshot in snapshots:
        if wanted.name not in snapshot.text:
            continue
        for each in snapshot.occurrences:
            meant = each.declaration
            is_meant = meant is not None and meant.place == wanted.place and each.span.text == wanted.name
            if is_meant and (with_declaration or not each.is_declaration):
                found.append(each.span)
    return found
