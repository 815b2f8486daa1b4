"""Collects diagnostics while a stage goes on."""

import re

from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.diagnostics.diagnostic import Diagnostic, Edit, Label, Severity
from lagdsl.foundation.diagnostics.suggest import Proposal
from lagdsl.foundation.source import Span


class Sink:
    """Collects the diagnostics of the early stages; later ones raise `CompilationFailed` through it."""

    def __init__(self) -> None:
        self._diagnostics: dict[Diagnostic, None] = {}  # in order; a set would lose it

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return tuple(self._diagnostics)

    @property
    def count(self) -> int:
        """Diagnostics so far."""
        return len(self._diagnostics)

    @property
    def has_errors(self) -> bool:
        return any(d.severity is Severity.ERROR for d in self._diagnostics)

    def report(
        self,
        code: str,
        primary: Span | Label | None,
        *labels: Label,
        notes: tuple[str, ...] = (),
        help: str | None = None,
        edit: Edit | None = None,
        **arguments: object,
    ) -> None:
        """Add the diagnostic `code`, its catalog templates filled with `arguments`.

        `help` and `notes` given here win over the row's own, and so do texts of labels. The same fact at the same place
        is kept once. `edit` is what `help` proposes, unless the row or a proposed name tells it.
        """
        row = ROWS[code]
        first = Label(primary) if isinstance(primary, Span) else primary
        places = [] if first is None else [_worded(first, row.label, arguments)]
        places += [_worded(label, row.secondary, arguments) for label in labels]
        if edit is None and first is not None:
            edit = _proposed(first.span, help)
        if edit is None and first is not None and help is None and row.fix is not None:
            edit = Edit(first.span, row.fix.format(**arguments))
        template = row.help.format(**arguments) if help is None and row.help is not None else help
        diagnostic = Diagnostic(
            code=code,
            severity=row.severity,
            message=row.message.format(**arguments),
            labels=tuple(places),
            notes=notes,
            help=template,
            edit=edit,
        )
        self.add(diagnostic)

    def add(self, diagnostic: Diagnostic) -> None:
        """Add what another sink has collected; the same fact at the same place is kept once."""
        self._diagnostics.setdefault(diagnostic)

    def raise_if_errors(self) -> None:
        """Raise `CompilationFailed` with all that was collected if any of it is an error."""
        if self.has_errors:
            raise failed(self.diagnostics)


def _proposed(span: Span, help: str | None) -> Edit | None:
    """The name that `help` proposes, in place of the one with which the text at `span` begins."""
    if not isinstance(help, Proposal) or not re.match(rf"{re.escape(help.asked)}(?!\w)", span.text):
        return None
    return Edit(Span(span.file, span.start, span.start + len(help.asked)), help.meant)


def _worded(label: Label, template: str | None, arguments: dict[str, object]) -> Label:
    return label if label.text or template is None else Label(label.span, template.format(**arguments))


class CompilationFailed(Exception):  # noqa: N818 the public name says what happened
    """A model text was rejected; `diagnostics` say where and why, `str()` is the rendered text."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        from lagdsl.foundation.diagnostics.render import render_all

        return render_all(self.diagnostics)


class UnknownName(CompilationFailed, KeyError):  # noqa: N818 the public name says what happened
    """A name that the model does not have was given: of a parameter, an input, a start value."""


_UNKNOWN = frozenset({"E0222", "E0819", "E0853", "E0874"})


def failed(diagnostics: tuple[Diagnostic, ...]) -> CompilationFailed:
    """The exception that these diagnostics are: UnknownName where all errors are about names that were given."""
    codes = {each.code for each in diagnostics if each.severity is Severity.ERROR}
    return UnknownName(diagnostics) if codes and codes <= _UNKNOWN else CompilationFailed(diagnostics)
