"""Semantic tokens: what each word of the text is."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.names.occurrences import Occurrence
from lagdsl.interfaces.lsp.positions import position_at
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.syntax.tokens import comments, end_of, plain_tokens, start_of
from lagdsl.language.syntax.vocabulary import vocabulary

_TYPES = ["keyword", "number", "string", "comment", "namespace", "class", "type", "function", "parameter", "property"]
_TYPES += ["variable", "enumMember", "operator"]
_MODIFIERS = ["declaration", "readonly", "defaultLibrary"]
LEGEND = lsp.SemanticTokensLegend(_TYPES, _MODIFIERS)

_OF_KINDS = {
    "package": "namespace",
    "type": "type",
    "function": "function",
    "argument": "parameter",
    "parameter": "parameter",
    "structural parameter": "parameter",
    "constant": "parameter",
    "coordinate": "property",
    "state": "property",
}
_OF_ROLES = {"attribute": "property", "function": "function", "type": "type", "member": "property", "name": "variable"}
_CLASSES = ("model", "block", "joint", "connector", "record")
_FIXED = {"parameter", "structural parameter", "constant"}


def tokens(snapshot: Snapshot) -> lsp.SemanticTokens:
    """All words, numbers, texts and comments, coded as differences as the protocol wants them."""
    found = {each.span.start: (each.span.end, *_of(each)) for each in snapshot.occurrences}
    words = vocabulary().words
    for token in plain_tokens(snapshot.text):
        start = start_of(token)
        if start in found:
            continue
        if token.type in ("NUMBER", "QUANTITY"):
            found[start] = end_of(token), "number", 0
        elif token.type == "STRING":
            found[start] = end_of(token), "string", 0
        elif token.value in words:
            found[start] = end_of(token), "keyword", 0
    for comment in comments(snapshot.text):
        found[comment.start] = comment.end, "comment", 0
    return lsp.SemanticTokens(_coded(snapshot, found))


def _of(each: Occurrence) -> tuple[str, int]:
    if each.declaration is None:
        return _OF_ROLES[each.role], 1 << 2
    kind = each.declaration.kind
    word = "class" if kind in _CLASSES else _OF_KINDS.get(kind, "variable")
    return word, int(each.is_declaration) | (2 if kind in _FIXED else 0)


def _coded(snapshot: Snapshot, found: dict[int, tuple[int, str, int]]) -> list[int]:
    """(lines down, columns on, length, type, modifiers) for each token; one over several lines is cut at their ends."""
    data: list[int] = []
    line = column = 0
    for begin in sorted(found):
        end, word, modifiers = found[begin]
        start = begin
        while start < end:
            stop = snapshot.text.find("\n", start, end)
            stop = end if stop < 0 else stop
            one, two = position_at(snapshot.file, start), position_at(snapshot.file, stop)
            if stop > start:
                on = one.character - column if one.line == line else one.character
                data += [one.line - line, on, two.character - one.character, _TYPES.index(word), modifiers]
                line, column = one.line, one.character
            start = stop + 1
    return data
