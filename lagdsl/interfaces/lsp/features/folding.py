"""Ranges that an editor may fold: classes, sections, blocks, long statements, comments."""

from __future__ import annotations

from lsprotocol import types as lsp

from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.tokens import comments
from lagdsl.language.syntax.walk import descendants

_FOLDED = (nodes.Class, nodes.Section, nodes.Definition, nodes.Declaration, nodes.Physics, nodes.Relation, nodes.Block)


def folding(snapshot: Snapshot) -> list[lsp.FoldingRange]:
    """Whole lines; a range keeps its first line and, of a class or block, its `end`."""
    if snapshot.unit is None:
        return []
    found: dict[tuple[int, int], lsp.FoldingRange] = {}
    for node in descendants(snapshot.unit):
        if isinstance(node, _FOLDED):
            first, last = node.span.first.line, node.span.last.line
            if isinstance(node, nodes.Class | nodes.Block):
                last -= 1
            if last > first:
                found.setdefault((first, last), lsp.FoldingRange(first - 1, last - 1))
    for comment in comments(snapshot.text):
        lines = comment.text.count("\n")
        if lines:
            first = snapshot.file.line_number(comment.start)
            kind = lsp.FoldingRangeKind.Comment
            found[first, first + lines] = lsp.FoldingRange(first - 1, first + lines - 1, kind=kind)
    return [found[key] for key in sorted(found)]
