"""Diagnostics as editors show them."""

from __future__ import annotations

from collections.abc import Iterable

from lsprotocol import types as lsp

from lagdsl.foundation.diagnostics import Diagnostic, Severity
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.interfaces.lsp.deep import Depth
from lagdsl.interfaces.lsp.positions import location_of, range_of

_SEVERITIES = {
    Severity.ERROR: lsp.DiagnosticSeverity.Error,
    Severity.WARNING: lsp.DiagnosticSeverity.Warning,
    Severity.NOTE: lsp.DiagnosticSeverity.Information,
}
_UNUSED = ("W0206", "W0257")


def shown(found: Iterable[Diagnostic], file: SourceFile) -> list[lsp.Diagnostic]:
    """The diagnostics of a text; those in other files stand at the place of this one that led there."""
    return [_shown(each, file) for each in found]


def _shown(found: Diagnostic, file: SourceFile) -> lsp.Diagnostic:
    own = next((label.span for label in found.labels if label.span.file is file), Span(file, 0, 0))
    others = [label for label in found.labels if label.span != own and label.text]
    return lsp.Diagnostic(
        range=range_of(own),
        message=_message(found.message, found.notes, found.help),
        severity=_SEVERITIES[found.severity],
        code=found.code,
        source="lag",
        tags=[lsp.DiagnosticTag.Unnecessary] if found.code in _UNUSED else None,
        related_information=[lsp.DiagnosticRelatedInformation(location_of(label.span), label.text) for label in others]
        or None,
    )


def deeper(depth: Depth, file: SourceFile, known: Iterable[Diagnostic]) -> list[lsp.Diagnostic]:
    """Diagnostics of the later stages, without those that are `known`."""
    told = {(each.code, each.message) for each in known}
    found = []
    for code, severity, message, help_, notes, start, end in depth.found:
        if (code, message) not in told:
            span = Span(file, 0, 0) if start is None else Span(file, start, end)
            text = _message(message, notes, help_)
            found.append(lsp.Diagnostic(range_of(span), text, _SEVERITIES[Severity(severity)], code, source="lag"))
    return found


def _message(message: str, notes: Iterable[str], help_: str | None) -> str:
    return "\n".join([message, *notes, *([] if help_ is None else [f"help: {help_}"])])
