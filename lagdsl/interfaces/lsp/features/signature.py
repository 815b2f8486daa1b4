"""Signature help inside the brackets of a call."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.features.cursor import cursor_at
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.manual.words import arguments_of, paragraph_on
from lagdsl.language.semantics.scope.scope import ClassSymbol, Entry, FunctionSymbol, lookup


def signature(snapshot: Snapshot, offset: int) -> lsp.SignatureHelp | None:
    """Parameters of the innermost function whose bracket is open, with the one at the cursor."""
    cursor = cursor_at(snapshot.text, offset)
    names = snapshot.class_at(offset)
    scope = names.scope if names is not None else snapshot.scope
    for bracket in reversed(cursor.brackets):
        if bracket.mark != "(" or not bracket.before:
            continue
        entry: Entry | None = lookup(scope, bracket.before[0]) if scope is not None else None
        for part in bracket.before[1:]:
            entry = entry.inner.find(part) if isinstance(entry, ClassSymbol) and entry.inner is not None else None
        if isinstance(entry, FunctionSymbol):
            texts = [parameter.span.text for parameter in entry.node.parameters]
            result = f" -> {entry.node.result.span.text}" if entry.node.result is not None else ""
            return _help(bracket.before[-1], texts, result, bracket.commas, entry.node.doc)
        counted = arguments_of(bracket.before[-1]) if len(bracket.before) == 1 else None
        if counted is not None:
            texts = [f"x{k}" for k in range(1, counted[1] + 1)] if counted[1] <= 4 else ["x1", "x2", "..."]
            texts = ["x"] if counted[1] == 1 else texts
            return _help(bracket.before[0], texts, "", bracket.commas, paragraph_on(bracket.before[0]))
    return None


def _help(name: str, parameters: list[str], result: str, active: int, doc: str | None) -> lsp.SignatureHelp:
    label = f"{name}({', '.join(parameters)}){result}"
    content = lsp.MarkupContent(lsp.MarkupKind.Markdown, doc) if doc else None
    information = lsp.SignatureInformation(label, content, [lsp.ParameterInformation(each) for each in parameters])
    return lsp.SignatureHelp([information], 0, min(active, max(len(parameters) - 1, 0)))
