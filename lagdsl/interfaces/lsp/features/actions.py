"""Code actions: what the help of a diagnostic proposes, where it is one change."""

from __future__ import annotations

from collections.abc import Iterable

from lsprotocol import types as lsp

from lagdsl.foundation.diagnostics import Diagnostic, Edit
from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.features.diagnostics import shown
from lagdsl.interfaces.lsp.positions import range_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.walk import descendants

_UNUSED = ("W0206", "W0257")


def actions(snapshot: Snapshot, uri: str, found: Iterable[Diagnostic], start: int, end: int) -> list[lsp.CodeAction]:
    """The actions for diagnostics that touch the characters `start` to `end`."""
    made = []
    for each in found:
        place = each.labels[0].span if each.labels else None
        edit = edit_of(snapshot, each)
        if place is None or edit is None or place.file is not snapshot.file or place.start > end or place.end < start:
            continue
        made.append(
            lsp.CodeAction(
                title=_title(each, edit),
                kind=lsp.CodeActionKind.QuickFix,
                diagnostics=shown([each], snapshot.file),
                is_preferred=True,
                edit=lsp.WorkspaceEdit(changes={uri: [lsp.TextEdit(range_of(edit.span), edit.text)]}),
            )
        )
    return made


def edit_of(snapshot: Snapshot, found: Diagnostic) -> Edit | None:
    """The change that removes a fault: the one that its help proposes, or the unused declaration taken out."""
    if found.edit is not None:
        return found.edit if found.edit.span.file is snapshot.file else None
    if found.code in _UNUSED and snapshot.unit is not None and found.labels:
        return _removal(snapshot.unit, found.labels[0].span)
    return None


def _title(found: Diagnostic, edit: Edit) -> str:
    if not edit.text:
        return f"delete `{_short(edit.span.text)}`"
    verb = "insert" if edit.span.start == edit.span.end else "write"
    return f"{verb} `{_short(edit.text)}`"


def _short(text: str) -> str:
    plain = " ".join(text.split())
    return plain if len(plain) <= 40 else f"{plain[:38]} …"


def _removal(unit: nodes.Unit, place: Span) -> Edit | None:
    """A declarator with its comma, or the whole statement with its line where it declares nothing else."""
    for node in descendants(unit):
        if isinstance(node, nodes.Component | nodes.Coordinate | nodes.Geometry):
            spans = [each.span for each in node.declarators]
            at = next((k for k, each in enumerate(node.declarators) if each.name_span == place), None)
            if at is not None and len(spans) == 1:
                return Edit(_line_of(node.span), "")
            if at is not None:
                start = spans[at].start if at == 0 else spans[at - 1].end
                end = spans[1].start if at == 0 else spans[at].end
                return Edit(Span(place.file, start, end), "")
        if isinstance(node, nodes.Import) and node.name.span == place and not node.names:
            return Edit(_line_of(node.span), "")
    return None


def _line_of(span: Span) -> Span:
    """The statement, with its whole line where it stands there alone."""
    text = span.file.text
    start, end = text.rfind("\n", 0, span.start) + 1, text.find("\n", span.end)
    if end >= 0 and not text[start : span.start].strip() and not text[span.end : end].strip():
        return Span(span.file, start, end + 1)
    return span
